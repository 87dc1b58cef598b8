// SPDX-License-Identifier: GPL-3.0-or-later
// Reveal the truth: what was hidden in a sample session beside what was found.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace handsight::widgets {

enum class TruthVerdict {
  right,    // found, and the number agrees
  off,      // found, but the number does not agree
  missed,   // hidden, not found
  too_much  // found, was not hidden
};

struct TruthRow {
  QString what;  // "joint elasticity of arm_2"
  QString parameter, unit;
  std::optional<double> hidden, found, sigma;  // in `unit`
  TruthVerdict verdict = TruthVerdict::right;
  QString remark;  // "4.1 sigma off"; may be empty
};

/// A table of few rows that is painted whole; `rows` empty: the empty text.
class TruthPanel : public QWidget {
  Q_OBJECT
 public:
  explicit TruthPanel(QWidget* parent = nullptr);
  void set_rows(std::vector<TruthRow> rows, const QString& sentence);  // "Right: ..." above the table
  void set_empty_text(const QString& sentence);
  const std::vector<TruthRow>& rows() const { return rows_; }
  QRectF row_rect(int row) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void row_chosen(int row);  // "see why"

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paint_row(QPainter& painter, int row) const;
  double top_of_rows() const;
  QString shortened_of(int row) const;

  std::vector<TruthRow> rows_;
  QString sentence_, empty_text_;
  int focused_ = 0;
};

}  // namespace handsight::widgets
