// SPDX-License-Identifier: Apache-2.0
#include "compare/several_sides.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "compare/change_normal.h"

namespace handsight {
namespace {

/// The place of a name among those that came before; a new one, or none, is added.
int number_of(const std::string& name, std::vector<std::string>& known) {
  const auto found = name.empty() ? known.end() : std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<int>(found - known.begin());
  known.push_back(name);
  return static_cast<int>(known.size()) - 1;
}

bool is_of_rig(const Effect& e) {
  return e.scope == EffectScope::camera || e.id == "camera_mount" || e.id == "stereo_rig" ||
         e.id == "camera_intrinsics" || e.id == "lens_distortion";
}

bool is_of_body(const Effect& e) {
  return e.scope == EffectScope::marker || e.scope == EffectScope::tag || e.id == "payload" || e.id == "body_slip" ||
         e.id == "target_scale" || e.id == "target_bend";
}

bool is_of_session(const Effect& e) { return e.id == "mount_drift" || e.id == "mount_slip" || e.id == "time_lag"; }

/// What tells one common number from another: effect, place, parameter, and whose it is.
using NumberKey = std::tuple<std::string, int, std::size_t, Owner, int>;

/// Numbers the effects' columns of all sides through, anew. Of a wide model the columns that a side had before are
/// told.
void number_effects(SeveralSides& all) {
  all.effects.clear();
  std::map<NumberKey, Eigen::Index> known;
  for (std::size_t k = 0; k < all.sides.size(); ++k) {
    SeveralSide& side = all.sides[k];
    const std::size_t reported = side.effects.size();
    side.effects.clear();
    for (const EffectColumn& c : side.problem.columns_of_effects) {
      const EffectTerm& term = side.problem.terms[c.term];
      const Owner owner = find_owner(term_effect(term));
      const int whose = owner == Owner::session ? static_cast<int>(k) : side.number(owner);
      const auto [at, is_new] = known.emplace(NumberKey{term.id, term.place, c.parameter, owner, whose},
                                              static_cast<Eigen::Index>(all.effects.size()));
      if (is_new)
        all.effects.push_back({term.id, c.parameter, c.sigma, all.is_wide && side.effects.size() >= reported});
      side.effects.push_back(at->second);
    }
  }
}

/// Sessions with the same joints, TCP and mount.
void number_hands(SeveralSides& all) {
  int count = 0;
  for (std::size_t k = 0; k < all.sides.size(); ++k) {
    const Chain& chain = all.sides[k].problem.source->chain;
    const auto same =
        std::find_if(all.sides.begin(), all.sides.begin() + static_cast<std::ptrdiff_t>(k), [&](const SeveralSide& s) {
          const Chain& c = s.problem.source->chain;
          return c.joints == chain.joints && c.tcp_link == chain.tcp_link && c.mount_link == chain.mount_link;
        });
    const bool is_new = same == all.sides.begin() + static_cast<std::ptrdiff_t>(k);
    all.sides[k].hand = is_new ? count++ : same->hand;
  }
}

/// The curves of each kind of hand.
void add_curves(SeveralSides& all) {
  Eigen::Index next = 0;
  for (int hand = 0;; ++hand) {
    std::vector<const Problem*> problems;
    for (const SeveralSide& s : all.sides)
      if (s.hand == hand) problems.push_back(&s.problem);
    if (problems.empty()) break;
    const std::vector<SharedCurve> curves = shared_curves(problems);
    for (SeveralSide& s : all.sides)
      if (s.hand == hand) {
        s.curves = curves;
        s.first_curve = next;
      }
    next += column_count(curves);
  }
  all.start.curves = Eigen::VectorXd::Zero(next);
  all.curve_scales = Eigen::VectorXd::Ones(next);
}

/// Of what is lacking, those of one name.
std::vector<SizeGroup> effect_groups(const SeveralSides& all) {
  std::map<NumberName, std::vector<Eigen::Index>> columns;
  for (std::size_t c = 0; c < all.effects.size(); ++c)
    if (all.effects[c].is_lacking)
      columns[{all.effects[c].id, all.effects[c].parameter}].push_back(static_cast<Eigen::Index>(c));
  return size_groups(columns);
}

std::vector<SizeGroup> curve_groups(const SeveralSides& all) {
  std::vector<SizeGroup> list;
  std::vector<Eigen::Index> done;
  for (const SeveralSide& s : all.sides) {
    if (std::find(done.begin(), done.end(), s.hand) != done.end()) continue;
    done.push_back(s.hand);
    add_groups(s.curves, s.first_curve, list);
  }
  return list;
}

Eigen::VectorXd in_sizes(const SeveralSides& all, const Eigen::VectorXd& effects) {
  Eigen::VectorXd values = effects;
  for (Eigen::Index c = 0; c < values.size(); ++c) values[c] /= all.effects[static_cast<std::size_t>(c)].size;
  return values;
}

}  // namespace

Owner find_owner(const Effect& e) {
  return is_of_rig(e) ? Owner::rig : is_of_body(e) ? Owner::body : is_of_session(e) ? Owner::session : Owner::robot;
}

Eigen::Index SeveralSides::first_marker(int body) const {
  Eigen::Index column = 0;
  for (int b = 0; b < body; ++b)
    column += 3 * static_cast<Eigen::Index>(start.markers[static_cast<std::size_t>(b)].size());
  return column;
}

Eigen::Index SeveralSides::first_mount(int rig) const {
  Eigen::Index column = first_marker(static_cast<int>(start.markers.size()));
  for (int r = 0; r < rig; ++r) column += mount_is_estimated[static_cast<std::size_t>(r)] ? 6 : 0;
  return column;
}

Eigen::Index SeveralSides::first_effect() const { return first_mount(static_cast<int>(mount_is_estimated.size())); }

Eigen::Index SeveralSides::columns() const {
  return first_effect() + static_cast<Eigen::Index>(effects.size()) + curve_scales.size();
}

SeveralSides several_sides(const std::vector<JoinedMember>& members, const std::vector<Fit>& fits) {
  SeveralSides all;
  std::vector<std::string> rigs, bodies;
  for (std::size_t k = 0; k < members.size(); ++k) {
    SeveralSide side{make_side(fits[k])};
    const Unknowns found = estimate(fits[k]);
    const std::size_t known_rigs = rigs.size(), known_bodies = bodies.size();
    side.rig = number_of(members[k].rig, rigs);
    side.body = number_of(members[k].body, bodies);
    if (rigs.size() > known_rigs) {
      all.start.mounts.push_back(found.mount_from_sensor);
      all.mount_is_estimated.push_back(side.problem.mount_is_estimated ? 1 : 0);
    }
    if (bodies.size() > known_bodies) all.start.markers.push_back(found.markers_in_tcp);
    all.sides.push_back(std::move(side));
  }
  number_hands(all);
  number_effects(all);
  all.start.effects = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.effects.size()));
  for (std::size_t k = members.size(); k-- > 0;)  // of the first that has it
    all.start.effects(all.sides[k].effects) = effect_values(all.sides[k].problem);
  all.effect_scales = Eigen::VectorXd::Ones(all.start.effects.size());
  all.repeatability.assign(rigs.size(), Matrix6::Zero());
  return all;
}

SeveralSides widened(const SeveralSides& sides, Width width) {
  SeveralSides wide = sides;
  if (width == Width::reported) return wide;
  wide.is_wide = true;
  for (SeveralSide& s : wide.sides) s.problem = with_lacking(s.problem, lacking_effects(s.problem));
  number_effects(wide);
  const auto count = static_cast<Eigen::Index>(wide.effects.size());
  wide.start.effects = Eigen::VectorXd::Zero(count);
  for (std::size_t k = wide.sides.size(); k-- > 0;)
    wide.start.effects(wide.sides[k].effects) = effect_values(wide.sides[k].problem);
  wide.effect_scales = Eigen::VectorXd::Ones(count);
  if (width == Width::catalogue_and_curves) add_curves(wide);
  return wide;
}

std::vector<ColumnPlace> list_columns(const SeveralSides& all, const SeveralSide& side) {
  std::vector<ColumnPlace> columns;
  const auto add = [&](Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index c = 0; c < count; ++c) columns.push_back({first + c, 1});
  };
  add(all.first_marker(side.body), 3 * side.problem.marker_count);
  if (side.problem.mount_is_estimated) add(all.first_mount(side.rig), 6);
  for (std::size_t e = 0; e < side.effects.size(); ++e) {
    const double own = side.problem.columns_of_effects[e].sigma;
    const double common = all.effects[static_cast<std::size_t>(side.effects[e])].size;
    columns.push_back({all.first_effect() + side.effects[e], common / own});
  }
  const auto effects = static_cast<Eigen::Index>(all.effects.size());
  add(all.first_effect() + effects + side.first_curve, column_count(side.curves));
  return columns;
}

SharedState read_state(const SeveralSide& side, const SeveralState& state) {
  SharedState own;
  own.unknowns.markers_in_tcp = state.markers[static_cast<std::size_t>(side.body)];
  own.unknowns.mount_from_sensor = state.mounts[static_cast<std::size_t>(side.rig)];
  own.unknowns.effects = state.effects(side.effects);
  own.curves = state.curves.segment(side.first_curve, column_count(side.curves));
  return own;
}

SeveralState moved_by(const SeveralSides& all, const SeveralState& from, const Eigen::VectorXd& step) {
  SeveralState to = from;
  Eigen::Index at = 0;
  for (auto& body : to.markers)
    for (Vector3& m : body) {
      m += step.segment<3>(at);
      at += 3;
    }
  for (std::size_t r = 0; r < to.mounts.size(); ++r) {
    if (!all.mount_is_estimated[r]) continue;
    to.mounts[r] = from.mounts[r] * small_motion<double>(Vector6(step.segment<6>(at)));
    at += 6;
  }
  for (Eigen::Index c = 0; c < to.effects.size(); ++c)
    to.effects[c] += step[at + c] * all.effects[static_cast<std::size_t>(c)].size;
  to.curves += step.segment(at + to.effects.size(), to.curves.size());
  return to;
}

void add_priors(const SeveralSides& all, const SeveralState& state, ScatteredNormal& n) {
  const Eigen::VectorXd values = in_sizes(all, state.effects);
  const Eigen::Index first = all.first_effect();
  for (Eigen::Index c = 0; c < values.size(); ++c) add_prior(n, first + c, values[c], all.effect_scales[c]);
  for (Eigen::Index c = 0; c < state.curves.size(); ++c)
    add_prior(n, first + values.size() + c, state.curves[c], all.curve_scales[c]);
}

void learn_sizes(SeveralSides& all, const SeveralState& state, const ScatteredNormal& n) {
  if (!all.is_wide) return;
  learn_scales({all.first_effect(), in_sizes(all, state.effects), state.curves}, n, effect_groups(all),
               curve_groups(all), all.effect_scales, all.curve_scales);
}

}  // namespace handsight
