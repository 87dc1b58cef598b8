// SPDX-License-Identifier: Apache-2.0
// A rendered session from its first label to its last observation, compared with its truth: which observations were
// taken, and was any marker put on a wrong corner? Usage: trial_tracking SESSION (a folder with truth.xml).
#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <set>

#include "base/numbers.h"
#include "estimation/online/online.h"
#include "session/session_xml.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"
#include "vision/markers/first_observation.h"

namespace handsight {
namespace {

struct Truth {
  std::vector<Vector3> markers_in_tcp;
  Rigid mount_from_sensor;
  std::vector<EffectTerm> effects;
  std::set<std::int64_t> disturbed;
};

Vector3 three(const char* text) {
  const auto n = parse_numbers(text);
  return {n->at(0), n->at(1), n->at(2)};
}

Truth read_truth(const std::filesystem::path& file, const Robot& robot) {
  tinyxml2::XMLDocument document;
  document.LoadFile(file.c_str());
  const tinyxml2::XMLElement* root = document.RootElement();
  Truth truth;
  for (auto* m = root->FirstChildElement("markers_in_tcp")->FirstChildElement(); m; m = m->NextSiblingElement())
    truth.markers_in_tcp.push_back(three(m->Attribute("xyz")));
  const auto* mount = root->FirstChildElement("mount_from_sensor");
  truth.mount_from_sensor = {rotation_from_rpy(three(mount->Attribute("rpy"))), three(mount->Attribute("xyz"))};
  for (auto* e = root->FirstChildElement("effects")->FirstChildElement(); e; e = e->NextSiblingElement())
    for (auto* p = e->FirstChildElement(); p; p = p->NextSiblingElement())
      add_effect_value(fmt::format("{}:{}.{}={}", e->Attribute("id"), p->Attribute("of"), p->Attribute("name"),
                                   p->Attribute("value")),
                       robot, truth.effects);
  for (auto* d = root->FirstChildElement("disturbance"); d; d = d->NextSiblingElement("disturbance"))
    truth.disturbed.insert(d->Int64Attribute("observation"));
  return truth;
}

/// px, from where the marker truly is; the largest of all images.
double corner_error(const Session& session, const Rigid& left_from_tcp, const Vector3& marker, const Sighting& s) {
  const Vector3 x = left_from_tcp * marker;
  double worst = 0;
  for (const CameraPoint& seen : s.in_cameras) {
    const RigCamera& c = session.rig->at(seen.camera);
    worst = std::max(worst, (seen.pixel - project(c.camera, Vector3(c.camera_from_first * x))).norm());
  }
  return worst;
}

int run(const std::filesystem::path& path) {
  Session session = read_session(path);
  const Chain chain = make_chain(session);
  const Truth truth = read_truth(folder(session) / "truth.xml", session.robot);
  auto left_from_tcp = [&](const Observation& o) {
    const ObservationState c = states_at(chain, o.position);
    return sensor_from_tcp(observed_ends(c, moved_sites(c, truth.effects)).ends, truth.mount_from_sensor);
  };
  auto list_images = [&](const Observation& o) {
    return ImagePair{read_image(folder(session) / o.images[0]), read_image(folder(session) / o.images[1])};
  };

  Observation& first = session.observations[0];
  const ImagePair first_images = list_images(first);
  std::vector<Vector2> pointed;
  for (const Vector3& m : truth.markers_in_tcp)
    pointed.push_back(project(session.rig->at(0).camera, left_from_tcp(first) * m) + Vector2(2, -1));
  const FirstLabels labels = label_first(make_stereo(*session.rig), detect_corners(first_images.left),
                                         detect_corners(first_images.right), pointed);
  if (!labels.refusal.empty()) {
    fmt::print("first observation: {}\n", labels.refusal);
    return 1;
  }
  for (std::size_t m = 0; m < labels.markers.size(); ++m)
    first.sightings.push_back(
        seen_at(static_cast<int>(m), labels.markers[m].left, labels.markers[m].right, MarkedBy::hand));

  OnlineCalibration online(session);
  int taken = 0, wrong = 0, with_images = 0, missed = 0, bad_taken = 0, by_one_camera = 0;
  double squares = 0, milliseconds = 0;
  int corners = 0;
  for (std::size_t k = 0; k < session.observations.size(); ++k) {
    const Observation& o = session.observations[k];
    const bool has_images = k > 0 && !o.images[0].empty();
    const auto images = has_images ? std::optional(list_images(o)) : std::nullopt;
    const OnlineStep step = online.add(o, images ? &*images : nullptr);
    const bool bad = truth.disturbed.count(o.id) > 0;
    taken += step.accepted ? 1 : 0;
    bad_taken += step.accepted && bad ? 1 : 0;
    missed += !step.accepted && !bad ? 1 : 0;
    if (!step.accepted) fmt::print("{:>4} rejected{}: {}\n", o.id, bad ? " (disturbed)" : " (GOOD)", step.reason);
    if (!has_images) continue;
    ++with_images;
    milliseconds += step.milliseconds;
    for (const Sighting& s : step.sightings) {
      if (bad || !step.accepted) continue;
      const double error =
          corner_error(session, left_from_tcp(o), truth.markers_in_tcp[static_cast<std::size_t>(s.marker)], s);
      wrong += error > 1.5 ? 1 : 0;
      by_one_camera += s.in_cameras.size() > 1 ? 0 : 1;
      squares += error * error;
      ++corners;
    }
  }
  fmt::print("{} observations, {} with images: {} taken, {} good ones rejected, {} of {} disturbed ones taken\n",
             session.observations.size(), with_images, taken, missed, bad_taken, truth.disturbed.size());
  fmt::print(
      "{} markers found, {} on a wrong corner, {} by one camera only; corner error {:.3f} px rms (worse image of each "
      "pair); {:.2f} ms an observation\n",
      corners, wrong, by_one_camera, std::sqrt(squares / std::max(corners, 1)),
      milliseconds / std::max(with_images, 1));
  return wrong == 0 && missed == 0 && bad_taken == 0 ? 0 : 1;
}

}  // namespace
}  // namespace handsight

int main(int argc, char** argv) {
  try {
    return handsight::run(argc > 1 ? argv[1] : HANDSIGHT_SOURCE_DIR "/sample_sessions/first_steps");
  } catch (const handsight::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
