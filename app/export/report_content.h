// SPDX-License-Identifier: GPL-3.0-or-later
// What a report is made of beside the numbers of the model.
#pragma once

#include <QImage>
#include <QString>
#include <vector>

#include "widgets/explain/bill_list.h"

namespace handsight::app {

/// A picture of the report with its caption.
struct ReportPicture {
  QString caption;
  QImage image;
};

/// What a report says first.
struct ReportStory {
  QString verdict;                       // how good the model is, in a sentence or two
  QString figures;                       // how far off it is, in numbers; may be empty
  QString next;                          // what to do; may be empty
  std::vector<widgets::BillEntry> bill;  // of the model; empty: nothing is in it
};

}  // namespace handsight::app
