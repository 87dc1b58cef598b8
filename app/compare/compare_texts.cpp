// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_texts.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// "lens" is no effect but two of them.
QString change_heading(const std::string& id, const std::vector<std::string>& where) {
  return id == "lens" ? QObject::tr("the lenses") : effect_text(id, where);
}

/// Lengths in mm, angles in degrees: what people compare with a ruler. A number in `unit` whose larger part (value or
/// sigma) would be a row of zeros in them is told in a thousandth of the unit.
ShownUnit compared_unit(const std::string& unit, double larger) {
  constexpr double degrees = 57.29577951308232, least = 1e-3;
  const auto is_small = [&](double scale) { return larger > 0 && scale * larger < least; };
  if (unit == "m") return is_small(1e3) ? ShownUnit{1e6, QString::fromUtf8("µm")} : ShownUnit{1e3, "mm"};
  if (unit == "rad")
    return is_small(degrees) ? ShownUnit{1e6, QString::fromUtf8("µrad")} : ShownUnit{degrees, QObject::tr("deg")};
  if (unit == "1" && is_small(100)) return {1e6, "ppm"};
  return shown_unit(unit);
}

double larger_of(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

/// "tcp_from_body x", "joint_offset of a2: offset".
QString number_name(const std::string& name) {
  const auto starts = [&](const char* text) { return name.rfind(text, 0) == 0; };
  const QString axis = QString::fromStdString(name.substr(name.rfind(' ') + 1));
  if (starts("tcp_from_body ")) return QObject::tr("TCP→Body %1").arg(axis);
  if (starts("mount_from_sensor ")) return QObject::tr("sensor on its mount, %1").arg(axis);
  const std::size_t colon = name.find(": ");
  if (colon == std::string::npos) return QString::fromStdString(name);
  const std::string head = name.substr(0, colon);
  const std::size_t of = head.find(" of ");
  const std::vector<std::string> where =
      of == std::string::npos ? std::vector<std::string>{} : std::vector<std::string>{head.substr(of + 4)};
  return QObject::tr("%1: %2").arg(effect_text(head.substr(0, of), where), number_title(name.substr(colon + 2)));
}

}  // namespace

QString comparison_sentence(const Comparison& c) {
  QString reported = translated(c.sentence);
  for (const Change& change : c.changes)
    reported.replace(QString::fromStdString(change.id), change_heading(change.id, {}));
  return reported;
}

QString hand_sentence(const Comparison& c) {
  if (!c.hand_mean_m) return {};
  return QObject::tr("The hand is %1 mm from where it was in the mean over these poses, at most %2 mm.")
      .arg(widgets::short_text(1e3 * *c.hand_mean_m), widgets::short_text(1e3 * c.hand_max_m.value_or(0)));
}

QString change_title(const Change& c) { return change_heading(c.id, c.where); }

QStringList change_numbers(const Change& c) {
  QStringList lines;
  Eigen::Index s = 0;
  for (const EffectTerm& t : c.terms) {
    const Effect& effect = term_effect(t);
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      const ShownUnit unit = compared_unit(c.units[static_cast<std::size_t>(s)], larger_of(t.values[p], c.sigma[s]));
      lines << QObject::tr("%1: %2 %3")
                   .arg(number_title(effect.parameters[p].name),
                        widgets::with_sigma_text(unit.scale * t.values[p], unit.scale * c.sigma[s]), unit.unit);
      ++s;
    }
  }
  return lines;
}

std::vector<NumberLine> number_lines(const Comparison& c) {
  std::vector<NumberLine> lines;
  for (const NumberChange& n : c.numbers) {
    const ShownUnit unit = compared_unit(n.unit, larger_of(n.after - n.before, n.sigma));
    const ShownUnit own = compared_unit(n.unit, larger_of(n.before, n.after));
    lines.push_back({number_name(n.name),
                     widgets::with_sigma_text(unit.scale * (n.after - n.before), unit.scale * n.sigma), unit.unit,
                     n.in_sigmas(),
                     QObject::tr("%1 → %2 %3")
                         .arg(widgets::short_text(own.scale * n.before, 4), widgets::short_text(own.scale * n.after, 4),
                              own.unit)});
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const NumberLine& a, const NumberLine& b) { return std::abs(a.sigmas) > std::abs(b.sigmas); });
  return lines;
}

QStringList hand_sentences(const SeveralComparison& c) {
  QStringList sentences;
  for (const ChangeBetween& change : c.changes)
    if (change.hand_mean_m > 0)
      sentences << QObject::tr("By %1 the hand moves by %2 mm in the mean over these poses, at most by %3 mm.")
                       .arg(change_title(change.change), widgets::short_text(1e3 * change.hand_mean_m),
                            widgets::short_text(1e3 * change.hand_max_m));
  return sentences;
}

namespace {

QString likely_text(double probability) {
  constexpr double least = 1e-3;
  if (probability < least) return QObject::tr("< %1 %").arg(widgets::short_text(100 * least, 1));
  return QObject::tr("%1 %").arg(probability > 0.99 ? widgets::fixed_text(std::floor(1e3 * probability) / 10, 1)
                                                    : widgets::short_text(100 * probability));
}

QString names_text(const std::vector<std::string>& titles) {
  QStringList names;
  for (const std::string& title : titles) names << QString::fromStdString(title);
  return names.join(", ");
}

SeveralLine find_line(const ChangeCandidate& c, bool is_change) {
  const QString heading =
      change_heading(c.id, c.where.empty() ? std::vector<std::string>{} : std::vector<std::string>{c.where});
  const QString name = QObject::tr("%1: %2 | %3").arg(heading, names_text(c.before), names_text(c.after));
  return {is_change ? name : QObject::tr("or %1").arg(name), likely_text(c.probability), is_change, c.before.back(),
          c.after.front()};
}

}  // namespace

std::vector<SeveralLine> several_lines(const SeveralComparison& c) {
  std::vector<SeveralLine> lines;
  for (const ChangeBetween& change : c.changes) {
    lines.push_back(find_line(change.reported, true));
    for (const ChangeCandidate& other : change.alternatives) lines.push_back(find_line(other, false));
  }
  for (const SharedThing& thing : c.shared)
    lines.push_back({QObject::tr("%1: the same in all").arg(change_heading(thing.id, {})),
                     likely_text(1 - thing.probability_changed)});
  return lines;
}

std::vector<NumberLine> number_lines(const SeveralComparison& c) {
  std::vector<NumberLine> lines;
  for (const ChangeBetween& between : c.changes) {
    const Change& change = between.change;
    Eigen::Index s = 0;
    for (const EffectTerm& t : change.terms) {
      const Effect& effect = term_effect(t);
      for (std::size_t p = 0; p < t.values.size(); ++p) {
        if (effect.parameters[p].is_choice) continue;
        const double sigma = change.sigma[s];
        const ShownUnit unit =
            compared_unit(change.units[static_cast<std::size_t>(s++)], larger_of(t.values[p], sigma));
        lines.push_back({QObject::tr("%1: %2").arg(change_title(change), number_title(effect.parameters[p].name)),
                         widgets::with_sigma_text(unit.scale * t.values[p], unit.scale * sigma), unit.unit,
                         sigma > 0 ? t.values[p] / sigma : 0});
      }
    }
  }
  return lines;
}

}  // namespace handsight::app
