// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/live_look.h"

#include <QObject>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "images/image_source.h"
#include "session/csv.h"
#include "session/new_session.h"

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

Angles read_angles(const fs::path& table, const std::vector<std::string>& joints) {
  std::string text = read_file(table);
  text.resize(text.rfind('\n') == std::string::npos ? 0
                                                    : text.rfind('\n') + 1);  // what is being written is no line yet
  Angles angles{.joints = static_cast<Eigen::Index>(joints.size())};
  std::vector<std::string> columns = joints;
  angles.has_number = names_column(text, "number");
  angles.has_time = names_column(text, "time");
  if (angles.has_number) columns.emplace_back("number");
  if (angles.has_time) columns.emplace_back("time");
  angles.lines = parse_poses(text, table.filename().string(), columns);
  return angles;
}

/// Which line of the table is a pair's; nothing: none yet.
std::optional<std::size_t> line_of(const Angles& angles, const ImageFiles& pair, std::size_t rank) {
  if (!angles.has_number) return rank < angles.lines.size() ? std::optional(rank) : std::nullopt;
  for (std::size_t i = 0; i < angles.lines.size(); ++i)
    if (angles.number(i) == static_cast<double>(pair.number)) return i;
  return std::nullopt;
}

/// Without numbers, lines are counted: those of pairs that are in the session must say what it says.
QString counting_refusal(const Angles& angles, const std::vector<ImageFiles>& pairs, const LiveTask& task) {
  if (angles.has_number) return {};
  if (angles.lines.size() != pairs.size())
    return QObject::tr(
               "%1 has %2 lines for %3 image pairs: it waits until they are as many. With a column \"number\" "
               "each pair finds its own line.")
        .arg(name_of(task.sources.table))
        .arg(angles.lines.size())
        .arg(pairs.size());
  for (std::size_t rank = 0; rank < pairs.size() && rank < angles.lines.size(); ++rank) {
    const auto known = task.known_left.find(pairs[rank].left.filename().string());
    if (known == task.known_left.end()) continue;
    if ((known->second - angles.lines[rank].head(angles.joints)).cwiseAbs().maxCoeff() > 1e-6)
      return QObject::tr(
                 "Line %1 of %2 is not the posture that the session has for %3. Name the images' numbers in a "
                 "column \"number\".")
          .arg(rank + 1)
          .arg(name_of(task.sources.table), name_of(pairs[rank].left));
  }
  return {};
}

class Look {
 public:
  explicit Look(const LiveTask& task) : task_(task) {}

  LiveLook run() {
    std::vector<ImageFiles> pairs;
    try {
      pairs = find_image_pairs(task_.sources.left_folder, task_.sources.right_folder);
    } catch (const InputError& error) {
      look_.remarks << QString::fromUtf8(error.what());
      return std::move(look_);
    }
    if (std::none_of(pairs.begin(), pairs.end(), [this](const ImageFiles& p) { return is_new(p); }))
      return std::move(look_);
    if (!read_table(pairs)) return std::move(look_);
    for (std::size_t rank = 0; rank < pairs.size(); ++rank)
      if (is_new(pairs[rank])) take(pairs[rank], rank);
    return std::move(look_);
  }

 private:
  bool is_new(const ImageFiles& pair) const {
    const std::string left = pair.left.filename().string(), right = pair.right.filename().string();
    return !task_.known_left.contains(left) && !(left.empty() && task_.known_right.contains(right)) &&
           !task_.passed_over.contains(left);
  }

  bool read_table(const std::vector<ImageFiles>& pairs) {
    std::error_code error;
    if (!fs::exists(task_.sources.table, error)) {
      look_.remarks << QObject::tr("%1 is not there yet: the joint angles of the new images, a line for each pair.")
                           .arg(name_of(task_.sources.table));
      return false;
    }
    try {
      angles_ = read_angles(task_.sources.table, task_.joints);
    } catch (const InputError& refusal) {
      look_.remarks << QString::fromUtf8(refusal.what());
      return false;
    }
    const QString refusal = counting_refusal(angles_, pairs, task_);
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

  void take(const ImageFiles& pair, std::size_t rank) {
    if (pair.left.empty() || pair.right.empty()) {
      const bool has_left = !pair.left.empty();
      if (is_settled(has_left ? pair.left : pair.right))
        look_.remarks << QObject::tr("%1 waits for its %2 image, with the number %3 in its name.")
                             .arg(name_of(has_left ? pair.left : pair.right),
                                  has_left ? QObject::tr("right") : QObject::tr("left"))
                             .arg(pair.number);
      return;
    }
    const bool left_settled = is_settled(pair.left), right_settled = is_settled(pair.right);
    if (!left_settled || !right_settled) return;
    const auto line = line_of(angles_, pair, rank);
    if (!line) {
      look_.remarks << QObject::tr("%1 waits for its joint angles in %2%3.")
                           .arg(name_of(pair.left), name_of(task_.sources.table),
                                angles_.has_number ? QObject::tr(" (number %1)").arg(pair.number)
                                                   : QObject::tr(" (line %1)").arg(rank + 1));
      return;
    }
    if (!is_whole(pair.left, task_.rig.left) || !is_whole(pair.right, task_.rig.right)) return;
    try {
      const bool twins = pair.left.filename() == pair.right.filename();
      LivePair whole{.left_name = pair.left.filename().string()};
      whole.left = bring_into(pair.left, task_.session_folder, twins ? "images/left" : "images");
      whole.right = bring_into(pair.right, task_.session_folder, twins ? "images/right" : "images");
      whole.position = angles_.lines[*line].head(angles_.joints);
      whole.time = angles_.time(*line);
      look_.pairs.push_back(std::move(whole));
    } catch (const InputError& error) {
      look_.remarks << QString::fromUtf8(error.what());
    }
  }

  const LiveTask& task_;
  Angles angles_;
  LiveLook look_;
};

}  // namespace

LiveSources own_sources(const Session& session) {
  LiveSources sources{folder(session) / "images", folder(session) / "images", folder(session) / "joints.csv"};
  for (const Observation& o : session.observations) {
    if (!o.images[0].empty()) sources.left_folder = folder(session) / fs::path(o.images[0]).parent_path();
    if (!o.images[1].empty()) sources.right_folder = folder(session) / fs::path(o.images[1]).parent_path();
  }
  return sources;
}

LiveTask task_of(const Session& session, const LiveSources& sources) {
  LiveTask task{.sources = sources, .session_folder = folder(session), .joints = session.joints};
  if (session.rig && is_pair(*session.rig)) task.rig = stereo_of(*session.rig);
  for (const Observation& o : session.observations) {
    if (!o.images[0].empty()) task.known_left[fs::path(o.images[0]).filename().string()] = o.position;
    if (!o.images[1].empty()) task.known_right.insert(fs::path(o.images[1]).filename().string());
  }
  return task;
}

LiveLook look_for_pairs(const LiveTask& task) { return Look(task).run(); }

}  // namespace handsight::app
