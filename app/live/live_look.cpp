// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/live_look.h"

#include <Eigen/Geometry>
#include <QObject>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "images/image_source.h"
#include "readers/csv.h"
#include "session/new_session.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

QString name_of(const fs::path& file) { return QString::fromStdString(file.filename().string()); }

/// The table, as far as its last line that has come to an end.
struct Angles {
  std::vector<Eigen::VectorXd> lines;  // joints, then number and time where there are such columns
  Eigen::Index joints = 0;
  bool has_number = false, has_time = false;

  double number(std::size_t line) const { return lines[line][joints]; }
  std::optional<double> time(std::size_t line) const {
    return has_time ? std::optional(lines[line][lines[line].size() - 1]) : std::nullopt;
  }
};

bool names_column(const std::string& text, const char* name) {
  std::string head = text.substr(0, text.find('\n'));
  for (char& c : head)
    if (c == ',' || c == ';' || c == '"' || c == '\'' || c == '\r') c = ' ';
  const auto words = split_words(head);
  return std::find(words.begin(), words.end(), name) != words.end();
}

/// base_from_flange, as the joints that stand for it; what follows the seven columns stays.
Eigen::VectorXd flange_joints(const Eigen::VectorXd& line, const std::string& table) {
  const Eigen::Quaterniond q(line[6], line[3], line[4], line[5]);
  if (!(std::abs(q.norm() - 1) < 0.01))
    throw InputError(fmt::format("{}: a quaternion qx qy qz qw has the length {:.3g}; expected 1.", table, q.norm()));
  Eigen::VectorXd joints(line.size() - 1);
  joints << position_of({q.normalized().toRotationMatrix(), line.head<3>()}), line.tail(line.size() - 7);
  return joints;
}

Angles read_angles(const fs::path& table, const LiveTask& task) {
  std::string text = read_file(table);
  text.resize(text.rfind('\n') == std::string::npos ? 0
                                                    : text.rfind('\n') + 1);  // what is being written is no line yet
  Angles angles{.joints = static_cast<Eigen::Index>(task.joints.size())};
  const bool is_pose = task.is_of_flange && names_column(text, "qx");
  std::vector<std::string> columns = task.joints;
  if (is_pose) columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  angles.has_number = names_column(text, "number");
  angles.has_time = names_column(text, "time");
  if (angles.has_number) columns.emplace_back("number");
  if (angles.has_time) columns.emplace_back("time");
  angles.lines = parse_poses(text, table.filename().string(), columns);
  if (is_pose)
    for (Eigen::VectorXd& line : angles.lines) line = flange_joints(line, table.filename().string());
  return angles;
}

/// The first image that is there, and its camera.
std::size_t first_camera(const InstantImages& instant) {
  std::size_t c = 0;
  while (c + 1 < instant.files.size() && instant.files[c].empty()) ++c;
  return c;
}

/// Which line of the table is an instant's; nothing: none yet.
std::optional<std::size_t> line_of(const Angles& angles, const InstantImages& instant, std::size_t rank) {
  if (!angles.has_number) return rank < angles.lines.size() ? std::optional(rank) : std::nullopt;
  for (std::size_t i = 0; i < angles.lines.size(); ++i)
    if (angles.number(i) == static_cast<double>(instant.number)) return i;
  return std::nullopt;
}

/// What the session knows of an instant; null where it is new.
const Eigen::VectorXd* known_posture(const LiveTask& task, const InstantImages& instant) {
  const std::size_t c = first_camera(instant);
  const auto known = task.known[c].find(instant.files[c].filename().string());
  return known == task.known[c].end() ? nullptr : &known->second;
}

/// Without numbers, lines are counted: those of instants that are in the session must say what it says.
QString counting_refusal(const Angles& angles, const std::vector<InstantImages>& instants, const LiveTask& task) {
  if (angles.has_number) return {};
  if (angles.lines.size() != instants.size())
    return (task.cameras.size() == 2
                ? QObject::tr("%1 has %2 lines for %3 image pairs: it waits until they are as many. With a column "
                              "\"number\" each pair finds its own line.")
                : QObject::tr("%1 has %2 lines for %3 images: it waits until they are as many. With a column "
                              "\"number\" each image finds its own line."))
        .arg(name_of(task.sources.table))
        .arg(angles.lines.size())
        .arg(instants.size());
  for (std::size_t rank = 0; rank < instants.size() && rank < angles.lines.size(); ++rank) {
    const Eigen::VectorXd* known = known_posture(task, instants[rank]);
    if (known && (*known - angles.lines[rank].head(angles.joints)).cwiseAbs().maxCoeff() > 1e-6)
      return QObject::tr(
                 "Line %1 of %2 is not the posture that the session has for %3. Name the images' numbers in a "
                 "column \"number\".")
          .arg(rank + 1)
          .arg(name_of(task.sources.table), name_of(instants[rank].files[first_camera(instants[rank])]));
  }
  return {};
}

/// "left" is the German "linken" and so on; other names are the user's own.
QString camera_text(const std::string& name) {
  return name == "left" ? QObject::tr("left") : name == "right" ? QObject::tr("right") : QString::fromStdString(name);
}

std::vector<std::string> camera_names_of(const LiveTask& task) {
  std::vector<std::string> names;
  for (const RigCamera& camera : task.cameras) names.push_back(camera.name);
  return names;
}

class Look {
 public:
  explicit Look(const LiveTask& task) : task_(task) {}

  LiveLook run() {
    std::vector<InstantImages> instants;
    try {
      instants = find_images(task_.sources.folders, camera_names_of(task_));
    } catch (const InputError& error) {
      look_.remarks << translated_error(error);
      return std::move(look_);
    }
    if (std::none_of(instants.begin(), instants.end(), [this](const InstantImages& i) { return is_new(i); }))
      return std::move(look_);
    if (!read_table(instants)) return std::move(look_);
    for (std::size_t rank = 0; rank < instants.size(); ++rank)
      if (is_new(instants[rank])) take(instants[rank], rank);
    return std::move(look_);
  }

 private:
  bool is_new(const InstantImages& instant) const {
    return !known_posture(task_, instant) && !task_.passed_over.contains(instant.files[0].filename().string());
  }

  bool read_table(const std::vector<InstantImages>& instants) {
    std::error_code error;
    if (!fs::exists(task_.sources.table, error)) {
      look_.remarks << (task_.cameras.size() == 2
                            ? QObject::tr(
                                  "%1 is not there yet: the joint angles of the new images, a line for each pair.")
                            : QObject::tr("%1 is not there yet: the joint angles, a line for each new image."))
                           .arg(name_of(task_.sources.table));
      return false;
    }
    try {
      angles_ = read_angles(task_.sources.table, task_);
    } catch (const InputError& refusal) {
      look_.remarks << translated_error(refusal);
      return false;
    }
    const QString refusal = counting_refusal(angles_, instants, task_);
    if (!refusal.isEmpty()) look_.remarks << refusal;
    return refusal.isEmpty();
  }

  /// Has the file been as it is for long enough, as far as looks can tell?
  bool is_settled(const fs::path& file) {
    std::error_code error;
    const auto now = std::chrono::steady_clock::now();
    FileStamp stamp{fs::file_size(file, error), fs::last_write_time(file, error), now};
    const auto before = task_.stamps.find(file.string());
    const bool is_same =
        before != task_.stamps.end() && before->second.size == stamp.size && before->second.written == stamp.written;
    if (is_same) stamp.since = before->second.since;
    look_.stamps[file.string()] = stamp;
    return is_same && now - stamp.since >= task_.settles_in;
  }

  bool is_whole(const fs::path& file, const Camera& camera) {
    const ShownImage shown = read_shown_image(file, file.filename().string(), camera);
    if (shown.image.isNull()) look_.remarks << shown.refusal;
    return !shown.image.isNull();
  }

  /// Says what the instant waits for; true where it waits for nothing.
  bool has_every_image(const InstantImages& instant) {
    const fs::path& there = instant.files[first_camera(instant)];
    for (std::size_t c = 0; c < instant.files.size(); ++c) {
      if (!instant.files[c].empty()) continue;
      if (is_settled(there))
        look_.remarks << QObject::tr("%1 waits for its %2 image, with the number %3 in its name.")
                             .arg(name_of(there), camera_text(task_.cameras[c].name))
                             .arg(instant.number);
      return false;
    }
    bool all_settled = true;
    for (const fs::path& file : instant.files) all_settled = is_settled(file) && all_settled;
    return all_settled;
  }

  void take(const InstantImages& instant, std::size_t rank) {
    if (!has_every_image(instant)) return;
    const auto line = line_of(angles_, instant, rank);
    if (!line) {
      look_.remarks << QObject::tr("%1 waits for its joint angles in %2%3.")
                           .arg(name_of(instant.files[0]), name_of(task_.sources.table),
                                angles_.has_number ? QObject::tr(" (number %1)").arg(instant.number)
                                                   : QObject::tr(" (line %1)").arg(rank + 1));
      return;
    }
    for (std::size_t c = 0; c < instant.files.size(); ++c)
      if (!is_whole(instant.files[c], task_.cameras[c].camera)) return;
    try {
      LiveInstant whole{.name = instant.files[0].filename().string()};
      for (std::size_t c = 0; c < instant.files.size(); ++c)
        whole.images.push_back(bring_into(instant.files[c], task_.session_folder, place_of(instant, c)));
      whole.position = angles_.lines[*line].head(angles_.joints);
      whole.time = angles_.time(*line);
      look_.instants.push_back(std::move(whole));
    } catch (const InputError& error) {
      look_.remarks << translated_error(error);
    }
  }

  /// One folder for all cameras unless their files have the same names.
  fs::path place_of(const InstantImages& instant, std::size_t camera) const {
    for (std::size_t i = 0; i < instant.files.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (instant.files[i].filename() == instant.files[k].filename())
          return fs::path("images") / task_.cameras[camera].name;
    return "images";
  }

  const LiveTask& task_;
  Angles angles_;
  LiveLook look_;
};

}  // namespace

LiveSources own_sources(const Session& session) {
  LiveSources sources{{}, folder(session) / "joints.csv"};
  const int count = session.rig ? session.rig->count() : 0;
  for (int c = 0; c < count; ++c) {
    fs::path images = folder(session) / "images";
    for (const Observation& o : session.observations)
      if (const std::string& image = o.images[static_cast<std::size_t>(c)]; !image.empty())
        images = folder(session) / fs::path(image).parent_path();
    sources.folders.push_back(images);
  }
  return sources;
}

LiveTask task_of(const Session& session, const LiveSources& sources) {
  LiveTask task{.sources = sources,
                .session_folder = folder(session),
                .joints = session.joints,
                .is_of_flange = session.robot.is_of_poses};
  if (session.rig) task.cameras = session.rig->cameras;
  task.known.resize(task.cameras.size());
  for (const Observation& o : session.observations)
    for (std::size_t c = 0; c < task.cameras.size(); ++c)
      if (!o.images[c].empty()) task.known[c][fs::path(o.images[c]).filename().string()] = o.position;
  return task;
}

LiveLook look_for_images(const LiveTask& task) { return Look(task).run(); }

}  // namespace handsight::app
