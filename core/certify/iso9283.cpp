// SPDX-License-Identifier: Apache-2.0
#include "certify/iso9283.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// With n - 1, as the standard has it.
double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0;
  for (const double v : values) squares += (v - middle) * (v - middle);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Vector3 turn_from(const Rigid& commanded, const Rigid& attained) {
  return vector_from_rotation(attained.rotation * commanded.rotation.transpose());
}

Vector3 mean_position(const std::vector<Rigid>& poses) {
  Vector3 sum = Vector3::Zero();
  for (const Rigid& p : poses) sum += p.translation;
  return sum / static_cast<double>(poses.size());
}

Vector3 mean_turn(const Rigid& commanded, const std::vector<Rigid>& poses) {
  Vector3 sum = Vector3::Zero();
  for (const Rigid& p : poses) sum += turn_from(commanded, p);
  return sum / static_cast<double>(poses.size());
}

void set_repeatability(const Rigid& commanded, const std::vector<Rigid>& attained, PoseFigures& f) {
  std::vector<double> lengths;
  for (const Rigid& p : attained) lengths.push_back((p.translation - f.barycentre).norm());
  f.rp = mean(lengths) + 3 * deviation(lengths);
  f.rp_abc = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> turns;
    for (const Rigid& p : attained) turns.push_back(turn_from(commanded, p)[axis]);
    (*f.rp_abc)[axis] = 3 * deviation(turns);
  }
}

}  // namespace

PoseFigures pose_figures(const Rigid& commanded, const std::vector<Rigid>& attained) {
  PoseFigures f;
  f.cycles = static_cast<int>(attained.size());
  f.barycentre = mean_position(attained);
  f.ap_xyz = f.barycentre - commanded.translation;
  f.ap = f.ap_xyz.norm();
  f.ap_abc = mean_turn(commanded, attained);
  if (attained.size() >= 2) set_repeatability(commanded, attained, f);
  return f;
}

DirectionFigures direction_figures(const Rigid& commanded, const std::vector<std::vector<Rigid>>& by_direction) {
  DirectionFigures f;
  for (std::size_t h = 0; h < by_direction.size(); ++h)
    for (std::size_t k = 0; k < h; ++k) {
      f.vap = std::max(f.vap, (mean_position(by_direction[h]) - mean_position(by_direction[k])).norm());
      const Vector3 turned = mean_turn(commanded, by_direction[h]) - mean_turn(commanded, by_direction[k]);
      f.vap_abc = f.vap_abc.cwiseMax(turned.cwiseAbs());
    }
  return f;
}

DistanceFigures distance_figures(const Rigid& commanded_1, const std::vector<Rigid>& attained_1,
                                 const Rigid& commanded_2, const std::vector<Rigid>& attained_2) {
  DistanceFigures f;
  std::vector<double> distances;
  for (std::size_t j = 0; j < std::min(attained_1.size(), attained_2.size()); ++j)
    distances.push_back((attained_1[j].translation - attained_2[j].translation).norm());
  f.cycles = static_cast<int>(distances.size());
  f.commanded = (commanded_1.translation - commanded_2.translation).norm();
  if (distances.empty()) return f;
  f.ad = mean(distances) - f.commanded;
  if (distances.size() >= 2) f.rd = 3 * deviation(distances);
  return f;
}

}  // namespace handsight
