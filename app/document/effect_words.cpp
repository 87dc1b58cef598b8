// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/effect_words.h"

#include <QObject>
#include <algorithm>

#include "effects/own_effect.h"
#include "words/core_words.h"

namespace handsight::app {

ShownUnit shown_unit(const std::string& unit) {
  if (unit == "rad") return {1e3, "mrad"};
  if (unit == "rad/(N m)") return {1e6, QString::fromUtf8("µrad/(N m)")};
  if (unit == "m") return {1e3, "mm"};
  if (unit == "m/N") return {1e6, QString::fromUtf8("µm/N")};
  if (unit == "s") return {1e3, "ms"};
  if (unit == "1") return {100, "%"};
  return {1, translated(unit)};
}

QString number_title(const std::string& name) {
  if (name == "tu") return QObject::tr("shift across, u");
  if (name == "tw") return QObject::tr("shift across, w");
  if (name == "ru") return QObject::tr("tilt about u");
  if (name == "rw") return QObject::tr("tilt about w");
  // "x_slope", "ry_bow" of a curve: one of several motions.
  const std::size_t mark = name.find('_');
  const std::string motion = name.substr(0, mark);
  if (mark != std::string::npos &&
      std::find(std::begin(motion_axes), std::end(motion_axes), motion) != std::end(motion_axes))
    return (motion.size() > 1 ? QObject::tr("%1 about %2") : QObject::tr("%1 along %2"))
        .arg(translated(name.substr(mark + 1)), QString(QChar(motion.back())));
  return translated(name);
}

QString effect_title(const std::string& id) {
  const Effect* effect = find_effect(id);
  return effect ? translated(effect->title) : QString::fromStdString(id);
}

QString place_text(const std::string& place) {
  // A joint's name is what the robot's file calls it, even where a text of the core is called the same.
  QString name = QString::fromStdString(place);
  const QStringList words = name.split(' ');
  bool is_number = false;
  if (words.size() == 2 && words[0] == "marker" && (words[1].toInt(&is_number), is_number))
    return QObject::tr("marker %1").arg(words[1]);
  if (words.size() == 4 && words[0] == "from" && words[1] == "observation" && words[3] == "on")
    return QObject::tr("from observation %1 on").arg(words[2]);
  return name;
}

namespace {

QString with_and(QStringList names) {
  if (names.size() < 2) return names.join("");
  const QString last = names.takeLast();
  return QObject::tr("%1 and %2").arg(names.join(", "), last);
}

}  // namespace

QString places_text(const std::vector<std::string>& where) {
  constexpr std::size_t most = 7;  // all the joints of an arm
  QStringList names;
  const std::size_t shown = where.size() > most ? most - 1 : where.size();
  for (std::size_t i = 0; i < shown; ++i) names << place_text(where[i]);
  if (shown < where.size()) return QObject::tr("%1 and %2 more").arg(names.join(", ")).arg(where.size() - shown);
  return with_and(std::move(names));
}

QString effect_text(const std::string& id, const std::vector<std::string>& where) {
  return of_places(within_sentence(effect_title(id)), where);
}

QString list_effects(const std::string& ids) {
  QStringList names;
  for (const QString& id : QString::fromStdString(ids).split(", ")) names << effect_text(id.toStdString(), {});
  return with_and(std::move(names));
}

QString of_places(const QString& title, const std::vector<std::string>& where) {
  if (where.empty()) return title;
  if (where.front().starts_with("from observation")) return title + ' ' + places_text(where);
  return QObject::tr("%1 of %2").arg(title, places_text(where));
}

std::vector<std::string> list_ids(const std::vector<EffectTerm>& terms) {
  std::vector<std::string> ids;
  for (const EffectTerm& term : terms)
    if (std::find(ids.begin(), ids.end(), term.id) == ids.end()) ids.push_back(term.id);
  return ids;
}

std::vector<EffectTerm> terms_of_effect(const std::vector<EffectTerm>& terms, const std::string& id) {
  std::vector<EffectTerm> some;
  for (const EffectTerm& term : terms)
    if (term.id == id) some.push_back(term);
  return some;
}

}  // namespace handsight::app
