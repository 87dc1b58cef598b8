// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/session_filter.h"

namespace handsight::app {

SessionFilter::SessionFilter(const Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &Document::opened, this, [this] {
    hidden_.clear();
    if (!document_.is_rejoining()) has_marks_ = false;
    emit changed();
  });
}

bool SessionFilter::is_any() const { return document_.collection() && document_.session().parts.size() > 1; }

QStringList SessionFilter::names() const {
  QStringList names;
  if (is_any())
    for (const SessionPart& part : document_.session().parts) names << QString::fromStdString(part.title);
  return names;
}

void SessionFilter::set_shown(int session, bool is_shown) {
  const auto count = document_.session().parts.size();
  if (is_shown)
    hidden_.erase(session);
  else if (hidden_.size() + 1 < count)  // one at least is looked at
    hidden_.insert(session);
  emit changed();
}

void SessionFilter::show_only(int session) {
  const int count = static_cast<int>(document_.session().parts.size());
  std::set<int> others;
  for (int i = 0; i < count; ++i)
    if (i != session) others.insert(i);
  hidden_ = hidden_ == others ? std::set<int>{} : others;
  emit changed();
}

void SessionFilter::set_marks(bool has_marks) {
  if (has_marks == has_marks_) return;
  has_marks_ = has_marks;
  emit changed();
}

int SessionFilter::find_session(std::int64_t id) const {
  const Observation* o = is_any() ? document_.find(id) : nullptr;
  return o ? o->part : -1;
}

bool SessionFilter::is_observation_shown(std::int64_t id) const {
  return hidden_.empty() || is_shown(find_session(id));
}

void SessionFilter::apply(std::vector<widgets::ScatterPoint>& points) const {
  if (!is_any()) return;
  std::erase_if(points, [this](const widgets::ScatterPoint& p) { return !is_observation_shown(p.observation); });
  if (!has_marks_) return;
  for (widgets::ScatterPoint& p : points) p.session = find_session(p.observation);
}

}  // namespace handsight::app
