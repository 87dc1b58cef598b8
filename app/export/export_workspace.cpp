// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/export_workspace.h"

#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "certify/certificate_pdf.h"
#include "certify/request.h"
#include "correct/robot_file.h"
#include "export/correction_box.h"
#include "export/exported.h"
#include "export/report.h"
#include "export/report_pictures.h"
#include "export/report_story.h"
#include "findings/explain_texts.h"
#include "session/calibration_xml.h"
#include "widgets/base/number_text.h"
#include "widgets/base/session_mark.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

/// One session of a collection by itself; else the one that is open.
std::shared_ptr<const Session> session_of_hand(const Document& document, const ModelVersion& model, std::size_t hand) {
  return hand < model.hands.size() ? model.hands[hand].session : document.shared_session();
}

using widgets::colors;

}  // namespace

ExportWorkspace::ExportWorkspace(Workbench& workbench, QWidget* parent) : Workspace(workbench, parent) {
  setObjectName("export");
  make_layout();
  connect(&workbench.document, &Document::opened, this, [this] {
    exported_ = -1;
    path_->setText(QString::fromStdString((folder(workbench_.document.session()) / "calibration.xml").string()));
    said_->hide();
    fill_hands();
  });
  connect(&workbench.document, &Document::model_changed, this, [this] {
    emit status_changed();
    if (is_active()) refresh();
  });
  for (auto signal : {&Diagnosing::diagnosis_changed, &Diagnosing::elsewhere_changed})
    connect(&workbench.diagnosing, signal, this, [this] {
      if (is_active()) refresh();
    });
  connect(&workbench, &Workbench::blunders_changed, this, [this] {
    if (is_active()) refresh();
  });
  connect_buttons();
}

void ExportWorkspace::connect_buttons() {
  connect(save_, &QPushButton::clicked, this, &ExportWorkspace::save_xml);
  connect(html_, &QPushButton::clicked, this, [this] { save_report(false); });
  connect(pdf_, &QPushButton::clicked, this, [this] { save_report(true); });
  connect(certificate_, &QPushButton::clicked, this, &ExportWorkspace::save_certificate);
  connect(copy_, &QPushButton::clicked, this, [this] {
    const ModelVersionPointer model = workbench_.document.model();
    if (!model || !model->fit) return;
    QGuiApplication::clipboard()->setText(motion_text(tcp_from_body(*model, hand()), form()));
    say(tr("Copied, in m and rad."), false);
  });
  connect(calibrate_, &QPushButton::clicked, this, [this] { emit workbench_.workspace_requested(Place::calibrate); });
  connect(forms_, &QButtonGroup::idClicked, this, &ExportWorkspace::refresh_motion);
  connect(hand_, &QComboBox::currentIndexChanged, this, [this] {
    if (is_active()) refresh();
  });
  connect(save_other_, &QPushButton::clicked, this,
          [this] { save_for_others(other_->currentData().toString().toStdString()); });
}

void ExportWorkspace::fill_hands() {
  const int before = hand_->currentIndex();
  const QSignalBlocker quiet(hand_);
  hand_->clear();
  const QStringList names = workbench_.sessions.names();
  for (int i = 0; i < names.size(); ++i)
    hand_->addItem(QIcon(widgets::session_mark_picture(i, 16, devicePixelRatioF())), names[i]);
  hand_->setVisible(!names.isEmpty());
  if (before >= 0 && before < names.size()) hand_->setCurrentIndex(before);
}

WorkStatus ExportWorkspace::status() const {
  const ModelVersionPointer model = workbench_.document.shown_model();
  if (!model || !model->fit) return {WorkState::waiting, tr("waits for a fit")};
  if (model->report->used < fewest_that_tell) return {WorkState::waiting, tr("waits for more observations")};
  if (exported_ == workbench_.document.revision()) return {WorkState::done, tr("exported")};
  return {WorkState::open, exported_ < 0 ? tr("ready") : tr("changed since")};
}

void ExportWorkspace::activate() { refresh(); }

void ExportWorkspace::refresh() {
  const ModelVersionPointer model = workbench_.document.model();
  const bool ready = model && model->fit;
  empty_->setText(model && !model->fit             ? tr("Nothing to export: %1").arg(model->refusal)
                  : workbench_.jobs.is_busy("fit") ? tr("A fit runs; the export follows it.")
                                                   : tr("Nothing to export: TCP→Body has not been estimated."));
  empty_->setVisible(!ready);
  calibrate_->setVisible(!ready);
  body_->setVisible(ready);
  for (QPushButton* b : {save_, html_, pdf_, certificate_, copy_, save_other_}) b->setEnabled(ready);
  correction_->show_model(model, hand());
  refresh_remarks(ready ? model : nullptr);
  if (!ready) return;
  refresh_motion();
  refresh_excluded(*model);
  QString text;
  try {
    text = QString::fromStdString(readable_text(*model->calibration));
  } catch (const std::exception& error) {  // numbers that are not finite, or could not be read again
    text = translated_error(error);
    save_->setEnabled(false);
  }
  if (xml_->toPlainText() != text) xml_->setPlainText(text);
  show_changes(text);
}

/// As Explain says it.
widgets::SessionVerdict ExportWorkspace::verdict(const ModelVersionPointer& model) const {
  return session_verdict(workbench_, model);
}

void ExportWorkspace::refresh_remarks(const ModelVersionPointer& model) {
  while (QLayoutItem* item = remarks_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  before_->setVisible(model != nullptr);
  if (!model) return;
  bool any_warning = false;
  std::vector<ExportRemark> remarks;  // of a wrong session there is nothing else to say
  if (workbench_.blunders().empty()) remarks = export_remarks(workbench_.document, *model);
  std::stable_partition(remarks.begin(), remarks.end(), [](const ExportRemark& remark) { return remark.is_warning; });
  remarks.insert(remarks.begin(), verdict_remark(verdict(model), *model));
  for (const ExportRemark& remark : remarks) {
    auto* label = new QLabel((remark.is_warning ? QString("▲  ") : QString("✓  ")) + remark.sentence, reported_);
    label->setWordWrap(true);
    remarks_->addWidget(label);
    label->show();  // at once: what is hidden has no height
    any_warning = any_warning || remark.is_warning;
  }
  QPalette tinted = reported_->palette();
  tinted.setColor(QPalette::Window, any_warning ? colors().care_tint : colors().good_tint);
  reported_->setPalette(tinted);
  fit_remarks();
}

/// However much there is to say, what is exported stays in sight, and the button that saves it.
void ExportWorkspace::fit_remarks() {
  if (remarks_->count() == 0) return;
  const int least = 100, wanted = reported_->heightForWidth(width() - 32), most = std::max(height() / 4, least);
  // A bar that is there takes room, and by that seems needed where it is not.
  before_->setVerticalScrollBarPolicy(wanted > most ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  before_->setFixedHeight(std::min(wanted, most));
  before_->verticalScrollBar()->setValue(0);
}

void ExportWorkspace::resizeEvent(QResizeEvent* event) {
  Workspace::resizeEvent(event);
  fit_remarks();
}

void ExportWorkspace::show_changes(const QString& text) {
  // Lines that the file on the disk does not have are marked.
  QSet<QString> on_disk;
  try {
    if (std::filesystem::exists(path()))
      for (const QString& line : QString::fromStdString(read_file(path())).split('\n')) on_disk.insert(line);
  } catch (const InputError&) {
    // What cannot be read cannot be compared.
  }
  QList<QTextEdit::ExtraSelection> marks;
  if (!on_disk.isEmpty())
    for (QTextBlock block = xml_->document()->begin(); block.isValid(); block = block.next()) {
      if (block.text().trimmed().isEmpty() || on_disk.contains(block.text())) continue;
      QTextEdit::ExtraSelection mark;
      mark.cursor = QTextCursor(block);
      mark.format.setBackground(colors().care_tint);
      mark.format.setProperty(QTextFormat::FullWidthSelection, true);
      marks.append(mark);
    }
  xml_->setExtraSelections(marks);
}

void ExportWorkspace::say(const QString& sentence, bool is_refusal) {
  QPalette tinted = said_->palette();
  tinted.setColor(QPalette::Window, is_refusal ? colors().bad_tint : colors().good_tint);
  said_->setPalette(tinted);
  said_->setText(sentence);
  said_->show();
}

void ExportWorkspace::save_xml() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  try {
    write_calibration(path(), *model->calibration);
    exported_ = workbench_.document.revision();
    say(tr("Written: %1").arg(path_->text()), false);
    refresh();
    emit status_changed();
  } catch (const std::exception& error) {
    say(translated_error(error), true);
  }
}

void ExportWorkspace::save_report(bool pdf) {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  std::filesystem::path file = path();
  file.replace_extension(pdf ? ".pdf" : ".html");
  try {
    const auto pictures = report_pictures(workbench_);
    const ReportStory story = report_story(workbench_, model);
    const QByteArray bytes = pdf ? report_pdf(workbench_.document, *model, pictures, story)
                                 : report_html(workbench_.document, *model, pictures, story).toUtf8();
    replace_file(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    say(tr("Written: %1").arg(QString::fromStdString(file.string())), false);
  } catch (const std::exception& error) {
    say(translated_error(error), true);
  }
}

/// Every observation is judged by a fit that has not seen it: five fits, in the background.
void ExportWorkspace::save_certificate() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  std::filesystem::path file = path();
  file.replace_extension(".certificate.pdf");
  workbench_.background.start<std::string>(
      "certificate", tr("Certificate"),
      [model, session = session_of_hand(workbench_.document, *model, hand()), hand = hand(),
       xml = path()](JobControl& control) {
        const CertificateRequest request =
            certificate_request(*session, calibration_of_hand(*model, hand), xml, "handsight " HANDSIGHT_VERSION);
        const Certificate made = make_certificate(*session, request, [&](double done) {
          control.report(done);
          return !control.is_cancelled();
        });
        return made.is_stopped ? std::string() : certificate_pdf(made);
      },
      [this, file](const std::string& pdf) {
        if (pdf.empty()) return;
        try {
          replace_file(file, pdf);
          say(tr("Written: %1").arg(QString::fromStdString(file.string())), false);
        } catch (const std::exception& error) {
          say(translated_error(error), true);
        }
      },
      [this](const QString& sentence) { say(sentence, true); });
}

void ExportWorkspace::save_for_others(const std::string& kind) {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  const Session& session = workbench_.document.session();
  const std::filesystem::path urdf = folder(session) / session.robot_file;
  std::filesystem::path file = path();
  file.replace_extension(export_kind(kind).ending);
  try {
    const CalibratedRobot robot = with_robot_file(
        calibrated_robot(calibration_of_hand(*model, hand()), session.robot, urdf.string(), path().string()), session);
    const ExportedFile made = exported_file(robot, kind, {std::filesystem::absolute(file), ""});
    replace_file(file, made.text);
    QStringList lines{tr("Written: %1").arg(QString::fromStdString(file.string()))};
    for (const Message& note : made.notes) lines << translated(note);
    say(lines.join('\n'), false);
  } catch (const std::exception& error) {
    say(translated_error(error), true);
  }
}

std::vector<Action> ExportWorkspace::own_actions() const {
  const auto offer = [this](const QString& id, const QString& text, QPushButton* button, const std::string& kind = {}) {
    return Action{.id = id,
                  .group = tr("Export"),
                  .text = text,
                  .run =
                      [this, button, kind] {
                        emit workbench_.workspace_requested(Place::write_out);
                        if (!kind.empty()) other_->setCurrentIndex(other_->findData(QString::fromStdString(kind)));
                        button->click();
                      },
                  .is_possible = [this] { return workbench_.document.is_open() && workbench_.document.model(); }};
  };
  std::vector<Action> actions = {offer("save_report_html", tr("Report as HTML"), html_),
                                 offer("save_report_pdf", tr("Report as PDF"), pdf_),
                                 offer("save_certificate", tr("Certificate as PDF"), certificate_)};
  for (int i = 0; i < other_->count(); ++i)
    actions.push_back(offer("save_as_" + other_->itemData(i).toString(), tr("Save as %1").arg(other_->itemText(i)),
                            save_other_, other_->itemData(i).toString().toStdString()));
  return actions;
}

}  // namespace handsight::app
