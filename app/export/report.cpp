// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>
#include <cmath>

#include "export/report_pages.h"
#include "export/report_parts.h"

namespace handsight::app {
namespace {

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
    const QString seen =
        seen_part(document, pictures, on_paper(document, pictures, story, scale), story, Pages::of_paper, picture_name);
    // The numbers of the hand are not torn apart.
    const double room = whole_page * (1 - last_page_of(pictures, seen));
    const bool has_room = room > height_of(hand_part(model, Pages::of_paper, false)) + between;
    const QString html = seen + hand_part(model, Pages::of_paper, !has_room) + rest_part(document, model);
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
         seen_part(document, pictures, as_they_come(pictures.size()), story, Pages::of_a_browser, inside) +
         hand_part(model, Pages::of_a_browser, false) + rest_part(document, model) + "</body></html>\n";
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
