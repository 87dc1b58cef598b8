// SPDX-License-Identifier: GPL-3.0-or-later
// Which sessions of a collection are shown, and whether plots tell them apart; nothing where one session is open.
#pragma once

#include <QObject>
#include <QStringList>
#include <set>
#include <vector>

#include "document/document.h"
#include "widgets/plots/scatter_plot.h"

namespace handsight::app {

class SessionFilter : public QObject {
  Q_OBJECT

 public:
  explicit SessionFilter(const Document& document, QObject* parent = nullptr);

  /// Of a collection of two sessions and more.
  bool is_any() const;
  QStringList names() const;
  bool is_shown(int session) const { return !hidden_.contains(session); }
  void set_shown(int session, bool is_shown);
  /// This one alone; all again where it was alone.
  void show_only(int session);
  bool has_marks() const { return has_marks_; }
  void set_marks(bool has_marks);

  /// -1 where one session is open, or the observation is not there.
  int find_session(std::int64_t observation) const;
  bool is_observation_shown(std::int64_t observation) const;
  /// Points of hidden sessions are left out; the others get their session's mark where plots tell them apart.
  void apply(std::vector<widgets::ScatterPoint>& points) const;

 signals:
  void changed();

 private:
  const Document& document_;
  std::set<int> hidden_;
  bool has_marks_ = false;
};

}  // namespace handsight::app
