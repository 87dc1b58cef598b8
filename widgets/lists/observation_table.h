// SPDX-License-Identifier: GPL-3.0-or-later
// The table of observations: rms in two units, angle, the worst marker, state and reason; sorted and filtered.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/base/cells.h"
#include "widgets/lists/observation_rows.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QButtonGroup;

namespace handsight::widgets {

class ObservationTableModel;
class ObservationTableFilter;

/// Model, view and delegate, no widget a row; 10,000 rows are quick. The order is kept when rows change: a chip offers
/// to sort again. Delete excludes the chosen, Insert includes them; Enter asks to relabel.
class ObservationTable : public QWidget {
  Q_OBJECT
 public:
  explicit ObservationTable(QWidget* parent = nullptr);
  void set_rows(std::vector<ObservationRow> rows);
  /// The units of the two columns of sizes; without a second one only one is shown.
  void set_units(SizeUnit first, std::optional<SizeUnit> second);
  void set_row(const ObservationRow& row);
  void set_selected(ObservationId id);
  /// Several at once, `current` among them; fewer than two: as set_selected.
  void set_selected_many(const std::vector<ObservationId>& ids, ObservationId current);
  void set_hovered(ObservationId id);
  void set_highlighted(std::vector<ObservationId> ids);
  void set_filter(RowFilter filter);
  /// The sentence (and the button's text, may be empty) where there is no row at all.
  void set_empty_text(const QString& sentence, const QString& action = {});

  ObservationId selected() const { return selected_; }
  std::vector<ObservationId> selected_many() const;  // in the order shown
  std::vector<ObservationId> shown() const;          // ids in the order shown
  QTableView* view() const { return view_; }

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);
  void observations_selected(const std::vector<qint64>& ids);  // more than one
  void exclude_requested(const std::vector<qint64>& ids);
  void include_requested(const std::vector<qint64>& ids);
  void relabel_requested(qint64 id);
  void empty_action_requested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void report_selection();
  void select_again(const std::vector<ObservationId>& ids);
  void show_menu(const QPoint& position);
  void update_summary();
  void show_reason();
  void ask_for_change(bool exclude);

  ObservationTableModel* model_;
  ObservationTableFilter* filter_;
  QTableView* view_ = nullptr;
  QWidget* rows_ = nullptr;  // the view's room, in which no row is cut
  QButtonGroup* filter_buttons_;
  QLineEdit* text_;
  QLabel *summary_, *empty_, *reason_ = nullptr;
  bool has_reasons_ = false;
  QPushButton *empty_action_, *resort_;
  QString empty_text_, empty_action_text_;
  ObservationId selected_ = no_observation, hovered_ = no_observation;
  bool is_telling_ = false, are_many_ = false;
};

}  // namespace handsight::widgets
