// SPDX-License-Identifier: GPL-3.0-or-later
// Labelling one observation: the user points in the left image, partners in the right one follow. No widgets.
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "document/edit.h"
#include "session/session.h"
#include "vision/markers/first_observation.h"
#include "vision/markers/following_observation.h"

namespace handsight::app {

/// The X-corners of both images of one observation.
struct CornersOfPair {
  std::vector<Corner> left, right;
};

/// A right corner near the epipolar line of a marker.
struct LabelCandidate {
  int corner = 0;  // index into the right corners
  Vector2 position{0, 0};
  double distance = 0;             // px from the epipolar line
  double depth = 0;                // m
  std::optional<double> misfit_m;  // how far the sides to the other markers would change against the present partners
  bool is_taken = false;
};

/// One marker as it stands.
struct LabelMarker {
  Corner left;  // where it is in the left image: a corner, or free
  bool left_is_free = false;
  std::optional<Corner> right;
  bool right_is_chosen = false;  // by the user: the program leaves it alone
  std::optional<StereoPoint> point;
};

class Labeller {
 public:
  /// Starts on an observation with the labels that it has, or with unfinished ones. Without corners nothing snaps.
  void start(const Session& session, const Observation& observation, CornersOfPair corners,
             const LabelDraft* draft = nullptr);
  void set_corners(CornersOfPair corners);

  /// Places the next marker at the nearest corner within 12 px, or exactly there. The sentence says why not.
  QString point(const Vector2& px, bool free);
  /// The marker that the last `point` placed; -1: none.
  int placed() const { return placed_; }
  /// What is labelled, as it can be remembered; nothing where it is what the observation itself says.
  std::optional<LabelDraft> draft() const;
  /// The markers as the session's other labels know them; empty places where they do not.
  const KnownMarkers& known() const { return known_; }
  /// Numbers that the sides of the other observations give the markers, where the present ones cannot be right: by
  /// present number. Empty: they may stay.
  std::map<int, int> numbers_by_sides() const;
  void renumber_all(const std::map<int, int>& numbers);
  /// Moves a marker in the left or right image; snaps unless free. Right: becomes the user's own choice.
  void move(int marker, bool left, const Vector2& px, bool free);
  void remove(int marker);
  /// Gives a marker another number; one that has it already gets the old number.
  void renumber(int marker, int to);
  void choose_partner(int marker, int right_corner);

  const std::map<int, LabelMarker>& markers() const { return markers_; }
  const CornersOfPair& corners() const { return corners_; }
  std::vector<LabelCandidate> candidates(int marker) const;
  /// The epipolar line of a marker in the right image, as it bends there.
  std::vector<Vector2> epipolar_line(const Vector2& left) const;

  int marker_count() const { return marker_count_; }
  int wanted() const;                                  // markers that a pose needs: three, or all
  const QString& refusal() const { return refusal_; }  // why it will not do; empty: it will, or more are wanted
  bool will_do() const;
  std::vector<Sighting> sightings() const;

  /// Sigma of the length of the side between two triangulated markers, m.
  std::optional<double> side_sigma(int from, int to) const;

 private:
  std::optional<Corner> nearest(const std::vector<Corner>& corners, const Vector2& px) const;
  /// A label of the session: exactly there, with the covariance of the corner under it.
  Corner labelled_corner(const std::vector<Corner>& corners, const Vector2& px) const;
  void find_partners();
  LabelDraft as_draft() const;

  std::optional<StereoRig> rig_;
  KnownMarkers known_;
  std::optional<LabelDraft> own_;  // the labels of the observation itself
  int placed_ = -1;
  int marker_count_ = 0;
  CornersOfPair corners_;
  std::map<int, LabelMarker> markers_;
  QString refusal_;
};

}  // namespace handsight::app
