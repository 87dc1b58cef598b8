// SPDX-License-Identifier: Apache-2.0
// A stranger before the window, on a laptop: what stands there to be read, and what to click next.
#pragma once

#include "app/window/pages.h"
#include "app/window/painted_text.h"

namespace handsight::test {

struct Stranger {
  Desk& desk;
  ExplainPage explain{desk};

  /// The size of a laptop's window, 1366 x 768 less a desktop's bars.
  void sit_down() {
    desk.window.resize(1366, 728);
    QTest::qWait(30);
  }
  void click_sample(const char* name) { desk.click(desk.find<QWidget>(name)); }

  /// Everything that a widget paints itself, with spaces between.
  static QString painted(QWidget* widget) {
    QStringList all;
    for (const PaintedText& text : texts_of(*widget)) all << text.text.trimmed();
    return all.join(' ');
  }
  static bool is_whole_in_sight(QWidget* widget) {
    QRegion seen = widget->visibleRegion();
    for (const QWidget* child : widget->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      if (child->isVisible()) seen += child->geometry();  // a part of it
    return widget->isVisible() && seen.boundingRect() == widget->rect();
  }
  QWidget* verdict_line() { return desk.find<QWidget>("verdict"); }

  /// How far off: error and noise, with their unit, in the verdict's sentence.
  bool reads_how_far_off() {
    static const QRegularExpression misses("[0-9.]+.(px|mm).*noise.*[0-9.]+.(px|mm)");
    return is_whole_in_sight(verdict_line()) && painted(verdict_line()).contains(misses);
  }
  /// Whose fault: the shares, in per cent with their names' letters.
  bool reads_whose_fault() {
    const auto& attribution = explain.verdict().attribution;
    return attribution && painted(verdict_line()).contains(QRegularExpression("[CBR].*[0-9]+.%"));
  }
  /// What is missing: the first card's own title, in the card.
  QString reads_what_is_missing() {
    if (explain.cards()->count() == 0) return {};
    widgets::CandidateCard* card = explain.cards()->card(0);
    const QString title = explain.first().title;
    return !card->visibleRegion().isEmpty() && painted(card).contains(title) ? title : QString();
  }
  /// What to click: a button that adds the first card, whole in sight and ready.
  QPushButton* finds_the_button() {
    if (!explain.can_add_first()) return nullptr;
    for (QPushButton* button : {explain.cards()->card(0)->add_button(), explain.cards()->add_button()})
      if (is_whole_in_sight(button) && button->isEnabled()) return button;
    return nullptr;
  }
};

}  // namespace handsight::test
