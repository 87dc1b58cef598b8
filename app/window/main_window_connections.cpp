// SPDX-License-Identifier: GPL-3.0-or-later
// What the strip, the model panel and the read-out line say to the document and the selection, and hear from them.
#include "widgets/base/read_out_line.h"
#include "widgets/base/unit_switch.h"
#include "widgets/lists/model_panel.h"
#include "widgets/lists/observation_strip.h"
#include "widgets/lists/three_numbers.h"
#include "window/header.h"
#include "window/main_window.h"
#include "words/core_words.h"
#include "workbench/link_selection.h"

namespace handsight::app {

void MainWindow::connect_strip() {
  Document& d = workbench_.document;
  strip_timer_.setSingleShot(true);
  strip_timer_.setInterval(40);
  connect(&strip_timer_, &QTimer::timeout, this, [this] {
    refresh_strip();
    refresh_rail();
  });
  state_timer_.setSingleShot(true);
  state_timer_.setInterval(1500);
  connect(&state_timer_, &QTimer::timeout, this, &MainWindow::remember_state);
  connect(&d, &Document::model_changed, this, [this] { state_timer_.start(); });
  connect(&d, &Document::closing, this, [this] {
    if (!state_timer_.isActive()) return;
    state_timer_.stop();
    remember_state();
  });
  connect(&workbench_.diagnosing, &Diagnosing::diagnosis_changed, this, [this] { state_timer_.start(); });
  panel_timer_.setSingleShot(true);
  panel_timer_.setInterval(0);
  connect(&panel_timer_, &QTimer::timeout, this, &MainWindow::refresh_panel);
  connect(&d, &Document::edited, this, [this] {
    if (!strip_timer_.isActive()) strip_timer_.start();
  });
  connect(&d, &Document::model_changed, this, [this] {
    refresh_strip();
    refresh_rail();
    refresh_crumbs();
    const ModelVersionPointer model = workbench_.document.shown_model();
    panel_timer_.start();
    panel_->set_empty_text(model && !model->refusal.isEmpty() ? model->refusal : tr("Not yet fitted."));
  });
  connect(&d, &Document::saved_changed, this, &MainWindow::refresh_rail);
  connect(&d, &Document::settings_changed, this, [this] { panel_timer_.start(); });
  connect(&workbench_.diagnosing, &Diagnosing::diagnosis_changed, this, [this] { panel_timer_.start(); });
  connect(&workbench_, &Workbench::tried, this, &MainWindow::refresh_strip);
  connect(&workbench_.jobs, &Jobs::changed, this, [this] { panel_->set_busy(workbench_.jobs.is_busy("fit")); });
  connect(panel_, &widgets::ModelPanel::effect_toggled, &editor_, &ModelEditor::tick);
  connect(panel_, &widgets::ModelPanel::effect_held, &editor_, &ModelEditor::hold);
  connect(panel_, &widgets::ModelPanel::number_held, &editor_, &ModelEditor::hold_number);
  connect(panel_, &widgets::ModelPanel::value_typed, &editor_, &ModelEditor::type);
  link_selection(strip_, workbench_);
  connect(&workbench_.selection, &Selection::changed, this, [this] {
    const Selected& s = workbench_.selection.current();
    strip_->set_selected(s.observation.value_or(widgets::no_observation));
    const auto& many = workbench_.selection.many();
    strip_->set_highlighted(many.size() > 1 ? std::vector<widgets::ObservationId>(many.begin(), many.end())
                                            : std::vector<widgets::ObservationId>{});
    panel_->set_selected_joint(s.joint ? QString::fromStdString(*s.joint) : QString());
    refresh_crumbs();
  });
}

void MainWindow::connect_read_out() {
  connect(&workbench_.document, &Document::noticed, this,
          [this](const QString& sentence) { read_out_->show_message(sentence); });
  for (Jobs* jobs : {&workbench_.jobs, &workbench_.background, &workbench_.explaining})
    connect(jobs, &Jobs::failed, this, [this](const QString& sentence) { read_out_->show_message(sentence); });
  for (Jobs* jobs : {&workbench_.jobs, &workbench_.explaining})
    connect(jobs, &Jobs::stopped, this, [this] { read_out_->show_message(tr("Stopped. Everything is as before.")); });
  connect(&workbench_, &Workbench::pointed_at, read_out_, &widgets::ReadOutLine::set_pointer);
  connect(header_->numbers(), &widgets::ThreeNumbers::read_out, read_out_, &widgets::ReadOutLine::set_pointer);
  connect(&workbench_.selection, &Selection::hover_changed, this, [this] {
    const Selected& h = workbench_.selection.hovered();
    strip_->set_hovered(h.observation.value_or(widgets::no_observation));
    if (!h.observation) {
      read_out_->set_pointer({});
      return;
    }
    const InspectionRow* row = workbench_.row(*h.observation);
    QString text = tr("obs %1").arg(*h.observation);
    if (row && row->rms) text += "  " + workbench_.units.text(measure_size(*row));
    if (const Observation* o = workbench_.document.find(*h.observation); o && !o->reason.empty())
      text += "  " + translated(o->reason);
    read_out_->set_pointer(text);
  });
  connect(read_out_, &widgets::ReadOutLine::crumb_clicked, this, [this](int index) {
    Selected s = workbench_.selection.current();
    if (index < 2) s.camera.reset();
    if (index < 1) s.marker.reset();
    workbench_.selection.select(s);
  });
}

void MainWindow::connect_units() {
  DisplayUnits& units = workbench_.units;
  const auto refresh = [this, &units] {
    for (const auto unit : DisplayUnits::all) units_->set_why_not(unit, units.why_not(unit));
    units_->set_unit(units.unit());
  };
  connect(&units, &DisplayUnits::changed, this, [this, refresh] {
    refresh();
    refresh_strip();
    refresh_crumbs();
    read_out_->set_pointer({});
  });
  connect(units_, &widgets::UnitSwitch::chosen, &units, &DisplayUnits::choose);
  refresh();
}

}  // namespace handsight::app
