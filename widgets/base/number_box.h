// SPDX-License-Identifier: GPL-3.0-or-later
// A field for a number that shows a true minus, as every other number of the window; a plain one can be typed.
#pragma once

#include <QDoubleSpinBox>

namespace handsight::widgets {

class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QString textFromValue(double value) const override {
    return QDoubleSpinBox::textFromValue(value).replace(QLatin1Char('-'), true_minus);
  }
  double valueFromText(const QString& text) const override { return QDoubleSpinBox::valueFromText(plain(text)); }
  QValidator::State validate(QString& text, int& position) const override {
    QString typed = plain(text);
    return QDoubleSpinBox::validate(typed, position);
  }

 private:
  static constexpr QChar true_minus{0x2212};
  static QString plain(QString text) { return text.replace(true_minus, QLatin1Char('-')); }
};

}  // namespace handsight::widgets
