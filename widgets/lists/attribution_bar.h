// SPDX-License-Identifier: GPL-3.0-or-later
// Three-way blame: how much of a residual comes from the cameras (C), the marker body (B), the robot (R).
#pragma once

#include <QWidget>
#include <optional>

namespace handsight::widgets {

/// Shares of the squared residual, 0 to 1, together at most 1.
struct ErrorAttribution {
  double cameras = 0, body = 0, robot = 0;
  bool of_tracker = false;  // a tracker measures in place of cameras
};

/// A bar in three colours with the letters and per cents, and a sentence below.
class AttributionBar : public QWidget {
  Q_OBJECT
 public:
  explicit AttributionBar(QWidget* parent = nullptr);
  void set_attribution(std::optional<ErrorAttribution> attribution);
  const std::optional<ErrorAttribution>& attribution() const { return attribution_; }
  /// What stands in place of the shares where there are none.
  void set_none_text(const QString& text);
  /// In words: what it is, what would make it right. Wraps.
  void set_sentence(const QString& sentence);
  const QString& sentence() const { return sentence_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<ErrorAttribution> attribution_;
  QString sentence_, none_text_;
};

}  // namespace handsight::widgets
