// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/warning_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QToolButton>

#include "estimation/report/session_warnings.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// The first image of each camera that is of another size than the camera says; its head alone is read.
QStringList size_warnings(const Session& session) {
  QStringList warnings;
  if (!session.rig || !is_pair(*session.rig)) return warnings;
  for (const bool left : {true, false}) {
    const Camera& camera = left ? session.rig->at(0).camera : session.rig->at(1).camera;
    for (const Observation& o : session.observations) {
      const std::string& file = left ? o.images[0] : o.images[1];
      if (file.empty()) continue;
      const QSize size = QImageReader(QString::fromStdString((folder(session) / file).string())).size();
      if (!size.isValid() || size == QSize(camera.width, camera.height)) break;
      warnings << QObject::tr("%1 is %2 x %3 px, the %4 camera says %5 x %6: images of another size are left out.")
                      .arg(QString::fromStdString(file))
                      .arg(size.width())
                      .arg(size.height())
                      .arg(left ? QObject::tr("left") : QObject::tr("right"))
                      .arg(camera.width)
                      .arg(camera.height);
      break;
    }
  }
  return warnings;
}

}  // namespace

WarningBar::WarningBar(Workbench& workbench, QWidget* parent) : QFrame(parent), workbench_(workbench) {
  setObjectName("doubts");
  setAutoFillBackground(true);
  label_ = new QLabel(this);
  label_->setObjectName("doubts_text");
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* away = new QToolButton(this);
  away->setObjectName("doubts_away");
  away->setText(tr("Put away"));
  away->setToolTip(tr("Until the session is opened again"));
  away->setMinimumHeight(widgets::control_height);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(widgets::layout_gap, 4, widgets::layout_gap, 4);
  row->addWidget(label_, 1);
  row->addWidget(away, 0, Qt::AlignTop);
  connect(away, &QToolButton::clicked, this, [this] {
    is_put_away_ = true;
    refresh();
  });
  connect(&workbench.document, &Document::opened, this, &WarningBar::look_through);
  connect(&workbench.document, &Document::model_changed, this, &WarningBar::look_at_model);
  connect(&workbench.document, &Document::closed, this, [this] {
    sentences_.clear();
    of_model_.clear();
    refresh();
  });
  refresh();
}

void WarningBar::look_through() {
  is_put_away_ = false;
  of_model_.clear();
  sentences_.clear();
  for (const Message& model_uncertainty : session_warnings(workbench_.document.session()))
    sentences_ << translated(model_uncertainty);
  sentences_ += size_warnings(workbench_.document.session());
  refresh();
}

void WarningBar::look_at_model() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  const QString model_uncertainty = translated(body_warning(model->fit->tcp_from_body));
  if (model_uncertainty == of_model_) return;
  of_model_ = model_uncertainty;
  refresh();
}

void WarningBar::refresh() {
  QStringList all = sentences_;
  if (!of_model_.isEmpty()) all << of_model_;
  constexpr qsizetype most = 3;
  QStringList shown = all.mid(0, most);
  for (QString& line : shown) line.prepend(QStringLiteral("▲  "));
  if (all.size() > most) shown << tr("And %1 more.").arg(all.size() - most);
  label_->setText(shown.join('\n'));
  label_->setToolTip(all.join('\n'));
  QPalette tinted = palette();
  tinted.setColor(QPalette::Window, widgets::colors().care_tint);
  if (palette().color(QPalette::Window) != widgets::colors().care_tint) setPalette(tinted);
  setVisible(!all.isEmpty() && !is_put_away_);
}

void WarningBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) refresh();
  QFrame::changeEvent(event);
}

}  // namespace handsight::app
