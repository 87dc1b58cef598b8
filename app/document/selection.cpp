// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/selection.h"

namespace handsight::app {

void Selection::set(const Selected& selected, const std::set<std::int64_t>& many) {
  if (selected == current_ && many == many_) return;
  if (selected != current_) {
    history_.push_back(current_);
    if (history_.size() > 200) history_.erase(history_.begin());
  }
  current_ = selected;
  many_ = many;
  emit changed();
}

void Selection::select(const Selected& selected) {
  set(selected, selected.observation ? std::set{*selected.observation} : std::set<std::int64_t>{});
}

void Selection::select_observation(std::int64_t id) {
  if (current_.observation == id && many_.size() <= 1) return;
  select({.observation = id});
}

void Selection::select_marker(std::int64_t id, int marker) { select({.observation = id, .marker = marker}); }

void Selection::select_many(const std::set<std::int64_t>& ids) {
  if (ids.empty()) return;
  Selected one = current_;
  if (!one.observation || !ids.contains(*one.observation)) one = {.observation = *ids.begin()};
  set(one, ids);
}

void Selection::hover(const Selected& hovered) {
  if (hovered == hovered_) return;
  hovered_ = hovered;
  emit hover_changed();
}

void Selection::clear() {
  history_.clear();
  hovered_ = {};
  if (current_ == Selected{} && many_.empty()) return;
  current_ = {};
  many_.clear();
  emit changed();
}

void Selection::up() {
  Selected next = current_;
  if (next.camera) {
    next.camera.reset();
  } else if (next.marker) {
    next.marker.reset();
  } else if (next.joint) {
    next.joint.reset();
  } else {
    next.observation.reset();
  }
  select(next);
}

void Selection::back() {
  if (history_.empty()) return;
  const Selected before = history_.back();
  history_.pop_back();
  current_ = before;
  many_ = before.observation ? std::set{*before.observation} : std::set<std::int64_t>{};
  emit changed();
}

}  // namespace handsight::app
