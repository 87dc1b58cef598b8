// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/correction_box.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

constexpr int poses = 500;
constexpr std::size_t bins = 36;

using widgets::colors;
using widgets::TextRole;

std::vector<double> shares(const std::vector<double>& errors, const std::vector<double>& edges) {
  std::vector<double> counts(edges.size() - 1, 0);
  for (const double e : errors) {
    const auto place = std::upper_bound(edges.begin(), edges.end(), e) - edges.begin() - 1;
    counts[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, static_cast<std::ptrdiff_t>(bins) - 1))] +=
        1.0 / static_cast<double>(errors.size());
  }
  return counts;
}

}  // namespace

GainBins gain_bins(const CorrectionGain& gain) {
  GainBins b;
  if (gain.before.empty()) return b;
  const auto [least_before, most_before] = std::minmax_element(gain.before.begin(), gain.before.end());
  const auto [least_after, most_after] = std::minmax_element(gain.after.begin(), gain.after.end());
  const double low = std::max(std::min(*least_before, *least_after), 1e-7);
  const double factor = std::max(std::max(*most_before, *most_after) / low, 1.001);
  for (std::size_t i = 0; i <= bins; ++i)
    b.edges.push_back(low * std::pow(factor, static_cast<double>(i) / static_cast<double>(bins)));
  b.before = shares(gain.before, b.edges);
  b.after = shares(gain.after, b.edges);
  return b;
}

/// Both histograms over one logarithmic axis, as commanded behind, corrected in front.
class GainBars : public QWidget {
 public:
  explicit GainBars(QWidget* parent) : QWidget(parent) { setMinimumHeight(96); }
  void set_bins(GainBins shown) {
    shown_ = std::move(shown);
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (shown_.before.empty()) return;
    QPainter painter(this);
    painter.setFont(widgets::text_font(TextRole::small));
    const int text = painter.fontMetrics().height();
    const QRectF area = QRectF(rect()).adjusted(1, text + 4, -1, -text - 4);
    double most = 0;
    for (const auto* list : {&shown_.before, &shown_.after})
      most = std::max(most, *std::max_element(list->begin(), list->end()));
    draw(painter, area, shown_.before, most, colors().care);
    draw(painter, area, shown_.after, most, colors().good);
    const int left = draw_key(painter, 0, tr("corrected"), colors().good);
    draw_key(painter, left, tr("as commanded"), colors().care);
    painter.setPen(colors().ink3);
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    const QRectF below(0, area.bottom() + 2, width(), text);
    const auto mm = [](double error) { return tr("%1 mm").arg(widgets::short_text(1e3 * error)); };
    painter.drawText(below, Qt::AlignLeft, mm(shown_.edges.front()));
    painter.drawText(below, Qt::AlignHCenter, mm(std::sqrt(shown_.edges.front() * shown_.edges.back())));
    painter.drawText(below, Qt::AlignRight, mm(shown_.edges.back()));
  }

 private:
  /// A square in the histogram's colour and its name; returns where the next one may begin.
  static int draw_key(QPainter& painter, int left, const QString& name, QColor color) {
    color.setAlphaF(0.75F);
    const QFontMetrics metrics = painter.fontMetrics();
    const int side = metrics.ascent() * 2 / 3, width = metrics.horizontalAdvance(name);
    painter.fillRect(QRect(left, metrics.ascent() - side, side, side), color);
    painter.setPen(colors().ink2);
    painter.drawText(QRect(left + side + 4, 0, width + 1, metrics.height()), Qt::AlignLeft, name);
    return left + side + 4 + width + 16;
  }

  static void draw(QPainter& painter, const QRectF& area, const std::vector<double>& list, double most, QColor color) {
    color.setAlphaF(0.75F);
    const double step = area.width() / static_cast<double>(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double height = area.height() * list[i] / most;
      painter.fillRect(QRectF(area.left() + step * static_cast<double>(i), area.bottom() - height, step - 1, height),
                       color);
    }
  }

  GainBins shown_;
};

CorrectionBox::CorrectionBox(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  setObjectName("correction");
  auto* title = new QLabel(tr("What this buys you"), this);
  title->setFont(widgets::text_font(TextRole::title));
  sentence_ = new QLabel(this);
  sentence_->setObjectName("correction_sentence");
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  bars_ = new GainBars(this);
  bars_->setObjectName("correction_bars");
  bars_->setAccessibleName(tr("The hand's error as commanded and corrected"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(title);
  layout->addWidget(sentence_);
  layout->addWidget(bars_);
  hide();
}

void CorrectionBox::show_model(const ModelVersionPointer& model, std::size_t hand) {
  const bool is_moved = model && model->fit && !model->prediction.effects.empty();
  setVisible(is_moved);
  if (!is_moved || (model == model_ && hand == hand_)) return;
  model_ = model;
  hand_ = hand;
  gain_.reset();
  show_gain();
  workbench_.background.start<CorrectionGain>(
      "correction", tr("What correcting buys"),
      [model, hand,
       session = hand < model->hands.size() ? model->hands[hand].session
                                            : workbench_.document.shared_session()](JobControl&) {
        std::vector<Eigen::VectorXd> measured;
        for (const Observation& o : session->observations)
          if (is_used(o)) measured.push_back(o.position);
        return correction_gain(make_chain(*session),
                               hand < model->hands.size() ? model->hands[hand].prediction : model->prediction, measured,
                               poses, 1);
      },
      [this, model, hand](const CorrectionGain& gain) {
        if (model != model_ || hand != hand_) return;
        gain_ = gain;
        show_gain();
      });
}

void CorrectionBox::show_gain() {
  bars_->setVisible(gain_ && !gain_->before.empty());
  if (!gain_) {
    sentence_->setText(tr("Being worked out over %1 poses like the measured ones ...").arg(poses));
    return;
  }
  constexpr double much = 0.95;  // what it is to get below, of what it is
  if (gain_->median_after > much * gain_->median_before) {
    bars_->hide();
    return sentence_->setText(tr("Over %1 poses like the measured ones the hand is off by %2 mm as commanded (median); "
                                 "corrected angles would not bring it nearer.")
                                  .arg(gain_->before.size())
                                  .arg(widgets::short_text(1e3 * gain_->median_before)));
  }
  QString said =
      tr("Over %1 poses like the measured ones the hand is off by %2 mm as commanded (median), and by %3 mm when "
         "the corrected angles are commanded, with all that the model is not sure of: by the C++ and Python files that "
         "this page saves.")
          .arg(gain_->before.size())
          .arg(widgets::short_text(1e3 * gain_->median_before), widgets::short_text(1e3 * gain_->median_after));
  if (gain_->not_reached > 0)
    said += ' ' + tr("%1 of the poses cannot be corrected within the joints' limits.").arg(gain_->not_reached);
  sentence_->setText(said);
  bars_->set_bins(gain_bins(*gain_));
}

}  // namespace handsight::app
