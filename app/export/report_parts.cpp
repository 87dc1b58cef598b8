// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report_parts.h"

#include <QDateTime>
#include <QObject>
#include <cmath>

#include "document/effect_words.h"
#include "export/export_texts.h"
#include "findings/explain_texts.h"
#include "findings/robot_checks.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "workbench/model_effects.h"

namespace handsight::app {
namespace {

/// What stands in the columns: after a name numbers, to the right, or words, to the left; or numbers alone.
enum class Columns { numbers, words, numbers_alone };

QString row(const QStringList& cells, Columns columns, const char* tag = "td") {
  QString text = "<tr>";
  for (int i = 0; i < cells.size(); ++i)
    text += QString("<%1 align=\"%2\">%3</%1>")
                .arg(tag, columns == Columns::words || (i == 0 && columns == Columns::numbers) ? "left" : "right",
                     cells[i].toHtmlEscaped());
  return text + "</tr>\n";
}

QString table(const QStringList& head, const std::vector<QStringList>& rows, Columns columns = Columns::numbers) {
  QString text = "<div class=\"wide\"><table cellspacing=\"0\" cellpadding=\"4\">\n";
  if (!head.isEmpty()) text += row(head, columns, "th");
  for (const QStringList& r : rows) text += row(r, columns);
  return text + "</table></div>\n";
}

/// As every other place tells it: px and, of the hand, mm; with a tracker mm of each marker.
QString error_text(const ErrorSummary& e) {
  if (!e.rms_pixel) return e.rms_m ? widgets::with_unit_text(1e3 * *e.rms_m, "mm") : QString("-");
  const QString px = widgets::with_unit_text(*e.rms_pixel, "px");
  return e.hand_m ? QObject::tr("%1 (%2 at the hand)").arg(px, widgets::with_unit_text(1e3 * *e.hand_m, "mm")) : px;
}

/// Eight places, as many as go beside the other numbers on paper: the full ones are in the XML.
QString matrix_table(const Rigid& motion) {
  const Matrix4 m = matrix_from_rigid(motion);
  std::vector<QStringList> rows;
  for (int r = 0; r < 4; ++r) {
    QStringList cells;
    for (int c = 0; c < 4; ++c) cells << widgets::fixed_text(m(r, c), r < 3 ? 8 : 0);
    rows.push_back(cells);
  }
  return table({}, rows, Columns::numbers_alone);
}

/// Beside each other where the width is known, else below each other.
QString beside(const QString& left, const QString& right, Pages pages) {
  if (pages == Pages::of_a_browser) return left + right;
  return "<table><tr><td>" + left + "</td><td width=\"24\"></td><td>" + right + "</td></tr></table>\n";
}

QString numbers_part(const Document& document, const ModelVersion& model) {
  QString text;
  std::vector<QStringList> rows;
  for (const MotionLine& l : effect_lines(document.session(), *model.fit))
    rows.push_back(
        {l.name, l.value, l.sigma == QObject::tr("held") || l.sigma.isEmpty() ? l.sigma : "± " + l.sigma, l.unit});
  if (!rows.empty()) text += "<h2>" + QObject::tr("Effects in the model") + "</h2>\n" + table({}, rows);
  const FitReport& r = *model.report;
  text += "<h2>" + QObject::tr("The fit") + "</h2>\n";
  const StoryError e = error_and_noise(model);
  rows = {{QObject::tr("Observations"), QString::number(r.observations)},
          {QObject::tr("Used"), QString::number(r.used)},
          {QObject::tr("Error fitted, rms"), error_text(r.fitted)},
          {QObject::tr("Error held out, rms"), error_text(r.held_out)}};
  if (e.elsewhere)
    rows.push_back({QObject::tr("Where whole regions of poses are held out"), error_text(r.held_out_region)});
  QString noise = e.noise ? error_with_unit(*e.noise, e.in_pixels) : QString("-");
  if (e.in_pixels && e.noise && r.noise_of_hand_m)  // beside the errors, which stand in both units
    noise = QObject::tr("%1 (%2 at the hand)").arg(noise, widgets::with_unit_text(1e3 * *r.noise_of_hand_m, "mm"));
  rows.push_back({QObject::tr("What noise alone would leave"), noise});
  rows.push_back({QObject::tr("Chi-squared per degree of freedom"), widgets::short_text(model.fit->chi2_per_dof, 3)});
  text += table({}, rows);
  for (const ExportRemark& remark : export_remarks(document, model))
    text += "<p>" + remark.sentence.toHtmlEscaped() + "</p>\n";
  return text;
}

QString decisions_part(const ModelVersion& model) {
  const QString wrong = model.wrong_points.empty()
                            ? QString()
                            : "<p>" + wrong_points_text(model, model.wrong_points.size()).toHtmlEscaped() + "</p>\n";
  if (model.report->rejected.empty()) return "<p>" + QObject::tr("Every observation was used.") + "</p>\n" + wrong;
  std::vector<QStringList> rows;
  for (const Unused& u : model.report->rejected) rows.push_back({QString::number(u.id), translated(u.reason)});
  return "<h2>" + QObject::tr("Not used") + "</h2>\n" +
         table({QObject::tr("Observation"), QObject::tr("Why")}, rows, Columns::words) + wrong;
}

QString checks_part(const Document& document) {
  std::vector<QStringList> rows;
  for (const auto& [effect, r] : document.readings())
    rows.push_back({effect_title(effect), check_number_text(r.predicted.value, r.predicted.sigma, r.predicted.unit),
                    check_number_text(r.value, r.sigma, r.predicted.unit),
                    translated(answer_check(r.predicted, r.value, r.sigma).text)});
  if (rows.empty()) return {};
  return "<h2>" + QObject::tr("Checked on the robot") + "</h2>\n" +
         table({QObject::tr("Cause"), QObject::tr("Predicted"), QObject::tr("Measured"), QObject::tr("What it says")},
               rows, Columns::words);
}

QString actions_part(const Document& document) {
  const QUndoStack& stack = document.undo_stack();
  if (stack.index() == 0) return {};
  const auto versions = document.versions();
  std::vector<QStringList> rows;
  for (int i = 0; i < stack.index(); ++i) {
    const ModelVersionPointer& after = versions[static_cast<std::size_t>(i) + 1];
    const auto e = after && after->fit ? error_and_noise(*after) : ErrorAndNoise{};
    rows.push_back({stack.text(i), e.error ? error_with_unit(*e.error, e.in_pixels) : QString("-")});
  }
  return "<h2>" + QObject::tr("What was done") + "</h2>\n" +
         table({QObject::tr("Action"), QObject::tr("Error after it")}, rows);
}

QString picture_part(const ReportPicture& picture, const QString& source, Pages pages, double scale) {
  // The row of a table stays on one page: picture and caption do not part.
  const QString begin = pages == Pages::of_paper ? "<table><tr><td>" : "<p class=\"picture\">";
  const QString end = pages == Pages::of_paper ? "</td></tr></table>\n" : "</p>\n";
  return begin + QString("<img width=\"%1\" alt=\"\" src=\"").arg(std::lround(scale * picture_width)) + source +
         "\"/><br/>" + picture.caption.toHtmlEscaped() + end;
}

}  // namespace

QString bill_part(const std::vector<widgets::BillEntry>& bill) {
  if (bill.empty()) return {};
  QString text =
      "<h2>" + QObject::tr("The bill: what each cause is worth at the hand (rms)") +
      "</h2>\n<div class=\"wide\"><table cellspacing=\"0\" cellpadding=\"4\">\n" +
      row({QObject::tr("Cause"), QObject::tr("At the hand"), QObject::tr("What to know of it")}, Columns::words, "th");
  for (const widgets::BillEntry& e : bill) {
    const QString cells[] = {e.cause, e.worth, e.remarks()};
    text += e.is_stand_in ? "<tr bgcolor=\"#fbf3e0\" class=\"care\">" : "<tr>";
    for (const QString& cell : cells)
      text += QString("<td align=\"%1\">").arg(&cell == &cells[1] ? "right" : "left") + cell.toHtmlEscaped() + "</td>";
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

QString story_part(const Document& document, const ReportStory& story) {
  const Session& s = document.session();
  QString text =
      "<h1>" + display_name(s).toHtmlEscaped() + "</h1>\n<p><b>" + story.verdict.toHtmlEscaped() + "</b></p>\n";
  for (const QString& sentence : {story.figures, story.next})
    if (!sentence.isEmpty()) text += "<p>" + sentence.toHtmlEscaped() + "</p>\n";
  return text + "<p class=\"from\">" + QString::fromStdString(s.file.string()).toHtmlEscaped() + "<br/>" +
         QDateTime::currentDateTimeUtc().toString(Qt::ISODate) + ", handsight " HANDSIGHT_VERSION "</p>\n";
}

QString seen_part(const Document& document, const std::vector<ReportPicture>& pictures,
                  const std::vector<PlacedPicture>& placed, const ReportStory& story, Pages pages,
                  const std::function<QString(std::size_t)>& source) {
  QString text = story_part(document, story);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto index = static_cast<std::size_t>(placed[i].index);
    text += picture_part(pictures[index], source(index), pages, placed[i].scale);
    if (i == 0) text += bill_part(story.bill);
  }
  if (placed.empty()) text += bill_part(story.bill);
  return text;
}

QString hand_part(const ModelVersion& model, Pages pages, bool on_a_new_page) {
  std::vector<QStringList> rows;
  for (const MotionLine& l : motion_lines(model, MotionForm::xyz_rpy))
    rows.push_back({l.name, l.value, l.sigma.isEmpty() ? QString() : "± " + l.sigma, l.unit});
  const QString head = on_a_new_page ? "<h2 style=\"page-break-before:always\">" : "<h2>";
  return head + QObject::tr("TCP→Body") + "</h2>\n" +
         beside(table({}, rows),
                "<p>" + QObject::tr("As a matrix, in m:") + "</p>\n" + matrix_table(model.fit->tcp_from_body), pages);
}

QString rest_part(const Document& document, const ModelVersion& model) {
  return numbers_part(document, model) + decisions_part(model) + checks_part(document) + actions_part(document);
}

}  // namespace handsight::app
