// SPDX-License-Identifier: Apache-2.0
// Correction, closed loop: a simulated robot with hidden effects and a curve, calibrated from 80 observations by
// improve, commanded to 200 targets as they are and corrected; by the core, by the exported C++ file and by the
// exported Python file. trial_correct COUNT [FIRST_SEED] [ROBOT] [KIND]: core; files: also by the files; told: as core,
// but the hidden effects and the curve's form are given to the fit, so that nothing has to be found; named: without
// a curve; given: without a curve, and as told; plausible: as given, and every number is drawn with just the size that
// the catalogue calls plausible (else each robot with 0.3 to 3 times that).
#include <fmt/format.h>

#include <cstdio>
#include <numeric>

#include "base/numbers.h"
#include "correct/correction.h"
#include "effects/own_effect.h"
#include "export/exported.h"
#include "fixtures/robots_with_everything.h"
#include "fixtures/trial_sessions.h"
#include "trials/table.h"

namespace handsight::trials {
namespace {

constexpr int targets = 200;

struct Hidden {
  Session session;
  std::vector<EffectTerm> effects;
  std::vector<Curve> curves;
  std::vector<Vector3> markers_in_tcp;
  Rigid tcp_from_body;  // by the sides that the fit has chosen
  std::vector<Eigen::VectorXd> poses;
};

/// Does the joint move hand against sensor? What moves both alike (a torso below head and arm) nobody can measure.
bool is_between(const Chain& chain, int joint) {
  return is_distal(chain.robot, joint, chain.tcp_link) != is_distal(chain.robot, joint, chain.mount_link);
}

/// Numbers of the size that the priors believe.
void draw_as_plausible(std::vector<EffectTerm>& terms, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      const EffectParameter& number = term_effect(t).parameters[p];
      const bool is_positive = t.id == "joint_elasticity";
      const double value = number.sigma * normal(random);
      if (!number.is_choice) t.values[p] = is_positive ? std::abs(value) : value;
    }
}

Hidden hidden_robot(int robot, std::uint64_t seed, const std::string& kind) {
  std::mt19937_64 random(seed * 9176 + 31 * static_cast<unsigned>(robot) + 7);
  const Session like = robot_session(robot, seed);
  const Chain chain = make_chain(like);
  Hidden h;
  for (const char* id : {"joint_offset", "joint_elasticity", "encoder_eccentricity"})
    for (const EffectTerm& t : random_terms(*find_effect(id), chain, random))
      if (is_between(chain, t.place)) h.effects.push_back(t);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  Curve curve;
  curve.joint = chain.joints[chain.joints.size() - 2 - random() % 3];
  curve.size = 1e-3 * uniform(random);
  curve.order = 2 + uniform(random);
  if (kind == "core" || kind == "files" || kind == "told") h.curves = {curve};
  if (kind == "plausible") draw_as_plausible(h.effects, random);
  SimulationOptions o = simulation(seed + 50000, robot);
  o.effects = h.effects;
  o.curves = h.curves;
  const SimulatedSession s = simulate_session(like, o);
  h.session = s.session;
  h.markers_in_tcp = s.markers_in_tcp;
  o.seed = seed + 90000;
  o.observations = targets;
  for (const Observation& observation : simulate_session(like, o).session.observations)
    h.poses.push_back(observation.position);
  return h;
}

/// Where the hand truly is, the body being where it is and TCP->Body as estimated: what can be observed of it.
Vector3 true_hand(const Hidden& h, const Chain& chain, const Eigen::VectorXd& commanded, const Rigid& tcp_from_body) {
  const ObservationState c = states_at(chain, commanded);
  const Rigid root_from_tcp = observed_ends(c, moved_sites(c, h.effects, h.curves)).ends.root_from_tcp;
  return (root_from_tcp * h.tcp_from_body * inverse(tcp_from_body)).translation;
}

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

double rms(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, v.size())));
}

/// Errors with what a file says to command; the largest difference to the core's joint angles.
void run_file(const Hidden& h, const CalibratedRobot& robot, const std::vector<Eigen::VectorXd>& by_core,
              const std::string& kind) {
  const TemporaryFolder folder;
  const auto file = folder.path / ("hand." + std::string(kind == "cpp" ? "cpp" : "py"));
  std::ofstream(file) << exported_file(robot, kind).text;
  std::string command = "python3 '" + file.string() + "' correct";
  if (kind == "cpp") {
    const std::string said = fixture::compiled(file, folder.path / "hand");
    if (!said.empty()) fmt::print("{}\n", said);
    command = "'" + (folder.path / "hand").string() + "' correct";
  }
  const std::vector<fixture::Answer> answers = fixture::answers(folder.path, command, h.poses);
  std::vector<double> after;
  double largest = 0;
  int reached = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(answers[i].numbers.data(),
                                                                static_cast<Eigen::Index>(answers[i].numbers.size()));
    reached += answers[i].word == "good";
    largest = std::max(largest, (q - by_core[i]).cwiseAbs().maxCoeff());
    const Vector3 wanted = predict_tcp(robot.chain, h.poses[i], robot.model).root_from_tcp.translation;
    after.push_back((true_hand(h, robot.chain, q, robot.model.tcp_from_body) - wanted).norm());
  }
  fmt::print("    by the {} file: {} of {} reached, median {:.4f} mm, angles as the core's to {:.1e} rad\n", kind,
             reached, answers.size(), 1e3 * median(after), largest);
}

/// The model and how it was fitted: found by improve, or that of the hidden effects.
struct Calibrated {
  Fit fit;
  FitOptions options;
  ModelUncertainty model_uncertainty = {};  // of what improve has found
};

/// The curve as an effect of which the form is known.
EffectTerm term_of_curve(const Session& session, const Curve& curve) {
  EffectDefinition d;
  d.id = d.title = "told_curve";
  d.parameters = {{"size", "rad", 1e-3}};
  d.moves = {{"angle", fmt::format("size*{}({}*q)", curve.cosine ? "cos" : "sin", format_number(curve.order))}};
  const auto effect = own_effect(d, session.robot);
  return term_of(*effect, curve.joint, effect);
}

Calibrated calibrated(const Hidden& h, bool is_given) {
  if (!is_given) {
    const Improvement improved = improve(h.session);
    return {improved.last.model.fit, improved.last.model_options, improved.inclusion_probabilities.model_uncertainty};
  }
  FitOptions options;
  options.estimated = h.effects;
  for (EffectTerm& t : options.estimated) std::fill(t.values.begin(), t.values.end(), 0);
  for (const Curve& curve : h.curves) options.estimated.push_back(term_of_curve(h.session, curve));
  return {fit(h.session, options), options};
}

int correct_trials(const Arguments& a, const TableOutput& output) {
  const bool is_given = a.kind == "told" || a.kind == "given" || a.kind == "plausible";
  std::vector<double> gains, ratios, squares, ratios_without, squares_without;
  for (int i = 0; i < a.count; ++i) {
    const int robot = a.robot >= 0 ? a.robot : i % 3;
    const std::uint64_t seed = a.first + static_cast<std::uint64_t>(i);
    Hidden h = hidden_robot(robot, seed, a.kind);
    const Calibrated found = calibrated(h, is_given);
    const Fit& f = found.fit;
    h.tcp_from_body = body_frame(f.sides, h.markers_in_tcp).tcp_from_body;
    const CalibratedRobot by_fit = calibrated_robot(h.session, f, report(h.session, f, found.options), found.options,
                                                    "trial", found.model_uncertainty);
    PredictionModel without_model_uncertainty = by_fit.model;
    without_model_uncertainty.model_uncertainty = {};
    std::vector<double> before, after, promised, promised_without;
    std::vector<Eigen::VectorXd> commanded;
    int reached = 0;
    for (const Eigen::VectorXd& pose : h.poses) {
      const ObservationState c = states_at(by_fit.chain, pose);
      const Correction correction = corrected(c, by_fit.model);
      const Vector3 wanted = observed_ends(c, {}).ends.root_from_tcp.translation;
      before.push_back((true_hand(h, by_fit.chain, pose, f.tcp_from_body) - wanted).norm());
      after.push_back((true_hand(h, by_fit.chain, correction.position, f.tcp_from_body) - wanted).norm());
      promised.push_back(correction.sigma_m);
      const ObservationState then = states_at(by_fit.chain, correction.position);
      promised_without.push_back(
          std::sqrt(predict_tcp(then, without_model_uncertainty).covariance.topLeftCorner<3, 3>().trace()));
      commanded.push_back(correction.position);
      reached += correction.reached;
    }
    gains.push_back(median(before) / median(after));
    ratios.push_back(rms(after) / rms(promised));
    squares.push_back(ratios.back() * ratios.back());
    ratios_without.push_back(rms(after) / rms(promised_without));
    squares_without.push_back(ratios_without.back() * ratios_without.back());
    fmt::print(
        "robot {} seed {}: {} of {} reached; hand off by {:.3f} mm as commanded, {:.4f} mm corrected (medians, {:.0f} "
        "times less); rms {:.4f} mm, promised {:.4f} mm ({:.2f} times; {:.2f} without doubt of the names)\n",
        robot, seed, reached, targets, 1e3 * median(before), 1e3 * median(after), gains.back(), 1e3 * rms(after),
        1e3 * rms(promised), ratios.back(), ratios_without.back());
    if (a.kind == "files")
      for (const char* kind : {"cpp", "python"}) run_file(h, by_fit, commanded, kind);
    std::fflush(stdout);
  }
  const auto within = [](const std::vector<double>& all) {
    return std::count_if(all.begin(), all.end(), [](double r) { return r <= 1.2; });
  };
  const auto mean = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  };
  fmt::print("{} robots: {:.0f} times less in the median\n", a.count, median(gains));
  const std::string command = fmt::format("`trial_correct {} {} {} {}`", a.count, a.first, a.robot, a.kind);
  Table table(
      {{.heading = "error over what sigma promises", .width = 64}, {"median", 2}, {"mean square", 2}, {"within 1.2"}},
      output);
  table.print({command, median(ratios), mean(squares), share_text(within(ratios), a.count)});
  table.print({command + ", without model uncertainty", median(ratios_without), mean(squares_without),
               share_text(within(ratios_without), a.count)});
  return 0;
}

}  // namespace
}  // namespace handsight::trials

int main(int argc, char** argv) {
  using namespace handsight::trials;
  const TableOutput output = take_table_output(argc, argv);
  return correct_trials(arguments(argc, argv, "core"), output);
}
