// SPDX-License-Identifier: Apache-2.0
// The wizard of files in the user's words.
#pragma once

#include <QtGui/qevent.h>

#include <QListWidget>
#include <QMimeData>
#include <QUrl>

#include "app/window/wizard_page.h"
#include "wizard/files_wizard.h"

namespace handsight::test {

struct FilesPage {
  Desk& desk;
  app::FilesWizard* dialog() { return desk.window.findChild<app::FilesWizard*>(); }
  bool drop(const std::vector<std::filesystem::path>& files, QWidget* on) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& file : files) urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
    data.setUrls(urls);
    QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(on, &enter);
    QDropEvent dropped(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(on, &dropped);
    return enter.isAccepted();
  }
  QStringList listed() {
    QStringList lines;
    auto* list = desk.find<QListWidget>("files_list");
    for (int i = 0; i < list->count(); ++i) lines << list->item(i)->text();
    return lines;
  }
  QString said() { return desk.find<QLabel>("files_said")->text(); }
  QAbstractButton* make() { return desk.find<QAbstractButton>("files_make"); }
  void fill(const char* name, const std::filesystem::path& with) {
    auto* field = desk.find<QLineEdit>(name);
    desk.find<QScrollArea>("files_scroll")->ensureWidgetVisible(field);
    QTest::qWait(10);
    desk.type_into(field, QString::fromStdString(with.string()));
  }
  /// Makes it and waits until it says what became of it.
  bool press_make() {
    desk.click(make());
    return desk.wait([this] { return !said().contains("being made"); });
  }
};

}  // namespace handsight::test
