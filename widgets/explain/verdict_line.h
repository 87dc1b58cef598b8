// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the whole session in a sentence: what is missing, what it would bring, whose fault. How far off the
// model is stands in the window's header (three_numbers.h).
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/base/cells.h"
#include "widgets/lists/attribution_bar.h"

namespace handsight::widgets {

enum class SessionState {
  waiting,  // nothing to judge yet
  mistake,  // the session itself is wrong
  looking,  // a diagnosis runs
  adequate,
  stand_in,  // at the noise, with something in the model that stands in for another cause
  unnamed,   // at the noise, but not all of it has a name
  missing,
  implausible,  // something is missing, and no robot is built as what would explain it
  ambiguous,
  unexplained,
  repeatability,
  too_few,
  noise_unknown,
};

/// "adequate", "something is missing", ...: the word beside the state's icon.
QString session_state_text(SessionState state);

struct SessionVerdict {
  SessionState state = SessionState::waiting;
  QString sentence;                             // at most two lines at 1056 px, without the header's figures
  QString figures;                              // those in a sentence, for pages without a header
  std::optional<double> error_px, noise_px;     // held out, per coordinate; absent with a tracker
  std::optional<double> error_mm, noise_mm;     // at the hand
  std::optional<double> error_sigma;            // in units of the noise
  SizeUnit unit = SizeUnit::pixel;              // which of them stands large; with a tracker never px
  ShownSize predicted;                          // with what is being tried: purple
  std::optional<ErrorAttribution> attribution;  // of the whole session
  QString why_no_attribution;                   // where it can never be parted; empty: not so
};

/// 72 px high: icon and word, the sentence, the blame C B R.
class VerdictLine : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictLine(QWidget* parent = nullptr);
  void set_verdict(SessionVerdict verdict);
  const SessionVerdict& verdict() const { return verdict_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void attribution_clicked();  // "whose fault": to the Inspect workspace

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QRectF attribution_area() const;
  void paint_state(QPainter& painter, const QRectF& area) const;
  void paint_sentence(QPainter& painter, const QRectF& area) const;
  void paint_attribution(QPainter& painter, const QRectF& area) const;

  SessionVerdict verdict_;
};

}  // namespace handsight::widgets
