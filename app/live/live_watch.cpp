// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/live_watch.h"

#include <algorithm>

#include "bench/preferences.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

constexpr int between_looks = 400;  // ms: what has not grown in that time is written to its end
constexpr int after_news = 50;      // ms: several files tend to come together

QString preference_of(const fs::path& session_file) {
  return "watch " + QString::fromStdString(fs::weakly_canonical(session_file).string());
}

/// A path as the user would name it: relative to the session where it is inside.
QString short_path(const fs::path& path, const fs::path& session_folder) {
  const fs::path inside = path.lexically_relative(session_folder);
  const bool is_inside = !inside.empty() && *inside.begin() != "..";
  return QString::fromStdString((is_inside ? inside : path).string());
}

}  // namespace

LiveSources live_sources(const Session& session) {
  const QStringList chosen = preference(preference_of(session.file)).split('\n');
  if (!session.rig || chosen.size() != session.rig->count() + 1) return own_sources(session);
  LiveSources sources{{}, chosen.back().toStdString()};
  for (qsizetype c = 0; c + 1 < chosen.size(); ++c) sources.folders.emplace_back(chosen[c].toStdString());
  return sources;
}

void remember_live_sources(const fs::path& session_file, const LiveSources& sources) {
  QStringList paths;
  std::vector<fs::path> all = sources.folders;
  all.push_back(sources.table);
  for (const fs::path& path : all) paths << QString::fromStdString(fs::absolute(path).lexically_normal().string());
  remember_preference(preference_of(session_file), paths.join('\n'));
}

LiveWatch::LiveWatch(Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &LiveWatch::look);
  const auto news = [this] {
    if (is_watching_ && !jobs_.is_busy()) timer_.start(after_news);
  };
  connect(&files_, &QFileSystemWatcher::directoryChanged, this, news);
  connect(&files_, &QFileSystemWatcher::fileChanged, this, news);
  connect(&bench.document, &Document::closed, this, [this] { set_watching(false); });
}

void LiveWatch::set_watching(bool watching) {
  if (watching == is_watching_) return;
  is_watching_ = watching;
  timer_.stop();
  jobs_.cancel();
  if (!files_.directories().isEmpty()) files_.removePaths(files_.directories());
  if (!files_.files().isEmpty()) files_.removePaths(files_.files());
  stamps_.clear();
  remarks_.clear();
  early_.clear();
  if (watching) {
    sources_ = live_sources(bench_.document.session());
    taken_.clear();
    arrivals_.reset();
    if (!bench_.document.session().rig) arrivals_ = std::make_shared<Arrivals>(bench_.document.session());
    arrived_ = 0;
    look();
  }
  emit state_changed();
}

void LiveWatch::set_sources(const LiveSources& sources) {
  remember_live_sources(bench_.document.session().file, sources);
  if (!is_watching_) return;
  set_watching(false);
  set_watching(true);
}

/// The watcher only hastens a look: some file systems tell it nothing, and folders may come later.
void LiveWatch::watch_paths() {
  QStringList wanted;
  std::vector<fs::path> all = sources_.folders;
  all.push_back(sources_.table.parent_path());
  for (const fs::path& path : all) {
    std::error_code error;
    const QString text = QString::fromStdString(path.string());
    if (fs::is_directory(path, error) && !files_.directories().contains(text) && !wanted.contains(text)) wanted << text;
  }
  if (!wanted.isEmpty()) files_.addPaths(wanted);
}

void LiveWatch::look() {
  if (!is_watching_) return;
  if (jobs_.is_busy()) return timer_.start(between_looks);  // a look of the watch before, at a slow drive
  watch_paths();
  if (arrivals_)
    look_for_measurements();
  else
    look_for_images_now();
}

void LiveWatch::look_for_images_now() {
  LiveTask task = task_of(bench_.document.session(), sources_);
  task.passed_over = taken_;
  task.stamps = stamps_;
  jobs_.start<std::shared_ptr<LiveLook>>(
      "look", tr("Looking for new images"),
      [task = std::move(task)](JobControl&) { return std::make_shared<LiveLook>(look_for_images(task)); },
      [this](const std::shared_ptr<LiveLook>& found) { take(std::move(*found)); },
      [this](const QString& sentence) { take({.remarks = {sentence}}); });
}

void LiveWatch::look_for_measurements() {
  jobs_.start<std::shared_ptr<Arrivals::Look>>(
      "look", tr("Looking for new measurements"),
      [arrivals = arrivals_](JobControl&) { return std::make_shared<Arrivals::Look>(arrivals->look()); },
      [this](const std::shared_ptr<Arrivals::Look>& found) { take_measured(std::move(*found)); },
      [this](const QString& sentence) {
        take_measured({{}, {sentence.toStdString()}});
      });
}

/// What was measured is not replaced by something invented: it is left out and named.
bool LiveWatch::is_early(const std::string& name, double time, double last) {
  if (time >= last) return false;
  early_ << tr("%1 was left out: its time, %2 s, is before that of the observation in front of it, %3 s. Mend the "
               "table and watch anew.")
                .arg(QString::fromStdString(name))
                .arg(time)
                .arg(last);
  return true;
}

namespace {

/// The next id, and the time of the last.
std::pair<std::int64_t, double> end_of(const Session& session) {
  std::pair<std::int64_t, double> end{0, -1};
  for (const Observation& o : session.observations) end = {std::max(end.first, o.id + 1), std::max(end.second, o.time)};
  return end;
}

}  // namespace

void LiveWatch::take(LiveLook look) {
  if (!is_watching_) return;
  stamps_ = std::move(look.stamps);
  std::vector<Observation> observations;
  std::vector<std::string> names;
  auto [id, time] = end_of(bench_.document.session());
  for (LiveInstant& instant : look.instants) {
    taken_.insert(instant.name);
    if (instant.time && is_early(instant.name, *instant.time, time)) continue;
    Observation o;
    o.id = id++;
    o.time = time = instant.time ? *instant.time : time + 1;
    o.position = std::move(instant.position);
    for (std::size_t c = 0; c < instant.images.size(); ++c) o.images[c] = std::move(instant.images[c]);
    observations.push_back(std::move(o));
    names.push_back(instant.name);
  }
  hand_over(std::move(observations), names, std::move(look.remarks));
}

void LiveWatch::take_measured(Arrivals::Look look) {
  if (!is_watching_) return;
  for (const std::string& remark : look.remarks) early_ << QString::fromStdString(remark);  // each is said once
  std::vector<Observation> observations;
  auto [id, time] = end_of(bench_.document.session());
  for (Observation& o : look.arrived) {
    if (is_early(tr("A pose").toStdString(), o.time, time)) continue;
    o.id = id++;
    time = o.time;
    observations.push_back(std::move(o));
  }
  const std::vector<std::string> names(observations.size());
  hand_over(std::move(observations), names, {});
}

void LiveWatch::hand_over(std::vector<Observation> observations, const std::vector<std::string>& names,
                          QStringList remarks) {
  timer_.start(between_looks);
  remarks = early_ + remarks;
  const bool has_news = !observations.empty() || remarks != remarks_;
  remarks_ = std::move(remarks);
  if (!observations.empty()) emit arrived_now(observations);
  // What could not be written down has not arrived: it is looked for again.
  bool is_lost = false;
  for (std::size_t i = 0; i < observations.size(); ++i)
    if (bench_.document.find(observations[i].id)) {
      ++arrived_;
    } else {
      taken_.erase(names[i]);
      is_lost = true;
    }
  if (is_lost && arrivals_) arrivals_ = std::make_shared<Arrivals>(bench_.document.session());
  if (has_news) emit state_changed();
}

QString LiveWatch::state_text() const {
  if (!is_watching_) return {};
  const fs::path home = folder(bench_.document.session());
  QString text = arrivals_ ? measured_text() : images_text(home);
  constexpr qsizetype most = 2;
  for (const QString& remark : remarks_.mid(0, most)) text += ' ' + remark;
  if (remarks_.size() > most) text += tr(" And %1 more.").arg(remarks_.size() - most);
  return text;
}

QString LiveWatch::measured_text() const {
  const Session& session = bench_.document.session();
  const QString wanted =
      session.pose_sensor ? tr("Waiting for the next pose of the target in poses.csv and %1 in joints.csv; %2 arrived.")
                          : tr("Waiting for the next points in points.csv and %1 in joints.csv; %2 arrived.");
  return wanted.arg(session.robot.is_of_poses ? tr("that of the flange") : tr("its joint angles")).arg(arrived_);
}

QString LiveWatch::images_text(const fs::path& home) const {
  QStringList places;
  for (const fs::path& place : sources_.folders)
    if (const QString text = short_path(place, home); !places.contains(text)) places << text;
  const QString where = places.size() == 2 ? tr("%1 and %2").arg(places[0], places[1]) : places.join(", ");
  return (sources_.folders.size() == 2
              ? tr("Waiting for the next image pair in %1 and its joint angles in %2; %3 arrived.")
              : tr("Waiting for the next images in %1 and their joint angles in %2; %3 arrived."))
      .arg(where, short_path(sources_.table, home))
      .arg(arrived_);
}

}  // namespace handsight::app
