// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_page.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <algorithm>

#include "compare/compare_cells.h"
#include "compare/compare_texts.h"
#include "findings/fit_watch.h"
#include "findings/pattern_plots.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/explain/residual_cloud.h"
#include "words/core_words.h"
#include "workbench/observation_views.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

constexpr double much = 4;  // sigmas beyond which a number counts as another one

std::vector<widgets::CloudPoint> list_points(const ComparedSide& side) {
  if (!side.residuals) return {};
  return make_cloud(side.residuals->views.corners, ids_of_places(side.residuals->views.problem, *side.session));
}

std::vector<widgets::CloudPoint> list_points(const std::vector<CalibrationResidual>& residuals,
                                             const Session& session) {
  std::vector<CornerResidual> corners;
  std::vector<std::int64_t> ids;
  for (const CalibrationResidual& r : residuals) {
    corners.push_back(r.corner);
    ids.resize(std::max<std::size_t>(ids.size(), static_cast<std::size_t>(r.corner.place) + 1));
    ids[static_cast<std::size_t>(r.corner.place)] = id_at(session, r.observation);
  }
  return make_cloud(corners, ids);
}

/// One of the four plots: position or rotation.
std::vector<widgets::ConvergencePlot::Sample> samples_of(const ComparedSide& side, int first) {
  std::vector<widgets::ConvergencePlot::Sample> samples;
  for (const widgets::ConvergencePoint& p : side.convergence) {
    widgets::ConvergencePlot::Sample s{.count = p.count, .observation = p.observation};
    for (int i = 0; i < 3; ++i) {
      s.value[static_cast<std::size_t>(i)] = p.tcp_from_body[first + i];
      s.sigma[static_cast<std::size_t>(i)] = p.sigma[first + i];
    }
    samples.push_back(s);
  }
  return samples;
}

/// What structure there is in either, the strongest of both first, as far as both can show it.
std::vector<PlotKey> shared_plots(const ComparedPair& pair) {
  std::vector<PlotKey> keys;
  std::vector<std::vector<PlotKey>> lists;
  for (const ComparedSide* side : {&pair.after, &pair.before})
    if (side->residuals) lists.push_back(strongest_plots(*side->residuals));
  for (std::size_t i = 0; i < widgets::PatternPage::plot_count; ++i)
    for (const auto& list : lists)
      if (i < list.size() && std::find(keys.begin(), keys.end(), list[i]) == keys.end()) keys.push_back(list[i]);
  return keys;
}

}  // namespace

ComparePage::ComparePage(Workbench& workbench, QWidget* parent) : Workspace(workbench, parent) {
  setObjectName("compare");
  make_layout();
  connect(choose_first_, &QPushButton::clicked, this, &ComparePage::choose);
  connect(choose_, &QPushButton::clicked, this, &ComparePage::choose);
  connect(swap_, &QPushButton::clicked, this, &ComparePage::swap);
  connect(again_, &QPushButton::clicked, this, &ComparePage::start);
  connect(close_, &QPushButton::clicked, this, &ComparePage::close_requested);
  for (QComboBox* box : shown_sides_)
    connect(box, &QComboBox::activated, this,
            [this] { show_sides(shown_sides_[0]->currentIndex(), shown_sides_[1]->currentIndex()); });
  connect(changes_, &QTableWidget::cellClicked, this, [this](int row) {
    const auto at = static_cast<std::size_t>(row);
    if (several_ && at < sides_of_rows_.size() && sides_of_rows_[at][0] >= 0)
      show_sides(sides_of_rows_[at][0], sides_of_rows_[at][1]);
  });
  connect(&workbench.document, &Document::opened, this, &ComparePage::clear);
  connect(&workbench.document, &Document::closed, this, &ComparePage::clear);
  for (auto signal : {&Document::settings_changed, &Document::model_changed})
    connect(&workbench.document, signal, this, &ComparePage::refresh_names);
  connect(&workbench.document, &Document::edited, this, &ComparePage::refresh_names);
  connect(&workbench.units, &DisplayUnits::changed, this, [this] {
    if (!pair_) return;
    refresh_clouds();
    refresh_patterns();
  });
  connect(&workbench.explaining, &Jobs::stopped, this, [this] {
    if (!is_running_) return;
    is_running_ = false;
    is_stopped_ = true;
    pair_.reset();
    several_.reset();
    refresh();
  });
  refresh();
}

void ComparePage::activate() {
  fit_to_height();
  refresh_names();
}

void ComparePage::clear() {
  others_.clear();
  is_chosen_ = other_is_later_ = false;
  pair_.reset();
  several_.reset();
  is_running_ = is_stopped_ = false;
  verdict_ = Verdict::none;
  said_->clear();
  more_->clear();
  cloud_->reset();
  refresh();
}

void ComparePage::choose() {
  if (is_joined(workbench_.document.session())) return compare_with(std::vector<std::filesystem::path>{});
  auto* dialog = new QFileDialog(this, tr("Compare with other sessions or a calibration"),
                                 QString::fromStdString(folder(workbench_.document.session()).parent_path().string()),
                                 tr("Sessions and calibrations (*.xml)"));
  dialog->setObjectName("compare_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    std::vector<std::filesystem::path> others;
    for (const QString& file : files) others.emplace_back(file.toStdString());
    std::sort(others.begin(), others.end());
    compare_with(std::move(others));
  });
  dialog->open();
}

void ComparePage::compare_with(std::vector<std::filesystem::path> others) {
  others_ = std::move(others);
  is_chosen_ = true;
  other_is_later_ = false;
  pair_.reset();
  several_.reset();
  start();
}

void ComparePage::swap() {
  if (several_) return show_sides(shown_sides_[1]->currentIndex(), shown_sides_[0]->currentIndex());
  other_is_later_ = !other_is_later_;
  start();
}

void ComparePage::start() {
  if (!workbench_.document.is_open() || !is_chosen_) return;
  is_running_ = true;
  is_stopped_ = false;
  others_.size() == 1 && !is_joined(workbench_.document.session()) ? start_pair() : start_several();
  refresh();
}

void ComparePage::start_pair() {
  const Document& d = workbench_.document;
  const ComparisonTask task{d.shared_session(), d.settings(), d.model(), others_.front(), other_is_later_};
  workbench_.explaining.start<std::shared_ptr<const ComparedPair>>(
      "comparison", tr("Comparing with %1").arg(others_text()),
      [task](JobControl& control) { return std::make_shared<const ComparedPair>(compare_pair(task, control)); },
      [this, revision = d.revision()](const std::shared_ptr<const ComparedPair>& pair) {
        revision_ = revision;
        show_pair(pair);
      },
      [this](const QString& sentence) { failed(sentence); });
}

void ComparePage::start_several() {
  const Document& d = workbench_.document;
  const SeveralTask task{d.shared_session(), d.settings(), others_};
  workbench_.explaining.start<std::shared_ptr<const ComparedSeveral>>(
      "comparison", others_.empty() ? tr("Comparing the sessions") : tr("Comparing with %1").arg(others_text()),
      [task](JobControl& control) { return std::make_shared<const ComparedSeveral>(compare_several(task, control)); },
      [this, revision = d.revision()](const std::shared_ptr<const ComparedSeveral>& several) {
        revision_ = revision;
        show_several(several);
      },
      [this](const QString& sentence) { failed(sentence); });
}

void ComparePage::failed(const QString& sentence) {
  is_running_ = false;
  pair_.reset();
  several_.reset();
  show_sentence(sentence, true);
}

QString ComparePage::others_text() const {
  QStringList names;
  for (const std::filesystem::path& other : others_) names << QString::fromStdString(other.string());
  return names.join(", ");
}

void ComparePage::show_sentence(const QString& sentence, bool is_refusal) {
  verdict_ = is_refusal ? Verdict::refused : verdict_;
  said_->setText(is_refusal ? QString::fromUtf8("✗ ") + sentence : sentence);
  more_->clear();
  refresh();
}

void ComparePage::show_pair(std::shared_ptr<const ComparedPair> pair) {
  is_running_ = false;
  several_.reset();
  pair_ = std::move(pair);
  const Comparison& c = pair_->comparison;
  const bool is_same = c.verdict == ComparisonVerdict::unchanged;
  verdict_ = is_same ? Verdict::same : Verdict::changed;
  said_->setText((is_same ? QString::fromUtf8("✓  ") : QString::fromUtf8("▲  ")) + comparison_sentence(c));
  QStringList more;
  if (!is_same) more << hand_sentence(c);
  for (const Message& note : c.notes) more << translated(note);
  more << pair_->notes;
  more.removeAll(QString());
  more_->setText(more.join(' '));
  refresh();
}

void ComparePage::refresh() {
  const bool has_pair = pair_ != nullptr && !is_running_;
  if (is_running_) said_->setText(tr("Being compared …"));
  if (is_stopped_) said_->setText(tr("Stopped. Nothing was compared."));
  if (is_running_ || is_stopped_) {
    verdict_ = Verdict::none;
    more_->clear();
  }
  more_->setVisible(!more_->text().isEmpty());
  verdict_box_->setVisible(has_other());
  empty_->setVisible(!has_other());
  choose_first_->setVisible(!has_other());
  body_->setVisible(has_pair);
  swap_->setVisible(has_pair);
  again_->setVisible(has_other() && !is_running_);
  swap_->setEnabled(has_pair && !pair_->before.is_calibration());
  which_->setVisible(has_pair && several_);
  choose_->setVisible(has_other() && !(workbench_.document.is_open() && is_joined(workbench_.document.session())));
  swap_->setToolTip(has_pair && pair_->before.is_calibration()
                        ? tr("A calibration is always the earlier one")
                        : tr("The earlier one is the later one, and the other way round"));
  tint();
  refresh_names();
  if (!has_pair) return;
  several_ ? refresh_several_lists() : refresh_lists();
  refresh_clouds();
  refresh_convergence();
  refresh_patterns();
}

void ComparePage::refresh_names() {
  if (!pair_ || is_running_) {
    names_->setText(!has_other()      ? tr("Compare with another session")
                    : others_.empty() ? tr("The sessions of this collection, compared")
                                      : tr("Compared with %1").arg(others_text()));
    return;
  }
  const bool is_stale = workbench_.document.is_open() && revision_ != workbench_.document.revision();
  QString names = tr("Before: %1. After: %2.").arg(pair_->before.name, pair_->after.name);
  if (several_) {
    QStringList all;
    for (const ComparedSide& side : several_->sides) all << side.name;
    names = tr("In order of time: %1.").arg(all.join(", "));
  }
  if (is_stale) names += ' ' + tr("The open session has changed since.");
  names_->setText(names);
  names_->setToolTip(QString::fromStdString(pair_->before.file.string() + "\n" + pair_->after.file.string()));
}

void ComparePage::refresh_lists() {
  const Comparison& c = pair_->comparison;
  changes_title_->setText(tr("By evidence"));
  changes_title_->setToolTip(tr("What counts is above %1.").arg(widgets::fixed_text(c.threshold, 1)));
  changes_->setHorizontalHeaderItem(1, head_cell(tr("ln Bayes")));
  changes_->setRowCount(static_cast<int>(c.changes.size()));
  for (int r = 0; r < changes_->rowCount(); ++r) {
    const Change& change = c.changes[static_cast<std::size_t>(r)];
    const bool counts = change.ln_bayes_factor >= c.threshold;
    changes_->setItem(r, 0, cell(change_title(change), false, counts));
    changes_->setItem(r, 1, cell(widgets::fixed_text(change.ln_bayes_factor, 1), true, counts));
    QString tip = change_numbers(change).join('\n');
    if (counts) tip += '\n' + tr("Above %1: no chance.").arg(widgets::fixed_text(c.threshold, 1));
    for (int column : {0, 1}) changes_->item(r, column)->setToolTip(tip);
  }
  const std::vector<NumberLine> lines = number_lines(c);
  numbers_title_->setText(tr("Numbers of both"));
  numbers_title_->setVisible(!lines.empty());
  numbers_->setVisible(!lines.empty());
  numbers_->setRowCount(static_cast<int>(lines.size()));
  for (int r = 0; r < numbers_->rowCount(); ++r) {
    const NumberLine& line = lines[static_cast<std::size_t>(r)];
    const QString cells[] = {line.name, line.change, line.unit, widgets::fixed_text(line.sigmas, 1)};
    for (int column = 0; column < 4; ++column) {
      QTableWidgetItem* item = cell(cells[column], column == 1 || column == 3, std::abs(line.sigmas) > much);
      item->setToolTip(line.name + ": " + line.before_after);
      numbers_->setItem(r, column, item);
    }
  }
}

void ComparePage::refresh_clouds() {
  const ComparedSide &before = pair_->before, &after = pair_->after;
  cloud_->reset();
  if (!after.residuals) return cloud_->set_empty_text(after.version ? after.version->refusal : QString());
  const bool in_pixels = after.session->rig.has_value();
  if (in_pixels) cloud_->set_camera_names(camera_names_in_words(*after.session->rig));
  const bool in_sigma = workbench_.units.unit() == widgets::SizeUnit::sigma;
  const auto find_noise = [&](const ComparedSide& side) {
    return side.residuals->views.noise_model.noise * (in_pixels ? 1 : 1e3);
  };
  // Each side's sigma is its own noise.
  const auto scaled = [&](std::vector<widgets::CloudPoint> points, const ComparedSide& side) {
    for (widgets::CloudPoint& p : points) {
      p.du /= in_sigma ? find_noise(side) : 1;
      p.dv /= in_sigma ? find_noise(side) : 1;
    }
    return points;
  };
  cloud_->set_unit(in_sigma    ? widgets::SizeUnit::sigma
                   : in_pixels ? widgets::SizeUnit::pixel
                               : widgets::SizeUnit::millimetre);
  cloud_->set_noise(in_sigma ? 1 : find_noise(after));
  cloud_->set_empty_text(before.version && !before.version->fit ? before.version->refusal
                                                                : tr("No residuals of this one."));
  cloud_->set_after_empty_text(tr("No residuals of this one."));
  if (before.is_calibration()) {
    cloud_->set_before(scaled(list_points(pair_->as_calibrated, *after.session), after),
                       tr("%1, as the calibration has it").arg(after.name));
    cloud_->set_after(scaled(list_points(after), after), tr("%1, fitted anew").arg(after.name));
  } else {
    cloud_->set_before(before.residuals ? scaled(list_points(before), before) : std::vector<widgets::CloudPoint>{},
                       tr("before: %1").arg(before.name));
    cloud_->set_after(scaled(list_points(after), after), tr("after: %1").arg(after.name));
  }
  cloud_->fit();
}

void ComparePage::refresh_convergence() {
  const ComparedSide* sides[] = {&pair_->before, &pair_->after};
  Vector6 origin;
  origin << pair_->tcp_from_body.translation, rpy_from_rotation(pair_->tcp_from_body.rotation);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    const ComparedSide& side = *sides[i % 2];
    const int first = i < 2 ? 0 : 3;
    plots_[i]->set_title((i < 2 ? tr("TCP→Body, position: %1") : tr("TCP→Body, rotation: %1")).arg(side.name));
    plots_[i]->set_empty_text(side.is_calibration()
                                  ? tr("A calibration tells its result alone: it is where the other one's curves are "
                                       "counted from.")
                              : side.version && side.version->fit ? tr("It is not known how this estimate came about.")
                              : side.version                      ? side.version->refusal
                                                                  : QString());
    plots_[i]->set_origin(std::array<double, 3>{origin[first], origin[first + 1], origin[first + 2]});
    plots_[i]->set_samples(samples_of(side, first));
  }
  for (widgets::ConvergencePlot* plot : {plots_[0], plots_[2]}) plot->fit();
  for (widgets::ConvergencePlot* plot : {plots_[1], plots_[3]}) plot->fit();
}

void ComparePage::refresh_patterns() {
  const ComparedSide* sides[] = {&pair_->before, &pair_->after};
  const std::vector<PlotKey> keys = shared_plots(*pair_);
  std::array<std::vector<widgets::PatternPlot>, 2> plots;
  for (const PlotKey& key : keys) {
    std::array<std::optional<widgets::PatternPlot>, 2> both;
    bool is_in_all = true;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!sides[i]->residuals) continue;
      both[i] = pattern_plot(
          key, *sides[i]->residuals,
          PlottedSession{*sides[i]->session, sides[i]->version->inspection.get(), workbench_.units.unit()});
      is_in_all = is_in_all && both[i].has_value();
    }
    if (!is_in_all) continue;
    for (std::size_t i = 0; i < 2; ++i)
      if (both[i]) plots[i].push_back(std::move(*both[i]));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    sides_[i]->setText((i == 0 ? tr("before: %1") : tr("after: %1")).arg(sides[i]->name));
    patterns_[i]->set_empty_text(sides[i]->is_calibration()
                                     ? tr("A calibration has no residuals of its own.")
                                     : tr("The residuals follow nothing here, or there is no fit."));
    patterns_[i]->set_plots(std::move(plots[i]));
  }
  for (widgets::PatternPage* page : patterns_) page->fit();
}

void ComparePage::fit_to_height() {
  constexpr int enough_for_two = 700;  // px: two rows of plots for each
  for (widgets::PatternPage* page : patterns_) page->set_rows(height() >= enough_for_two ? 2 : 1);
}

void ComparePage::resizeEvent(QResizeEvent* event) {
  Workspace::resizeEvent(event);
  fit_to_height();
}

void ComparePage::tint() {
  const auto& c = widgets::colors();
  const QColor ground = verdict_ == Verdict::same      ? c.good_tint
                        : verdict_ == Verdict::changed ? c.care_tint
                        : verdict_ == Verdict::refused ? c.bad_tint
                                                       : c.sunken;
  QPalette tinted = verdict_box_->palette();
  if (tinted.color(QPalette::Window) == ground) return;
  tinted.setColor(QPalette::Window, ground);
  verdict_box_->setPalette(tinted);
}

void ComparePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) tint();
  Workspace::changeEvent(event);
}

}  // namespace handsight::app
