// SPDX-License-Identifier: GPL-3.0-or-later
// The robot of the lower row: as the model bends it, as a running fit bends it, in a planned pose.
#include <QLabel>
#include <algorithm>

#include "document/bent_robot.h"
#include "explain/watching_pane.h"
#include "widgets/base/number_text.h"
#include "widgets/scene/robot_view.h"
#include "workbench/observation_views.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

double largest_motion(const std::vector<Rigid>& a, const std::vector<Rigid>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, (a[i].translation - b[i].translation).norm());
  return largest;
}

/// The hand, and what carries the sensor.
std::vector<Vector3> places_of_interest(const Session& session, int index) {
  const auto links = link_motions(session, session.observations[static_cast<std::size_t>(index)].position);
  std::vector<Vector3> places;
  for (const std::string& name : {session.tcp, session.mount.link})
    if (const int link = find_link(session.robot, name); link >= 0)
      places.push_back(links[static_cast<std::size_t>(link)].translation);
  return places;
}

}  // namespace

void WatchingPane::show_robot() {
  const Session& session = workbench_.document.session();
  const ModelVersionPointer now = workbench_.document.shown_model();
  const int index = selected_index();
  if (index < 0 || !workbench_.document.is_open()) return;
  if (!robot_is_set_) {
    robot_->set_robot(session.robot, (folder(session) / session.robot_file).parent_path());
    robot_is_set_ = true;
  }
  robot_->set_interest(places_of_interest(session, index));
  const Observation& chosen = session.observations[static_cast<std::size_t>(index)];
  robot_->set_fixtures(scene_fixtures(workbench_.document, chosen, link_motions(session, chosen.position)));
  if (!now || !now->fit) {
    straight_ = link_motions(session, session.observations[static_cast<std::size_t>(index)].position);
    robot_->set_posture(straight_);
    robot_->set_ghost(std::nullopt);
    robot_title_->setText(tr("Observation %1").arg(session.observations[static_cast<std::size_t>(index)].id));
    return;
  }
  straight_ = bent_links(*now->fit->problem.source, index, {});
  robot_->set_posture(straight_);
  robot_->set_selected_observation(session.observations[static_cast<std::size_t>(index)].id);
  set_ghost(bent_links(*now->fit->problem.source, index, list_terms(*now->fit)));
}

void WatchingPane::set_ghost(const std::vector<Rigid>& bent) {
  const double largest = largest_motion(straight_, bent);
  const Session& session = workbench_.document.session();
  const auto id = session.observations[static_cast<std::size_t>(selected_index())].id;
  if (largest < 1e-7) {
    robot_->set_ghost(std::nullopt);
    robot_title_->setText(tr("Observation %1; the model bends nothing").arg(id));
    return;
  }
  if (!adding_.is_running() || magnification_ <= 1) magnification_ = round_magnification(largest, 0.12);
  robot_->set_ghost_magnification(magnification_);
  robot_->set_ghost(bent);
  robot_title_->setText(tr("Observation %1, bent by the model: %2 mm, drawn %3 ×")
                            .arg(id)
                            .arg(widgets::short_text(1e3 * largest))
                            .arg(magnification_));
}

void WatchingPane::show_posture(const Eigen::VectorXd& position) {
  robot_->set_posture(link_motions(workbench_.document.session(), position));
  robot_->set_ghost(std::nullopt);
  robot_title_->setText(tr("The planned pose"));
}

void WatchingPane::bend(double share) {
  // Without a graphics card the robot costs more than the cloud: half as often is enough for it.
  constexpr int ms_between_robots = 75;
  if (share < 1 && since_robot_.isValid() && since_robot_.elapsed() < ms_between_robots) return;
  since_robot_.start();
  bent_now_ = bent_to_;
  for (std::size_t i = 0; i < bent_now_.size(); ++i) {
    const Rigid &from = bent_from_[i], &to = bent_to_[i];
    bent_now_[i].translation = from.translation + share * (to.translation - from.translation);
    const Vector3 turn = share * vector_from_rotation(from.rotation.transpose() * to.rotation);
    bent_now_[i].rotation = from.rotation * rotation_from_vector<double>(turn);
  }
  set_ghost(bent_now_);
}

}  // namespace handsight::app
