// SPDX-License-Identifier: GPL-3.0-or-later
#include "collection/sessions_bar.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "widgets/base/number_text.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

constexpr int mark_size = 16;

/// "0.21 px": of the session's own observations, held out where that is known.
QString compute_error(const PartReport& part) {
  const ErrorSummary& error = part.held_out.rms_pixel || part.held_out.rms_m ? part.held_out : part.fitted;
  if (part.has_cameras && error.rms_pixel) return widgets::short_text(*error.rms_pixel) + " px";
  return error.rms_m ? widgets::short_text(1e3 * *error.rms_m) + " mm" : QString();
}

}  // namespace

SessionsBar::SessionsBar(Workbench& workbench, QWidget* parent) : QFrame(parent), workbench_(workbench) {
  setObjectName("sessions");
  row_ = new QHBoxLayout(this);
  row_->setContentsMargins(widgets::layout_gap, 2, widgets::layout_gap, 2);
  row_->setSpacing(4);
  auto* title = new QLabel(tr("Sessions"), this);
  row_->addWidget(title);
  row_->addStretch(1);
  marks_ = button("session_marks", tr("Marks in plots"), tr("Draws each point as its session's mark"));
  marks_->setCheckable(true);
  shared_ = button("what_is_shared", tr("What is shared…"), tr("Which have the same cameras, which the same hand"));
  add_ = button("add_session", tr("Add a session…"), tr("Another hand, another camera or another day of this robot"));
  for (QToolButton* b : {marks_, shared_, add_}) row_->addWidget(b);
  connect(marks_, &QToolButton::toggled, &workbench.sessions, &SessionFilter::set_marks);
  connect(shared_, &QToolButton::clicked, this, &SessionsBar::shared_wanted);
  connect(add_, &QToolButton::clicked, this, &SessionsBar::add_wanted);
  connect(&workbench.document, &Document::opened, this, &SessionsBar::rebuild);
  connect(&workbench.document, &Document::closed, this, &SessionsBar::rebuild);
  connect(&workbench.document, &Document::model_changed, this, &SessionsBar::refresh);
  connect(&workbench.sessions, &SessionFilter::changed, this, &SessionsBar::refresh);
  hide();
}

QToolButton* SessionsBar::button(const char* name, const QString& text, const QString& tip) {
  auto* b = new QToolButton(this);
  b->setObjectName(name);
  b->setText(text);
  b->setToolTip(tip);
  b->setMinimumHeight(24);
  return b;
}

void SessionsBar::rebuild() {
  for (QToolButton* b : sessions_) delete b;
  sessions_.clear();
  const bool is_any = workbench_.document.is_open() && workbench_.sessions.is_any();
  setVisible(is_any);
  if (!is_any) return;
  const int count = static_cast<int>(workbench_.sessions.names().size());
  for (int i = 0; i < count; ++i) {
    QToolButton* b = button("", {}, {});
    b->setObjectName(QString("session_%1").arg(i));
    b->setCheckable(true);
    b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(b, &QToolButton::clicked, this, [this, i](bool shown) {
      if (QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier))
        workbench_.sessions.show_only(i);
      else
        workbench_.sessions.set_shown(i, shown);
    });
    row_->insertWidget(1 + i, b);
    sessions_.push_back(b);
  }
  refresh();
}

void SessionsBar::refresh() {
  if (sessions_.empty() || !workbench_.document.is_open()) return;
  const QStringList titles = workbench_.sessions.names();
  if (titles.size() != static_cast<qsizetype>(sessions_.size())) return rebuild();  // one came or went
  const ModelVersionPointer model = workbench_.document.shown_model();
  names_.clear();
  for (int i = 0; i < static_cast<int>(sessions_.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const QString error = model && at < model->parts.size() ? compute_error(model->parts[at]) : QString();
    names_ << (error.isEmpty() ? titles[i] : titles[i] + "  " + error);
    const bool is_shown = workbench_.sessions.is_shown(i);
    sessions_[at]->setChecked(is_shown);
    sessions_[at]->setIcon(QIcon(widgets::session_mark_picture(i, mark_size, devicePixelRatioF())));
    sessions_[at]->setAccessibleName(titles[i]);
    sessions_[at]->setToolTip(
        names_.back() + '\n' +
        tr("%1 everywhere; Shift+click: this one alone").arg(is_shown ? tr("Hides it") : tr("Shows it")));
  }
  marks_->setChecked(workbench_.sessions.has_marks());
  fit_names();
}

/// As long as there is room for them.
void SessionsBar::fit_names() {
  if (sessions_.empty()) return;
  constexpr int rim = 36;
  int taken = 2 * widgets::layout_gap + 100;
  for (const QToolButton* b : {marks_, shared_, add_}) taken += b->sizeHint().width() + 4;
  const int room = std::max((width() - taken) / static_cast<int>(sessions_.size()) - 4, 60);
  for (std::size_t i = 0; i < sessions_.size(); ++i) {
    QToolButton& b = *sessions_[i];
    b.setText(b.fontMetrics().elidedText(names_.value(static_cast<int>(i)), Qt::ElideMiddle, room - rim));
  }
}

void SessionsBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit_names();
}

void SessionsBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) refresh();
  QFrame::changeEvent(event);
}

}  // namespace handsight::app
