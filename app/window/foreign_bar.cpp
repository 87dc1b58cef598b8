// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/foreign_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

constexpr int after_news = 100;       // ms: it is written to its end by then, or there is news again
constexpr int between_looks = 2'000;  // ms: some file systems tell a watcher nothing

}  // namespace

ForeignBar::ForeignBar(Workbench& workbench, QWidget* parent) : QFrame(parent), workbench_(workbench) {
  setObjectName("foreign");
  setAutoFillBackground(true);
  auto* label = new QLabel(tr("Another program has written this session since it was read."), this);
  label->setObjectName("foreign_text");
  label->setWordWrap(true);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* b = new QPushButton(text, this);
    b->setObjectName(name);
    b->setToolTip(tip);
    b->setMinimumHeight(widgets::control_height);
    b->setAutoDefault(false);
    return b;
  };
  auto* later = button("foreign_later", tr("Not now"), tr("The next save puts it together"));
  auto* together = button("foreign_together", tr("Put together"),
                          tr("Takes over what was written there, and saves what was done here with it"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(widgets::layout_gap, 4, widgets::layout_gap, 4);
  row->addWidget(label, 1);
  row->addWidget(later);
  row->addWidget(together);
  connect(together, &QPushButton::clicked, this, &ForeignBar::save_requested);
  connect(later, &QPushButton::clicked, this, [this] {
    is_put_off_ = true;
    hide();
  });
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &ForeignBar::look);
  connect(&files_, &QFileSystemWatcher::directoryChanged, this, [this] { timer_.start(after_news); });
  connect(&workbench.document, &Document::opened, this, &ForeignBar::begin);
  connect(&workbench.document, &Document::closed, this, &ForeignBar::end);
  // A save knows what stands there.
  connect(&workbench.document, &Document::saved_changed, this, [this](bool is_saved) {
    if (is_saved && workbench_.document.is_open()) begin();
  });
  // While it is asked what is to be kept the page says it.
  connect(&workbench.document, &Document::collided, this, [this] {
    if (!workbench_.document.collisions().empty()) hide();
  });
  tint();
  hide();
}

void ForeignBar::begin() {
  is_put_off_ = false;
  seen_.reset();
  const QString folder = QString::fromStdString(workbench_.document.file().parent_path().string());
  if (!files_.directories().contains(folder)) {
    if (!files_.directories().isEmpty()) files_.removePaths(files_.directories());
    files_.addPath(folder);
  }
  say(false);
  timer_.start(after_news);
}

void ForeignBar::end() {
  timer_.stop();
  if (!files_.directories().isEmpty()) files_.removePaths(files_.directories());
  hide();
}

void ForeignBar::look() {
  if (!workbench_.document.is_open()) return;
  timer_.start(between_looks);
  std::vector<fs::path> files{workbench_.document.file()};
  if (workbench_.sessions.is_any())
    for (const SessionPart& part : workbench_.document.session().parts) files.push_back(part.file);
  Stamp now{0, fs::file_time_type::min()};  // the sizes together, the latest time
  for (const fs::path& file : files) {
    std::error_code no_size, no_time;
    now.size += fs::file_size(file, no_size);
    now.written = std::max(now.written, fs::last_write_time(file, no_time));
    if (no_size || no_time) return;  // it is being replaced
  }
  if (seen_ == now) return;
  seen_ = now;
  say(workbench_.document.is_changed_by_another());
}

void ForeignBar::say(bool is_changed) {
  setVisible(is_changed && !is_put_off_ && workbench_.document.collisions().empty());
}

void ForeignBar::tint() {
  QPalette tinted = palette();
  tinted.setColor(QPalette::Window, widgets::colors().care_tint);
  if (palette().color(QPalette::Window) != widgets::colors().care_tint) setPalette(tinted);
}

void ForeignBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) tint();
  QFrame::changeEvent(event);
}

}  // namespace handsight::app
