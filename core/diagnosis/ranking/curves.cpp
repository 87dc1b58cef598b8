// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/combinations.h"
#include "base/threads.h"
#include "diagnosis/curves/place_formulas.h"
#include "diagnosis/evidence/prior_odds.h"
#include "effects/own_effect.h"

namespace handsight {
namespace {

constexpr std::size_t most_variables = 3, most_refined = 6;
constexpr double near_best = 8;          // ln: what a form may lack before its setting is refined
constexpr double catalogue_turns = 2.3;  // slower waves of a joint of its own angle are near those that have names
constexpr int search_steps = 14;
constexpr std::string_view title_of_curve = "Curve of the ";

/// One form at one site, with the directions of the site that it moves.
struct Form {
  const CurveSite* site = nullptr;
  ShapeVariable variable;
  CurveShape shape;
  std::vector<Eigen::Index> directions;
  double ln_factor = -1e300;
};

std::vector<Eigen::Index> all_directions(const CurveSite& site) {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(site.sizes.size()));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  return all;
}

std::vector<Eigen::Index> parameters_of(const Form& f) {
  std::vector<Eigen::Index> list;
  for (Eigen::Index function = 0; function < f.shape.values.cols(); ++function)
    for (const Eigen::Index d : f.directions) list.push_back(function * f.site->sizes.size() + d);
  return list;
}

class Search {
 public:
  Search(const WhitenedModel& w, const NoiseKnowledge& noise) : w_(w), noise_(noise) {}

  std::vector<Score> scores_of(const CurveSite& site, const std::vector<const Eigen::MatrixXd*>& values) const {
    return scores_at(w_, site, values);
  }

  double make_factor(const Form& f) const { return make_factor(f, score_at(w_, *f.site, f.shape.values)); }

  double make_factor(const Form& f, const Score& whole) const {
    return ln_bayes_factor(take_part(whole, parameters_of(f)), w_, noise_);
  }

  /// The setting between its neighbours that suits best (golden section).
  void settle_setting(Form& f) const {
    auto [low, high] = setting_range(f.shape);
    if (!(high > low)) return;
    if (f.shape.family == ShapeFamily::wave && f.site->kind == EmpiricalErrorSite::joint &&
        f.variable.variable->kind == VariableKind::angle && f.variable.variable->joint == f.site->joint)
      low = std::max(low, catalogue_turns);
    if (!(high > low)) return;
    constexpr double golden = 0.381966011250105;
    Form a = at(f, low + golden * (high - low)), b = at(f, high - golden * (high - low));
    for (int step = 0; step < search_steps; ++step) {
      if (a.ln_factor > b.ln_factor) {
        high = b.shape.setting;
        b = a;
        a = at(f, low + golden * (high - low));
      } else {
        low = a.shape.setting;
        a = b;
        b = at(f, high - golden * (high - low));
      }
      if (!(high > low)) break;
    }
    for (const Form* other : {&a, &b})
      if (other->ln_factor > f.ln_factor) f = *other;
  }

  /// Takes out the directions without which the form is likelier.
  void settle_directions(Form& f) const {
    const Score whole = score_at(w_, *f.site, f.shape.values);
    for (bool shrunk = true; shrunk && f.directions.size() > 1;) {
      Form best = f;
      for (std::size_t i = 0; i < f.directions.size(); ++i) {
        Form less = f;
        less.directions.erase(less.directions.begin() + static_cast<std::ptrdiff_t>(i));
        less.ln_factor = make_factor(less, whole);
        if (less.ln_factor > best.ln_factor) best = less;
      }
      shrunk = best.directions.size() < f.directions.size();
      f = best;
    }
  }

  Eigen::VectorXd estimate_of(const Form& f) const {
    const Score s = take_part(score_at(w_, *f.site, f.shape.values), parameters_of(f));
    return linear_estimate(s, w_, noise_).value;
  }

 private:
  Form at(const Form& f, double setting) const {
    Form other = f;
    other.shape = make_shape(f.variable, f.shape.family, setting);
    other.ln_factor = make_factor(other);
    return other;
  }

  const WhitenedModel& w_;
  const NoiseKnowledge& noise_;
};

/// Which of the variables a product with `v` is with: its formula ends with that variable's.
const Variable* other_factor(const CurveShape& product, const Variable& v, const std::vector<Variable>& variables) {
  const std::string other = product.formulas.front().substr(v.formula.size() + 1);
  return &*std::find_if(variables.begin(), variables.end(), [&](const Variable& x) { return x.formula == other; });
}

bool can_act_there(const Variable& v, const CurveShape& shape, const CurveSite& site) {
  const bool is_line = shape.family == ShapeFamily::line;
  if (site.kind != EmpiricalErrorSite::joint) return shape.at_rigid && !is_line;
  if (site.joint == v.joint) return shape.at_joint && !is_line;
  return v.kind != VariableKind::torque;
}

/// Every form of a variable that a formula can write, at every site, with its evidence.
void add_forms(const Search& search, const std::vector<CurveSite>& sites, const Variable& v,
               const std::vector<Variable>& variables, std::vector<Form>& forms) {
  std::vector<CurveShape> shapes = list_shapes(v, variables);
  if (v.kind == VariableKind::angle) shapes.push_back(make_shape({&v}, ShapeFamily::line, 0));
  std::erase_if(shapes, [](const CurveShape& s) { return s.formulas.empty(); });
  std::vector<std::vector<std::optional<Form>>> made(shapes.size(), std::vector<std::optional<Form>>(sites.size()));
  each_part(static_cast<int>(sites.size()), true, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    std::vector<const Eigen::MatrixXd*> values;
    std::vector<std::size_t> acting;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (!can_act_there(v, shapes[k], sites[place])) continue;
      values.push_back(&shapes[k].values);
      acting.push_back(k);
    }
    const std::vector<Score> scores = search.scores_of(sites[place], values);
    for (std::size_t k = 0; k < acting.size(); ++k) {
      const CurveShape& shape = shapes[acting[k]];
      ShapeVariable of{&v};
      if (shape.family == ShapeFamily::product) of.other = other_factor(shape, v, variables);
      Form f{&sites[place], of, shape, all_directions(sites[place])};
      f.ln_factor = search.make_factor(f, scores[k]);
      made[acting[k]][place] = std::move(f);
    }
  });
  for (auto& of_shape : made)
    for (std::optional<Form>& form : of_shape)
      if (form) forms.push_back(std::move(*form));
}

/// "x", "rz" of a rigid site; empty of a joint.
std::string axis_name(const Form& f, Eigen::Index direction) {
  return f.site->kind == EmpiricalErrorSite::joint ? "" : motion_axes[direction];
}

std::string parameter_name(const Form& f, Eigen::Index function, Eigen::Index direction) {
  const std::string axis = axis_name(f, direction);
  const std::string name = f.shape.family == ShapeFamily::wave   ? (function == 0 ? "sine" : "cosine")
                           : f.shape.family == ShapeFamily::bend ? (function == 0 ? "slope" : "bow")
                                                                 : "size";
  return axis.empty() ? name : axis + "_" + name;
}

std::string site_text(const Form& f, const Robot& robot) {
  if (f.site->kind == EmpiricalErrorSite::joint)
    return "the angle of " + robot.joints[static_cast<std::size_t>(f.site->joint)].name;
  std::string axes;
  for (const Eigen::Index d : f.directions) axes += (axes.empty() ? "" : ", ") + axis_name(f, d);
  return fmt::format("{} ({})", f.site->kind == EmpiricalErrorSite::tcp ? "the hand" : "the sensor's mount", axes);
}

EffectDefinition definition_of(const Form& f, const std::string& id, const Robot& robot) {
  const bool at_joint = f.site->kind == EmpiricalErrorSite::joint;
  EffectDefinition d;
  d.id = id;
  d.unnamed = true;
  d.title = std::string(title_of_curve) + f.variable.variable->name.english();
  d.scope = at_joint ? "joint" : "session";
  d.cause = message("{} moves with the {}, {}: it has no name in the catalogue.", site_text(f, robot),
                    f.variable.variable->name, f.shape.text);
  d.cause.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(d.cause.front())));
  const bool slides = at_joint && robot.joints[static_cast<std::size_t>(f.site->joint)].kind == JointKind::prismatic;
  const std::string prefix = f.site->kind == EmpiricalErrorSite::tcp ? "hand_" : "mount_";
  for (const Eigen::Index direction : f.directions) {
    std::string formula;
    for (Eigen::Index function = 0; function < f.shape.values.cols(); ++function) {
      const std::string name = parameter_name(f, function, direction);
      const bool is_shift = at_joint ? slides : direction < 3;
      d.parameters.push_back({name, is_shift ? "m" : "rad", f.site->sizes[direction]});
      formula += (formula.empty() ? "" : " + ") + name + "*" + f.shape.formulas[static_cast<std::size_t>(function)];
    }
    d.moves.push_back({at_joint ? "angle" : prefix + axis_name(f, direction), formula, 0});
  }
  return d;
}

}  // namespace

std::optional<FoundCurve> find_curve(const WhitenedModel& w, const NoiseKnowledge& noise, const Problem& problem,
                                     const std::vector<Variable>& variables,
                                     const std::vector<RankedEmpiricalError>& empirical_errors, const std::string& id) {
  const Robot& robot = problem.source->chain.robot;
  const std::vector<CurveSite> sites = curve_sites(w, problem);
  const Search search(w, noise);
  std::vector<Form> forms;
  std::vector<Variable> followed;  // as formulas give them
  followed.reserve(most_variables);
  for (const RankedEmpiricalError& l : empirical_errors) {
    if (l.ln_bayes_factor < empirical_errors.front().ln_bayes_factor - near_best || followed.size() == most_variables)
      break;
    if (l.empirical_error.variable->formula.empty()) continue;
    followed.push_back(as_written(*l.empirical_error.variable));
    add_forms(search, sites, followed.back(), variables, forms);
  }
  if (forms.empty()) return std::nullopt;
  std::stable_sort(forms.begin(), forms.end(), [](const Form& a, const Form& b) { return a.ln_factor > b.ln_factor; });
  const double ln_forms = std::log(static_cast<double>(forms.size()) / static_cast<double>(followed.size()));
  const double least = forms.front().ln_factor - std::max(near_best, 0.15 * std::abs(forms.front().ln_factor));
  if (forms.size() > most_refined) forms.resize(most_refined);
  Form* best = nullptr;
  double best_value = -1e300;
  for (Form& f : forms) {
    if (f.ln_factor < least) break;
    search.settle_setting(f);
    search.settle_directions(f);
    if (f.directions.size() < static_cast<std::size_t>(f.site->sizes.size())) search.settle_setting(f);
    const double ways = ln_choose(static_cast<double>(f.site->sizes.size()), static_cast<double>(f.directions.size()));
    if (f.ln_factor - ways <= best_value) continue;
    best_value = f.ln_factor - ways;
    best = &f;
  }
  FoundCurve found;
  const auto effect = own_effect(definition_of(*best, id, robot), robot);
  found.term = term_of(*effect, best->site->joint, effect);
  const Eigen::VectorXd value = search.estimate_of(*best);
  const auto directions = static_cast<Eigen::Index>(best->directions.size());
  for (Eigen::Index d = 0; d < directions; ++d)
    for (Eigen::Index function = 0; function < best->shape.values.cols(); ++function) {
      const auto number = static_cast<std::size_t>(d * best->shape.values.cols() + function);
      found.term.values[number] = value[function * directions + d] * effect->parameters[number].sigma;
    }
  found.ln_factor = best->ln_factor;
  found.ln_ways = ln_forms + best->ln_factor - best_value;
  found.variable = best->variable.variable->name;
  found.where = best->site->kind == EmpiricalErrorSite::tcp ? "hand"
                : best->site->kind == EmpiricalErrorSite::mount
                    ? "mount"
                    : robot.joints[static_cast<std::size_t>(best->site->joint)].name;
  return found;
}

std::string next_curve_id(const std::vector<EffectTerm>& terms) {
  for (int number = 1;; ++number) {
    std::string id = fmt::format("curve_{}", number);
    if (std::none_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return t.id == id; })) return id;
  }
}

std::string followed_variable(const EffectDefinition& curve) {
  return curve.title.starts_with(title_of_curve) ? curve.title.substr(title_of_curve.size()) : curve.title;
}

bool is_curve_of_time(const EffectTerm& term) {
  return is_curve(term) && followed_variable(*term.own->definition) == "time";
}

double ln_odds_against_curve(const EffectTerm& term) {
  return ln_ways_of_curves - ln_odds_of_unnamed + (is_curve_of_time(term) ? ln_odds_against_drift : 0);
}

std::string sites_text(const EffectDefinition& d) {
  std::string text;
  for (const DefinedMove& m : d.moves) text += (text.empty() ? "" : ", ") + m.site;
  return text;
}

std::string formula_text(const EffectDefinition& d) {
  std::string text;
  for (const DefinedMove& m : d.moves) text += (text.empty() ? "" : "; ") + m.site + ": " + m.formula;
  const std::string place = centred_part(text);
  if (place.empty()) return text;
  for (std::size_t at; (at = text.find(place)) != std::string::npos;) text.replace(at, place.size(), "u");
  return text + "; u = " + place.substr(1, place.size() - 2);
}

}  // namespace handsight
