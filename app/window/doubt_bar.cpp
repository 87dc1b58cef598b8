// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/doubt_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QToolButton>

#include "estimation/report/session_doubts.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

/// The first image of each camera that is of another size than the camera says; its head alone is read.
QStringList size_doubts(const Session& session) {
  QStringList doubts;
  if (!session.rig || !is_pair(*session.rig)) return doubts;
  for (const bool left : {true, false}) {
    const Camera& camera = left ? session.rig->at(0).camera : session.rig->at(1).camera;
    for (const Observation& o : session.observations) {
      const std::string& file = left ? o.images[0] : o.images[1];
      if (file.empty()) continue;
      const QSize size = QImageReader(QString::fromStdString((folder(session) / file).string())).size();
      if (!size.isValid() || size == QSize(camera.width, camera.height)) break;
      doubts << QObject::tr("%1 is %2 x %3 px, the %4 camera says %5 x %6: images of another size are left out.")
                    .arg(QString::fromStdString(file))
                    .arg(size.width())
                    .arg(size.height())
                    .arg(left ? QObject::tr("left") : QObject::tr("right"))
                    .arg(camera.width)
                    .arg(camera.height);
      break;
    }
  }
  return doubts;
}

}  // namespace

DoubtBar::DoubtBar(Workbench& bench, QWidget* parent) : QFrame(parent), bench_(bench) {
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
  away->setMinimumHeight(widgets::kControlHeight);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(widgets::kGap, 4, widgets::kGap, 4);
  row->addWidget(label_, 1);
  row->addWidget(away, 0, Qt::AlignTop);
  connect(away, &QToolButton::clicked, this, [this] {
    is_put_away_ = true;
    refresh();
  });
  connect(&bench.document, &Document::opened, this, &DoubtBar::look_through);
  connect(&bench.document, &Document::model_changed, this, &DoubtBar::look_at_model);
  connect(&bench.document, &Document::closed, this, [this] {
    sentences_.clear();
    of_model_.clear();
    refresh();
  });
  refresh();
}

void DoubtBar::look_through() {
  is_put_away_ = false;
  of_model_.clear();
  sentences_.clear();
  for (const Message& doubt : session_doubts(bench_.document.session())) sentences_ << translated(doubt);
  sentences_ += size_doubts(bench_.document.session());
  refresh();
}

void DoubtBar::look_at_model() {
  const ModelVersionPointer model = bench_.document.model();
  if (!model || !model->fit) return;
  const QString doubt = translated(body_doubt(model->fit->tcp_from_body));
  if (doubt == of_model_) return;
  of_model_ = doubt;
  refresh();
}

void DoubtBar::refresh() {
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

void DoubtBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) refresh();
  QFrame::changeEvent(event);
}

}  // namespace handsight::app
