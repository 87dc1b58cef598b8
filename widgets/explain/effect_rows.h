// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the table of effects: each with one verdict.
#pragma once

#include <QString>

namespace handsight::widgets {

enum class EffectVerdict { in_model, would_help, may_be_there, worse, no_sign, cannot_be_seen, same_as, unknown };
/// "in the model", "would help", "may be there", "fits, but worse", "no sign", "unseen on these poses", "same as", "-".
QString effect_verdict_text(EffectVerdict verdict);

struct EffectRow {
  QString id, name;
  QString where;  // joints, for the second column; may be empty
  EffectVerdict verdict = EffectVerdict::unknown;
  QString same_as;  // with same_as: the other's name
  QString reason;   // a sentence
};

}  // namespace handsight::widgets
