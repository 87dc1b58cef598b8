// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/recheck_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "base/utc_now.h"
#include "compare/change_watch.h"
#include "document/effect_words.h"
#include "experiment/recheck/recheck_poses.h"
#include "session/calibration_xml.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/plots/history_plot.h"
#include "words/core_words.h"
#include "words/counted.h"
#include "workbench/link_selection.h"
#include "workbench/preferences.h"

namespace handsight::app {
namespace {

using widgets::HistoryPlot;

constexpr int poses_of_a_recheck = 5;
constexpr double alarm = 1000;          // the e-value that counts as a change
constexpr double highest_shown = 1e15;  // beyond it nothing gets any surer

double seconds_of(const std::string& utc) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return static_cast<double>(time.toSecsSinceEpoch());
}

/// A number's own key and its name: "joint_offset:a3.offset", "joint offset of a3: offset (mrad)".
std::string find_key(const RecheckNumber& n) { return n.what + ':' + n.where + '.' + n.name; }

QString display_name(const RecheckNumber& n) {
  return QStringLiteral("%1: %2").arg(
      effect_text(n.what, n.where.empty() ? std::vector<std::string>() : std::vector{n.where}), number_title(n.name));
}

/// As the plot shows it: it ends where nothing gets any surer.
QString e_value_text(double e_value) {
  return e_value > highest_shown ? QObject::tr("above %1").arg(QString::fromUtf8("10¹⁵"))
                                 : widgets::short_text(e_value, 3);
}

/// Looks at each observation as it comes, and writes the log. In the run's thread.
struct Watching {
  std::filesystem::path calibration, log;
  std::optional<ChangeWatch> watch;

  void begin(const Session& session, ExperimentOptions& options) {
    const CalibratedRobot before =
        calibrated_robot(read_calibration(calibration), session.robot, session.robot_file, calibration.string());
    options.given = recheck_poses(before, session, options.cell, poses_of_a_recheck);
    watch.emplace(before);
    for (const Observation& o : session.observations) (void)watch->add(session, o);
  }
  void look(const Session& session, const Observation& o) {
    if (const auto step = watch->add(session, o)) add_to_log(log, recheck_entry(utc_now(), o.id, *step));
  }
};

}  // namespace

RecheckPage::RecheckPage(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  setObjectName("recheck_page");
  make_layout();
  connect(number_, &QComboBox::currentIndexChanged, this, &RecheckPage::show_number);
  connect(log_, &QLineEdit::editingFinished, this, &RecheckPage::refresh);
  set_session();
}

QLayout* RecheckPage::make_fields() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  const auto add = [&](int row, const char* name, const QString& text, const QString& tip, const QString& filter) {
    auto* field = new QLineEdit(this);
    field->setObjectName(name);
    field->setToolTip(tip);
    field->setMinimumHeight(widgets::control_height);
    auto* label = new QLabel(text, this);
    label->setBuddy(field);
    auto* button = new QPushButton(tr("Choose…"), this);
    button->setObjectName(QString(name) + "_choose");
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [=, this] { choose(field, text, filter); });
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row, 1);
    grid->addWidget(button, row, 2);
    return field;
  };
  calibration_ = add(0, "recheck_calibration", tr("Calibration"),
                     tr("The one that is asked whether it still holds; Export writes it"), tr("Calibrations (*.xml)"));
  calibration_->setPlaceholderText(tr("calibration.xml, as Export writes it"));
  log_ = add(1, "recheck_log", tr("Log"), tr("A line is added for every observation; recheck --csv writes the same"),
             tr("Logs (*.csv)"));
  return grid;
}

QWidget* RecheckPage::make_plots() {
  e_values_ = new HistoryPlot(HistoryPlot::Along::time, this);
  e_values_->setObjectName("recheck_e_values");
  e_values_->set_title(tr("Evidence that something has changed"));
  e_values_->set_quantity(tr("e-value"), {}, true);
  e_values_->set_limit(alarm, tr("1000: it has changed"));
  e_values_->set_empty_text(tr("Each observation of a recheck is a point here."));
  history_ = new HistoryPlot(HistoryPlot::Along::time, this);
  history_->setObjectName("recheck_history");
  history_->set_empty_text(tr("How each number of mount, hand and joint zeros went, with two sigma."));
  number_ = new QComboBox(this);
  number_->setObjectName("recheck_number");
  number_->setAccessibleName(tr("The number whose history is shown"));
  number_->setMinimumHeight(widgets::control_height);
  connect(number_, &QComboBox::activated, this, [this] { is_number_chosen_ = true; });
  number_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(number_);
  column->addWidget(history_, 1);
  auto* plots = new QSplitter(Qt::Horizontal, this);
  plots->addWidget(e_values_);
  plots->addWidget(right);
  plots->setSizes({600, 600});
  plots->setChildrenCollapsible(false);
  plots->setHandleWidth(8);
  for (HistoryPlot* plot : {e_values_, history_}) link_selection(plot, workbench_);
  return plots;
}

void RecheckPage::make_layout() {
  said_ = new QLabel(this);
  said_->setObjectName("recheck_said");
  said_->setFont(widgets::text_font(widgets::TextRole::title));
  more_ = new QLabel(this);
  more_->setObjectName("recheck_more");
  for (QLabel* label : {said_, more_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 8, 0, 0);
  layout->setSpacing(8);
  layout->addLayout(make_fields());
  layout->addWidget(said_);
  layout->addWidget(more_);
  layout->addWidget(make_plots(), 1);
}

void RecheckPage::choose(QLineEdit* field, const QString& title, const QString& filter) {
  auto* dialog = new QFileDialog(this, title, field->text(), filter);
  dialog->setObjectName(field->objectName() + "_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(field == log_ ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  if (field == log_) dialog->setOption(QFileDialog::DontConfirmOverwrite);
  connect(dialog, &QFileDialog::fileSelected, this, [this, field](const QString& file) {
    field->setText(file);
    refresh();
  });
  dialog->open();
}

void RecheckPage::set_session() {
  entries_.clear();
  const bool is_open = workbench_.document.is_open();
  const std::filesystem::path home = is_open ? folder(workbench_.document.session()) : std::filesystem::path();
  log_->setText(is_open ? QString::fromStdString((home / "recheck.csv").string()) : QString());
  const QString last = is_open ? preference("calibration of " + QString::fromStdString(home.string())) : QString();
  std::error_code error;
  const std::filesystem::path beside = home / "calibration.xml";
  calibration_->setText(!last.isEmpty()                                     ? last
                        : is_open && std::filesystem::exists(beside, error) ? QString::fromStdString(beside.string())
                                                                            : QString());
  refresh();
}

void RecheckPage::complete(RunWish& wish) const {
  const QString calibration = calibration_->text().trimmed();
  if (calibration.isEmpty())
    throw InputError("Choose the calibration that is to be asked whether it still holds; Export writes one.");
  if (log_->text().trimmed().isEmpty())
    throw InputError("Say where the log of the rechecks is to be kept: a CSV file.");
  remember_preference("calibration of " + QString::fromStdString(folder(workbench_.document.session()).string()),
                      calibration);
  auto watching = std::make_shared<Watching>();
  watching->calibration = calibration.toStdString();
  watching->log = log_->text().trimmed().toStdString();
  wish.prepare = [watching](const Session& session, ExperimentOptions& options) { watching->begin(session, options); };
  wish.watch = [watching](const Session& session, const Observation& o) { watching->look(session, o); };
}

void RecheckPage::refresh() {
  const std::filesystem::path log = log_->text().trimmed().toStdString();
  if (log.empty()) return show_entries();
  using Entries = std::shared_ptr<const std::vector<RecheckEntry>>;
  jobs_.start<Entries>(
      "log", tr("Reading the log"),
      [log](JobControl&) { return std::make_shared<const std::vector<RecheckEntry>>(read_recheck_log(log)); },
      [this](const Entries& entries) {
        entries_ = *entries;
        show_entries();
      },
      [this](const QString& sentence) {
        entries_.clear();
        show_entries();
        said_->setText(sentence);
      });
}

void RecheckPage::show_entries() {
  std::vector<widgets::HistoryPoint> points;
  for (const RecheckEntry& e : entries_)
    points.push_back({.x = seconds_of(e.utc),
                      .y = std::min(e.e_value, highest_shown),
                      .stands_out = e.changed,
                      .observation = e.id});
  e_values_->set_points(std::move(points));
  const QString chosen = number_->currentData().toString();
  {
    const QSignalBlocker quiet(number_);
    number_->clear();
    if (!entries_.empty())
      for (const RecheckNumber& n : entries_.back().numbers)
        number_->addItem(display_name(n), QString::fromStdString(find_key(n)));
    number_->setCurrentIndex(std::max(0, is_number_chosen_ ? number_->findData(chosen) : telling_number()));
    number_->setVisible(number_->count() > 0);
  }
  show_number();
  more_->clear();
  if (entries_.empty()) {
    said_->setText(tr("Has anything changed since a calibration?"));
    more_->setText(tr(
        "Choose the calibration and connect the driver: the robot goes to the five poses that show mount, hand and "
        "joint zeros best. It may be asked every hour, for ever: of a robot that has not changed, the chance of ever "
        "being told otherwise is 1 in 1000. Keep one session for all rechecks of a calibration."));
    return;
  }
  const RecheckEntry& last = entries_.back();
  said_->setText(last.changed ? tr("Something has changed: %1.").arg(translated(last.text))
                              : tr("Nothing speaks for a change."));
  more_->setText(tr("%1 looked at, the last at %2 UTC; e-value %3, where 1000 would count as a change.")
                     .arg(counted(static_cast<qint64>(entries_.size()), "%n observation(s)"),
                          QString::fromStdString(last.utc).replace('T', ' ').remove('Z'))
                     .arg(e_value_text(last.e_value)));
}

/// The place of the first number of what has changed, or is likeliest to have.
int RecheckPage::telling_number() const {
  if (entries_.empty()) return -1;
  const RecheckEntry& last = entries_.back();
  const auto found = std::find_if(last.numbers.begin(), last.numbers.end(), [&](const RecheckNumber& n) {
    return last.changed && n.what == last.what && n.where == last.where;
  });
  return found == last.numbers.end() ? -1 : static_cast<int>(found - last.numbers.begin());
}

void RecheckPage::show_number() {
  const std::string key = number_->currentData().toString().toStdString();
  std::vector<widgets::HistoryPoint> points;
  std::string unit;
  for (const RecheckEntry& e : entries_)
    for (const RecheckNumber& n : e.numbers) {
      if (find_key(n) != key) continue;
      unit = n.unit;
      const double scale = shown_unit(n.unit).scale;
      points.push_back({.x = seconds_of(e.utc),
                        .y = scale * n.value,
                        .sigma = scale * n.sigma,
                        .stands_out = e.changed && e.what == n.what && e.where == n.where,
                        .observation = e.id});
    }
  history_->set_quantity(tr("change"), shown_unit(unit).unit, false);
  history_->set_points(std::move(points));
}

}  // namespace handsight::app
