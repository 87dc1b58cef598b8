// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers at axes with the minus and the decimal mark of everywhere else. Internal to widgets/plots.
#pragma once

#include <qcustomplot.h>

#include "widgets/base/number_text.h"

namespace handsight::widgets {

/// `Ticker`: one of QCustomPlot's.
template <class Ticker>
class MarkedTicker : public Ticker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return Ticker::getTickLabel(tick, QLocale::c(), format, precision)
        .replace(QChar('-'), QChar(0x2212))
        .replace(QChar('.'), decimal_mark());
  }
};

}  // namespace handsight::widgets
