// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/export_workspace.h"

#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTableWidget>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "certify/certificate_pdf.h"
#include "certify/request.h"
#include "correct/robot_file.h"
#include "diagnosis/attribution/fresh_poses.h"
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
using widgets::TextRole;

/// "hit: 4.1, limit 12"
QString fresh_text(const FreshPose& pose) {
  if (pose.is_known_bad && !pose.is_hit)
    return QObject::tr("known to be wrong: %1, limit %2")
        .arg(widgets::short_text(1e3 * pose.distance), widgets::short_text(1e3 * pose.allowed));
  return (pose.is_hit ? QObject::tr("hit: %1, limit %2") : QObject::tr("miss: %1, limit %2"))
      .arg(widgets::short_text(1e3 * pose.distance), widgets::short_text(1e3 * pose.allowed));
}

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
  std::vector<ExportRemark> remarks = export_remarks(workbench_.document, *model);
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

void ExportWorkspace::refresh_motion() {
  const ModelVersionPointer model = workbench_.document.model();
  if (!model || !model->fit) return;
  auto lines = motion_lines(*model, form(), hand());
  if (form() != MotionForm::matrix)
    for (const MotionLine& line : effect_lines(workbench_.document.session(), *model->fit)) lines.push_back(line);
  motion_->setRowCount(static_cast<int>(lines.size()));
  for (int r = 0; r < motion_->rowCount(); ++r) {
    const MotionLine& l = lines[static_cast<std::size_t>(r)];
    const QString cells[] = {l.name, l.value, l.sigma, l.unit};
    for (int c = 0; c < 4; ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      item->setTextAlignment((c == 1 || c == 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      if (c == 1 || c == 2) item->setFont(widgets::number_font(TextRole::body));
      motion_->setItem(r, c, item);
    }
  }
  fit_columns();
}

/// Names as wide as they are, and in several lines where the numbers would be pushed out of sight.
void ExportWorkspace::fit_columns() {
  motion_->horizontalHeader()->setStretchLastSection(false);
  motion_->resizeColumnsToContents();
  int numbers = 0;
  for (int c = 1; c < motion_->columnCount(); ++c) numbers += motion_->columnWidth(c);
  constexpr int scroll_bar = 16, least = 120;
  const int room = std::max(motion_->width() - numbers - scroll_bar, least);
  if (form() != MotionForm::matrix && motion_->columnWidth(0) > room) motion_->setColumnWidth(0, room);
  motion_->horizontalHeader()->setStretchLastSection(true);
  motion_->resizeRowsToContents();
}

bool ExportWorkspace::eventFilter(QObject* watched, QEvent* event) {
  if (watched == motion_ && event->type() == QEvent::Resize && motion_->rowCount() > 0) fit_columns();
  return Workspace::eventFilter(watched, event);
}

void ExportWorkspace::refresh_excluded(const ModelVersion& model) {
  const auto& unused = model.report->rejected;
  excluded_title_->setText(
      unused.empty() ? tr("Every observation was used")
                     : tr("%1 not used").arg(counted(static_cast<qint64>(unused.size()), "%n observation(s)")));
  excluded_->setVisible(!unused.empty());
  const auto fresh = fresh_poses(*model.inspection);
  const auto count = [&](auto test) { return std::count_if(fresh.begin(), fresh.end(), test); };
  const auto hits = count([](const FreshPose& p) { return p.is_hit && !p.is_known_bad; });
  const auto bad = count([](const FreshPose& p) { return p.is_known_bad; });
  const auto tests = static_cast<qint64>(fresh.size()) - bad;
  QString sentence = tests == 0
                         ? tr("No fresh pose can test it: the fit has seen all that can be used.")
                         : tr("Fresh poses: of %1 that the fit has not seen, %2 within the 95 % ellipsoid of those "
                              "it has.")
                               .arg(tests)
                               .arg(hits == 1 ? tr("1 lies") : tr("%1 lie").arg(hits));
  if (bad > 0) sentence += ' ' + tr("Known to be wrong and not counted: %1.").arg(bad);
  fresh_->setVisible(!fresh.empty());
  fresh_->setText(sentence);
  excluded_->setRowCount(static_cast<int>(unused.size()));
  for (int r = 0; r < excluded_->rowCount(); ++r) {
    const Unused& u = unused[static_cast<std::size_t>(r)];
    excluded_->setItem(r, 0, new QTableWidgetItem(QString::number(u.id)));
    auto* why = new QTableWidgetItem(translated(u.reason));
    why->setToolTip(why->text());
    excluded_->setItem(r, 2, why);
    const auto pose = std::find_if(fresh.begin(), fresh.end(), [&](const FreshPose& p) { return p.id == u.id; });
    excluded_->setItem(r, 1, new QTableWidgetItem(pose == fresh.end() ? QStringLiteral("-") : fresh_text(*pose)));
  }
  constexpr int gap = 12;  // else a text that ends and one that begins read as one
  for (int column = 0; column < 2; ++column) {
    excluded_->resizeColumnToContents(column);
    excluded_->setColumnWidth(column, excluded_->columnWidth(column) + gap);
  }
  excluded_->resizeRowsToContents();
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
