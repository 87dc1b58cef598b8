// SPDX-License-Identifier: GPL-3.0-or-later
#include "live/live_watch.h"

#include <algorithm>

#include "words/core_words.h"
#include "workbench/preferences.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

constexpr int between_looks = 400;                 // ms
constexpr int after_news = 50;                     // ms: several files tend to come together
constexpr std::chrono::milliseconds settled{300};  // what has not grown in that time is written to its end

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

LiveWatch::LiveWatch(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &LiveWatch::look);
  const auto news = [this] {
    if (is_watching_ && !jobs_.is_busy()) timer_.start(after_news);
  };
  connect(&files_, &QFileSystemWatcher::directoryChanged, this, news);
  connect(&files_, &QFileSystemWatcher::fileChanged, this, news);
  connect(&workbench.document, &Document::edited, this, [this] { is_session_changed_ = true; });
  connect(&workbench.document, &Document::closed, this, [this] { set_watching(false); });
}

void LiveWatch::set_watching(bool watching) {
  if (watching == is_watching_) return;
  is_watching_ = watching;
  timer_.stop();
  jobs_.cancel();
  if (!files_.directories().isEmpty()) files_.removePaths(files_.directories());
  if (!files_.files().isEmpty()) files_.removePaths(files_.files());
  arrivals_.reset();
  remarks_.clear();
  early_.clear();
  if (watching) {
    sources_ = live_sources(workbench_.document.session());
    arrivals_ = std::make_shared<Arrivals>(workbench_.document.session(), sources_, settled);
    is_session_changed_ = false;
    arrived_ = 0;
    look();
  }
  emit state_changed();
}

void LiveWatch::set_sources(const LiveSources& sources) {
  remember_live_sources(workbench_.document.session().file, sources);
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
  if (std::exchange(is_session_changed_, false)) arrivals_->know(workbench_.document.session());
  struct Found {
    std::vector<Observation> arrived;
    std::vector<Message> standing;
  };
  jobs_.start<std::shared_ptr<Found>>(
      "look", workbench_.document.session().rig ? tr("Looking for new images") : tr("Looking for new measurements"),
      [arrivals = arrivals_](JobControl&) {
        auto found = std::make_shared<Found>();
        found->arrived = arrivals->look().arrived;
        found->standing = arrivals->standing();
        return found;
      },
      [this](const std::shared_ptr<Found>& found) { take(std::move(found->arrived), found->standing); },
      [this](const QString& sentence) { take({}, {verbatim(sentence.toStdString())}); });
}

/// What was measured is not replaced by something invented: it is left out and named.
bool LiveWatch::is_early(const Observation& arrived, double last) {
  if (arrived.time >= last) return false;
  const QString image = QString::fromStdString(fs::path(arrived.images[0]).filename().string());
  early_ << tr("%1 was left out: its time, %2 s, is before that of the observation in front of it, %3 s. Mend the "
               "table and watch anew.")
                .arg(image.isEmpty() ? tr("A pose") : image)
                .arg(arrived.time)
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

void LiveWatch::take(std::vector<Observation> arrived, const std::vector<Message>& remarks) {
  if (!is_watching_) return;
  std::vector<Observation> observations;
  auto [id, time] = end_of(workbench_.document.session());
  for (Observation& o : arrived) {
    if (is_early(o, time)) continue;
    o.id = id++;
    time = o.time;
    observations.push_back(std::move(o));
  }
  QStringList said = early_;
  for (const Message& remark : remarks) said << translated(remark);
  const bool has_news = !observations.empty() || said != remarks_;
  remarks_ = std::move(said);
  timer_.start(between_looks);
  hand_over(observations);
  if (has_news) emit state_changed();
}

/// What could not be written down has not arrived: it is looked for again.
void LiveWatch::hand_over(const std::vector<Observation>& observations) {
  if (observations.empty()) return;
  emit arrived_now(observations);
  if (!arrivals_) return;
  for (const Observation& o : observations)
    if (workbench_.document.find(o.id))
      ++arrived_;
    else
      arrivals_->forget(o);
  is_session_changed_ = true;
}

QString LiveWatch::state_text() const {
  if (!is_watching_) return {};
  const fs::path home = folder(workbench_.document.session());
  QString text = workbench_.document.session().rig ? images_text(home) : measured_text();
  constexpr qsizetype most = 2;
  for (const QString& remark : remarks_.mid(0, most)) text += ' ' + remark;
  if (remarks_.size() > most) text += tr(" And %1 more.").arg(remarks_.size() - most);
  return text;
}

QString LiveWatch::measured_text() const {
  const Session& session = workbench_.document.session();
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
