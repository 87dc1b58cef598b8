// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/part_fit.h"

#include <algorithm>

#include "base/error.h"
#include "effects/own_effect.h"
#include "effects/term_numbers.h"
#include "estimation/fit/fit_parts.h"
#include "session/joined.h"

namespace handsight {
namespace {

/// One number of a part's term, and the column of the whole fit's problem that it is; -1 where it is held.
struct PartNumber {
  double value = 0;
  std::vector<Eigen::Index> columns;  // more than one: their sum
};

struct PartTerm {
  EffectTerm term;
  std::vector<PartNumber> numbers;
  bool is_estimated = false;
};

bool moves_anything(const Sites& s) {
  const auto moves = [](const JointChange& j) { return j.angle != 0 || !j.frame.isZero(0) || j.compliance != 0; };
  return !s.mount.isZero(0) || !s.drift.isZero(0) || !s.body.isZero(0) || !s.hand.isZero(0) ||
         s.robot.payload_mass != 0 || std::any_of(s.robot.joints.begin(), s.robot.joints.end(), moves) ||
         std::any_of(s.markers.begin(), s.markers.end(), [](const Vector3& m) { return !m.isZero(0); });
}

/// The part's terms out of those of all.
class PartTerms {
 public:
  PartTerms(const Session& joined, const Fit& fit, const Session& own, int part)
      : fit_(fit),
        part_(joined.parts[static_cast<std::size_t>(part)]),
        chain_(fit.problem.source->chain.parts[static_cast<std::size_t>(part)]),
        own_chain_(make_chain(own)),
        own_effects_(list_own_effects(own, own_chain_)),
        several_rigs_(fit.problem.source->chain.first_cameras.size() > 1) {
    const Problem& p = fit.problem;
    for (std::size_t t = 0; t < p.terms.size(); ++t) add(t);
  }

  std::vector<PartTerm> terms;

 private:
  std::vector<PartNumber> list_numbers(std::size_t t) const {
    const Problem& p = fit_.problem;
    std::vector<PartNumber> numbers;
    for (const double value : p.terms[t].values) numbers.push_back({value, {}});
    for (std::size_t c = 0; c < p.columns_of_effects.size(); ++c)
      if (p.columns_of_effects[c].term == t)
        numbers[p.columns_of_effects[c].parameter].columns.push_back(p.effect_column() + static_cast<Eigen::Index>(c));
    return numbers;
  }

  void add(std::size_t t) {
    const EffectTerm& term = fit_.problem.terms[t];
    const Effect& effect = term_effect(term);
    if (effect.scope == EffectScope::part) return add_of_part(t, effect);
    if (effect.scope == EffectScope::marker) {
      const int marker = term.place - part_.first_marker;
      if (marker >= 0 && marker < part_.marker_count) put(effect.id, marker, list_numbers(t), effect);
      return;
    }
    if (effect.scope == EffectScope::camera && several_rigs_) return add_of_camera(t, effect);
    put(effect.id, term.place, list_numbers(t), effect);
  }

  /// Where the effect acts in this part it is that of the whole session, or of the joint that it moves.
  void add_of_part(std::size_t t, const Effect& effect) {
    const EffectTerm& term = fit_.problem.terms[t];
    ObservationState c = states_at(chain_, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain_.joints.size())));
    c.velocity.setOnes();
    c.approach.setOnes();
    std::vector<double> values = term.values;
    for (std::size_t p = 0; p < values.size(); ++p)
      if (!effect.parameters[p].is_choice) values[p] = 1;
    Sites sites = unmoved_sites(fit_.problem.source->chain);
    effect.move(c, term.place, values, sites);
    if (!moves_anything(sites)) return;
    constexpr std::string_view changed = "_changed";
    if (!effect.id.ends_with(changed)) return put(effect.id, -1, list_numbers(t), effect);
    const std::string id = effect.id.substr(0, effect.id.size() - changed.size());
    for (std::size_t j = 0; j < sites.robot.joints.size(); ++j) {
      const JointChange& joint = sites.robot.joints[j];
      if (joint.angle != 0 || !joint.frame.isZero(0) || joint.compliance != 0 || joint.gap != 0)
        return put(id, static_cast<int>(j), list_numbers(t), effect);
    }
  }

  /// Of a rig by itself: two cameras have one effect, whose numbers are those of the first, then of the second.
  void add_of_camera(std::size_t t, const Effect& effect) {
    const int camera = fit_.problem.terms[t].place - part_.first_camera;
    if (camera < 0 || camera >= part_.camera_count) return;
    const std::vector<PartNumber> numbers = list_numbers(t);
    if (part_.camera_count != 2) return put(effect.id, camera, numbers, effect);
    if (effect.id == "rig") return put("stereo_rig", -1, numbers, effect);
    const Effect* const of_pair = find_effect(effect.id, own_effects_);
    if (!of_pair) return;
    std::vector<PartNumber> both(of_pair->parameters.size());
    std::copy(numbers.begin(), numbers.end(), both.begin() + static_cast<std::ptrdiff_t>(camera * numbers.size()));
    put(effect.id, -1, both, effect);
  }

  void put(const std::string& id, int place, std::vector<PartNumber> numbers, const Effect& of_all) {
    const auto own = std::find_if(own_effects_.begin(), own_effects_.end(), [&](const auto& e) { return e->id == id; });
    const Effect* const effect = own != own_effects_.end() ? own->get() : find_effect(id);
    if (!effect) return;
    for (std::size_t p = 0; p < numbers.size() && p < effect->parameters.size(); ++p)
      if (effect->parameters[p].is_choice && effect->parameters[p].choices.empty() &&
          of_all.scope != EffectScope::session)
        numbers[p].value -= part_.first_order;
    for (PartTerm& known : terms)
      if (known.term.id == id && known.term.place == place && same_choices(*effect, known, numbers))
        return add_to(*effect, numbers, known);
    PartTerm one{term_of(*effect, place, own != own_effects_.end() ? *own : nullptr), numbers};
    terms.push_back(std::move(one));
  }

  static bool same_choices(const Effect& effect, const PartTerm& known, const std::vector<PartNumber>& numbers) {
    for (std::size_t p = 0; p < numbers.size(); ++p)
      if (effect.parameters[p].is_choice && known.numbers[p].value != numbers[p].value) return false;
    return true;
  }

  static void add_to(const Effect& effect, const std::vector<PartNumber>& numbers, PartTerm& known) {
    for (std::size_t p = 0; p < numbers.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      known.numbers[p].value += numbers[p].value;
      auto& columns = known.numbers[p].columns;
      columns.insert(columns.end(), numbers[p].columns.begin(), numbers[p].columns.end());
    }
  }

  const Fit& fit_;
  const SessionPart& part_;
  const Chain& chain_;
  Chain own_chain_;
  OwnEffects own_effects_;
  bool several_rigs_;
};

/// The terms with their values: those with a free number are estimated.
void part_terms(std::vector<PartTerm>& terms, std::vector<EffectTerm>& held, std::vector<EffectTerm>& estimated) {
  for (PartTerm& t : terms) {
    const Effect& effect = term_effect(t.term);
    t.term.held.assign(t.numbers.size(), 0);
    for (std::size_t p = 0; p < t.numbers.size(); ++p) {
      t.term.values[p] = t.numbers[p].value;
      const bool is_free = !t.numbers[p].columns.empty();
      t.term.held[p] = is_free || effect.parameters[p].is_choice ? 0 : 1;
      t.is_estimated = t.is_estimated || is_free;
    }
  }
  std::stable_partition(terms.begin(), terms.end(), [](const PartTerm& t) { return !t.is_estimated; });
  for (const PartTerm& t : terms) (t.is_estimated ? estimated : held).push_back(t.term);
}

/// How the part's columns follow from those of all: part x all.
Eigen::MatrixXd by_all_columns(const SessionPart& part, const Problem& own, const Problem& all,
                               const std::vector<PartTerm>& terms) {
  Eigen::MatrixXd by = Eigen::MatrixXd::Zero(own.columns(), all.columns());
  by.block(0, 3 * part.first_marker, 3 * part.marker_count, 3 * part.marker_count).setIdentity();
  if (const Eigen::Index column = all.column_of_mount(part.mount); column >= 0 && own.mount_is_estimated)
    by.block<6, 6>(own.mount_column(), column).setIdentity();
  for (std::size_t c = 0; c < own.columns_of_effects.size(); ++c) {
    const EffectColumn& column = own.columns_of_effects[c];
    for (const Eigen::Index of_all : terms[column.term].numbers[column.parameter].columns)
      by(own.effect_column() + static_cast<Eigen::Index>(c), of_all) = 1;
  }
  return by;
}

void set_numbers(const Eigen::MatrixXd& covariance, const BodyFrame& frame, Fit& fit) {
  const Problem& p = fit.problem;
  fit.parameter_covariance = covariance;
  const Eigen::Index markers = 3 * p.marker_count;
  const std::vector<Eigen::Index> first_of_term = first_numbers(p.terms, 6);
  Eigen::MatrixXd by = Eigen::MatrixXd::Zero(first_of_term.back(), p.columns());
  by.topLeftCorner(6, markers) = frame.motion_by_markers;
  for (std::size_t c = 0; c < p.columns_of_effects.size(); ++c) {
    const EffectColumn& column = p.columns_of_effects[c];
    by(first_of_term[column.term] + static_cast<Eigen::Index>(column.parameter),
       p.effect_column() + static_cast<Eigen::Index>(c)) = 1;
  }
  fit.model_covariance = by * covariance * by.transpose();
  fit.covariance = body_covariance(frame, covariance.topLeftCorner(markers, markers));
  fit.model_covariance.topLeftCorner<6, 6>() = fit.covariance;  // with the rotations that nothing shows
  for (std::size_t t = 0; t < p.terms.size(); ++t) {
    FittedEffect fitted{p.terms[t], std::vector<double>(p.terms[t].values.size(), 0.0)};
    for (std::size_t n = 0; n < fitted.sigmas.size(); ++n) {
      const Eigen::Index at = first_of_term[t] + static_cast<Eigen::Index>(n);
      fitted.sigmas[n] = std::sqrt(std::max(fit.model_covariance(at, at), 0.0));
    }
    fit.effects.push_back(std::move(fitted));
  }
}

}  // namespace

PartFit fit_of_part(const Session& joined, const Fit& whole, int number) {
  const SessionPart& part = joined.parts[static_cast<std::size_t>(number)];
  PartFit result;
  result.session = part_session(joined, number);
  Session& session = result.session;
  Fit& fit = result.fit;
  std::vector<PartTerm> terms = PartTerms(joined, whole, session, number).terms;
  std::vector<EffectTerm> held, estimated;
  part_terms(terms, held, estimated);
  fit.problem = make_problem(session, make_chain(session), held, estimated);
  const FitPart found = list_parts(joined, whole)[static_cast<std::size_t>(number)];
  Unknowns& u = fit.solution.unknowns;
  const auto begin = estimate(whole).markers_in_tcp.begin() + part.first_marker;
  u.markers_in_tcp.assign(begin, begin + part.marker_count);
  u.mount_from_sensor = found.mount_from_sensor;
  u.effects = effect_values(fit.problem);
  const BodySides sides = sides_of_body(fit.problem, u.markers_in_tcp, 0);
  const BodyFrame frame = body_frame(sides, u.markers_in_tcp);
  fit.problem.tcp_from_slip = fit.tcp_from_body = frame.tcp_from_body;
  place_observations(fit.problem);
  fit.sides = sides;
  fit.rotation_is_observed = frame.unobserved.cols() == 0;
  for (const Vector3& x : u.markers_in_tcp) fit.markers_in_body.push_back(inverse(frame.tcp_from_body) * x);
  const Eigen::MatrixXd by = by_all_columns(part, fit.problem, whole.problem, terms);
  set_numbers(by * whole.parameter_covariance * by.transpose(), frame, fit);
  fit.solution.converged = whole.solution.converged;
  fit.solution.normal = NormalEquations(fit.problem.columns());
  fit.solution.basis = Eigen::MatrixXd::Identity(fit.problem.columns(), fit.problem.columns());
  fit.objective = whole.objective;
  fit.covariance_kind = whole.covariance_kind;
  fit.residual_rms = whole.residual_rms * part.residual_unit;
  fit.rows = whole.rows;
  fit.unknowns = whole.unknowns;
  if (whole.noise) fit.noise = *whole.noise * part.residual_unit;
  fit.chi2_per_dof = whole.chi2_per_dof;
  fit.problem.noise = whole.problem.noise * part.residual_unit;
  return result;
}

int part_named(const Session& joined, const std::string& title) {
  std::string known;
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    if (joined.parts[p].title == title) return static_cast<int>(p);
    known += (known.empty() ? "" : ", ") + joined.parts[p].title;
  }
  throw InputError(known.empty()
                       ? message("--session {}: this is one session by itself; leave the option out.", title)
                       : message("--session {}: the collection has no such session; it has {}.", title, known));
}

}  // namespace handsight
