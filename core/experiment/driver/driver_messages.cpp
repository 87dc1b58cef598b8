// SPDX-License-Identifier: Apache-2.0
#include "experiment/driver/driver_messages.h"

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace handsight {
namespace {

using Json = nlohmann::json;

[[noreturn]] void bad(const std::string& line, const Message& what) {
  throw DriverFault(message("The driver answered {}, which {}; the experiment stops.", in_quotes(line, 120), what));
}

Json object_of(const std::string& line) {
  Json answer = Json::parse(line, nullptr, false);
  if (answer.is_discarded()) bad(line, "is no JSON");
  if (!answer.is_object()) bad(line, "is no JSON object");
  return answer;
}

Json list_of(const Eigen::VectorXd& v) { return std::vector<double>(v.data(), v.data() + v.size()); }

double number_in(const Json& value, const std::string& line, const char* key, const Bounds& within) {
  if (!value.is_number() || !within.hold(value.get<double>()))
    bad(line, message("has in \"{}\" something else than numbers from {} to {}", verbatim(key), within.lowest,
                      within.highest));
  return value.get<double>();
}

std::vector<double> numbers_in(const Json& list, const std::string& line, const char* key, const Bounds& within) {
  if (!list.is_array()) bad(line, message("has in \"{}\" something else than a list of numbers", verbatim(key)));
  std::vector<double> numbers;
  for (const Json& one : list) numbers.push_back(number_in(one, line, key, within));
  return numbers;
}

Eigen::VectorXd vector_in(const Json& list, const std::string& line, const char* key, std::size_t count,
                          const Bounds& within) {
  const std::vector<double> numbers = numbers_in(list, line, key, within);
  if (numbers.size() != count)
    bad(line, message("has {} numbers in \"{}\", expected {}", numbers.size(), verbatim(key), count));
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(count));
}

std::string text_in(const Json& answer, const std::string& line, const char* key) {
  if (!answer.contains(key) || !answer[key].is_string()) bad(line, message("has no text in \"{}\"", verbatim(key)));
  return answer[key].get<std::string>();
}

std::vector<std::string> texts_in(const Json& answer, const std::string& line, const char* key) {
  if (!answer.contains(key) || !answer[key].is_array()) bad(line, message("has no list in \"{}\"", verbatim(key)));
  std::vector<std::string> texts;
  for (const Json& one : answer[key]) {
    if (!one.is_string()) bad(line, message("has in \"{}\" something else than texts", verbatim(key)));
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

/// Whether the answer says that it went well; else its reason in `why`.
bool is_ok(const Json& answer, const std::string& line, Message& why) {
  if (!answer.contains("ok") || !answer["ok"].is_boolean()) bad(line, "says in \"ok\" neither true nor false");
  if (answer["ok"].get<bool>()) return true;
  why = verbatim(shortened(text_in(answer, line, "why"), 200));
  return false;
}

Rigid pose_in(const Json& pose, const std::string& line) {
  if (!pose.is_object() || !pose.contains("xyz")) bad(line, "has a target_pose without \"xyz\"");
  Rigid rigid;
  rigid.translation = vector_in(pose["xyz"], line, "xyz", 3, bounds::length);
  if (pose.contains("quaternion")) {
    const Eigen::VectorXd q = vector_in(pose["quaternion"], line, "quaternion", 4, bounds::joint);
    if (!(q.norm() > 0.5 && q.norm() < 2)) bad(line, "has a quaternion whose length is not 1");
    rigid.rotation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  } else if (pose.contains("rpy")) {
    rigid.rotation = rotation_from_rpy(vector_in(pose["rpy"], line, "rpy", 3, bounds::joint));
  } else {
    bad(line, "has a target_pose without \"quaternion\" (x y z w) or \"rpy\"");
  }
  return rigid;
}

void read_points(const Json& points, const std::string& line, int markers, LookAnswer& look) {
  if (!points.is_array() || points.size() > static_cast<std::size_t>(markers))
    bad(line, message("has in \"points\" no list of at most {} points", markers));
  for (std::size_t m = 0; m < points.size(); ++m) {
    if (points[m].is_null()) continue;  // not seen
    Sighting sighting{.marker = static_cast<int>(m)};
    sighting.point = vector_in(points[m], line, "points", 3, bounds::length);
    look.sightings.push_back(sighting);
  }
}

void read_markers(const Json& list, const std::string& line, const Rig* rig, int markers, LookAnswer& look) {
  if (!rig || !list.is_array()) bad(line, "has \"markers\", which only the cameras of a session see");
  int last = -1;
  for (const Json& one : list) {
    if (!one.is_object() || !one.contains("index") || !one["index"].is_number_integer())
      bad(line, "has a marker without \"index\"");
    Sighting sighting{.marker = one["index"].get<int>()};
    if (sighting.marker <= last || sighting.marker >= markers)
      bad(line, message("has marker {}, expected ascending numbers from 0 to {}", sighting.marker, markers - 1));
    last = sighting.marker;
    for (int c = 0; c < rig->count(); ++c)
      if (one.contains(rig->at(c).name))
        see(sighting, c, vector_in(one[rig->at(c).name], line, rig->at(c).name.c_str(), 2, bounds::pixel));
    if (!sighting.in_cameras.empty()) look.sightings.push_back(sighting);
  }
}

void read_images(const Json& images, const std::string& line, const Rig* rig, LookAnswer& look) {
  if (!rig || !images.is_object()) bad(line, "has \"images\", which the session has no cameras for");
  for (const auto& [camera, file] : images.items()) {
    bool is_known = false;
    for (int c = 0; c < rig->count(); ++c) is_known = is_known || rig->at(c).name == camera;
    if (!is_known || !file.is_string() || file.get<std::string>().empty())
      bad(line,
          message("names an image of {}, expected files of the cameras {}", in_quotes(camera), listed_names(*rig)));
    look.images[camera] = file.get<std::string>();
  }
}

}  // namespace

std::string hello_line(std::int64_t id) { return Json{{"do", "hello"}, {"id", id}}.dump(); }
std::string look_line(std::int64_t id) { return Json{{"do", "look"}, {"id", id}}.dump(); }
std::string stop_line(std::int64_t id) { return Json{{"do", "stop"}, {"id", id}}.dump(); }

std::string move_line(std::int64_t id, const std::vector<Eigen::VectorXd>& path, double speed) {
  Json points = Json::array();
  for (const Eigen::VectorXd& point : path) points.push_back(list_of(point));
  return Json{{"do", "move"}, {"path", points}, {"speed", speed}, {"id", id}}.dump();
}

std::string touch_line(std::int64_t id, const TouchRequest& request) {
  const Json touch{{"fixture", request.fixture}, {"position", list_of(request.position)}};
  return Json{{"do", "look"}, {"touch", touch}, {"id", id}}.dump();
}

std::int64_t answered_id(const std::string& line) {
  const Json answer = object_of(line);
  if (!answer.contains("id") || !answer["id"].is_number_integer()) bad(line, "repeats no \"id\"");
  return answer["id"].get<std::int64_t>();
}

DriverHello hello_answer(const std::string& line) {
  const Json answer = object_of(line);
  DriverHello hello;
  hello.joints = texts_in(answer, line, "joints");
  hello.can = texts_in(answer, line, "can");
  if (answer.contains("name")) hello.name = shortened(text_in(answer, line, "name"), 80);
  if (answer.contains("position"))
    hello.position = vector_in(answer["position"], line, "position", hello.joints.size(), bounds::joint);
  return hello;
}

MoveAnswer move_answer(const std::string& line, std::size_t joints) {
  const Json answer = object_of(line);
  MoveAnswer move;
  move.ok = is_ok(answer, line, move.why);
  if (!move.ok) return move;
  if (!answer.contains("position")) bad(line, "does not say in \"position\" where the robot stands");
  move.position = vector_in(answer["position"], line, "position", joints, bounds::joint);
  if (answer.contains("torque") && !answer["torque"].empty())
    move.torque = vector_in(answer["torque"], line, "torque", joints, bounds::torque);
  if (answer.contains("time")) move.time = number_in(answer["time"], line, "time", bounds::time);
  return move;
}

LookAnswer look_answer(const std::string& line, const Rig* rig, int markers) {
  const Json answer = object_of(line);
  LookAnswer look;
  look.ok = is_ok(answer, line, look.why);
  if (!look.ok) return look;
  if (answer.contains("images")) {
    read_images(answer["images"], line, rig, look);
  } else if (answer.contains("points")) {
    read_points(answer["points"], line, markers, look);
  } else if (answer.contains("target_pose")) {
    look.target_pose = pose_in(answer["target_pose"], line);
  } else if (answer.contains("markers")) {
    read_markers(answer["markers"], line, rig, markers, look);
  } else {
    bad(line, "has none of \"images\", \"points\", \"target_pose\" and \"markers\"");
  }
  return look;
}

TouchAnswer touch_answer(const std::string& line, std::size_t joints, int markers) {
  const Json answer = object_of(line);
  TouchAnswer touch;
  touch.ok = is_ok(answer, line, touch.why);
  if (!touch.ok) return touch;
  if (!answer.contains("touched") || !answer["touched"].is_object()) bad(line, "does not say in \"touched\" what");
  const Json& touched = answer["touched"];
  touch.fixture = text_in(touched, line, "fixture");
  if (touched.contains("value")) touch.value = number_in(touched["value"], line, "value", bounds::length);
  if (touched.contains("marker")) {
    if (!touched["marker"].is_number_integer()) bad(line, "has a \"marker\" that is no number of a tip");
    touch.marker = touched["marker"].get<int>();
    if (touch.marker < 0 || touch.marker >= markers)
      bad(line, message("has marker {}, expected ascending numbers from 0 to {}", touch.marker, markers - 1));
  }
  if (answer.contains("position"))
    touch.position = vector_in(answer["position"], line, "position", joints, bounds::joint);
  if (answer.contains("torque") && !answer["torque"].empty())
    touch.torque = vector_in(answer["torque"], line, "torque", joints, bounds::torque);
  if (answer.contains("time")) touch.time = number_in(answer["time"], line, "time", bounds::time);
  return touch;
}

DriverRequest driver_request(const std::string& line) {
  const Json message = object_of(line);
  DriverRequest request;
  request.id = answered_id(line);
  request.what = text_in(message, line, "do");
  if (request.what == "look" && message.contains("touch")) {
    const Json& touch = message["touch"];
    request.touch = TouchRequest{text_in(touch, line, "fixture"), {}};
    if (touch.contains("position")) {
      const std::vector<double> q = numbers_in(touch["position"], line, "position", bounds::joint);
      request.touch->position = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    }
  }
  if (request.what != "move") return request;
  if (!message.contains("path") || !message["path"].is_array() || message["path"].empty())
    bad(line, "has no points in \"path\"");
  for (const Json& point : message["path"]) {
    const std::vector<double> numbers = numbers_in(point, line, "path", bounds::joint);
    request.path.emplace_back(
        Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
  }
  if (message.contains("speed")) request.speed = number_in(message["speed"], line, "speed", bounds::joint);
  return request;
}

std::string answer_line(std::int64_t id, const DriverHello& hello) {
  Json answer{{"id", id}, {"joints", hello.joints}, {"can", hello.can}, {"name", hello.name}};
  if (hello.position) answer["position"] = list_of(*hello.position);
  return answer.dump();
}

std::string answer_line(std::int64_t id, const MoveAnswer& move) {
  if (!move.ok) return Json{{"id", id}, {"ok", false}, {"why", move.why}}.dump();
  Json answer{{"id", id}, {"ok", true}, {"position", list_of(move.position)}};
  if (move.torque.size() > 0) answer["torque"] = list_of(move.torque);
  if (move.time) answer["time"] = *move.time;
  return answer.dump();
}

std::string answer_line(std::int64_t id, const LookAnswer& look, const Rig* rig) {
  if (!look.ok) return Json{{"id", id}, {"ok", false}, {"why", look.why}}.dump();
  Json answer{{"id", id}, {"ok", true}};
  if (!look.images.empty()) {
    answer["images"] = look.images;
  } else if (look.target_pose) {
    const Eigen::Quaterniond q(look.target_pose->rotation);
    answer["target_pose"] = {{"xyz", list_of(look.target_pose->translation)}, {"quaternion", list_of(q.coeffs())}};
  } else if (rig) {
    Json markers = Json::array();
    for (const Sighting& s : look.sightings) {
      Json marker{{"index", s.marker}};
      for (const CameraPoint& p : s.in_cameras) marker[rig->at(p.camera).name] = list_of(p.pixel);
      markers.push_back(marker);
    }
    answer["markers"] = markers;
  } else {
    Json points = Json::array();
    for (const Sighting& s : look.sightings) {
      while (points.size() < static_cast<std::size_t>(s.marker)) points.push_back(nullptr);
      points.push_back(list_of(*s.point));
    }
    answer["points"] = points;
  }
  return answer.dump();
}

std::string answer_line(std::int64_t id, const TouchAnswer& touch) {
  if (!touch.ok) return Json{{"id", id}, {"ok", false}, {"why", touch.why}}.dump();
  Json touched{{"fixture", touch.fixture}, {"marker", touch.marker}};
  if (touch.value) touched["value"] = *touch.value;
  Json answer{{"id", id}, {"ok", true}, {"touched", touched}};
  if (touch.position.size() > 0) answer["position"] = list_of(touch.position);
  if (touch.torque.size() > 0) answer["torque"] = list_of(touch.torque);
  if (touch.time) answer["time"] = *touch.time;
  return answer.dump();
}

std::string stopped_line(std::int64_t id) { return Json{{"id", id}, {"ok", true}}.dump(); }

}  // namespace handsight
