// SPDX-License-Identifier: GPL-3.0-or-later
// The model panel: the effects in the model with a check box each, their parameters against what is plausible.
#pragma once

#include <QFrame>
#include <QHash>
#include <vector>

#include "widgets/lists/model_parameter.h"

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace handsight::widgets {

struct ModelEffect {
  QString id;     // what signals say; unique in the panel
  QString title;  // "TCP->Body", "Camera mount", "Joint elasticity"
  QString help;   // tool tip: cause, where it shows
  bool is_in_model = false;
  bool is_permanent = false;     // no check box: always part of the model
  bool can_change = true;        // false: the check box is disabled, `note` says why
  bool is_candidate = false;     // being tried: purple
  bool can_hold = false;         // offers to hold all its numbers, or to estimate them again
  bool is_held = false;          // all its numbers are held
  QString group;                 // "Joints": the heading under which it stands while it is not in the model
  bool is_out_of_sight = false;  // a group of nothing else begins folded
  QString note;                  // a sentence: "implausible ...", "cannot be seen on these poses"
  bool note_is_warning = false;
  std::vector<ModelParameter> parameters;
};

/// 288 px wide, folds to 36. What is in the model stands on top, the others below in groups that fold. Parameters show
/// as name, value and sigma in the unit, and a bar: the value between minus and plus three plausible deviations with
/// its own sigma as a whisker.
class ModelPanel : public QFrame {
  Q_OBJECT
 public:
  explicit ModelPanel(QWidget* parent = nullptr);
  void set_effects(std::vector<ModelEffect> effects);
  void set_headline(const QString& text);    // beside the title: "9.1 px"
  void set_empty_text(const QString& text);  // where there are no effects
  void set_busy(bool busy);                  // a refit runs: says so, boxes stay usable
  void set_folded(bool folded);
  void set_selected_joint(const QString& joint);
  bool is_folded() const { return is_folded_; }

 signals:
  void effect_toggled(const QString& id, bool in_model);
  void effect_held(const QString& id, bool held);
  void number_held(const QString& id, int parameter, bool held);
  void value_typed(const QString& id, int parameter, double value);  // of a held number, in the parameter's unit
  void joint_selected(const QString& joint);                         // the `of` of a parameter was clicked
  void folded_changed(bool folded);

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rebuild();
  void refresh_texts();
  QWidget* make_effect(const ModelEffect& effect);
  void add_parameter(const ModelEffect& effect, int index, QWidget* box);
  void add_groups();
  bool is_group_folded(const QString& group) const;

  std::vector<ModelEffect> effects_;
  QString headline_text_, empty_text_, selected_joint_;
  bool is_folded_ = false, is_busy_ = false;
  QLabel *title_, *headline_;
  QToolButton* fold_;
  QScrollArea* scroll_;
  QWidget* content_;
  QVBoxLayout* list_ = nullptr;
  QHash<QString, bool> group_choices_;  // folded or unfolded by the user
};

}  // namespace handsight::widgets
