// SPDX-License-Identifier: GPL-3.0-or-later
// The list of decisions of an online calibration, each with its reason.
#pragma once

#include <QListView>
#include <optional>
#include <vector>

#include "widgets/base/cells.h"

namespace handsight::widgets {

class DecisionModel;

struct DecisionEntry {
  ObservationId id = no_observation;
  CellState state = CellState::used;
  QString reason;                        // of a rejection, or a remark
  ShownSize size;                        // of an accepted one
  std::optional<double> rms_over_sigma;  // colours it
  int coordinates = 12;
};

/// Newest last and in view, unless the user has scrolled up. Click or arrows select.
class DecisionList : public QListView {
  Q_OBJECT
 public:
  explicit DecisionList(QWidget* parent = nullptr);
  void set_entries(std::vector<DecisionEntry> entries);
  void append(const std::vector<DecisionEntry>& entries);
  void set_selected(ObservationId id);
  void set_empty_text(const QString& sentence);
  int count() const;

 signals:
  void observation_selected(qint64 id);
  void observation_hovered(qint64 id);

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  DecisionModel* decisions_;
  QString empty_text_;
  bool is_telling_ = false;
};

}  // namespace handsight::widgets
