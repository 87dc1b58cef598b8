// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the folders into which a robot's cameras write, and hands over what is whole as an observation: the images of
// one instant, or a tracker's points or a target's pose where there is no camera.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "base/message.h"
#include "live/arrivals.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// Where the images and angles of a session arrive: what was chosen for it, else its own folder.
LiveSources live_sources(const Session& session);
void remember_live_sources(const std::filesystem::path& session_file, const LiveSources& sources);

class LiveWatch : public QObject {
  Q_OBJECT

 public:
  explicit LiveWatch(Workbench& workbench, QObject* parent = nullptr);

  bool is_watching() const { return is_watching_; }
  void set_watching(bool watching);
  const LiveSources& sources() const { return sources_; }
  void set_sources(const LiveSources& sources);
  int arrived() const { return arrived_; }
  /// "Waiting for the next image pair in images; 3 arrived.", with what does not come in.
  QString state_text() const;

 signals:
  void state_changed();
  /// New observations for the end of the session, in their order, without markers and decisions.
  void arrived_now(const std::vector<Observation>& observations);

 private:
  QString measured_text() const;
  QString images_text(const std::filesystem::path& home) const;
  void watch_paths();
  void look();
  void take(std::vector<Observation> arrived, const std::vector<Message>& remarks);
  void hand_over(const std::vector<Observation>& observations);
  bool is_early(const Observation& arrived, double last);

  Workbench& workbench_;
  Jobs jobs_;  // of its own: what else is in the background may take long
  QFileSystemWatcher files_;
  QTimer timer_;
  LiveSources sources_;
  std::shared_ptr<Arrivals> arrivals_;  // in the worker's hands while it looks
  bool is_session_changed_ = false;     // since arrivals_ knows it
  QStringList remarks_, early_;         // early_: what is left out for good, as because its time runs back
  int arrived_ = 0;
  bool is_watching_ = false;
};

}  // namespace handsight::app
