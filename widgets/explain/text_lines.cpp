// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/text_lines.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QTextLayout>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "widgets/base/number_text.h"

namespace handsight::widgets {
namespace {

struct Piece {
  int start = 0, length = 0;
};

std::vector<Piece> pieces_of(const QFont& font, const QString& text, double width, int most_lines) {
  QTextLayout layout(unbroken(text), font);  // as long as the text
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  std::vector<Piece> pieces;
  layout.beginLayout();
  while (static_cast<int>(pieces.size()) <= most_lines) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(std::max(width, 10.0));
    pieces.push_back({line.textStart(), line.textLength()});
  }
  layout.endLayout();
  return pieces;
}

}  // namespace

double lines_height(const QFont& font, const QString& text, double width, int most_lines) {
  if (text.isEmpty()) return 0;
  const int lines = std::min(static_cast<int>(pieces_of(font, text, width, most_lines).size()), most_lines);
  return lines * QFontMetricsF(font).lineSpacing();
}

bool is_shortened(const QFont& font, const QString& text, double width, int most_lines) {
  return static_cast<int>(pieces_of(font, text, width, most_lines).size()) > most_lines;
}

void draw_lines(QPainter& painter, const QFont& font, const QRectF& area, const QString& text, int most_lines) {
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  const std::vector<Piece> pieces = pieces_of(font, text, area.width(), most_lines);
  for (int i = 0; i < static_cast<int>(pieces.size()) && i < most_lines; ++i) {
    const Piece& piece = pieces[static_cast<std::size_t>(i)];
    const bool is_cut = i + 1 == most_lines && static_cast<int>(pieces.size()) > most_lines;
    const QString line = is_cut ? metrics.elidedText(text.mid(piece.start), Qt::ElideRight, area.width())
                                : text.mid(piece.start, piece.length).trimmed();
    painter.drawText(QPointF(area.left(), area.top() + metrics.ascent() + i * metrics.lineSpacing()), line);
  }
}

namespace {

class RowsOfWidth : public QObject {
 public:
  explicit RowsOfWidth(QListView* list) : QObject(list), list_(list) { list->viewport()->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
      QTimer::singleShot(0, list_, [list = list_] {
        list->doItemsLayout();
        list->scrollTo(list->currentIndex());
      });
    return false;
  }

 private:
  QListView* list_;
};

}  // namespace

void lay_rows_out_again(QListView* list) { new RowsOfWidth(list); }

}  // namespace handsight::widgets
