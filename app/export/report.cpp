// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDateTime>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>
#include <cmath>
#include <functional>

#include "document/effect_words.h"
#include "export/export_texts.h"
#include "export/report_pages.h"
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

/// Nine places: the full numbers are in the XML.
QString matrix_table(const Rigid& motion) {
  const Matrix4 m = matrix_from_rigid(motion);
  std::vector<QStringList> rows;
  for (int r = 0; r < 4; ++r) {
    QStringList cells;
    for (int c = 0; c < 4; ++c) cells << widgets::fixed_text(m(r, c), r < 3 ? 9 : 0);
    rows.push_back(cells);
  }
  return table({}, rows, Columns::numbers_alone);
}

enum class Pages { of_paper, of_a_browser };

/// Beside each other where the width is known, else below each other.
QString beside(const QString& left, const QString& right, Pages pages) {
  if (pages == Pages::of_a_browser) return left + right;
  return "<table><tr><td>" + left + "</td><td width=\"24\"></td><td>" + right + "</td></tr></table>\n";
}

QString numbers_part(const Document& document, const ModelVersion& model, Pages pages) {
  std::vector<QStringList> rows;
  for (const MotionLine& l : motion_lines(model, MotionForm::xyz_rpy))
    rows.push_back({l.name, l.value, l.sigma.isEmpty() ? QString() : "± " + l.sigma, l.unit});
  QString text = "<h2>" + QObject::tr("TCP→Body") + "</h2>\n";
  text += beside(table({}, rows),
                 "<p>" + QObject::tr("As a matrix, in m:") + "</p>\n" + matrix_table(model.fit->tcp_from_body), pages);
  rows.clear();
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

/// On a telephone as on a wide screen and on paper: what is too wide scrolls by itself, a picture keeps its caption, a
/// row stays whole. Always light, as the pictures are.
constexpr const char* style =
    ":root{color-scheme:light}\n"
    "body{font:14px/1.45 sans-serif;max-width:760px;margin:0 auto;padding:32px 16px;color:#1b2128;background:#fff;"
    "overflow-wrap:anywhere}\n"
    "h1{line-height:1.2}h2{margin-top:32px;break-after:avoid}\n"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums}\n"
    "th,td{border-bottom:1px solid #d0d5db;padding:4px 16px 4px 0;overflow-wrap:normal}tr{break-inside:avoid}\n"
    "td[align=right]{white-space:nowrap}\n"
    ".wide{overflow-x:auto}\n"
    ".from{color:#4a5560}\n"
    ".picture{margin:28px 0;color:#4a5560;break-inside:avoid}\n"
    ".care td{background:#fbf3e0;color:#6e4800}\n"
    "img{max-width:100%;height:auto;margin-bottom:4px}\n"
    "@media print{body{max-width:none;padding:0;font-size:10pt}.wide{overflow-x:visible}}\n";

constexpr int picture_width = 600;  // of the page's px

QString picture_part(const ReportPicture& picture, const QString& source, Pages pages, double scale) {
  // The row of a table stays on one page: picture and caption do not part.
  const QString begin = pages == Pages::of_paper ? "<table><tr><td>" : "<p class=\"picture\">";
  const QString end = pages == Pages::of_paper ? "</td></tr></table>\n" : "</p>\n";
  return begin + QString("<img width=\"%1\" alt=\"\" src=\"").arg(std::lround(scale * picture_width)) + source +
         "\"/><br/>" + picture.caption.toHtmlEscaped() + end;
}

/// A row a cause; what stands in for another one in amber.
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

/// The first page: what there is to say, before any number.
QString story_part(const Document& document, const ReportStory& story) {
  const Session& s = document.session();
  QString text =
      "<h1>" + display_name(s).toHtmlEscaped() + "</h1>\n<p><b>" + story.verdict.toHtmlEscaped() + "</b></p>\n";
  if (!story.next.isEmpty()) text += "<p>" + story.next.toHtmlEscaped() + "</p>\n";
  return text + "<p class=\"from\">" + QString::fromStdString(s.file.string()).toHtmlEscaped() + "<br/>" +
         QDateTime::currentDateTimeUtc().toString(Qt::ISODate) + ", handsight " HANDSIGHT_VERSION "</p>\n";
}

/// `source` gives the picture's address: inside the file, or of a resource.
QString body(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
             const std::vector<PlacedPicture>& placed, const ReportStory& story, Pages pages,
             const std::function<QString(std::size_t)>& source) {
  QString text = story_part(document, story);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto index = static_cast<std::size_t>(placed[i].index);
    text += picture_part(pictures[index], source(index), pages, placed[i].scale);
    if (i == 0) text += bill_part(story.bill);
  }
  if (placed.empty()) text += bill_part(story.bill);
  return text + numbers_part(document, model, pages) + decisions_part(model) + checks_part(document) +
         actions_part(document);
}

std::vector<PlacedPicture> as_they_come(std::size_t count) {
  std::vector<PlacedPicture> placed;
  for (std::size_t i = 0; i < count; ++i) placed.push_back({static_cast<int>(i), 1});
  return placed;
}

/// A4 within its margins, in px of 96 to an inch; the page's number stands below.
constexpr double page_width = 642, page_height = 940, between = 14;
constexpr double whole_page = 971;  // with what is left free for a row that does not fit

double height_of(const QString& html) {
  QTextDocument text;
  text.setDefaultFont(QFont("DejaVu Sans", 9));
  text.setTextWidth(page_width);
  text.setHtml(html);
  return text.size().height();
}

double height_of(const ReportPicture& picture, double scale) {
  const double caption = height_of("<p>" + picture.caption.toHtmlEscaped() + "</p>");
  return scale * picture_width * picture.image.height() / std::max(1.0, double(picture.image.width())) + caption +
         between;
}

/// The first page has the story and, below the first picture, the bill.
std::vector<PlacedPicture> on_paper(const Document& document, const std::vector<ReportPicture>& pictures,
                                    const ReportStory& story, double scale) {
  std::vector<double> heights;
  for (const ReportPicture& p : pictures) heights.push_back(height_of(p, scale));
  const double first = height_of(story_part(document, story)) + height_of(bill_part(story.bill));
  std::vector<PlacedPicture> placed = placed_pictures(heights, page_height, std::max(page_height - first, 0.0));
  for (PlacedPicture& p : placed) p.scale *= scale;
  return placed;
}

QString picture_name(std::size_t i) { return QString("picture:%1").arg(i); }

void set_text(QTextDocument& text, const std::vector<ReportPicture>& pictures, const QString& html) {
  for (std::size_t i = 0; i < pictures.size(); ++i)
    text.addResource(QTextDocument::ImageResource, QUrl(picture_name(i)), pictures[i].image);
  text.setDefaultFont(QFont("DejaVu Sans", 9));
  text.setHtml(html);
}

/// How far the last page is filled, from 0 to 1.
double last_page_of(const std::vector<ReportPicture>& pictures, const QString& html) {
  QTextDocument text;
  set_text(text, pictures, html);
  text.setDocumentMargin(0);
  text.setPageSize(QSizeF(page_width, whole_page));
  double bottom = 0;
  for (QTextBlock b = text.begin(); b.isValid(); b = b.next())
    bottom = std::max(bottom, text.documentLayout()->blockBoundingRect(b).bottom());
  return bottom / whole_page - std::floor(bottom / whole_page);
}

/// With pictures as large as they can be for a last page that is not half empty; else the fullest.
QString html_on_paper(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                      const ReportStory& story) {
  constexpr double wanted = 0.5, scales[] = {1, 0.94, 0.88, 0.82, 0.76, 0.7};
  QString best;
  double fullest = -1;
  for (const double scale : scales) {
    const QString html = body(document, model, pictures, on_paper(document, pictures, story, scale), story,
                              Pages::of_paper, picture_name);
    const double full = last_page_of(pictures, html);
    if (full > fullest) best = html, fullest = full;
    if (full >= wanted) break;
  }
  return best;
}

}  // namespace

QString report_html(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                    const ReportStory& story) {
  const auto inside = [&](std::size_t i) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    pictures[i].image.save(&buffer, "PNG");
    return "data:image/png;base64," + QString::fromLatin1(bytes.toBase64());
  };
  //: the code of the language of the report, as HTML wants it
  const QString language = QObject::tr("en");
  return "<!DOCTYPE html>\n<html lang=\"" + language +
         "\"><head><meta charset=\"utf-8\"/>"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/><title>" +
         display_name(document.session()).toHtmlEscaped() + "</title><style>\n" + style + "</style></head><body>\n" +
         body(document, model, pictures, as_they_come(pictures.size()), story, Pages::of_a_browser, inside) +
         "</body></html>\n";
}

QByteArray report_pdf(const Document& document, const ModelVersion& model, const std::vector<ReportPicture>& pictures,
                      const ReportStory& story) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter);  // the text keeps 2 cm by itself
    writer.setTitle(QString::fromStdString(document.session().title));
    writer.setCreator("handsight " HANDSIGHT_VERSION);
    QTextDocument text;
    set_text(text, pictures, html_on_paper(document, model, pictures, story));
    text.print(&writer);
  }
  return bytes;
}

}  // namespace handsight::app
