// SPDX-License-Identifier: Apache-2.0
#include "simulation/shown_target.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chain/arrangement.h"
#include "targets/pattern.h"

namespace handsight {
namespace {

constexpr double board_thickness = 0.004;  // m

Eigen::VectorXd drawn(const Chain& chain, double share, Random& random) {
  Eigen::VectorXd position(static_cast<Eigen::Index>(chain.joints.size()));
  for (Eigen::Index j = 0; j < position.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    const bool is_bounded = joint.lower > -1e29 && joint.upper < 1e29;
    const double lower = is_bounded ? joint.lower : -std::numbers::pi,
                 upper = is_bounded ? joint.upper : std::numbers::pi;
    position[j] = 0.5 * (lower + upper) + share * 0.5 * (upper - lower) * random.uniform(-1, 1);
  }
  return position;
}

/// The middle of the points and their outward normal, in the frame of the target.
Vector3 middle_of(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& x : points) middle += x / static_cast<double>(points.size());
  return middle;
}

/// A frame whose z goes into the sheet that faces `normal`, turned about it.
Matrix3 facing(const Vector3& normal, double turn) {
  return rotation_about(normal, turn) * axes_from(-normal, normal.unitOrthogonal());
}

/// Where the target's middle is and how it is turned, in the TCP frame.
Rigid place_on_hand(double size, Random& random) {
  const Vector3 normal = random.gaussian3().normalized();
  const Vector3 aside = normal.unitOrthogonal();
  const double far = 0.04 + 0.2 * size * random.uniform();
  return {facing(normal, random.uniform(0, 2 * std::numbers::pi)), far * normal + 0.02 * random.gaussian() * aside};
}

/// Under the camera in that of many postures in which it looks down most, as far below as it is to be seen from.
Rigid place_on_table(const Session& like, const SimulationOptions& options, Random& random) {
  const Chain chain = chain_of(like);
  const Vector3 up = like.gravity.norm() > 0 ? Vector3(-like.gravity.normalized()) : Vector3::UnitZ();
  Rigid best;
  double most = -2;
  for (int i = 0; i < 400; ++i) {
    const ChainEnds ends = chain_ends(chain, drawn(chain, options.joint_range, random));
    const Rigid tcp_from_sensor = inverse(sensor_from_tcp(ends, like.mount.mount_from_sensor));
    const Vector3 up_in_tcp = ends.root_from_tcp.rotation.transpose() * up;
    const double down = -tcp_from_sensor.rotation.col(2).dot(up_in_tcp);
    if (down <= most) continue;
    most = down;
    const double distance = std::clamp(0.55, 1.1 * options.nearest, 0.9 * options.farthest);
    best = {facing(up_in_tcp, random.uniform(0, 2 * std::numbers::pi)),
            tcp_from_sensor.translation + distance * tcp_from_sensor.rotation.col(2)};
  }
  return best;
}

double size_of(const std::vector<Vector3>& points, const Vector3& middle) {
  double radius = 0;
  for (const Vector3& x : points) radius = std::max(radius, (x - middle).norm());
  return 2 * radius;
}

/// Where the pieces lie to each other: side by side, tilted and out of plane a little.
std::vector<Rigid> lay_out(const KnownShape& shape, double size, Random& random) {
  const int count = shape.piece_count();
  if (count == 1) return {Rigid{Matrix3::Identity(), -middle_of(shape.markers)}};
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<Rigid> pieces;
  for (int p = 0; p < count; ++p) {
    const Vector3 tilt = 0.1 * random.gaussian3();
    const int column = p % columns, row = p / columns;
    const Vector3 place(1.7 * size * (column - 0.5 * (columns - 1)), 1.7 * size * (row - 0.5 * (columns - 1)),
                        0.2 * size * random.uniform(-1, 1));
    pieces.push_back({rotation_from_vector<double>(tilt), place});
  }
  return pieces;
}

/// Where a piece is by its points.
Rigid tcp_from_piece(const KnownShape& shape, const std::vector<Vector3>& points_in_tcp, int piece) {
  std::vector<std::size_t> own;
  for (std::size_t m = 0; m < shape.markers.size(); ++m)
    if (shape.piece(m) == piece) own.push_back(m);
  const auto count = static_cast<Eigen::Index>(own.size());
  Eigen::Matrix3Xd in_tcp(3, count), in_piece(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    in_tcp.col(i) = points_in_tcp[own[static_cast<std::size_t>(i)]];
    in_piece.col(i) = shape.markers[own[static_cast<std::size_t>(i)]];
  }
  return align_points(in_tcp, in_piece, Eigen::VectorXd::Ones(count));
}

/// The sheet's frame: its middle, x to the right, y up and z out of it.
Rigid piece_from_sheet(const Box& outline) {
  Matrix3 axes = Matrix3::Identity();
  axes(1, 1) = axes(2, 2) = -1;
  const Vector2 middle = outline.top_left + 0.5 * outline.size;
  return {axes, Vector3(middle.x(), middle.y(), 0)};
}

/// White paper round the print.
double rim_of(const Target& target) {
  return target.kind == TargetKind::chessboard || target.kind == TargetKind::charuco ? 0.5 * target.square
                                                                                     : 0.25 * target.tag;
}

}  // namespace

bool tcp_is_moved(const Chain& chain) { return arrangement_of(chain) != Arrangement::sensor_on_hand; }

ShownBody shown_target(const Session& like, const SimulationOptions& options, double printed_off, Random random) {
  const KnownShape& shape = *like.shape;
  const double piece_size = 1.2 * size_of(target_points(*like.target).size() > 4 && shape.piece_count() == 1
                                              ? shape.markers
                                              : std::vector<Vector3>(shape.markers.begin(), shape.markers.begin() + 4),
                                          shape.piece_count() == 1 ? middle_of(shape.markers) : Vector3::Zero().eval());
  const Rigid tcp_from_target =
      tcp_is_moved(chain_of(like)) ? place_on_hand(piece_size, random) : place_on_table(like, options, random);
  const std::vector<Rigid> pieces = lay_out(shape, piece_size, random);
  ShownBody body;
  for (std::size_t m = 0; m < shape.markers.size(); ++m)
    body.markers_in_tcp.push_back(tcp_from_target * pieces[static_cast<std::size_t>(shape.piece(m))] *
                                  Vector3(shape.markers[m] + printed_off * random.gaussian3()));
  body.normal_in_tcp = -tcp_from_target.rotation.col(2);
  return body;
}

ShownBody outermost(const Session& like, const ShownBody& target) {
  const KnownShape& shape = *like.shape;
  ShownBody few;
  few.normal_in_tcp = target.normal_in_tcp;
  for (int piece = 0; piece < shape.piece_count(); ++piece)
    for (const Vector2& way : {Vector2(1, 1), Vector2(1, -1), Vector2(-1, 1), Vector2(-1, -1)}) {
      std::size_t best = shape.markers.size();
      for (std::size_t m = 0; m < shape.markers.size(); ++m)
        if (shape.piece(m) == piece && (best == shape.markers.size() ||
                                        way.dot(shape.markers[m].head<2>()) > way.dot(shape.markers[best].head<2>())))
          best = m;
      few.markers_in_tcp.push_back(target.markers_in_tcp[best]);
    }
  return few;
}

void move_target(const Session& session, const std::vector<Vector3>& points_in_tcp, Scene& scene) {
  for (int piece = 0; piece < session.shape->piece_count(); ++piece) {
    const auto i = static_cast<std::size_t>(piece);
    Plate& sheet = scene.hand_plates[i];
    const Rigid tcp_from_sheet = tcp_from_piece(*session.shape, points_in_tcp, piece) *
                                 piece_from_sheet(pattern_of(*session.target, piece).outline);
    sheet.frame_from_plate = tcp_from_sheet;
    // The sheet stands a little above its board, so that neither cuts through the other.
    scene.hand[i].frame_from_solid =
        tcp_from_sheet * Rigid{Matrix3::Identity(), {0, 0, -0.5 * board_thickness - 0.0005}};
  }
}

void add_target(const Session& session, const std::vector<Vector3>& points_in_tcp, bool on_hand, Scene& scene) {
  const double rim = rim_of(*session.target);
  for (int piece = 0; piece < session.shape->piece_count(); ++piece) {
    const Box outline = pattern_of(*session.target, piece).outline;
    Plate sheet;
    sheet.pattern = Pattern::printed;
    sheet.half_size = 0.5 * outline.size + Vector2::Constant(rim);
    sheet.print = std::make_shared<const BlackAt>(*session.target, piece);
    sheet.print_middle = outline.top_left + 0.5 * outline.size;
    sheet.dark = 35;
    sheet.light = 210;
    scene.hand_plates.push_back(sheet);
    Solid board;
    board.half_size = {sheet.half_size.x(), sheet.half_size.y(), 0.5 * board_thickness};
    board.grey = 105;
    scene.hand.push_back(board);
  }
  move_target(session, points_in_tcp, scene);
  if (!on_hand) return;
  const Rigid& board = scene.hand.front().frame_from_solid;
  Solid arm;  // behind the board
  arm.kind = SolidKind::capsule;
  arm.half_size = {0.035, 0.035, 0.08};
  arm.frame_from_solid = board * Rigid{Matrix3::Identity(), {0, 0, -0.5 * board_thickness - 0.12}};
  arm.grey = 90;
  scene.hand.push_back(arm);
}

}  // namespace handsight
