// SPDX-License-Identifier: Apache-2.0
#include "certify/certificate.h"

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/median.h"
#include "base/sha256.h"
#include "base/utc_now.h"

namespace handsight {
namespace {

constexpr int map_poses = 1500;

ErrorFigures figures(const std::vector<AttainedPose>& poses, Rigid AttainedPose::*which) {
  ErrorFigures f;
  std::vector<double> lengths, turns;
  for (const AttainedPose& p : poses) {
    lengths.push_back(((p.*which).translation - p.commanded.translation).norm());
    if (p.shows_turn)
      turns.push_back(vector_from_rotation((p.*which).rotation * p.commanded.rotation.transpose()).norm());
  }
  if (lengths.empty()) return f;
  std::sort(lengths.begin(), lengths.end());
  const auto rms = [](const std::vector<double>& values) {
    double squares = 0;
    for (const double v : values) squares += v * v;
    return std::sqrt(squares / static_cast<double>(values.size()));
  };
  for (const double l : lengths) f.mean += l / static_cast<double>(lengths.size());
  f.rms = rms(lengths);
  f.largest = lengths.back();
  f.p95 = lengths[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(lengths.size()))) - 1];
  if (turns.empty()) return f;
  f.rms_turn = rms(turns);
  f.largest_turn = *std::max_element(turns.begin(), turns.end());
  return f;
}

void set_coverage(Certificate& c) {
  std::vector<double> limits;
  for (const AttainedPose& p : c.poses) {
    limits.push_back(length_limit(p.covariance, 0.95));
    c.coverage.inside += (p.after.translation - p.commanded.translation).norm() <= limits.back();
    ++c.coverage.all;
  }
  c.coverage.interval = clopper_pearson(c.coverage.inside, c.coverage.all, 0.95);
  if (!limits.empty()) c.median_limit = median(std::move(limits));
}

void add_file(const std::string& what, const std::filesystem::path& file, Certificate& c) {
  std::error_code error;
  if (file.empty() || !std::filesystem::is_regular_file(file, error)) return;
  const std::string bytes = read_file(file);
  c.files.push_back({what, file.filename().string(), bytes.size(), sha256(bytes)});
}

/// Of all images together: the digest of the lines "DIGEST NAME", in order of observation and camera.
void add_images(const Session& session, Certificate& c) {
  std::string lines;
  std::uint64_t bytes = 0;
  int count = 0;
  for (const Observation& o : session.observations)
    for (const std::string& image : o.images) {
      std::error_code error;
      if (image.empty() || !std::filesystem::is_regular_file(folder(session) / image, error)) continue;
      const std::string content = read_file(folder(session) / image);
      lines += sha256(content) + "  " + image + "\n";
      bytes += content.size();
      ++count;
    }
  if (count > 0) c.files.push_back({"images", fmt::format("{} files, by their digests", count), bytes, sha256(lines)});
}

std::string make_title(const Session& session) {
  if (!session.title.empty()) return session.title;
  return std::filesystem::absolute(session.file).parent_path().filename().string();
}

}  // namespace

std::string sensor_text(const Session& session) {
  if (session.pose_sensor) return "a pose sensor on " + session.mount.link;
  if (!session.rig)
    return session.sigma_point ? fmt::format("a 3D measuring device on {}, sigma {:.3g} mm", session.mount.link,
                                             1e3 * *session.sigma_point)
                               : "a 3D measuring device on " + session.mount.link;
  const Camera& first = session.rig->at(0).camera;
  return fmt::format("{} camera{} of {} x {} pixels on {}", session.rig->count(), session.rig->count() > 1 ? "s" : "",
                     first.width, first.height, session.mount.link);
}

Certificate make_certificate(const Session& session, const CertificateRequest& request,
                             const std::function<bool(double done)>& goes_on) {
  Certificate c;
  c.date = utc_now();
  c.software = request.software;
  c.title = make_title(session);
  c.robot = session.robot.name;
  c.hand = request.chain.robot.links[static_cast<std::size_t>(request.chain.tcp_link)].name;
  c.sensor = sensor_text(session);
  c.model_from = request.model_from;
  c.joints = static_cast<int>(session.joints.size());
  c.observations = static_cast<int>(session.observations.size());
  c.effects = request.effects;
  AttainedPoses attained =
      attained_poses(session, request.model, [&](double done) { return !goes_on || goes_on(0.8 * done); });
  c.folds = attained.folds;
  c.shown_nothing = attained.shown_nothing;
  c.used = static_cast<int>(attained.all.size()) + attained.shown_nothing;
  if (attained.all.empty())
    throw InputError(
        "No observation shows where the hand was: three markers, or points of a tracker, are needed for a "
        "certificate.");
  c.iso = iso_test(session, attained);
  c.poses = std::move(attained.all);
  c.before = figures(c.poses, &AttainedPose::before);
  c.after = figures(c.poses, &AttainedPose::after);
  set_coverage(c);
  std::vector<Eigen::VectorXd> positions;
  for (const AttainedPose& p : c.poses)
    positions.push_back(session.observations[static_cast<std::size_t>(p.index)].position);
  if (goes_on && !goes_on(0.8)) c.is_stopped = true;
  if (!c.is_stopped) c.expected = expected_errors(request.chain, request.prediction, positions, map_poses, 1);
  add_file("session", session.file, c);
  add_file("robot", session.robot_file.empty() ? std::filesystem::path() : folder(session) / session.robot_file, c);
  add_file("effects", folder(session) / "effects.xml", c);
  add_file("calibration", request.calibration, c);
  add_images(session, c);
  return c;
}

}  // namespace handsight
