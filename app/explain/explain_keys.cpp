// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that are held in Explain: N shows noise alone, B blinks between before and after.
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>

#include "explain/explain_workspace.h"
#include "explain/failing_pane.h"
#include "explain/missing_pane.h"
#include "explain/watching_pane.h"
#include "widgets/explain/version_list.h"
#include "widgets/explain/what_if_slider.h"

namespace handsight::app {

bool ExplainWorkspace::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::WindowDeactivate && watched == window()) {  // the release will not come here
    hold_noise(false);
    hold_blink(false);
  }
  const bool is_press = event->type() == QEvent::KeyPress, is_release = event->type() == QEvent::KeyRelease;
  if ((!is_press && !is_release) || !isVisible()) return false;
  auto* key = static_cast<QKeyEvent*>(event);
  if ((key->key() != Qt::Key_N && key->key() != Qt::Key_B) || key->modifiers() != Qt::NoModifier) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget->window() != window()) return false;
  // Where letters are typed, or mean something of their own, they are not ours.
  const QWidget* focus = QApplication::focusWidget();
  for (const QWidget* w = focus; w; w = w->parentWidget())
    if (qobject_cast<const QLineEdit*>(w) || qobject_cast<const widgets::VersionList*>(w) ||
        qobject_cast<const widgets::Staircase*>(w) || qobject_cast<const widgets::WhatIfSlider*>(w))
      return false;
  if (key->isAutoRepeat()) return true;
  if (key->key() == Qt::Key_N) hold_noise(is_press);
  if (key->key() == Qt::Key_B) hold_blink(is_press);
  return true;
}

void ExplainWorkspace::hold_noise(bool held) {
  if (held == shows_noise_ || (held && !failing_->residuals())) return;
  shows_noise_ = held;
  if (!held) return failing_->show_measured_again();
  const std::uint64_t draw = noise_seed_++;
  failing_->show_noise(draw, tr("Noise alone on the same poses, draw %1").arg(draw));
}

void ExplainWorkspace::hold_blink(bool held) {
  if (held == blink_.isActive()) return;
  watching_->set_blinking(held);
  if (held) {
    blink_phase_ = false;
    blink_.start();
    return blink();
  }
  blink_.stop();
  failing_->show_measured_again();
}

void ExplainWorkspace::blink() {
  ModelVersionPointer a = watching_->compared_a(), b = watching_->compared_b();
  if (!a || !b) {
    b = workbench_.document.shown_model();
    a = nullptr;
    for (const ModelVersionPointer& version : workbench_.document.versions()) {
      if (version == b) break;
      if (version && version->fit) a = version;
    }
  }
  if (!a || !b) return;
  blink_phase_ = !blink_phase_;
  const ModelVersionPointer& shown = blink_phase_ ? a : b;
  if (const auto residuals = workbench_.diagnosing.compute_residuals(shown))
    failing_->show_instead(*residuals, (blink_phase_ ? tr("Before: %1") : tr("After: %1"))
                                           .arg(shown->cause.isEmpty() ? tr("as opened") : shown->cause));
}

std::vector<Action> ExplainWorkspace::own_actions() const {
  const auto explained = [](const char* id, const QString& gesture, const QString& what) {
    return Action{.id = id, .group = tr("Explain"), .text = what, .gesture = gesture};
  };
  const auto done = [this](const char* id, const QString& text, const QString& tip, auto&& run) {
    return Action{.id = id,
                  .group = tr("Explain"),
                  .text = text,
                  .tip = tip,
                  .run =
                      [this, run] {
                        emit workbench_.workspace_requested(Place::explain);
                        run();
                      },
                  .is_possible = [this] { return workbench_.document.is_open(); }};
  };
  Action reveal =
      done("reveal", tr("Reveal the &truth"), tr("what was hidden in this session"), [this] { missing_->reveal(); });
  reveal.is_possible = reveal.is_offered = [this] { return missing_->can_reveal(); };
  constexpr int of_actions = 2;
  reveal.section = of_actions;
  return {
      done("until_it_stops", tr("Add until it stops"), tr("add the best cause again and again"),
           [this] { missing_->add_until_it_stops(); }),
      done("why_not", tr("Why not …?"), tr("all effects, with one verdict each"), [this] { missing_->show_why_not(); }),
      done("tour", tr("Tour: find the missing effect"), {}, [this] { findChild<QToolButton*>("start_tour")->click(); }),
      std::move(reveal),
      explained("card_keys", tr("Tab, Enter"), tr("look at a card, add it")),
      explained("hold_keys", tr("N, B held down"), tr("noise alone, before and after")),
      explained("brush", tr("Shift+drag"), tr("choose observations in a plot"))};
}

}  // namespace handsight::app
