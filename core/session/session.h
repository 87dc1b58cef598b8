// SPDX-License-Identifier: Apache-2.0
// A session: a robot, what watches it, and the observations. Plain data; read and written by session_xml.h.
#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "camera/rig.h"
#include "print/target.h"
#include "robot/robot.h"
#include "session/effect_definition.h"

namespace handsight {

struct FixtureKind;  // session/fixtures/fixture_kind.h
struct Reading;

enum class MarkedBy { hand, tracker, import };

/// How sure an image point is: standard deviations of u and v (px) and their covariance (px^2, smaller than su sv).
struct PixelSigma {
  double u = 0, v = 0, uv = 0;
};

/// Where one camera saw a marker.
struct CameraPoint {
  int camera = 0;                        // of the rig
  Vector2 pixel;                         // px
  std::optional<PixelSigma> sigma = {};  // absent: the session's usual one
};

/// Where one marker was seen in one observation: by cameras, or in a tracker session as a point.
struct Sighting {  // NOLINT(bugprone-exception-escape): what is small is moved without allocating
  int marker = 0;  // 0 to marker_count - 1
  boost::container::small_vector<CameraPoint, 2> in_cameras = {};  // in order of camera, each at most once
  std::optional<Vector3> point = {};                               // m, in the tracker's frame
  std::optional<Vector3> along = {};  // in that frame: only the product with the point is measured
  const Reading* reading = nullptr;   // in that frame: only this length is measured, as of the point
  MarkedBy by = MarkedBy::import;
  std::optional<double> point_sigma = {};  // m, of each coordinate; absent: the session's usual one
  /// The sigma of a measurement whose residuals are taken as they are (px, m): those of surer ones are drawn out, those
  /// of less sure ones drawn in. 0: all are taken as they are.
  double usual_sigma = 0;
};

/// What a camera saw of the marker; null where it did not.
const CameraPoint* seen_by(const Sighting& sighting, int camera);
CameraPoint* seen_by(Sighting& sighting, int camera);

/// The camera sees the marker there, in place of what was.
void see(Sighting& sighting, int camera, const Vector2& pixel, const std::optional<PixelSigma>& sigma = {});

/// The camera does not see it.
void forget(Sighting& sighting, int camera);

/// A marker seen there by the first camera, and by the second where it is given.
Sighting seen_at(int marker, const Vector2& first, const std::optional<Vector2>& second = {},
                 MarkedBy by = MarkedBy::import);

/// Neighbouring markers of a known shape that are one firm thing, a tag: it lies where the shape says, off by a motion
/// of which this is known.
struct ShapePart {
  int first = 0, count = 0;  // its markers
  double sigma = 0;          // m, of its middle's shift along each axis
  double sigma_angle = 0;    // rad, of its turn about each axis
};

/// How the markers lie to each other, where that is known beforehand: their places in a frame of their own. Of several
/// pieces (single tags) each has its own frame, and nothing is known of one against another.
struct KnownShape {
  std::vector<Vector3> markers;           // m
  std::optional<double> sigma = 0;        // m, of one coordinate of one marker; 0: exactly so; nothing: only about so
  std::vector<double> piece_sigmas = {};  // m, by piece where they differ; empty: all are `sigma`
  std::vector<int> pieces = {};           // the piece of each marker, ascending; empty: all are one
  std::vector<ShapePart> parts = {};      // that are placed within sigmas, all markers in order; empty: there are none

  int piece(std::size_t marker) const { return pieces.empty() ? 0 : pieces[marker]; }
  int piece_count() const { return pieces.empty() ? 1 : pieces.back() + 1; }
  double piece_sigma(int piece) const {
    return piece_sigmas.empty() ? sigma.value_or(0) : piece_sigmas[static_cast<std::size_t>(piece)];
  }
  bool is_rigid() const { return sigma == 0.0 && piece_count() == 1 && parts.empty(); }
};

/// A sensor that tells where a target is and how it is turned. Absent sigmas are estimated.
struct PoseSensor {
  std::optional<double> sigma;        // m, of one coordinate of its place
  std::optional<double> sigma_angle;  // rad, of its turn about one axis
};

enum class Decision { none, accepted, rejected, excluded };

/// Where an observation of a part of a session stood in the whole (session/sample.h): what follows from its neighbours
/// there must not follow from those that it has been left with.
struct PlaceInWhole {
  int order = 0;                    // among all observations, by time
  double start = 0, end = 0;        // s, of the whole session
  Eigen::VectorXd position_before;  // of the observation before it; empty: it was the first
};

struct Observation {
  std::int64_t id = 0;                          // non-negative, unique
  double time = 0;                              // s
  Eigen::VectorXd position;                     // rad or m, in the order of Session::joints
  Eigen::VectorXd velocity;                     // empty where not measured
  Eigen::VectorXd torque;                       // N m (N), empty where not measured
  std::array<std::string, max_cameras> images;  // by camera, relative to the session's folder; empty: there is none
  std::vector<Sighting> sightings;              // in order of marker
  std::optional<Rigid> target_pose;  // sensor_from_target as a pose sensor measured it; `sightings` stand for it
  Decision decision = Decision::none;
  Message reason;                                       // of the decision, for people
  std::shared_ptr<const PlaceInWhole> whole = nullptr;  // null: the session is no part of another
  int part = 0;                                         // of a joined session: into Session::parts
};

/// The link that carries the cameras or the tracker, and where on it: mount_from_sensor, the sensor's frame being
/// the first camera's (x right, y down, z forward) or the tracker's own.
struct Mount {
  std::string link;
  Rigid mount_from_sensor;
  bool estimate = false;  // only a guess: part of every fit
  bool known = true;      // false: estimate="yes" with neither xyz nor rpy; the start is found in closed form
};

/// What a probe touches. Each has a frame of its own, which takes the sensor's place (SessionPart::mount).
struct Fixture {
  std::string id;
  const FixtureKind* kind = nullptr;       // of session/fixtures/list.h
  std::optional<double> sigma;             // m, of one reading there
  std::optional<double> place_sigma = {};  // m: how exactly its place is known where it is estimated; absent: a guess
};

/// Two fixtures whose frames' origins are this far apart.
struct KnownDistance {
  int of = 0, from = 0;      // into Session::fixtures
  double by = 0, sigma = 0;  // m
};

/// One of several sessions of a robot that are fitted as one (session/joined.h).
struct SessionPart {
  std::string title;                  // unique
  std::filesystem::path file;         // its session.xml
  std::string tcp;                    // its link
  std::vector<std::string> own = {};  // effects ("joint_offset:arm_3") that are its own though they are the robot's
  int mount = 0;                      // of the joined session's: 0 is Session::mount, then Session::other_mounts
  int body = 0;                       // the parts with the same number see the same body
  int first_marker = 0, marker_count = 0;  // of that body, among the joined session's
  int first_camera = 0, camera_count = 0;  // in the joined session's rig; 0: a tracker's
  std::int64_t first_id = 0;               // added to its observations' ids
  double first_time = 0;                   // s, added to their times
  int first_order = 0;                     // added to their places in time (PlaceInWhole::order)
  double residual_unit = 1;                // of its own residuals (px, m): what one of the joined session's stands for
  int fixture = -1;                        // that is touched there, into Session::fixtures; -1: it is none
};

struct Session {
  std::filesystem::path file;  // session.xml; images and robot are relative to its folder
  std::string title;
  std::string robot_file;
  Robot robot;
  std::string tcp;                      // the link whose frame is TCP
  std::optional<double> repeatability;  // declared of the robot: rad (m) of one joint
  Vector3 gravity{0, 0, -9.81};         // m/s^2, in the root link's frame
  Mount mount;
  std::optional<Rig> rig;                 // absent: a tracker session
  std::optional<double> sigma_pixel;      // declared noise of one image coordinate, px
  std::optional<double> sigma_point;      // tracker sessions: declared noise of one coordinate, m
  std::optional<PoseSensor> pose_sensor;  // in place of cameras and tracker: see session/pose_points.h
  std::optional<Target> target;           // whose points are the markers, by number; found in images without a label
  std::optional<KnownShape> shape;        // of the markers; absent: they are found wherever they are
  int marker_count = 0;
  std::vector<std::string> joints;        // the order of position, velocity and torque; joints not named stand at 0
  std::vector<SessionPart> parts;         // of a joined session; empty: it is one by itself
  std::vector<Mount> other_mounts;        // of a joined session: mounts 1, 2 ...
  std::vector<Fixture> fixtures;          // of a session of touches: each is a part, with its own mount
  std::vector<KnownDistance> distances;   // between them
  std::vector<Observation> observations;  // in order of time
  std::vector<EffectDefinition> effect_definitions;  // of effects.xml and the user's own folder
  std::vector<Message> notes;                        // what the reader ignored, and warnings, a sentence each
  std::shared_ptr<const std::string> source;  // the XML text as read, so that saving keeps what is not understood

  bool is_tracker() const { return !rig.has_value(); }
  /// Of touches alone, by one hand: every part is a fixture.
  bool is_touch() const;
};

/// The part in which a fixture is touched first.
const SessionPart& part_of_fixture(const Session& session, int fixture);

/// The mount of a part, or of a session that is none: 0 is Session::mount, then Session::other_mounts.
const Mount& find_mount(const Session& session, int mount);

/// The element that holds what watches the robot: "stereo", "cameras", "tracker" or "pose_sensor".
const char* device_tag(const Session& session);

/// The folder that robot and images are relative to.
std::filesystem::path folder(const Session& session);

/// What a sighting without a sigma of its own is taken to have (px, m): declared for the session, else the median of
/// those that are given; 0 where no sighting tells one.
double usual_sigma(const Session& session);

PixelSigma pixel_sigma(const Eigen::Matrix2d& covariance);
Eigen::Matrix2d make_covariance(const PixelSigma& sigma);

/// The session's markers become the points of the target.
void set_target(Session& session, const Target& target);

/// Must somebody show the program its markers in the images before anything can be found in them? Not where points name
/// themselves or are measured by the sensor, nor where there are labels already.
bool needs_label(const Session& session);

/// Is there an image of any camera?
bool has_images(const Observation& observation);

/// Is the observation part of a fit: it has a sighting and is neither rejected nor excluded?
bool is_used(const Observation& observation);

}  // namespace handsight
