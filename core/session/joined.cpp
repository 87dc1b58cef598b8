// SPDX-License-Identifier: Apache-2.0
#include "session/joined.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "session/by_time.h"

namespace handsight {
namespace {

Message called(const JoinedMember& m) { return message("session \"{}\"", m.title); }

/// The place of a name among those that came before; a new one, or none, is added.
int number_of(const std::string& name, std::vector<std::string>& known) {
  const auto found = name.empty() ? known.end() : std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<int>(found - known.begin());
  known.push_back(name);
  return static_cast<int>(known.size()) - 1;
}

bool same_camera(const RigCamera& a, const RigCamera& b) {
  const auto numbers = camera_numbers(a.camera);
  const bool same_numbers = std::all_of(numbers.begin(), numbers.end(),
                                        [&](const CameraNumber& n) { return a.camera.*n.value == b.camera.*n.value; });
  return same_numbers && a.name == b.name && a.camera.width == b.camera.width && a.camera.height == b.camera.height &&
         (a.camera_from_first.translation - b.camera_from_first.translation).isZero(1e-12) &&
         (a.camera_from_first.rotation - b.camera_from_first.rotation).isZero(1e-12);
}

/// What the joined session's own residuals are in.
bool is_in_pixels(const std::vector<JoinedMember>& members) {
  return std::any_of(members.begin(), members.end(), [](const JoinedMember& m) { return m.session.rig.has_value(); });
}

std::optional<double> find_noise(const JoinedMember& m) {
  const auto& declared = m.session.rig ? m.session.sigma_pixel : m.session.sigma_point;
  return declared ? declared : m.noise;
}

class Joiner {
 public:
  Joiner(const std::vector<JoinedMember>& members, const std::string& title, const std::filesystem::path& file)
      : members_(members) {
    const Session& first = members.front().session;
    all_.file = file.empty() ? first.file : file;
    all_.title = title;
    all_.robot_file = first.robot_file;
    all_.robot = first.robot;
    all_.tcp = first.tcp;
    all_.repeatability = first.repeatability;
    all_.gravity = first.gravity;
    all_.effect_definitions = first.effect_definitions;
    is_in_pixels_ = is_in_pixels(members);
    decide_units();
  }

  Session joined() {
    for (const JoinedMember& m : members_)
      for (const std::string& joint : m.session.joints)
        if (std::find(all_.joints.begin(), all_.joints.end(), joint) == all_.joints.end()) all_.joints.push_back(joint);
    for (std::size_t i = 0; i < members_.size(); ++i) add(i);
    set_shape();
    return std::move(all_);
  }

 private:
  /// One sensor's noise is the unit; where nothing differs, nothing is weighed.
  void decide_units() {
    const auto leads = std::find_if(members_.begin(), members_.end(),
                                    [&](const JoinedMember& m) { return m.session.rig.has_value() == is_in_pixels_; });
    const std::optional<double> unit = find_noise(*leads);
    for (const JoinedMember& m : members_) {
      const bool is_other_kind = m.session.rig.has_value() != is_in_pixels_;
      weighs_ = weighs_ || is_other_kind || find_noise(m) != unit;
    }
    for (const JoinedMember& m : members_)
      if (weighs_ && !find_noise(m))
        throw InputError(message(
            "{}: nothing tells the noise of its sensor, by which it counts beside the others; declare it (sigma of "
            "<{}>).",
            called(m), device_tag(m.session)));
    (is_in_pixels_ ? all_.sigma_pixel : all_.sigma_point) = unit;
  }

  void add(std::size_t member) {
    const JoinedMember& m = members_[member];
    const Session& s = m.session;
    if (member > 0) require_alike(m);
    if (s.is_touch()) return add_fixtures(m);
    SessionPart& part = all_.parts.emplace_back(take_part(m));
    add_rig(m, part);
    add_body(m, part);
    add_observations(m, static_cast<int>(all_.parts.size()) - 1, part);
    for (const Message& note : s.notes) all_.notes.push_back(message("{}: {}", m.title, note));
  }

  SessionPart take_part(const JoinedMember& m) const {
    SessionPart part;
    part.title = m.title;
    part.file = m.session.file;
    part.tcp = m.session.tcp;
    part.own = m.own;
    const double unit = is_in_pixels_ ? all_.sigma_pixel.value_or(1) : all_.sigma_point.value_or(1);
    part.residual_unit = weighs_ ? *find_noise(m) / unit : 1;
    return part;
  }

  /// A session of touches is as many parts as it has fixtures, of one hand.
  void add_fixtures(const JoinedMember& m) {
    const Session& s = m.session;
    SessionPart whole = take_part(m);
    add_body(m, whole);
    const std::size_t first = all_.parts.size();
    add_observations(m, static_cast<int>(first), whole);
    std::vector<int> fixtures;  // the session's own by their places among all
    for (std::size_t f = 0; f < s.fixtures.size(); ++f) {
      SessionPart part = whole;
      part.title = m.title + " " + s.fixtures[f].id;
      add_fixture(m, f, part);
      fixtures.push_back(part.fixture);
      all_.parts.push_back(std::move(part));
    }
    for (const KnownDistance& d : s.distances)
      all_.distances.push_back(
          {fixtures[static_cast<std::size_t>(d.of)], fixtures[static_cast<std::size_t>(d.from)], d.by, d.sigma});
    for (const Message& note : s.notes) all_.notes.push_back(message("{}: {}", m.title, note));
  }

  /// Of sessions with the same rig those of one name are one.
  void add_fixture(const JoinedMember& m, std::size_t f, SessionPart& part) {
    const Fixture& fixture = m.session.fixtures[f];
    const std::size_t before = rigs_.size();
    part.mount = number_of(m.rig.empty() ? "" : m.rig + "\n" + fixture.id, rigs_);
    if (rigs_.size() == before) {
      const SessionPart& same = first_with(&SessionPart::mount, part.mount);
      part.fixture = same.fixture;
      if (all_.fixtures[static_cast<std::size_t>(same.fixture)].kind != fixture.kind)
        throw InputError(
            message("{}: rig=\"{}\" is that of session \"{}\", but the fixture {} is of another kind; "
                    "give it a name of its own.",
                    called(m), m.rig, same.title, fixture.id));
      return;
    }
    const Mount& mount = find_mount(m.session, static_cast<int>(f));
    if (part.mount == 0)
      all_.mount = mount;
    else
      all_.other_mounts.push_back(mount);
    part.fixture = static_cast<int>(all_.fixtures.size());
    all_.fixtures.push_back(fixture);
  }

  void require_alike(const JoinedMember& m) const {
    require_same_robot(members_.front().session, m.session);
    if (!(m.session.gravity - all_.gravity).isZero(1e-9))
      throw InputError(message("{}: gravity is {} there and {} in {}; one robot stands in one gravity.", called(m),
                               shown(m.session.gravity), shown(all_.gravity), called(members_.front())));
  }

  static std::string shown(const Vector3& v) { return fmt::format("{:g} {:g} {:g}", v.x(), v.y(), v.z()); }

  /// The mount, and the cameras that look from it.
  void add_rig(const JoinedMember& m, SessionPart& part) {
    const Session& s = m.session;
    const std::size_t before = rigs_.size();
    part.mount = number_of(m.rig, rigs_);
    part.camera_count = s.rig ? s.rig->count() : 0;
    if (rigs_.size() == before) {
      const SessionPart& same = first_with(&SessionPart::mount, part.mount);
      require_same_rig(m, same);
      part.first_camera = same.first_camera;
      return;
    }
    if (part.mount == 0)
      all_.mount = s.mount;
    else
      all_.other_mounts.push_back(s.mount);
    if (!s.rig) return;
    if (!all_.rig) all_.rig.emplace();
    part.first_camera = all_.rig->count();
    if (part.first_camera + s.rig->count() > max_cameras)
      throw InputError(
          message("{}: together the sessions have more than {} cameras; give sessions that share "
                  "cameras the same rig=\"\".",
                  called(m), max_cameras));
    for (RigCamera camera : s.rig->cameras) {
      if (find_camera(*all_.rig, camera.name) >= 0) camera.name = fmt::format("{}_{}", camera.name, part.mount + 1);
      all_.rig->cameras.push_back(std::move(camera));
    }
  }

  void require_same_rig(const JoinedMember& m, const SessionPart& same) const {
    const Session& s = m.session;
    const Mount& mount = same.mount == 0 ? all_.mount : all_.other_mounts[static_cast<std::size_t>(same.mount - 1)];
    const char* const differs = s.mount.link != mount.link           ? "sits on another link"
                                : s.mount.estimate != mount.estimate ? "says otherwise whether its place is known"
                                : part_of_rig_differs(s, same)       ? "has other cameras"
                                                                     : nullptr;
    if (differs)
      throw InputError(message("{}: rig=\"{}\" is that of session \"{}\", but it {}; give it a name of its own.",
                               called(m), m.rig, same.title, differs));
  }

  bool part_of_rig_differs(const Session& s, const SessionPart& same) const {
    if ((s.rig ? s.rig->count() : 0) != same.camera_count) return true;
    for (int c = 0; c < same.camera_count; ++c) {
      RigCamera known = all_.rig->at(same.first_camera + c);
      known.name = s.rig->at(c).name;
      if (!same_camera(known, s.rig->at(c))) return true;
    }
    return false;
  }

  const SessionPart& first_with(int SessionPart::*number, int value) const {
    return *std::find_if(all_.parts.begin(), all_.parts.end(),
                         [&](const SessionPart& p) { return p.*number == value; });
  }

  void add_body(const JoinedMember& m, SessionPart& part) {
    const Session& s = m.session;
    const std::size_t before = bodies_.size();
    part.body = number_of(m.body, bodies_);
    part.marker_count = s.marker_count;
    if (bodies_.size() == before) {
      const SessionPart& same = first_with(&SessionPart::body, part.body);
      if (same.tcp != s.tcp || same.marker_count != s.marker_count)
        throw InputError(message("{}: body=\"{}\" is that of session \"{}\", but it has {}; give it a name of its own.",
                                 called(m), m.body, same.title,
                                 same.tcp != s.tcp ? "another TCP" : "another number of markers"));
      part.first_marker = same.first_marker;
      return;
    }
    part.first_marker = all_.marker_count;
    all_.marker_count += s.marker_count;
    shown_.push_back(&m);
  }

  void add_observations(const JoinedMember& m, int number, SessionPart& part) {
    const Session& s = m.session;
    std::vector<Eigen::Index> locate;  // of its joints among all
    for (const std::string& joint : s.joints)
      locate.push_back(std::find(all_.joints.begin(), all_.joints.end(), joint) - all_.joints.begin());
    const auto in_all = [&](const Eigen::VectorXd& own) -> Eigen::VectorXd {
      if (own.size() == 0) return {};
      Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all_.joints.size()));
      values(locate) = own;
      return values;
    };
    const std::vector<int> order = by_time(s);
    const auto at = [&](std::size_t k) -> const Observation& {
      return s.observations[static_cast<std::size_t>(order[k])];
    };
    part.first_id = next_id_;
    part.first_order = next_order_;
    part.first_time = order.empty() ? 0 : next_time_ - at(0).time;
    for (std::size_t k = 0; k < order.size(); ++k) {
      Observation o = at(k);
      auto whole = std::make_shared<PlaceInWhole>();
      whole->order = next_order_ + static_cast<int>(o.whole ? static_cast<std::size_t>(o.whole->order) : k);
      whole->start = part.first_time + (o.whole ? o.whole->start : at(0).time);
      whole->end = part.first_time + (o.whole ? o.whole->end : at(order.size() - 1).time);
      const Eigen::VectorXd before = o.whole ? o.whole->position_before
                                     : k > 0 ? at(k - 1).position
                                             : Eigen::VectorXd();
      whole->position_before = in_all(before);
      o.whole = std::move(whole);
      o.part = number + (s.is_touch() ? o.part : 0);
      o.id += part.first_id;
      o.time += part.first_time;
      o.position = in_all(o.position);
      o.velocity = in_all(o.velocity);
      o.torque = in_all(o.torque);
      renumber_images(part, s, o);
      for (Sighting& sighting : o.sightings) renumber(part, find_noise(m), sighting);
      all_.observations.push_back(std::move(o));
    }
    for (const Observation& o : all_.observations) {
      next_id_ = std::max(next_id_, o.id + 1);
      next_time_ = std::max(next_time_, o.whole->end + 1);
      next_order_ = std::max(next_order_, o.whole->order + 1);
    }
  }

  /// To the joined session's folder.
  void renumber_images(const SessionPart& part, const Session& s, Observation& o) const {
    const auto own = o.images;
    const std::filesystem::path here = folder(all_).empty() ? "." : folder(all_);
    o.images = {};
    for (int c = 0; c < part.camera_count; ++c) {
      const std::string& image = own[static_cast<std::size_t>(c)];
      if (!image.empty())
        o.images[static_cast<std::size_t>(part.first_camera + c)] =
            std::filesystem::absolute(folder(s) / image).lexically_proximate(std::filesystem::absolute(here)).string();
    }
  }

  void renumber(const SessionPart& part, std::optional<double> noise, Sighting& s) const {
    s.marker += part.first_marker;
    for (CameraPoint& p : s.in_cameras) {
      p.camera += part.first_camera;
      if (!weighs_) continue;
      if (!p.sigma) p.sigma = PixelSigma{*noise, *noise, 0};
    }
    if (weighs_ && s.point && !s.point_sigma) s.point_sigma = *noise;
  }

  /// Of one body its own; of several each a piece, those of unknown shape in single points.
  void set_shape() {
    if (bodies_.size() == 1) {
      all_.target = shown_.front()->session.target;
      all_.shape = shown_.front()->session.shape;
      all_.pose_sensor = shown_.front()->session.pose_sensor;
      return;
    }
    const bool any = std::any_of(shown_.begin(), shown_.end(),
                                 [](const JoinedMember* m) { return m->session.shape && m->session.shape->sigma; });
    if (!any) return;
    KnownShape shape;
    for (const JoinedMember* m : shown_) add_pieces(m->session, shape);
    all_.shape = std::move(shape);
  }

  static void add_pieces(const Session& s, KnownShape& shape) {
    const bool is_known = s.shape && s.shape->sigma && s.shape->parts.empty();
    const int next = shape.pieces.empty() ? 0 : shape.pieces.back() + 1;
    for (int i = 0; i < s.marker_count; ++i) {
      const auto m = static_cast<std::size_t>(i);
      shape.markers.push_back(s.shape ? s.shape->markers[m] : Vector3(Vector3::Zero()));
      shape.pieces.push_back(next + (is_known ? s.shape->piece(m) : i));
      const auto pieces = static_cast<std::size_t>(shape.pieces.back() + 1);
      if (shape.piece_sigmas.size() < pieces)
        shape.piece_sigmas.push_back(is_known ? s.shape->piece_sigma(s.shape->piece(m)) : 0.0);
    }
  }

  const std::vector<JoinedMember>& members_;
  Session all_;
  bool is_in_pixels_ = false, weighs_ = false;
  std::vector<std::string> rigs_, bodies_;
  std::vector<const JoinedMember*> shown_;  // the first that shows each body
  std::int64_t next_id_ = 0;
  double next_time_ = 0;
  int next_order_ = 0;
};

}  // namespace

Session joined(const std::vector<JoinedMember>& members, const std::string& title, const std::filesystem::path& file) {
  check(!members.empty(), "no session to join");
  if (members.size() == 1) return members.front().session;
  return Joiner(members, title, file).joined();
}

}  // namespace handsight
