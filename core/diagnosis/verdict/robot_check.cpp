// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/robot_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/verdict/robot_readings.h"
#include "effects/units.h"

namespace handsight {
namespace {

/// Symbols of a joint's axes mean nothing to who reads a sentence.
std::string in_words(const std::string& name) {
  if (name == "tu") return "shift across, u,";
  if (name == "tw") return "shift across, w,";
  if (name == "ru") return "tilt about u";
  if (name == "rw") return "tilt about w";
  return name;
}

/// What would be read with these effects in the model; nothing where it cannot be worked out.
using Reading = std::function<ReadValue(const Terms&)>;

constexpr std::size_t most_poses = 50;  // looked at for the one in which it shows most
constexpr double least_shown = 1e-7;    // rad, m, kg, px: less would not show at all

/// A number of the candidate that is no choice.
struct Number {
  std::size_t term, parameter;
};

std::vector<Number> list_numbers(const Terms& terms) {
  std::vector<Number> numbers;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Effect& effect = term_effect(terms[t]);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice) numbers.push_back({t, p});
  }
  return numbers;
}

Terms joined(Terms all, const Terms& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The candidate's part of a reading: along its own direction, so that a length stays a length.
struct Part {
  double value = 0, sigma = 0;
};

ReadValue take_part(const Reading& reading, const Terms& model, const Terms& candidate) {
  const auto without = reading(model), with = reading(joined(model, candidate));
  if (!without || !with) return std::nullopt;
  return Eigen::VectorXd(*with - *without);
}

double measure_size(const Eigen::VectorXd& part) { return part.norm(); }

std::optional<Part> predicted(const Reading& reading, const Terms& model, const DiagnosisCandidate& c) {
  const auto part = take_part(reading, model, c.terms);
  if (!part || measure_size(*part) < least_shown) return std::nullopt;
  const Eigen::VectorXd direction = part->size() == 1 ? Eigen::VectorXd::Ones(1) : Eigen::VectorXd(part->normalized());
  const std::vector<Number> numbers = list_numbers(c.terms);
  Eigen::VectorXd by_number = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [t, p] = numbers[i];
    const double step = 1e-2 * term_effect(c.terms[t]).parameters[p].sigma;
    Terms up = c.terms, down = c.terms;
    up[t].values[p] += step;
    down[t].values[p] -= step;
    const auto above = reading(joined(model, up)), below = reading(joined(model, down));
    if (!above || !below) return std::nullopt;
    by_number[static_cast<Eigen::Index>(i)] = direction.dot(*above - *below) / (2 * step);
  }
  return Part{direction.dot(*part), std::sqrt(std::max(by_number.dot(c.covariance * by_number), 0.0))};
}

/// One marker of one observation, where the fit has it.
struct FittedPoint {
  const ProblemObservation* observation;
  int marker;
  Vector3 x_in_sensor;
};

std::vector<FittedPoint> fitted_points(const Fit& fit) {
  std::vector<FittedPoint> points;
  if (!fit.problem.rig) return points;
  for (const ProblemObservation& o : fit.problem.observations)
    for (const Sighting& s : o.sightings)
      if (static_cast<int>(s.in_cameras.size()) == fit.problem.rig->count() || s.in_cameras.size() > 2)
        points.push_back({&o, s.marker, sensor_from_tcp_at(o, estimate(fit)) * marker_at(o, estimate(fit), s.marker)});
  return points;
}

class Prediction {
 public:
  Prediction(const Diagnosis& d, const DiagnosisCandidate& c)
      : d_(d), c_(c), fit_(d.model.fit), model_(list_terms(fit_)), chain_(fit_.problem.source->chain) {}

  std::optional<CheckPrediction> make() const {
    switch (term_effect(c_.terms.front()).check_reads) {
      case CheckReads::number:
        return own_number();
      case CheckReads::drop:
        return in_a_pose("Hang 1 kg on the hand: it should sag", "further", drop);
      case CheckReads::turn:
        return turn();
      case CheckReads::two_sides:
        return in_a_pose("The hand moves by", "from one side to the other", between_sides);
      case CheckReads::start_to_end:
        return in_a_pose(
            "The hand moves by", "from the start of the session to its end",
            [this](const ObservationState& c, const Terms& t) { return from_start_to_end(c, t, mount()); });
      case CheckReads::place:
        return in_a_pose(
            "The hand is", "beside where the model has it",
            [this](const ObservationState& c, const Terms& t) { return hand_in_sensor(c, t, mount()); }, false);
      case CheckReads::epipolar:
        return in_the_images("off the epipolar line", [](const Rig& nominal, const Rig& rig, const Vector3& x) {
          return off_epipolar_line(nominal, rig, x);
        });
      case CheckReads::image:
        return in_the_images("from where the calibration has them",
                             [](const Rig&, const Rig& rig, const Vector3& x) { return image_points(rig, x); });
    }
    return std::nullopt;
  }

 private:
  const Rigid& mount() const { return estimate(fit_).mount_from_sensor; }

  /// The surest of those that are of the first one's kind.
  std::optional<CheckPrediction> own_number() const {
    const std::vector<Number> numbers = list_numbers(c_.terms);
    const Effect& effect = term_effect(c_.terms.front());
    std::optional<std::size_t> best;
    const auto value = [&](std::size_t i) { return c_.terms[numbers[i].term].values[numbers[i].parameter]; };
    const auto sigma = [&](std::size_t i) {
      return std::sqrt(std::max(c_.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)), 0.0));
    };
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (effect.parameters[numbers[i].parameter].unit != effect.parameters.front().unit) continue;
      if (!best || std::abs(value(i)) * sigma(*best) > std::abs(value(*best)) * sigma(i)) best = i;
    }
    if (!best) return std::nullopt;
    const EffectParameter& p = effect.parameters[numbers[*best].parameter];
    const std::string place = place_name(effect, c_.terms[numbers[*best].term].place, chain_.robot);
    return CheckPrediction{message("The {}{} differs by", looked_up(in_words(p.name)),
                                   place.empty() ? Message() : message(" of {}", place)),
                           "from the model's",
                           value(*best),
                           sigma(*best),
                           unit_at(effect, numbers[*best].parameter, c_.terms[numbers[*best].term].place, chain_.robot),
                           std::nullopt};
  }

  /// At the hand, in the pose in which the candidate shows most.
  template <class Read>
  std::optional<CheckPrediction> in_a_pose(const char* before, const char* after, const Read& read,
                                           bool is_at_rest = true) const {
    const auto& observations = fit_.problem.observations;
    const std::size_t stride = observations.size() / most_poses + 1;
    const auto reading_at = [&](std::size_t i) -> Reading {
      const ObservationState& seen = fit_.problem.source->states[static_cast<std::size_t>(observations[i].index)];
      return [c = is_at_rest ? at_rest(seen) : seen, &read](const Terms& terms) { return read(c, terms); };
    };
    double most = 0;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < observations.size(); i += stride)
      if (const auto part = take_part(reading_at(i), model_, c_.terms); part && measure_size(*part) > most) {
        most = measure_size(*part);
        best = i;
      }
    const auto part = best ? predicted(reading_at(*best), model_, c_) : std::nullopt;
    if (!part) return std::nullopt;
    const std::int64_t id = find_id(observations[*best]);
    return CheckPrediction{before, message("{} (pose {})", after, id), part->value, part->sigma, "m", id};
  }

  /// Between the two angles, of those that the session has seen, that the candidate parts most.
  std::optional<CheckPrediction> turn() const {
    double most = 0;
    std::optional<CheckPrediction> best;
    for (const EffectTerm& term : c_.terms) {
      const auto [from, to] = most_parted(term, seen_range(term.place));
      const Reading reading = [&, joint = term.place, low = from, high = to](const Terms& terms) -> ReadValue {
        return Eigen::VectorXd::Constant(
            1, angle_error(any_pose(), terms, joint, high) - angle_error(any_pose(), terms, joint, low));
      };
      const auto part = predicted(reading, model_, c_);
      if (!part || std::abs(part->value) <= most) continue;
      most = std::abs(part->value);
      const Joint& j = chain_.robot.joints[static_cast<std::size_t>(term.place)];
      const bool slides = j.kind == JointKind::prismatic;
      constexpr double degrees = 57.29577951308232;
      best = CheckPrediction{
          slides ? message("{}, moved from {:.0f} to {:.0f} mm, moves", j.name, 1e3 * from, 1e3 * to)
                 : message("{}, turned from {:.0f} to {:.0f} degrees, turns", j.name, degrees * from, degrees * to),
          "further than it reads",
          part->value,
          part->sigma,
          slides ? "m" : "rad",
          std::nullopt};
    }
    return best;
  }

  const ObservationState& any_pose() const { return fit_.problem.source->states.front(); }

  std::pair<double, double> seen_range(int joint) const {
    double low = 1e300, high = -1e300;
    for (const ProblemObservation& o : fit_.problem.observations) {
      const double q = fit_.problem.source->states[static_cast<std::size_t>(o.index)].sensor[joint];
      low = std::min(low, q);
      high = std::max(high, q);
    }
    return {low, high};
  }

  std::pair<double, double> most_parted(const EffectTerm& term, std::pair<double, double> range) const {
    constexpr int steps = 48;
    double least = 1e300, most = -1e300, at_least = 0, at_most = 0;
    for (int i = 0; i <= steps; ++i) {
      const double q = range.first + (range.second - range.first) * i / steps;
      const double error = angle_error(any_pose(), {term}, term.place, q);
      if (error < least) least = error, at_least = q;
      if (error > most) most = error, at_most = q;
    }
    return std::minmax(at_least, at_most);
  }

  template <class Read>
  std::optional<CheckPrediction> in_the_images(const char* after, const Read& read) const {
    const Rig* rig = chain_.rig ? &*chain_.rig : nullptr;
    if (!rig) return std::nullopt;
    const std::vector<FittedPoint> points = fitted_points(fit_);
    const std::size_t stride = points.size() / most_poses + 1;
    const auto reading_at = [&](const FittedPoint& point) -> Reading {
      const ObservationState& c = fit_.problem.source->states[static_cast<std::size_t>(point.observation->index)];
      return [&c, rig, x = point.x_in_sensor, &read](const Terms& terms) -> ReadValue {
        return read(*rig, moved_rig(*rig, moved_sites(c, terms)), x);
      };
    };
    double most = 0;
    const FittedPoint* best = nullptr;
    for (std::size_t i = 0; i < points.size(); i += stride)
      if (const auto part = take_part(reading_at(points[i]), model_, c_.terms); part && measure_size(*part) > most) {
        most = measure_size(*part);
        best = &points[i];
      }
    const auto part = best ? predicted(reading_at(*best), model_, c_) : std::nullopt;
    if (!part) return std::nullopt;
    const std::int64_t id = find_id(*best->observation);
    return CheckPrediction{message("Where marker {} is in observation {}, matched points lie", best->marker, id),
                           after,
                           part->value,
                           part->sigma,
                           "px",
                           id};
  }

  std::int64_t find_id(const ProblemObservation& o) const {
    return d_.model.session.observations[static_cast<std::size_t>(o.index)].id;
  }

  const Diagnosis& d_;
  const DiagnosisCandidate& c_;
  const Fit& fit_;
  Terms model_;
  const Chain& chain_;
};

}  // namespace

std::optional<CheckPrediction> predicted_check(const Diagnosis& model, const DiagnosisCandidate& candidate) {
  if (candidate.unnamed || candidate.terms.empty() || model.model.fit.problem.observations.empty()) return std::nullopt;
  if (candidate.covariance.rows() != static_cast<Eigen::Index>(list_numbers(candidate.terms).size()))
    return std::nullopt;
  return Prediction(model, candidate).make();
}

}  // namespace handsight
