// SPDX-License-Identifier: GPL-3.0-or-later
// The Label workspace: the first observation, by hand.
#pragma once

#include "label/labeller.h"
#include "workbench/workspace.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace handsight::widgets {
class ImageView;
class Loupe;
class TrianglePanel;
}  // namespace handsight::widgets

namespace handsight::app {

class LabelWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit LabelWorkspace(Workbench& workbench, QWidget* parent = nullptr);

  std::vector<Action> own_actions() const override;
  WorkStatus status() const override;
  Panel panel() const override { return Panel::absent; }
  void activate() override;
  bool key(QKeyEvent* event) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_layout();
  void connect_left();
  void connect_right();
  void connect_panel();
  void show_observation();
  void find_corners(std::int64_t id);
  void corners_found(std::int64_t id, CornersOfPair corners);
  /// Everything that is shown, from the labeller.
  void refresh();
  void refresh_panel();
  void say(const QString& sentence);
  void select_marker(int marker);
  /// Writes what is labelled into the document; `join` as Edit::joins.
  void remember(const QString& sentence, std::int64_t join = 0);
  void placed(const Vector2& px, bool free);
  void number_by_sides();
  void remove_marker(int marker);
  void renumber(int marker, int to);
  void choose_partner(int corner);
  void use();
  void next_observation();

  Labeller labeller_;
  std::int64_t observation_ = -1, shown_ = -1;  // shown_: the one before it was read again
  std::int64_t corners_of_ = -1;
  CornersOfPair corners_;  // of that observation
  int marker_ = -1;        // selected
  QString sentence_;       // the last refusal of a click
  bool is_own_edit_ = false, can_take_back_ = false;
  std::int64_t nudge_join_ = 0;  // nudges one after the other are one action
  int nudged_ = -1;
  bool is_labelled_here_ = true;  // else the labels came with the session, or belong to one of several
  bool was_coming_ = false;       // an image of what is shown
  widgets::ImageView *left_, *right_;
  widgets::Loupe *left_loupe_, *right_loupe_;
  widgets::TrianglePanel* triangle_;
  QCheckBox* together_;
  QLabel* hint_;
  QGridLayout* grid_;
};

}  // namespace handsight::app
