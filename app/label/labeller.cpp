// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/labeller.h"

#include <QObject>
#include <algorithm>

#include "estimation/problem/running_shape.h"
#include "vision/markers/marker_numbering.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

constexpr double snap_distance = 12;  // px, as handsight-cli label has it

Corner free_corner(const Vector2& px) {
  Corner corner;
  corner.position = px;
  corner.covariance = 0.25 * Eigen::Matrix2d::Identity();  // a steady hand under the loupe: half a pixel
  return corner;
}

/// The markers as labels of other observations show them; what a play has found follows those and says nothing new.
KnownMarkers known_from_others(const Session& session, std::int64_t except) {
  KnownMarkers known{std::vector<std::optional<Vector3>>(static_cast<std::size_t>(session.marker_count)), {}};
  known.sigma.resize(known.in_body.size(), 0);
  if (!session.rig || !is_pair(*session.rig)) return known;
  constexpr int enough = 20;
  RunningShape shape(session.marker_count);
  int taken = 0;
  for (const Observation& o : session.observations) {
    if (o.id == except || !is_used(o) || taken >= enough) continue;
    std::vector<Sighting> labels;
    for (const Sighting& s : o.sightings)
      if (s.in_cameras.size() > 1 && s.by != MarkedBy::tracker) labels.push_back(s);
    if (labels.size() < 3) continue;
    shape.add(&*session.rig, labels, session.sigma_pixel.value_or(0.3));
    ++taken;
  }
  if (taken == 0) return known;
  known.in_body = shape.markers();
  known.sigma = shape.sigmas();
  return known;
}

}  // namespace

void Labeller::start(const Session& session, const Observation& observation, CornersOfPair corners,
                     const LabelDraft* draft) {
  rig_ = session.rig && is_pair(*session.rig) ? std::optional(make_stereo(*session.rig)) : std::nullopt;
  marker_count_ = session.marker_count;
  known_ = known_from_others(session, observation.id);
  markers_.clear();
  placed_ = -1;
  corners_ = std::move(corners);
  for (const Sighting& s : observation.sightings) {
    const CameraPoint *left = seen_by(s, 0), *right = seen_by(s, 1);
    if (!left) continue;
    LabelMarker& marker = markers_[s.marker];
    marker.left = labelled_corner(corners_.left, left->pixel);
    if (!right) continue;
    marker.right = labelled_corner(corners_.right, right->pixel);
    marker.right_is_chosen = true;
  }
  own_ = as_draft();
  if (draft) {
    markers_.clear();
    for (const DraftMarker& d : *draft) {
      LabelMarker& marker = markers_[d.marker];
      marker.left = d.left_is_free ? free_corner(d.left) : labelled_corner(corners_.left, d.left);
      marker.left_is_free = d.left_is_free;
      if (!d.right) continue;
      marker.right = labelled_corner(corners_.right, *d.right);
      marker.right_is_chosen = true;
    }
  }
  find_partners();
}

LabelDraft Labeller::as_draft() const {
  LabelDraft draft;
  for (const auto& [number, m] : markers_)
    draft.push_back({number, m.left.position, m.left_is_free,
                     m.right_is_chosen && m.right ? std::optional(m.right->position) : std::nullopt});
  return draft;
}

std::optional<LabelDraft> Labeller::draft() const {
  LabelDraft now = as_draft();
  return own_ == now ? std::nullopt : std::optional(std::move(now));
}

std::map<int, int> Labeller::numbers_by_sides() const {
  std::vector<NumberedPoint> points;
  for (const auto& [number, m] : markers_) {
    if (!m.point) return {};
    points.push_back({number, m.point->point, m.point->covariance});
  }
  const auto numbers = handsight::numbers_by_sides(points, known_);
  std::map<int, int> by_number;
  if (numbers)
    for (std::size_t i = 0; i < points.size(); ++i) by_number[points[i].marker] = (*numbers)[i];
  return by_number;
}

void Labeller::renumber_all(const std::map<int, int>& numbers) {
  std::map<int, LabelMarker> renumbered;
  for (auto& [number, m] : markers_) {
    const auto found = numbers.find(number);
    renumbered[found == numbers.end() ? number : found->second] = std::move(m);
  }
  markers_ = std::move(renumbered);
  find_partners();
}

void Labeller::set_corners(CornersOfPair corners) {
  corners_ = std::move(corners);
  find_partners();
}

std::optional<Corner> Labeller::nearest(const std::vector<Corner>& corners, const Vector2& px) const {
  const Corner* best = nullptr;
  for (const Corner& c : corners)
    if (!best || (c.position - px).squaredNorm() < (best->position - px).squaredNorm()) best = &c;
  if (!best || (best->position - px).norm() > snap_distance) return std::nullopt;
  return *best;
}

Corner Labeller::labelled_corner(const std::vector<Corner>& corners, const Vector2& px) const {
  Corner corner = nearest(corners, px).value_or(free_corner(px));
  corner.position = px;
  return corner;
}

QString Labeller::point(const Vector2& px, bool free) {
  placed_ = -1;
  int number = 0;
  while (markers_.contains(number)) ++number;
  if (number >= marker_count_)
    return marker_count_ == 1
               ? QObject::tr("The marker is placed. Drag it, or remove it first.")
               : QObject::tr("All %1 markers are placed. Drag one, or remove it first.").arg(marker_count_);
  LabelMarker marker;
  if (free) {
    marker.left = free_corner(px);
    marker.left_is_free = true;
  } else {
    const auto corner = nearest(corners_.left, px);
    if (!corner) return QObject::tr("No corner within 12 px. Hold Alt to set it freely.");
    for (const auto& [other, placed] : markers_)
      if ((placed.left.position - corner->position).norm() < 0.5)
        return QObject::tr("Marker %1 is on this corner already. Take another corner.").arg(other);
    marker.left = *corner;
  }
  markers_[number] = marker;
  placed_ = number;
  find_partners();
  return {};
}

void Labeller::move(int marker, bool left, const Vector2& px, bool free) {
  const auto found = markers_.find(marker);
  if (found == markers_.end()) return;
  LabelMarker& m = found->second;
  const auto corner = free ? std::nullopt : nearest(left ? corners_.left : corners_.right, px);
  Corner placed = corner.value_or(left ? m.left : m.right.value_or(free_corner(px)));
  if (!corner) placed.position = px;
  if (left) {
    m.left = placed;
    m.left_is_free = !corner;
  } else {
    m.right = placed;
    m.right_is_chosen = true;
  }
  find_partners();
}

void Labeller::remove(int marker) {
  markers_.erase(marker);
  find_partners();
}

void Labeller::renumber(int marker, int to) {
  if (marker == to || to < 0 || to >= marker_count_ || !markers_.contains(marker)) return;
  const LabelMarker moved = markers_[marker];
  if (markers_.contains(to)) {
    markers_[marker] = markers_[to];
  } else {
    markers_.erase(marker);
  }
  markers_[to] = moved;
  find_partners();
}

void Labeller::choose_partner(int marker, int right_corner) {
  const auto found = markers_.find(marker);
  if (found == markers_.end() || right_corner < 0 || right_corner >= static_cast<int>(corners_.right.size())) return;
  found->second.right = corners_.right[static_cast<std::size_t>(right_corner)];
  found->second.right_is_chosen = true;
  find_partners();
}

void Labeller::find_partners() {
  refusal_.clear();
  if (!rig_ || markers_.empty()) return;
  std::vector<Corner> lefts;
  std::vector<Vector2> pointed;
  bool any_chosen = false;
  for (const auto& [number, m] : markers_) {
    lefts.push_back(m.left);
    pointed.push_back(m.left.position);
    any_chosen = any_chosen || m.right_is_chosen;
  }
  const FirstLabels together = any_chosen ? FirstLabels{} : label_first(*rig_, lefts, corners_.right, pointed);
  std::size_t place = 0;
  for (auto& [number, m] : markers_) {
    const std::size_t i = place++;
    if (m.right_is_chosen) continue;
    m.right.reset();
    if (!together.markers.empty()) {
      for (const Corner& c : corners_.right)
        if (c.position == together.markers[i].right) m.right = c;
      continue;
    }
    const auto pairs = corner_pairs(*rig_, {m.left}, corners_.right);
    const auto best = std::min_element(pairs.begin(), pairs.end(), [](const CornerPair& a, const CornerPair& b) {
      return a.point.epipolar_distance + 2 * a.unlikeness < b.point.epipolar_distance + 2 * b.unlikeness;
    });
    if (best != pairs.end()) m.right = corners_.right[static_cast<std::size_t>(best->right)];
  }
  std::vector<Corner> rights;
  for (auto& [number, m] : markers_) {
    m.point.reset();
    if (!m.right) continue;
    m.point = triangulate(*rig_, m.left.position, m.right->position, m.left.covariance, m.right->covariance);
    rights.push_back(*m.right);
  }
  // With the partners that are taken now, the same judgement as on the command line.
  if (static_cast<int>(markers_.size()) >= wanted())
    refusal_ = translated(
        (together.markers.empty() && any_chosen ? label_first(*rig_, lefts, rights, pointed) : together).refusal);
}

std::vector<LabelCandidate> Labeller::candidates(int marker) const {
  std::vector<LabelCandidate> list;
  const auto found = markers_.find(marker);
  if (!rig_ || found == markers_.end()) return list;
  const LabelMarker& m = found->second;
  PairOptions options;
  options.epipolar_threshold = 6;  // px: shown are more than are taken by themselves
  for (const CornerPair& pair : corner_pairs(*rig_, {m.left}, corners_.right, options)) {
    LabelCandidate c{.corner = pair.right, .position = corners_.right[static_cast<std::size_t>(pair.right)].position};
    c.distance = pair.point.epipolar_distance;
    c.depth = pair.point.point.z();
    c.is_taken = m.right && (m.right->position - c.position).norm() < 1e-9;
    double worst = 0;
    bool has_other = false;
    for (const auto& [number, other] : markers_) {
      if (number == marker || !other.point) continue;
      has_other = true;
      if (!m.point) continue;
      const double now = (other.point->point - m.point->point).norm();
      const double then = (other.point->point - pair.point.point).norm();
      if (std::abs(then - now) > std::abs(worst)) worst = then - now;
    }
    if (has_other && m.point) c.misfit_m = worst;
    list.push_back(c);
  }
  std::sort(list.begin(), list.end(),
            [](const LabelCandidate& a, const LabelCandidate& b) { return a.distance < b.distance; });
  if (list.size() > 12) list.resize(12);
  return list;
}

std::vector<Vector2> Labeller::epipolar_line(const Vector2& left) const {
  std::vector<Vector2> line;
  if (!rig_) return line;
  const auto ray = undistort(rig_->left, left);
  if (!ray) return line;
  for (int i = 0; i <= 60; ++i) {
    const double depth = 0.15 * std::pow(10.0 / 0.15, i / 60.0);  // m
    const Vector3 x(depth * ray->x(), depth * ray->y(), depth);
    const Vector3 in_right = rig_->right_from_left * x;
    if (in_right.z() < 0.05 || !is_visible(rig_->right, in_right, -200)) continue;
    line.push_back(project(rig_->right, in_right));
  }
  return line;
}

int Labeller::wanted() const { return std::min(3, marker_count_); }

bool Labeller::will_do() const {
  if (static_cast<int>(markers_.size()) < wanted() || !refusal_.isEmpty()) return false;
  return std::all_of(markers_.begin(), markers_.end(), [](const auto& m) { return m.second.point.has_value(); });
}

std::vector<Sighting> Labeller::sightings() const {
  std::vector<Sighting> list;
  for (const auto& [number, m] : markers_) {
    Sighting s{.marker = number, .by = MarkedBy::hand};
    see(s, 0, m.left.position, pixel_sigma(measured_covariance(m.left)));
    if (m.right) see(s, 1, m.right->position, pixel_sigma(measured_covariance(*m.right)));
    list.push_back(s);
  }
  return list;
}

std::optional<double> Labeller::side_sigma(int from, int to) const {
  const auto a = markers_.find(from), b = markers_.find(to);
  if (a == markers_.end() || b == markers_.end() || !a->second.point || !b->second.point) return std::nullopt;
  const Vector3 d = b->second.point->point - a->second.point->point;
  if (d.norm() < 1e-9) return std::nullopt;
  const Vector3 u = d.normalized();
  return std::sqrt(u.dot((a->second.point->covariance + b->second.point->covariance) * u));
}

}  // namespace handsight::app
