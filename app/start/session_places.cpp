// SPDX-License-Identifier: GPL-3.0-or-later
#include "start/session_places.h"

#include <QCoreApplication>
#include <QObject>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "document/journal.h"

namespace handsight::app {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_recent = 8;

fs::path recent_file() { return state_folder() / "recent.json"; }

Json read_recent() {
  try {
    return Json::parse(read_file(recent_file()));
  } catch (const std::exception&) {
    return Json::array();  // never opened one, or the list is broken: it is only a list
  }
}

fs::path samples_folder() {
  const fs::path here = QCoreApplication::applicationDirPath().toStdString();
  for (const fs::path& folder :
       {here / ".." / "share" / "handsight" / "sample_sessions", fs::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions"}) {
    std::error_code error;
    if (fs::exists(folder, error)) return fs::weakly_canonical(folder, error);
  }
  return {};
}

fs::path copy_folder(const std::string& name) { return state_folder() / "samples" / name; }

}  // namespace

std::vector<RecentSession> recent_sessions() {
  std::vector<RecentSession> list;
  const Json recent = read_recent();
  if (!recent.is_array()) return list;
  for (const Json& one : recent) {
    if (!one.is_object() || !one.contains("file") || !one["file"].is_string()) continue;
    const fs::path file = one["file"].get<std::string>();
    std::error_code error;
    if (!fs::exists(file, error)) continue;
    RecentSession session{file,
                          QString::fromStdString(one.value("title", file.parent_path().filename().string())),
                          QString::fromStdString(one.value("state", "")),
                          {}};
    if (one.contains("ratios") && one["ratios"].is_array())
      for (const Json& ratio : one["ratios"])
        if (ratio.is_number()) session.ratios.push_back(ratio.get<double>());
    list.push_back(std::move(session));
  }
  return list;
}

namespace {

/// A list of what was opened lately is not worth a refusal.
void write_recent(const std::vector<RecentSession>& sessions) {
  Json list = Json::array();
  for (const RecentSession& one : sessions)
    if (list.size() < most_recent)
      list.push_back({{"file", one.file.string()},
                      {"title", one.title.toStdString()},
                      {"state", one.state.toStdString()},
                      {"ratios", one.ratios}});
  std::error_code error;
  fs::create_directories(state_folder(), error);
  try {
    replace_file(recent_file(), list.dump(1, ' ', false, Json::error_handler_t::replace));
  } catch (const InputError&) {
    return;
  }
}

}  // namespace

void remember_session(const fs::path& file, const QString& title) {
  const fs::path whole = fs::weakly_canonical(file);
  std::vector<RecentSession> list = recent_sessions();
  RecentSession first{whole, title, {}, {}};
  for (const RecentSession& one : list)
    if (one.file == whole) first = {whole, title, one.state, one.ratios};
  std::erase_if(list, [&](const RecentSession& one) { return one.file == whole; });
  list.insert(list.begin(), std::move(first));
  write_recent(list);
}

void remember_state(const fs::path& file, const QString& state, const std::vector<double>& ratios) {
  const fs::path whole = fs::weakly_canonical(file);
  std::vector<RecentSession> list = recent_sessions();
  for (RecentSession& one : list) {
    if (one.file != whole) continue;
    one.state = state;
    one.ratios = ratios;
    return write_recent(list);
  }
}

fs::path first_image(const fs::path& session_folder) {
  std::error_code error;
  std::vector<fs::path> all;
  for (const fs::directory_entry& e : fs::directory_iterator(session_folder / "images", error)) {
    const std::string ending = e.path().extension().string();
    if (ending == ".png" || ending == ".jpg" || ending == ".pgm") all.push_back(e.path());
  }
  return all.empty() ? fs::path() : *std::min_element(all.begin(), all.end());
}

std::vector<SampleSession> sample_sessions() {
  const fs::path folder = samples_folder();
  std::vector<SampleSession> list;
  const auto add = [&](const char* name, const QString& title, const QString& sentence) {
    if (!folder.empty() && fs::exists(folder / name / "session.xml"))
      list.push_back({name, title, sentence, folder / name});
  };
  add("hidden_3", QObject::tr("Tour: the hand that hangs (Hidden 3)"),
      QObject::tr("Justin's hand is three pixels from where it should be: what is missing? Step by step."));
  add("first_steps", QObject::tr("First steps"),
      QObject::tr("Twelve observations with images, nothing hidden: label three markers, play, export."));
  add("one_camera", QObject::tr("One camera and a printed board"),
      QObject::tr("A ChArUco board on the hand, twelve images, nothing to label: play, export."));
  add("probe_and_plate", QObject::tr("A probe and a plate"),
      QObject::tr("No camera, no tracker: a plate in three places and two sockets were touched. What is wrong?"));
  add("panda_sockets", QObject::tr("A real robot: a Panda and four sockets"),
      QObject::tr(
          "Measured with a printed ball and sockets, by people in Delft. What is wrong with it, nobody knows."));
  add("hundred_poses", QObject::tr("A hundred poses"),
      QObject::tr("A guided arm that sags, and three bad poses with three different causes to find."));
  add("thesis_simulation", QObject::tr("The thesis's simulation"),
      QObject::tr("Six poses, everything measured 1 cm nearer than it is: no images, labels only."));
  add("hidden_1", QObject::tr("Hidden 1: the used arm"),
      QObject::tr("In some postures it misses much more than in others. Where is it, and how large?"));
  add("hidden_2", QObject::tr("Hidden 2: the unknown corners"),
      QObject::tr("A quarter of a pixel is left. Is that the cameras, or is there something to be found?"));
  add("hidden_4", QObject::tr("Hidden 4: after the weekend"),
      QObject::tr("Nothing was done to the robot, they say, and still the error is six times what it was."));
  add("hidden_5", QObject::tr("Hidden 5: a long afternoon"),
      QObject::tr("Justin guided by hand. In the morning's test everything was right."));
  add("hidden_6", QObject::tr("Hidden 6: not the first answer"),
      QObject::tr("The error is only twice the noise. Do not stop at the first answer."));
  add("hidden_7", QObject::tr("Hidden 7: reflections"),
      QObject::tr("One image point in twenty is wrong. Can the robot's error still be named?"));
  add("hidden_8", QObject::tr("Hidden 8: another supplier"),
      QObject::tr("A good answer need not be a name: where, following what, and how much."));
  return list;
}

fs::path working_copy(const SampleSession& sample) {
  fs::path copy = copy_folder(sample.name);
  std::error_code error;
  if (fs::exists(copy / "session.xml", error)) return copy;
  const fs::path partial = copy.string() + ".partial";
  fs::remove_all(partial, error);
  fs::create_directories(partial.parent_path(), error);
  fs::copy(sample.folder, partial, fs::copy_options::recursive, error);
  if (!error) fs::rename(partial, copy, error);
  if (error)
    throw InputError(
        message("{}: the sample session could not be copied there ({}); make room or set "
                "XDG_STATE_HOME to another folder.",
                shown_path(copy), system_text(error)));
  return copy;
}

fs::path fresh_copy(const SampleSession& sample) {
  std::error_code error;
  const fs::path copy = copy_folder(sample.name);
  if (fs::exists(copy, error)) {
    // The journal belongs to the work that is thrown away.
    try {
      const std::string digest = compute_digest(read_file(copy / "session.xml"));
      Journal(copy / "session.xml", digest).clear(digest);
    } catch (const InputError&) {
      throw InputError(message("{}: the sample session is open in another window; close it first.", shown_path(copy)));
    }
    fs::remove_all(copy, error);
  }
  return working_copy(sample);
}

std::string take_sample(const fs::path& session_file) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(session_file, error).parent_path();
  if (folder.parent_path() != fs::weakly_canonical(state_folder() / "samples", error)) return {};
  return folder.filename().string();
}

}  // namespace handsight::app
