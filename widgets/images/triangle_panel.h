// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the Label workspace: the triangulated triangle, its sides with sigma, and whether it will do.
#pragma once

#include <QFrame>
#include <optional>
#include <vector>

#include "widgets/images/triangle_state.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace handsight::widgets {

class TriangleSketch;

/// A corner of the right image that may be the partner of the selected marker.
struct TriangleCandidate {
  int index = 0;        // what signals say
  double distance = 0;  // px from the epipolar line
  std::optional<double> depth_m;
  QString sides;  // how the sides would come out: "fits", "+4 mm"
  bool is_taken = false;
};

class TrianglePanel : public QFrame {
  Q_OBJECT
 public:
  explicit TrianglePanel(QWidget* parent = nullptr);
  void set_state(TriangleState state);
  void set_candidates(int marker, std::vector<TriangleCandidate> candidates);
  const TriangleState& state() const { return state_; }

 signals:
  void use_requested();      // "Use it"
  void discard_requested();  // "Next observation"
  void action_requested();   // TriangleState::action
  void marker_selected(int number);
  void marker_removed(int number);
  void marker_renumbered(int number, int to);
  void candidate_hovered(int index);  // -1: none
  void candidate_chosen(int index);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void refresh_markers();
  void refresh_candidates();
  void show_marker_menu(const QPoint& position);

  TriangleState state_;
  std::vector<TriangleCandidate> candidates_;
  int candidates_of_ = -1;
  TriangleSketch* sketch_;
  QTableWidget *markers_, *candidate_table_;
  QLabel *title_, *sides_, *sentence_, *candidates_title_;
  QPushButton *use_ = nullptr, *discard_ = nullptr, *action_ = nullptr;
  bool is_filling_ = false;
};

}  // namespace handsight::widgets
