// SPDX-License-Identifier: Apache-2.0
#include "simulation/shown_target.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "chain/arrangement.h"
#include "simulation/hand.h"
#include "simulation/shown_tags.h"
#include "targets/pattern.h"

namespace handsight {
namespace {

constexpr double board_thickness = 0.004;  // m

/// From the share of the limits; of a sliding joint without any, from what was taken of it.
Eigen::VectorXd drawn(const Session& like, const Chain& chain, double share, Random& random) {
  Eigen::VectorXd position(static_cast<Eigen::Index>(chain.joints.size()));
  for (Eigen::Index j = 0; j < position.size(); ++j) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
    const bool is_bounded = joint.lower > -1e29 && joint.upper < 1e29;
    JointSpan span{is_bounded ? joint.lower : -std::numbers::pi, is_bounded ? joint.upper : std::numbers::pi};
    if (!is_bounded && joint.kind == JointKind::prismatic) span = joint_span(like, joint, j, share);
    position[j] = 0.5 * (span.lower + span.upper) + share * 0.5 * (span.upper - span.lower) * random.uniform(-1, 1);
  }
  return position;
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
  const Chain chain = make_chain(like);
  const Vector3 up = like.gravity.norm() > 0 ? Vector3(-like.gravity.normalized()) : Vector3::UnitZ();
  Rigid best;
  double most = -2;
  for (int i = 0; i < 400; ++i) {
    const ChainEnds ends = chain_ends(chain, drawn(like, chain, options.joint_range, random));
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

double measure_size(const std::vector<Vector3>& points, const Vector3& middle) {
  double radius = 0;
  for (const Vector3& x : points) radius = std::max(radius, (x - middle).norm());
  return 2 * radius;
}

/// Where the pieces lie to each other: side by side, tilted and out of plane a little.
std::vector<Rigid> lay_out(const KnownShape& shape, double size, Random& random) {
  const int count = shape.piece_count();
  if (count == 1) return {Rigid{Matrix3::Identity(), -mean_point(shape.markers)}};
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

/// Where a printed piece is by its points.
Rigid tcp_from_piece(const std::vector<TargetPoint>& printed, const std::vector<Vector3>& points_in_tcp, int piece) {
  std::vector<std::size_t> own;
  for (std::size_t m = 0; m < printed.size(); ++m)
    if (printed[m].piece == piece) own.push_back(m);
  const auto count = static_cast<Eigen::Index>(own.size());
  Eigen::Matrix3Xd in_tcp(3, count), in_piece(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    in_tcp.col(i) = points_in_tcp[own[static_cast<std::size_t>(i)]];
    in_piece.col(i) = printed[own[static_cast<std::size_t>(i)]].position;
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

/// White paper round the print of a piece.
double rim_of(const Target& target, int piece) {
  if (has_places(target)) return rim_of_tag(target, static_cast<std::size_t>(piece));
  return target.kind == TargetKind::chessboard || target.kind == TargetKind::charuco ? 0.5 * target.square
                                                                                     : 0.25 * target.tag;
}

/// Where the arm is that carries the target: behind the board, or where a body of tags shows none; nothing where it has
/// tags all round.
std::optional<Rigid> arm_behind(const Session& session, const std::vector<Vector3>& points_in_tcp,
                                const Rigid& first_board) {
  constexpr double reach = 0.12;  // m, from the board to the middle of the arm
  const std::vector<Vector3> faces = face_normals(*session.target);
  if (faces.empty()) return first_board * Rigid{Matrix3::Identity(), {0, 0, -0.5 * board_thickness - reach}};
  const std::vector<TargetPoint> described = target_points(*session.target);
  Eigen::Matrix3Xd there(3, faces.size()), here(3, faces.size());
  Vector3 open = Vector3::Zero();
  for (std::size_t m = 0; m < faces.size(); ++m) {
    here.col(static_cast<Eigen::Index>(m)) = described[m].position;
    there.col(static_cast<Eigen::Index>(m)) = points_in_tcp[m];
    open -= faces[m] / static_cast<double>(faces.size());
  }
  if (open.norm() < 0.05) return std::nullopt;
  const Vector3 middle = mean_point(points_in_tcp);
  const Rigid tcp_from_target = align_points(there, here, Eigen::VectorXd::Ones(here.cols()));
  const Vector3 along = tcp_from_target.rotation * open.normalized();
  return Rigid{axes_from(along, along.unitOrthogonal()),
               middle + (0.5 * measure_size(points_in_tcp, middle) + reach) * along};
}

}  // namespace

bool tcp_is_moved(const Chain& chain) { return find_arrangement(chain) != Arrangement::sensor_on_hand; }

ShownBody shown_target(const Session& like, const SimulationOptions& options, double printed_off, Random random) {
  const KnownShape& shape = *like.shape;
  const double piece_size =
      1.2 * measure_size(target_points(*like.target).size() > 4 && shape.piece_count() == 1
                             ? shape.markers
                             : std::vector<Vector3>(shape.markers.begin(), shape.markers.begin() + 4),
                         shape.piece_count() == 1 ? mean_point(shape.markers) : Vector3::Zero().eval());
  const Rigid tcp_from_target =
      tcp_is_moved(make_chain(like)) ? place_on_hand(piece_size, random) : place_on_table(like, options, random);
  const std::vector<Rigid> pieces = lay_out(shape, piece_size, random);
  ShownBody body;
  const std::vector<Vector3> lie = really_placed(shape, random);
  for (std::size_t m = 0; m < lie.size(); ++m)
    body.markers_in_tcp.push_back(tcp_from_target * pieces[static_cast<std::size_t>(shape.piece(m))] *
                                  Vector3(lie[m] + printed_off * random.gaussian3()));
  body.normal_in_tcp = -tcp_from_target.rotation.col(2);
  for (const Vector3& normal : face_normals(*like.target))
    body.normals_in_tcp.push_back(tcp_from_target.rotation * normal);
  return body;
}

ShownBody outermost(const Session& like, const ShownBody& target) {
  if (!target.normals_in_tcp.empty()) return target;
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
  const std::vector<TargetPoint> printed = printed_points(*session.target);
  for (int piece = 0; piece <= printed.back().piece; ++piece) {
    const auto i = static_cast<std::size_t>(piece);
    Plate& sheet = scene.hand_plates[i];
    const Rigid tcp_from_sheet =
        tcp_from_piece(printed, points_in_tcp, piece) * piece_from_sheet(pattern_of(*session.target, piece).outline);
    sheet.frame_from_plate = tcp_from_sheet;
    // The sheet stands a little above its board, so that neither cuts through the other.
    scene.hand[i].frame_from_solid =
        tcp_from_sheet * Rigid{Matrix3::Identity(), {0, 0, -0.5 * board_thickness - 0.0005}};
  }
}

void add_target(const Session& session, const std::vector<Vector3>& points_in_tcp, bool on_hand, Scene& scene) {
  const int pieces = printed_points(*session.target).back().piece + 1;
  for (int piece = 0; piece < pieces; ++piece) {
    const double rim = rim_of(*session.target, piece);
    const Box outline = pattern_of(*session.target, piece).outline;
    Plate sheet;
    sheet.pattern = SurfacePattern::printed;
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
  const auto place = arm_behind(session, points_in_tcp, scene.hand.front().frame_from_solid);
  if (!place) return;
  Solid arm;
  arm.kind = SolidKind::capsule;
  arm.half_size = {0.035, 0.035, 0.08};
  arm.frame_from_solid = *place;
  arm.grey = 90;
  scene.hand.push_back(arm);
}

}  // namespace handsight
