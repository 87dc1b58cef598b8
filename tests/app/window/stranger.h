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

  QWidget* header() { return desk.find<QWidget>("three_numbers"); }

  /// How far off: error and noise with their unit, and how many times, in the header. The verdict's sentence, which
  /// stands below it, says none of them again.
  bool reads_how_far_off() {
    static const QRegularExpression numbers(
        "^[0-9.]+.(px|mm) (error now|held out).* [0-9.]+.(px|mm) noise.* [0-9.]+.\u00D7 ratio$");
    return is_whole_in_sight(header()) && painted(header()).contains(numbers) && is_whole_in_sight(verdict_line()) &&
           repeated_figures().isEmpty();
  }
  /// What the header says and the verdict's sentence says again.
  QStringList repeated_figures() {
    static const QRegularExpression figure("[0-9.]+.(px|mm|\u00D7)");
    QStringList repeated;
    for (auto i = figure.globalMatch(painted(header())); i.hasNext();)
      if (const QString one = i.next().captured(); explain.verdict().sentence.contains(one)) repeated << one;
    return repeated;
  }
  /// Whose fault: the shares, in per cent with their names' letters; of one marker alone, that nobody can say.
  bool reads_whose_fault() {
    const widgets::SessionVerdict& verdict = explain.verdict();
    if (desk.document().session().marker_count == 1)
      return !verdict.attribution && painted(verdict_line()).contains("Cannot be split with one marker");
    return verdict.attribution && painted(verdict_line()).contains(QRegularExpression("[CBR].*[0-9]+.%"));
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
