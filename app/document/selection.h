// SPDX-License-Identifier: GPL-3.0-or-later
// What is selected, the same everywhere; and what the pointer is on. One object a window.
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace handsight::app {

/// One thing: an observation, and in it a marker, and of it one camera's image of it; or a joint.
struct Selected {
  std::optional<std::int64_t> observation;
  std::optional<int> marker;
  std::optional<int> camera;  // of the rig
  std::optional<std::string> joint;

  bool operator==(const Selected&) const = default;
};

class Selection : public QObject {
  Q_OBJECT

 public:
  explicit Selection(QObject* parent = nullptr) : QObject(parent) {}

  const Selected& current() const { return current_; }
  /// Several observations (a dragged rectangle), the current one among them; empty or one where there are none more.
  const std::set<std::int64_t>& many() const { return many_; }
  const Selected& hovered() const { return hovered_; }

  void select(const Selected& selected);
  void select_observation(std::int64_t id);
  void select_marker(std::int64_t id, int marker);
  void select_many(const std::set<std::int64_t>& ids);
  void hover(const Selected& hovered);
  void clear();

  /// From a camera's image to the marker, the observation, nothing.
  void up();
  /// The selection before this one.
  void back();

 signals:
  void changed();
  void hover_changed();

 private:
  void set(const Selected& selected, const std::set<std::int64_t>& many);

  Selected current_, hovered_;
  std::set<std::int64_t> many_;
  std::vector<Selected> history_;
};

}  // namespace handsight::app
