// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/effect_rows.h"

#include <QCoreApplication>

namespace handsight::widgets {

QString effect_verdict_text(EffectVerdict verdict) {
  const auto said = [](const char* text) {
    return QCoreApplication::translate("handsight::widgets::EffectTable", text);
  };
  switch (verdict) {
    case EffectVerdict::in_model:
      return said("in the model");
    case EffectVerdict::would_help:
      return said("would help");
    case EffectVerdict::may_be_there:
      return said("may be there");
    case EffectVerdict::worse:
      return said("fits, but worse");
    case EffectVerdict::no_sign:
      return said("no sign");
    case EffectVerdict::cannot_be_seen:
      return said("unseen on these poses");
    case EffectVerdict::same_as:
      return said("same as");
    case EffectVerdict::unknown:
      break;
  }
  return QStringLiteral("-");
}

}  // namespace handsight::widgets
