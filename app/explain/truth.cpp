// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/truth.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "base/xml.h"
#include "diagnosis/selection/model_changes.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "effects/own_effect.h"
#include "effects/units.h"
#include "widgets/base/number_text.h"

namespace handsight::app {
namespace {

std::filesystem::path truth_file(const Session& session) { return session.file.parent_path() / "truth.xml"; }

EffectTerm& term_at(std::vector<EffectTerm>& terms, const Effect& effect, int place) {
  for (EffectTerm& t : terms)
    if (t.id == effect.id && t.place == place) return t;
  return terms.emplace_back(EffectTerm{effect.id, place, std::vector<double>(effect.parameters.size(), 0.0)});
}

void read_effect(const XmlNode& node, const Session& session, std::vector<EffectTerm>& terms) {
  const std::string id = required_name(node, "id");
  const Effect* effect = find_effect(id);
  if (!effect) refuse(node, "names an effect that is not in the catalogue.");
  for (const XmlNode& p : children(node, "parameter")) {
    const auto of = find_text(p, "of");
    int place = -1;
    if (of && effect->scope == EffectScope::marker) {
      place = static_cast<int>(std::strtol(of->c_str(), nullptr, 10));
    } else if (of && effect->scope == EffectScope::tag) {
      place = static_cast<int>(std::strtol(of->c_str() + (of->starts_with("tag ") ? 4 : 0), nullptr, 10));
    } else if (of) {
      place = find_joint(session.robot, *of);
      if (place < 0) refuse(p, "names a joint that the robot does not have.");
    }
    const std::string name = required_name(p, "name");
    for (std::size_t i = 0; i < effect->parameters.size(); ++i)
      if (effect->parameters[i].name == name) term_at(terms, *effect, place).values[i] = required_number(p, "value");
  }
}

const FittedEffect* found_for(const EffectTerm& hidden, const Fit& fit) {
  for (const FittedEffect& f : fit.effects)
    if (f.term.id == hidden.id && f.term.place == hidden.place) return &f;
  return nullptr;
}

/// Choices (from which observation on) need not be the same number to mean the same; so near they may be.
constexpr double near_choice = 1.5;
constexpr double sigmas_that_agree = 4;

void compare_term(const Session& session, const EffectTerm& hidden, const Fit& fit,
                  std::vector<widgets::TruthRow>& rows) {
  const Effect& effect = *find_effect(hidden.id);
  const FittedEffect* found = found_for(hidden, fit);
  const std::string place = place_name(effect, hidden.place, session.robot);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
    const EffectParameter& parameter = effect.parameters[p];
    const ShownUnit unit = shown_unit(unit_at(effect, p, hidden.place, session.robot));
    widgets::TruthRow row;
    row.what = place.empty() ? effect_text(hidden.id, {}) : place_text(place);
    row.parameter = number_title(parameter.name);
    row.unit = unit.unit;
    row.hidden = unit.scale * hidden.values[p];
    if (!found) {
      row.verdict = widgets::TruthVerdict::missed;
      row.remark = QObject::tr("not in the model");
    } else {
      const double sigma = found->sigmas[p], off = std::abs(found->term.values[p] - hidden.values[p]);
      row.found = unit.scale * found->term.values[p];
      if (sigma > 0) row.sigma = unit.scale * sigma;
      const bool agrees = parameter.is_choice ? off <= near_choice
                          : sigma > 0         ? off <= sigmas_that_agree * sigma
                                              : off < 1e-12;
      row.verdict = agrees ? widgets::TruthVerdict::right : widgets::TruthVerdict::off;
      if (sigma > 0 && !agrees) row.remark = QObject::tr("%1 sigma off").arg(widgets::short_text(off / sigma));
    }
    rows.push_back(row);
  }
}

/// Is the term a curve without a name that acts at this joint or follows its angle?
bool is_curve_at(const EffectTerm& term, const std::string& joint, const Session& session) {
  const Effect& effect = term_effect(term);
  if (!effect.is_unnamed()) return false;
  if (place_name(effect, term.place, session.robot) == joint) return true;
  return std::any_of(effect.definition->moves.begin(), effect.definition->moves.end(), [&](const DefinedMove& m) {
    return m.formula.find("q_" + formula_name(joint)) != std::string::npos;
  });
}

/// Small deviations claim nothing: whether they were hidden is not asked.
void add_what_was_not_hidden(const Session& session, const Truth& truth, const Fit& fit,
                             std::vector<widgets::TruthRow>& rows) {
  for (const FittedEffect& f : fit.effects) {
    if (is_small(f.term)) continue;
    const bool is_hidden = std::any_of(truth.effects.begin(), truth.effects.end(), [&](const EffectTerm& t) {
      return t.id == f.term.id && t.place == f.term.place;
    });
    const bool is_curve = std::any_of(truth.curves.begin(), truth.curves.end(),
                                      [&](const auto& curve) { return is_curve_at(f.term, curve.first, session); });
    if (is_hidden || is_curve) continue;
    const Effect& effect = term_effect(f.term);
    const std::string place = place_name(effect, f.term.place, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const ShownUnit unit = shown_unit(unit_at(effect, p, f.term.place, session.robot));
      widgets::TruthRow row;
      row.what = display_name({f.term}, session);
      row.parameter = number_title(effect.parameters[p].name);
      row.unit = unit.unit;
      row.found = unit.scale * f.term.values[p];
      if (f.sigmas[p] > 0) row.sigma = unit.scale * f.sigmas[p];
      row.verdict = widgets::TruthVerdict::too_much;
      row.remark = QObject::tr("was not hidden");
      rows.push_back(row);
    }
  }
}

QString hidden_text(const Session& session, const Truth& truth) {
  QStringList parts;
  for (const std::string& id : list_ids(truth.effects)) {
    std::vector<std::string> where;
    for (const EffectTerm& t : truth.effects)
      if (const std::string place = place_name(*find_effect(id), t.place, session.robot); t.id == id && !place.empty())
        where.push_back(place);
    parts << effect_text(id, where);
  }
  for (const auto& [joint, formula] : truth.curves)
    parts << QObject::tr("a curve without a name in %1, %2 rad")
                 .arg(QString::fromStdString(joint), QString::fromStdString(formula));
  return parts.join(", ");
}

}  // namespace

bool knows_truth(const Session& session) {
  return !session.file.empty() && std::filesystem::exists(truth_file(session));
}

Truth read_truth(const Session& session) {
  const std::filesystem::path file = truth_file(session);
  const std::string name = shown_path(file);
  const auto document = parse_xml(read_file(file), name);
  const XmlNode root = require_root(*document, name, "handsight_truth");
  Truth truth;
  if (const auto effects = find_child(root, "effects"))
    for (const XmlNode& node : children(*effects, "effect")) read_effect(node, session, truth.effects);
  for (const XmlNode& node : children(root, "curve"))
    truth.curves.push_back({required_name(node, "of"), required_name(node, "deviation")});
  return truth;
}

TruthComparison compare_with_truth(const Session& session, const Truth& truth, const Fit& fit, const Diagnosis* d) {
  TruthComparison c;
  for (const EffectTerm& hidden : truth.effects) compare_term(session, hidden, fit, c.rows);
  add_what_was_not_hidden(session, truth, fit, c.rows);
  for (const auto& [joint, formula] : truth.curves) {
    widgets::TruthRow row{.what = QObject::tr("a curve without a name in %1").arg(QString::fromStdString(joint)),
                          .parameter = QString::fromStdString(formula)};
    const bool is_seen = d && is_outdone(*d) &&
                         std::find(d->candidates.front().where.begin(), d->candidates.front().where.end(), joint) !=
                             d->candidates.front().where.end();
    const bool is_in_model =
        std::any_of(fit.effects.begin(), fit.effects.end(),
                    [&, joint = joint](const FittedEffect& f) { return is_curve_at(f.term, joint, session); });
    row.verdict = is_seen || is_in_model ? widgets::TruthVerdict::right : widgets::TruthVerdict::missed;
    row.remark = is_in_model ? QObject::tr("in the model as a curve without a name")
                 : is_seen   ? QObject::tr("seen, and said to have no name")
                             : QString();
    c.rows.push_back(row);
  }
  const auto any = [&](widgets::TruthVerdict v) {
    return std::any_of(c.rows.begin(), c.rows.end(), [&](const widgets::TruthRow& r) { return r.verdict == v; });
  };
  using widgets::TruthVerdict;
  const bool nothing_hidden = truth.effects.empty() && truth.curves.empty();
  const QString hidden = nothing_hidden ? QObject::tr("Nothing was hidden.")
                                        : QObject::tr("Hidden was: %1.").arg(hidden_text(session, truth));
  const QString verdict = any(TruthVerdict::missed)     ? QObject::tr("Not found (yet).")
                          : any(TruthVerdict::too_much) ? QObject::tr("Wrong: the model has more than was hidden.")
                          : any(TruthVerdict::off)      ? QObject::tr("Right cause, another size.")
                          : nothing_hidden              ? QObject::tr("Right: nothing was added.")
                                                        : QObject::tr("Right.");
  c.sentence = hidden + ' ' + verdict;
  if (std::any_of(fit.effects.begin(), fit.effects.end(), [](const FittedEffect& f) { return is_small(f.term); }))
    c.sentence += ' ' + QObject::tr("The small deviations at each joint that it has besides are no causes.");
  return c;
}

}  // namespace handsight::app
