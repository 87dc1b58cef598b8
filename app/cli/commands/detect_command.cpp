// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "command.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"
#include "vision/markers/corner_pairs.h"

namespace handsight::cli {
namespace {

struct DetectArguments {
  std::string left, right, session;
  Output output;
};

Json corners_json(const std::vector<Corner>& corners) {
  Json list = Json::array();
  for (const Corner& c : corners)
    list.push_back({{"u", c.position.x()},
                    {"v", c.position.y()},
                    {"strength", c.strength},
                    {"contrast", c.contrast},
                    {"sigma_u", std::sqrt(c.covariance(0, 0))},
                    {"sigma_v", std::sqrt(c.covariance(1, 1))},
                    {"covariance", matrix(c.covariance)}});
  return list;
}

void print_corners(const Output& out, const char* name, const std::vector<Corner>& corners) {
  out.line(fmt::format("{}: {} corners", name, corners.size()));
  if (!corners.empty()) out.line("          u        v   sigma u  sigma v  contrast   strength");
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.line(fmt::format("{:>3} {:>8.3f} {:>8.3f}  {:>8.4f} {:>8.4f}  {:>8.1f} {:>10.4g}", i, corners[i].position.x(),
                         corners[i].position.y(), std::sqrt(corners[i].covariance(0, 0)),
                         std::sqrt(corners[i].covariance(1, 1)), corners[i].contrast, corners[i].strength));
}

int run(const DetectArguments& o) {
  note_input(o.left);
  note_input(o.right);
  const Session session = open_session(o.session, o.output);
  if (!session.rig) throw InputError("detect needs a session with cameras; this one has a tracker.");
  require_pair(session, "detect");
  const Image left_image = read_image(o.left, session.rig->at(0).camera, o.left),
              right_image = read_image(o.right, session.rig->at(1).camera, o.right);
  const std::vector<Corner> left = detect_corners(left_image), right = detect_corners(right_image);
  print_corners(o.output, "left", left);
  print_corners(o.output, "right", right);
  Json pairs = Json::array();
  o.output.line("pairs: left right  epipolar px      x        y        z m");
  for (const CornerPair& p : corner_pairs(make_stereo(*session.rig), left, right)) {
    o.output.line(fmt::format("       {:>4} {:>5}  {:>11.3f} {:>8.4f} {:>8.4f} {:>8.4f}", p.left, p.right,
                              p.point.epipolar_distance, p.point.point.x(), p.point.point.y(), p.point.point.z()));
    pairs.push_back({{"left", p.left},
                     {"right", p.right},
                     {"epipolar_distance_pixel", p.point.epipolar_distance},
                     {"point", numbers(p.point.point)},
                     {"covariance", matrix(p.point.covariance)}});
  }
  o.output.json({{"left", corners_json(left)}, {"right", corners_json(right)}, {"pairs", pairs}});
  return done;
}

}  // namespace

Command add_detect(const CommandLine& program) {
  auto options = std::make_shared<DetectArguments>();
  const CommandLine command = program.command("detect", "X-corners of both images and their epipolar pairs");
  command.option("LEFT", options->left, "Left image").required();
  command.option("RIGHT", options->right, "Right image").required();
  command.option("--session", options->session, "The session that has the cameras").required();
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
