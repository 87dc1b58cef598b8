// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/header.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>
#include <algorithm>

#include "widgets/base/icons.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/lists/three_numbers.h"
#include "words/counted.h"
#include "workbench/touch_views.h"

namespace handsight::app {
namespace {

/// The error with everything that is left out of the fit (excluded observations, points that are wrong whatever the
/// robot does), and how much that is; nothing where nothing is left out.
QString excluded_note(const Workbench& workbench) {
  using widgets::SizeUnit;
  const Inspection* all = workbench.inspection();
  if (!all) return {};
  SizeUnit unit = workbench.units.unit();
  // In mm the number beside it is of the hand, which is not known of observations that the fit leaves out.
  if (unit == SizeUnit::millimetre && all->in_pixels) unit = SizeUnit::pixel;
  double squares = 0;
  int weights = 0, excluded = 0;
  for (const InspectionRow& row : all->rows) {
    const Observation* o = workbench.document.find(row.id);
    const auto size = measure_size(row).in(unit);
    if (!o || !size || (o->decision != Decision::excluded && !row.is_used)) continue;
    const int weight = unit == SizeUnit::millimetre ? row.points : row.coordinates;
    excluded += o->decision == Decision::excluded ? 1 : 0;
    squares += *size * *size * weight;
    weights += weight;
  }
  const ModelVersionPointer model = workbench.document.shown_model();
  const auto wrong = static_cast<qint64>(model ? model->wrong_points.size() : 0);
  if (excluded + wrong == 0 || weights == 0) return {};
  QStringList left_out;
  if (excluded > 0) left_out << QObject::tr("%1 excluded").arg(excluded);
  if (wrong > 0) left_out << QObject::tr("%1 set aside").arg(counted(wrong, "%n point(s)"));
  return QObject::tr("%1; with all %2")
      .arg(left_out.join(QObject::tr(" and ")), widgets::size_text({std::sqrt(squares / weights), unit}));
}

}  // namespace

namespace {

/// A title that is shortened in its middle where there is no room for it.
class TitleButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr int rim = 8;
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.text = fontMetrics().elidedText(option.text, Qt::ElideMiddle, width() - rim);
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
  }
};

}  // namespace

Header::Header(Workbench& workbench, const Actions& actions, QMenu* session_menu, QWidget* parent)
    : QWidget(parent), workbench_(workbench), actions_(actions) {
  setObjectName("header");
  const auto button = [this](const char* name, const QString& text, const QString& tip) {
    auto* b = new TitleButton(this);
    b->setObjectName(name);
    b->setText(text);
    b->setToolTip(tip);
    b->setAutoRaise(true);
    b->setMinimumHeight(widgets::control_height);
    return b;
  };
  session_ = button("session_menu", tr("Session"), tr("Open, save, close"));
  session_->setMenu(session_menu);
  session_->setPopupMode(QToolButton::InstantPopup);
  session_->setFont(widgets::text_font(widgets::TextRole::title));
  session_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  undo_ = button("undo", tr("Undo"), {});
  redo_ = button("redo", tr("Redo"), {});
  undo_->setIcon(widgets::icon("undo"));
  redo_->setIcon(widgets::icon("redo"));
  for (QToolButton* b : {undo_, redo_}) b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  job_ = new QLabel(this);
  job_->setObjectName("job");
  job_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  job_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names must not widen the window
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setFixedSize(80, 6);
  progress_->setRange(0, 1000);
  cancel_ = button("cancel", tr("Cancel"), tr("Stops the job; everything stays as it was before"));
  numbers_ = new widgets::ThreeNumbers(this);
  numbers_->setObjectName("three_numbers");
  connect(numbers_, &widgets::ThreeNumbers::version_selected, this, [this](int stair) {
    if (stair < static_cast<int>(stairs_.size()))
      workbench_.document.show_version(stairs_[static_cast<std::size_t>(stair)]);
  });

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(8);
  layout->addWidget(session_);
  layout->addSpacing(8);
  layout->addWidget(undo_);
  layout->addWidget(redo_);
  layout->addWidget(job_, 1);
  layout->addWidget(progress_);
  layout->addWidget(cancel_);
  layout->addSpacing(16);
  layout->addWidget(numbers_);

  connect(undo_, &QToolButton::clicked, &workbench.document, &Document::undo);
  connect(redo_, &QToolButton::clicked, &workbench.document, &Document::redo);
  connect(cancel_, &QToolButton::clicked, &workbench.jobs, [this] { shown_jobs().stop(); });
  for (Jobs* jobs : {&workbench.jobs, &workbench.explaining})
    connect(jobs, &Jobs::changed, this, [this] {
      if (shown_jobs().is_busy() && !poll_.isActive()) poll_.start(50);
      refresh_job();
    });
  connect(&poll_, &QTimer::timeout, this, &Header::refresh_job);
  for (auto signal : {&Document::opened, &Document::closed, &Document::model_changed})
    connect(&workbench.document, signal, this, [this] {
      refresh_session();
      refresh_numbers();
    });
  connect(&workbench.document, &Document::edited, this, &Header::refresh_session);
  connect(&workbench.document, &Document::settings_changed, this, &Header::refresh_session);
  connect(&workbench.document, &Document::readings_changed, this, &Header::refresh_session);
  connect(&workbench.document, &Document::saved_changed, this, &Header::refresh_session);
  connect(&workbench, &Workbench::tried, this, &Header::refresh_numbers);
  for (auto signal : {&Diagnosing::diagnosis_changed, &Diagnosing::elsewhere_changed})
    connect(&workbench.diagnosing, signal, this, &Header::refresh_numbers);
  connect(&workbench.units, &DisplayUnits::changed, this, &Header::refresh_numbers);
  refresh_session();
  refresh_job();
}

void Header::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  share_room();
}

/// Where there is little room the arrows alone say undo and redo: words would push the window beyond a small screen,
/// or cut the session's title.
void Header::share_room() {
  constexpr int small_screen = 1200, between = 64;  // px: margins and what parts the widgets
  const bool is_small = width() < small_screen;
  progress_->setFixedWidth(is_small ? 48 : 120);
  for (QToolButton* b : {undo_, redo_})
    b->setToolButtonStyle(is_small ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
  if (is_small) return;
  int wanted = session_->sizeHint().width() + numbers_->minimumSizeHint().width() + between;
  for (const QWidget* w : std::initializer_list<QWidget*>{undo_, redo_, progress_, cancel_})
    if (!w->isHidden()) wanted += w->sizeHint().width();
  if (wanted <= width()) return;
  for (QToolButton* b : {undo_, redo_}) b->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void Header::refresh_session() {
  const Document& d = workbench_.document;
  const QString name = d.is_open() ? display_name(d.session()) + (d.is_saved() ? "" : " •") : tr("Session");
  session_->setText(name + QStringLiteral("  ▾"));
  session_->setMinimumWidth(std::min(96, session_->sizeHint().width()));  // a long title must not widen the window
  session_->setToolTip(!d.is_open()   ? tr("Open, save, close")
                       : d.is_saved() ? tr("Everything is saved in %1").arg(QString::fromStdString(d.file().string()))
                                      : tr("Not yet saved in session.xml (Ctrl+S). Nothing is lost if you close."));
  const QUndoStack& stack = d.undo_stack();
  undo_->setEnabled(stack.canUndo());
  redo_->setEnabled(stack.canRedo());
  undo_->setToolTip(stack.canUndo() ? tr("Undo: %1 (%2)").arg(stack.undoText(), actions_.of("undo").keys_text())
                                    : tr("Nothing to undo"));
  redo_->setToolTip(stack.canRedo() ? tr("Do again: %1 (%2)").arg(stack.redoText(), actions_.of("redo").keys_text())
                                    : tr("Nothing to redo"));
  for (QWidget* w : {static_cast<QWidget*>(undo_), static_cast<QWidget*>(redo_), static_cast<QWidget*>(numbers_)})
    w->setVisible(d.is_open());
  share_room();
}

Jobs& Header::shown_jobs() const { return workbench_.jobs.is_busy() ? workbench_.jobs : workbench_.explaining; }

void Header::refresh_job() {
  const JobState state = shown_jobs().state();
  if (!shown_jobs().is_busy()) poll_.stop();
  // A job of a moment would only flicker; one that does not know how far it is can be cancelled like any other.
  constexpr double moment = 0.4;  // s
  const bool shown =
      state.is_running && (cancel_->isVisible() || state.seconds_left || state.share > 0.02 || state.seconds > moment);
  const bool changes = shown == progress_->isHidden();
  progress_->setVisible(shown);
  cancel_->setVisible(shown);
  if (changes) share_room();
  if (!shown) return job_->clear();
  const QString share = state.share > 0 ? tr("%1 %").arg(static_cast<int>(100 * state.share)) : QString();
  QString text = state.title;
  if (!share.isEmpty()) text += ": " + share;
  const QString titled = text;
  if (state.seconds_left) text += tr(", %1 left").arg(widgets::duration_text(*state.seconds_left));
  // Where there is no room the name stays with its tool tip, and the share with the bar: what is cut says nothing.
  const int room = job_->width() - 4;
  const QFontMetrics metrics = job_->fontMetrics();
  const QString texts[] = {text, titled, share, QString()};
  job_->setText(*std::ranges::find_if(
      texts, [&](const QString& one) { return one.isEmpty() || metrics.horizontalAdvance(one) <= room; }));
  job_->setToolTip(text);
  progress_->setRange(0, state.share > 0 ? 1000 : 0);
  progress_->setValue(static_cast<int>(1000 * state.share));
}

void Header::refresh_numbers() {
  widgets::ErrorNumbers n;
  const ModelVersionPointer shown = workbench_.document.shown_model();
  if (shown && shown->fit) {
    const auto unit = workbench_.units.unit();
    const auto noise = shown->fit->noise;
    const VersionSizes sizes = list_sizes(*shown, noise);
    n.unit = widgets::unit_name(unit);
    n.now = sizes.error().in(unit);
    n.noise = sizes.noise.in(unit);
    n.ratio = sizes.error().sigma;
    if (unit == widgets::SizeUnit::millimetre && n.now && n.noise && *n.noise > 0) {
      n.ratio = *n.now / *n.noise;
      // Far away cameras see depth so badly that it hides in mm what px show.
      constexpr double hides = 0.7;
      if (sizes.error().sigma && *n.ratio < hides * *sizes.error().sigma) n.noise_note = tr("mostly of the depth");
    }
    const Story& story = workbench_.story();
    if (story.error.elsewhere)
      n.elsewhere = size_of_error(*story.error.elsewhere, story.error.in_pixels, noise).in(unit);
    n.is_stale = workbench_.document.model() == nullptr;
    n.excluded_note = excluded_note(workbench_);
    if (const auto predicted = workbench_.predicted_error()) {
      const ResidualSize tried =
          as_read(size_of_error(*predicted, !workbench_.document.session().is_tracker(), noise), *shown);
      n.predicted = tried.in(unit);  // in a unit in which it is not known it is left out
      if (n.predicted) n.predicted_ratio = tried.sigma;
    }
    stairs_.clear();
    for (const ModelVersionPointer& version : workbench_.document.versions()) {
      if (!version || !version->fit) continue;
      if (version == shown) n.current = static_cast<int>(stairs_.size());
      stairs_.push_back(version);
      const VersionSizes one = list_sizes(*version, noise);
      n.versions.push_back(
          {version->cause.isEmpty() ? tr("as opened") : version->cause, one.fitted.in(unit), one.error().in(unit)});
    }
  }
  numbers_->set_numbers(std::move(n));
  share_room();
}

}  // namespace handsight::app
