// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/appearance.h"

#include <QActionGroup>
#include <QApplication>
#include <QLocale>
#include <QMenu>

#include "widgets/base/apply_theme.h"
#include "window/language.h"
#include "workbench/preferences.h"

namespace handsight::app {
namespace {

using widgets::MotionChoice;

const QStringList theme_words = {"desktop", "light", "dark"};
const QStringList motion_words = {"desktop", "full", "reduced"};
/// As the desktop has it, English, and what there is a translation into.
QStringList language_words() { return QStringList{"", "en"} + languages(); }

/// As its speakers call it: "Deutsch".
QString name_of_language(const QString& language) {
  QString name = QLocale(language).nativeLanguageName();
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name.isEmpty() ? language : '&' + name;
}

/// The place of a word in a list; the first where it is none of them.
int locate(const QStringList& words, const QString& word) { return std::max(0, static_cast<int>(words.indexOf(word))); }

}  // namespace

Appearance::Appearance(QApplication& application, const QString& named) : application_(application) {
  speak(application, preference("language"));
  theme_ = static_cast<ThemeChoice>(locate(theme_words, named.isEmpty() ? preference("theme") : named));
  widgets::set_motion(static_cast<MotionChoice>(locate(motion_words, preference("motion"))));
  connect(&desktop_theme_, &widgets::DesktopTheme::changed, this, &Appearance::apply);
  apply();
}

void Appearance::apply() {
  const auto kind = theme_ == ThemeChoice::light  ? widgets::ThemeKind::light
                    : theme_ == ThemeChoice::dark ? widgets::ThemeKind::dark
                                                  : desktop_theme_.kind();
  widgets::apply_theme(application_, kind);
}

void Appearance::choose(ThemeChoice theme) {
  remember_preference("theme", theme_words[static_cast<int>(theme)]);
  theme_ = theme;
  apply();
}

void Appearance::choose(MotionChoice motion) {
  remember_preference("motion", motion_words[static_cast<int>(motion)]);
  widgets::set_motion(motion);
}

void Appearance::choose_language(const QString& language) { remember_preference("language", language); }

void Appearance::add_to(QMenu& menu, QAction* before) {
  const auto add = [&](const QString& title, const QStringList& names, int now, auto chosen) {
    auto* choices = new QMenu(title, &menu);
    menu.insertMenu(before, choices);
    auto* group = new QActionGroup(choices);
    for (int i = 0; i < names.size(); ++i) {
      QAction* action = choices->addAction(names[i], choices, [chosen, i] { chosen(i); });
      action->setCheckable(true);
      action->setChecked(i == now);
      group->addAction(action);
    }
    return choices;
  };
  add(tr("&Theme"), {tr("As the &desktop"), tr("&Light"), tr("D&ark")}, static_cast<int>(theme_), [this](int i) {
    choose(static_cast<ThemeChoice>(i));
  })->setObjectName("menu_theme");
  add(tr("&Motion"), {tr("As the &desktop"), tr("&Full"), tr("&Reduced: nothing moves on its way")},
      static_cast<int>(widgets::motion()), [this](int i) { choose(static_cast<MotionChoice>(i)); })
      ->setObjectName("menu_motion");
  QStringList names{tr("As the &desktop"), "&English"};
  for (const QString& language : languages()) names << name_of_language(language);
  add(tr("&Language, from the next start on"), names, locate(language_words(), preference("language")), [this](int i) {
    choose_language(language_words()[i]);
  })->setObjectName("menu_language");
}

}  // namespace handsight::app
