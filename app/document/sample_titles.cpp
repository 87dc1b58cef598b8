// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/sample_titles.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace handsight::app {
namespace {

/// As sample_sessions/*/session.xml have them.
constexpr const char* titles[] = {
    QT_TRANSLATE_NOOP("titles", "First steps"),
    QT_TRANSLATE_NOOP("titles", "One camera and a printed board"),
    QT_TRANSLATE_NOOP("titles", "A probe and a plate"),
    QT_TRANSLATE_NOOP("titles", "A real Panda: a ball in four sockets"),
    QT_TRANSLATE_NOOP("titles", "A hundred poses"),
    QT_TRANSLATE_NOOP("titles", "The thesis's simulation"),
    QT_TRANSLATE_NOOP("titles", "Hidden 1: the pedestal arm"),
    QT_TRANSLATE_NOOP("titles", "Hidden 2: the light arm"),
    QT_TRANSLATE_NOOP("titles", "Hidden 3: Justin"),
    QT_TRANSLATE_NOOP("titles", "Hidden 4: the pedestal arm"),
    QT_TRANSLATE_NOOP("titles", "Hidden 5: Justin"),
    QT_TRANSLATE_NOOP("titles", "Hidden 6: the light arm"),
    QT_TRANSLATE_NOOP("titles", "Hidden 7: the light arm"),
    QT_TRANSLATE_NOOP("titles", "Hidden 8: the pedestal arm"),
};

}  // namespace

QString shown_title(const QString& title) {
  const bool is_sample =
      std::any_of(std::begin(titles), std::end(titles), [&](const char* one) { return title == one; });
  return is_sample ? QCoreApplication::translate("titles", title.toUtf8().constData()) : title;
}

}  // namespace handsight::app
