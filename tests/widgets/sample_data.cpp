// SPDX-License-Identifier: Apache-2.0
#include "widgets/sample_data.h"

#include <cmath>

#include "chain/chain.h"
#include "estimation/online/online.h"
#include "robot/posture.h"
#include "session/session_xml.h"

namespace handsight::test {
namespace {

using namespace widgets;

const ProblemObservation* problem_of(const Fit& fit, int index) {
  for (const ProblemObservation& o : fit.problem.observations)
    if (o.index == index) return &o;
  return nullptr;
}

}  // namespace

SampleData read_sample(const char* name) {
  SampleData data;
  data.session = read_session(std::string(HANDSIGHT_SOURCE_DIR) + "/sample_sessions/" + name);
  data.fit = fit(data.session);
  data.report = report(data.session, data.fit);
  data.noise = data.fit.noise.value_or(0.2);
  return data;
}

std::vector<ObservationCell> SampleData::cells() const {
  std::vector<ObservationCell> all;
  for (const Observation& o : session.observations) all.push_back({o.id, CellState::waiting, {}, {}, 12, {}});
  for (const ObservationReport& r : report.per_observation) {
    ObservationCell& cell = all[static_cast<std::size_t>(r.index)];
    cell.state = CellState::used;
    if (r.rms_pixel) cell.rms_over_sigma = *r.rms_pixel / noise;
  }
  if (all.size() > 7) {
    all[4].state = CellState::excluded;
    all[7].state = CellState::rejected;
    all[7].note = "joints moved 0.7 deg since observation 6; 2 deg count as new";
  }
  return all;
}

std::vector<ObservationRow> SampleData::rows() const {
  std::vector<ObservationRow> all;
  const auto states = cells();
  for (std::size_t i = 0; i < states.size(); ++i) {
    ObservationRow row;
    row.id = states[i].id;
    row.state = states[i].state;
    row.rms_over_sigma = states[i].rms_over_sigma;
    row.reason = states[i].note;
    all.push_back(row);
  }
  for (const ObservationReport& r : report.per_observation) {
    ObservationRow& row = all[static_cast<std::size_t>(r.index)];
    row.rms_pixel = r.rms_pixel;
    if (r.rms_m) row.rms_mm = 1000 * *r.rms_m;
    if (r.deviation) row.angle_deg = vector_from_rotation(r.deviation->tcp_from_tcp_est.rotation).norm() * 180 / M_PI;
    row.worst = "2, right";
    row.worst_over_sigma = row.rms_over_sigma;
    row.is_odd = r.outlier;
    if (r.outlier) row.reason = "the whole pose is off";
  }
  return all;
}

std::vector<MapPoint> SampleData::map_points() const {
  std::vector<MapPoint> points;
  for (const ProblemObservation& o : fit.problem.observations) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, estimate(fit).mount_from_sensor);
    for (const Sighting& s : o.sightings) {
      const Vector3 x = sensor_from_tcp * estimate(fit).markers_in_tcp[static_cast<std::size_t>(s.marker)];
      const auto add = [&](int camera, const CameraPoint* seen, const Vector2& predicted) {
        if (!seen) return;
        const Vector2 residual = seen->pixel - predicted;
        points.push_back({session.observations[static_cast<std::size_t>(o.index)].id, s.marker, camera, seen->pixel,
                          residual, residual.norm() / std::sqrt(2.0) / noise});
      };
      add(0, seen_by(s, 0), project(session.rig->at(0).camera, x));
      add(1, seen_by(s, 1), project(session.rig->at(1).camera, Vector3(session.rig->at(1).camera_from_first * x)));
    }
  }
  return points;
}

std::vector<ConvergencePoint> SampleData::convergence() const {
  std::vector<ConvergencePoint> points;
  OnlineCalibration online(session);
  for (const Observation& o : session.observations) {
    const OnlineStep step = online.add(o, nullptr);
    if (!step.accepted || !step.has_estimate) continue;
    ConvergencePoint point;
    point.count = static_cast<int>(step.kept);
    point.observation = o.id;
    point.tcp_from_body << step.tcp_from_body.translation, vector_from_rotation(step.tcp_from_body.rotation);
    point.sigma = step.sigma;
    if (step.tcp_from_tcp_est) {
      Vector6 v;
      v << step.tcp_from_tcp_est->translation, vector_from_rotation(step.tcp_from_tcp_est->rotation);
      point.tcp_from_tcp_est = v;
    }
    points.push_back(point);
  }
  return points;
}

std::vector<SceneArrow> SampleData::arrows() const {
  std::vector<SceneArrow> arrows;
  for (const ObservationReport& r : report.per_observation) {
    const ProblemObservation* o = problem_of(fit, r.index);
    if (!r.deviation || !o) continue;
    arrows.push_back({r.id, o->root_from_tcp.translation,
                      o->root_from_tcp.rotation * r.deviation->tcp_from_tcp_est.translation,
                      r.rms_pixel ? std::optional(*r.rms_pixel / noise) : std::nullopt, 12});
  }
  return arrows;
}

std::vector<Rigid> SampleData::posture(int observation) const {
  const Chain chain = make_chain(session);
  const auto& o = session.observations[static_cast<std::size_t>(observation)];
  return solve_posture(chain.robot, joint_values(chain.robot, chain.joints, o.position), chain.gravity).root_from_link;
}

Rigid SampleData::root_from_tcp(int observation) const {
  return posture(observation)[static_cast<std::size_t>(find_link(session.robot, session.tcp))];
}

std::vector<SceneCamera> SampleData::cameras(int observation) const {
  const Rigid left = posture(observation)[static_cast<std::size_t>(find_link(session.robot, session.mount.link))] *
                     session.mount.mount_from_sensor;
  return {{"left", left, session.rig->at(0).camera},
          {"right", left * inverse(session.rig->at(1).camera_from_first), session.rig->at(1).camera}};
}

void SampleData::show_in(ImageView& view, int observation) const {
  const Observation& o = session.observations[static_cast<std::size_t>(observation)];
  view.set_title(QString("Left, %1").arg(QString::fromStdString(o.images[0])));
  if (!o.images[0].empty()) view.set_image(QImage(QString::fromStdString((folder(session) / o.images[0]).string())));
  if (view.image().isNull()) view.set_frame_size(session.rig->at(0).camera.width, session.rig->at(0).camera.height);
  const Rigid left_from_tcp = inverse(cameras(observation)[0].root_from_camera) * root_from_tcp(observation);
  std::vector<ImageMark> marks;
  std::vector<ImageArrow> arrows;
  for (int m = 0; m < session.marker_count; ++m) {
    const Vector3 in_tcp = estimate(fit).markers_in_tcp[static_cast<std::size_t>(m)];
    const Vector2 predicted = project(session.rig->at(0).camera, Vector3(left_from_tcp * in_tcp));
    for (const Sighting& s : o.sightings) {
      const CameraPoint* const left = seen_by(s, 0);
      if (s.marker != m || !left) continue;
      const Vector2 residual = left->pixel - predicted;
      marks.push_back({m, left->pixel, MarkRole::measured, residual.norm() / std::sqrt(2.0) / noise, 2, {}});
      arrows.push_back({predicted, residual, residual.norm() / std::sqrt(2.0) / noise, 2});
    }
    marks.push_back({m, predicted, MarkRole::predicted, {}, 2, {}});
  }
  view.set_marks(marks);
  view.set_arrows(arrows);
  std::vector<ImageAxes> axes;
  for (const bool is_estimate : {false, true}) {
    const Rigid shifted =
        left_from_tcp * Rigid{Matrix3::Identity(), is_estimate ? Vector3(0.01, -0.02, 0) : Vector3(0, 0, 0)};
    ImageAxes a;
    a.is_estimate = is_estimate;
    a.origin = project(session.rig->at(0).camera, shifted.translation);
    for (int i = 0; i < 3; ++i)
      a.tips[static_cast<std::size_t>(i)] =
          project(session.rig->at(0).camera, Vector3(shifted * Vector3(0.08 * Vector3::Unit(i))));
    axes.push_back(a);
  }
  view.set_axes(axes);
}

std::vector<ObservationCell> many_cells(int count) {
  std::vector<ObservationCell> cells;
  for (int i = 0; i < count; ++i) {
    ObservationCell cell;
    cell.id = i;
    cell.state = i % 101 == 100 ? CellState::excluded : i % 17 == 16 ? CellState::rejected : CellState::used;
    cell.rms_over_sigma = 0.7 + 0.5 * std::abs(std::sin(0.37 * i)) + (i % 211 == 5 ? 8.0 : 0.0);
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace handsight::test
