// SPDX-License-Identifier: GPL-3.0-or-later
// How the table of observations shows its rows: their height, and the columns' widths by what they say.
#pragma once

class QTableView;

namespace handsight::widgets {

/// Of a view that has its model.
void set_up_view(QTableView& view);

/// The beginning of a reason tells little: without room for more the line below the table has it alone.
void give_room_to_reason(QTableView& view, bool has_reasons);

}  // namespace handsight::widgets
