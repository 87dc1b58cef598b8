// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibrate/transport.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "words/counted.h"
#include "workbench/session_parts.h"

namespace handsight::app {
namespace {

constexpr int magnifications[] = {1, 2, 5, 10, 20, 50, 100};

}  // namespace

Transport::Transport(Workbench& workbench, Player& player, QWidget* parent)
    : QWidget(parent), workbench_(workbench), player_(player), live_(workbench) {
  make_layout();
  connect_live();
  player_.set_speed(speed_->currentData().toDouble());
}

void Transport::make_layout() {
  play_ = new QPushButton(tr("Play"), this);
  play_->setObjectName("play");
  play_->setDefault(true);
  const auto button = [this](const char* name, const QString& text, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setObjectName(name);
    b->setText(text);
    b->setToolTip(tip);
    return b;
  };
  step_ = button("step", tr("Step"), tr("One observation (.)"));
  step_->setIcon(widgets::icon("step"));
  rewind_ = button("rewind", tr("Rewind"), tr("Play from the first observation again"));
  rewind_->setIcon(widgets::icon("rewind"));
  watch_ =
      button("watch", tr("Watch folder"),
             tr("Takes new images or measurements and joint angles in as they arrive, and goes on playing with them"));
  watch_->setCheckable(true);
  watch_->setIcon(widgets::icon("watch"));
  for (QToolButton* b : {step_, rewind_, watch_}) b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  speed_ = new QComboBox(this);
  speed_->setObjectName("speed");
  for (const double s : {1.0, 2.0, 5.0, 10.0, 30.0}) speed_->addItem(tr("%1 per second").arg(s), s);
  speed_->addItem(tr("As fast as it goes"), 0.0);
  speed_->setCurrentIndex(3);
  speed_->setFocusPolicy(Qt::StrongFocus);
  progress_ = new QLabel(this);
  progress_->setObjectName("play_progress");
  progress_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // its words must not widen the window
  progress_->setFont(widgets::text_font(widgets::TextRole::small));
  progress_->setWordWrap(true);
  progress_->setFixedHeight(2 * progress_->fontMetrics().lineSpacing());
  label_next_ = new QPushButton(this);
  label_next_->setObjectName("label_next");
  label_next_->setToolTip(tr("Opens it in Label; with its markers labelled the play goes on by itself"));
  label_next_->hide();
  connect(label_next_, &QPushButton::clicked, this, [this] {
    if (workbench_.label_wanted) emit workbench_.relabel_requested(*workbench_.label_wanted);
  });
  ghost_ = new QSlider(Qt::Horizontal, this);
  ghost_->setObjectName("ghost");
  ghost_->setAccessibleName(tr("Magnification of deviations"));
  ghost_->setRange(0, static_cast<int>(std::size(magnifications)) - 1);
  ghost_->setFixedWidth(140);
  ghost_->setValue(3);
  ghost_text_ = new QLabel(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (QWidget* w : std::initializer_list<QWidget*>{play_, step_, rewind_, speed_, watch_, label_next_}) {
    w->setMinimumHeight(28);
    if (w != label_next_) row->addWidget(w);
  }
  row->addSpacing(8);
  row->addWidget(progress_, 1);
  row->addWidget(label_next_);
  row->addWidget(ghost_text_);
  row->addWidget(ghost_);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 4, 0, 4);
  rows->setSpacing(4);
  rows->addLayout(row);
  rows->addWidget(make_live_row());
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(play_, &QPushButton::clicked, this, [this] { player_.is_playing() ? player_.pause() : player_.play(); });
  connect(step_, &QToolButton::clicked, &player_, &Player::step);
  connect(rewind_, &QToolButton::clicked, &player_, &Player::rewind);
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this] { player_.set_speed(speed_->currentData().toDouble()); });
  const auto magnify = [this] {
    ghost_text_->setText(tr("deviations %1 ×").arg(magnification()));
    emit magnification_changed(magnification());
  };
  connect(ghost_, &QSlider::valueChanged, this, magnify);
  magnify();
}

QWidget* Transport::make_live_row() {
  live_row_ = new QWidget(this);
  live_text_ = new QLabel(live_row_);
  live_text_->setObjectName("live_text");
  live_text_->setWordWrap(true);
  live_text_->setTextFormat(Qt::PlainText);
  sources_ = new QToolButton(live_row_);
  sources_->setObjectName("live_sources");
  sources_->setText(tr("Where from…"));
  sources_->setToolTip(tr("Where the images and the joint angles arrive"));
  sources_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(sources_);
  connect(menu, &QMenu::aboutToShow, this, &Transport::fill_sources);
  sources_->setMenu(menu);
  auto* row = new QHBoxLayout(live_row_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(live_text_, 1);
  row->addWidget(sources_, 0, Qt::AlignTop);
  live_row_->hide();
  return live_row_;
}

void Transport::connect_live() {
  connect(watch_, &QToolButton::toggled, this, [this](bool on) {
    live_.set_watching(on);
    player_.set_live(on);
    if (on && is_labelled()) player_.play();
  });
  connect(&live_, &LiveWatch::arrived_now, &player_, &Player::arrive);
  connect(&live_, &LiveWatch::state_changed, this, &Transport::refresh);
}

/// A folder for each camera of the session, and the table.
void Transport::fill_sources() {
  QMenu* menu = sources_->menu();
  menu->clear();
  const auto& rig = workbench_.document.session().rig;
  for (int c = 0; rig && c < rig->count(); ++c) {
    const std::string& name = rig->at(c).name;
    menu->addAction(name == "left"    ? tr("Images of the left camera…")
                    : name == "right" ? tr("Images of the right camera…")
                                      : tr("Images of camera %1…").arg(QString::fromStdString(name)),
                    this, [this, c] { choose_folder(c); });
  }
  menu->addAction(tr("Table of joint angles…"), this, &Transport::choose_table);
  menu->addAction(tr("The session's own folder"), this,
                  [this] { live_.set_sources(own_sources(workbench_.document.session())); });
}

void Transport::choose_folder(int camera) {
  const auto place = static_cast<std::size_t>(camera);
  choose(tr("Where the images arrive"), live_.sources().folders.at(place), {},
         [place](LiveSources& sources, const std::filesystem::path& chosen) { sources.folders.at(place) = chosen; });
}

void Transport::choose_table() {
  choose(tr("Table of joint angles"), live_.sources().table, tr("Tables (*.csv *.txt)"),
         [](LiveSources& sources, const std::filesystem::path& chosen) { sources.table = chosen; });
}

/// A folder where there is no filter of files.
void Transport::choose(const QString& title, const std::filesystem::path& now, const QString& filter,
                       const std::function<void(LiveSources&, const std::filesystem::path&)>& set) {
  auto* dialog = new QFileDialog(this, title, QString::fromStdString(now.string()), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(filter.isEmpty() ? QFileDialog::Directory : QFileDialog::AnyFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, set](const QString& chosen) {
    LiveSources sources = live_.sources();
    set(sources, chosen.toStdString());
    live_.set_sources(sources);
  });
  dialog->open();
}

void Transport::toggle_play() { play_->click(); }

double Transport::magnification() const { return magnifications[ghost_->value()]; }

bool Transport::is_labelled() const {
  const auto& all = workbench_.document.session().observations;
  return workbench_.document.session().target ||
         std::any_of(all.begin(), all.end(), [](const Observation& o) { return !o.sightings.empty(); });
}

namespace {

/// Before the first step: what there is to play, or what an earlier play made of it.
QString waiting_text(const Session& session) {
  const auto decided = [&](Decision decision) {
    return std::count_if(session.observations.begin(), session.observations.end(),
                         [decision](const Observation& o) { return o.decision == decision; });
  };
  const auto taken = decided(Decision::accepted), rejected = decided(Decision::rejected);
  const QString all = counted(static_cast<qint64>(session.observations.size()), "%n observation(s)");
  if (taken == 0) return Transport::tr("%1 to play").arg(all);
  return Transport::tr("%1, %2 taken, %3 rejected").arg(all).arg(taken).arg(rejected);
}

}  // namespace

QString Transport::progress_text() const {
  if (workbench_.document.is_open() && is_joined(workbench_.document.session()))
    return tr("Each session is played by itself.");
  if (workbench_.document.is_open() && workbench_.document.session().is_touch()) return tr("Nothing to play");
  if (!workbench_.document.is_open() || !is_labelled())
    return tr("Waits for three markers: label the first observation (Ctrl+1).");
  const std::size_t count = workbench_.document.session().observations.size(), at = player_.position();
  if (at == 0) return waiting_text(workbench_.document.session());
  const std::size_t taken = player_.steps().back().accepted;
  if (const auto& search = player_.steps().back().search)
    return tr("%1 of %2 observations. The cameras' mount is still unknown: %3 labelled, %4 left open, which agree on "
              "none yet.")
        .arg(at)
        .arg(count)
        .arg(search->labelled)
        .arg(search->open);
  return tr("%1 of %2 observations, %3 taken, %4 rejected").arg(at).arg(count).arg(taken).arg(at - taken);
}

void Transport::refresh() {
  const bool open = workbench_.document.is_open(), are_touches = open && workbench_.document.session().is_touch(),
             labelled = open && is_labelled() && !is_joined(workbench_.document.session()) && !are_touches;
  const bool is_over = player_.is_finished() && !player_.is_live();
  play_->setIcon(widgets::icon(player_.is_playing() ? "pause" : "play"));
  play_->setText(player_.is_playing() ? tr("Pause") : is_over ? tr("Play again") : tr("Play"));
  for (QWidget* w : std::initializer_list<QWidget*>{play_, step_, rewind_}) w->setEnabled(labelled);
  const auto& rig = workbench_.document.session().rig;
  // Markers without names are found in the images of two cameras; trackers and sensors of poses write tables.
  watch_->setEnabled(open && !are_touches && !is_joined(workbench_.document.session()) &&
                     (!rig || is_pair(*rig) || workbench_.document.session().target));
  sources_->setVisible(rig.has_value());
  if (watch_->isChecked() && !live_.is_watching()) watch_->setChecked(false);
  progress_->setText(progress_text());
  progress_->setToolTip(progress_->text());
  label_next_->setVisible(workbench_.label_wanted && !player_.is_playing());
  if (workbench_.label_wanted) label_next_->setText(tr("Label observation %1 next").arg(*workbench_.label_wanted));
  live_row_->setVisible(live_.is_watching());
  live_text_->setText(live_.state_text());
}

}  // namespace handsight::app
