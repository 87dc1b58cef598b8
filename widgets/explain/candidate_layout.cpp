// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/candidate_layout.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/drawings/effect_drawing.h"
#include "widgets/explain/text_lines.h"

namespace handsight::widgets {
namespace {

constexpr double outer_margin = 10, drawing_size = 96, size_row = 18, error_row = 20, least_card = 168;
constexpr double field_height = 24, field_width = 116;
constexpr int most_sizes = 4, most_title_lines = 3, most_words_lines = 5, most_evidence_lines = 3, most_where_lines = 3,
              most_caution_lines = 3;

QString card_text(const char* text) { return QCoreApplication::translate("handsight::widgets::CandidateCard", text); }

QFont body() { return text_font(TextRole::body); }
QFont small() { return text_font(TextRole::small); }

QString measured_label() { return card_text("Measured"); }

/// The sign, ink and ground of an honest card.
struct Honest {
  QString sign;
  QColor ink, tint;
};

Honest honest(CardKind kind) {
  const Colors& c = colors();
  switch (kind) {
    case CardKind::adequate:
      return {QStringLiteral("✓"), c.good, c.good_tint};
    case CardKind::unexplained:
      return {QStringLiteral("?"), c.bad, c.bad_tint};
    case CardKind::ambiguous:
      return {QStringLiteral("⇄"), c.care, c.care_tint};
    case CardKind::repeatability:
      return {QStringLiteral("∴"), c.care, c.care_tint};
    default:
      return {QStringLiteral("?"), c.care, c.care_tint};
  }
}

void paint_honest(QPainter& painter, const CardState& state, const CardLayout& layout) {
  const Honest look = honest(state.kind);
  const QPointF middle = layout.drawing.center();
  painter.setPen(QPen(look.ink, 3));
  painter.setBrush(look.tint);
  painter.drawEllipse(middle, 34, 34);
  QFont font = text_font(TextRole::number);
  font.setPixelSize(34);
  painter.setFont(font);
  painter.drawText(layout.drawing, Qt::AlignCenter, look.sign);
}

void paint_title(QPainter& painter, const CardState& state, const CardLayout& l) {
  painter.setFont(text_font(TextRole::title));
  painter.setPen(colors().ink1);
  if (l.title.height() > 24)
    draw_lines(painter, painter.font(), l.title, state.title, most_title_lines);
  else
    draw_text(painter, l.title, Qt::AlignLeft | Qt::AlignVCenter, state.title);
  painter.setPen(colors().ink2);
  draw_lines(painter, body(), l.where, state.where, most_where_lines);
}

/// The error that is left as a bar on a log scale that ends at the noise, today's as an outline round it.
void paint_error(QPainter& painter, const ErrorLeft& error, const QRectF& area) {
  const Colors& c = colors();
  painter.setFont(number_font(TextRole::body));
  const QString text = error_left_text(error);
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 2;
  painter.setPen(error.is_predicted ? c.candidate : c.ink1);
  draw_text(painter, area.adjusted(area.width() - wide, 0, 0, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  const QRectF bar(area.left(), area.top() + 4, area.width() - wide - 12, area.height() - 8);
  if (bar.width() < 30 || !error.now || !(*error.now > 0)) return;
  const double least = std::min({error.noise.value_or(*error.now), error.left.value_or(*error.now), *error.now});
  const double low = std::max(least, 1e-9) / 1.6, high = std::max(*error.now, error.left.value_or(0)) * 1.02;
  const auto find_x = [&](double value) {
    return bar.left() + bar.width() * std::clamp(std::log(value / low) / std::log(high / low), 0.0, 1.0);
  };
  painter.fillRect(bar, c.sunken);
  if (error.left && *error.left > 0) {
    const QRectF left(bar.left(), bar.top(), find_x(*error.left) - bar.left(), bar.height());
    if (error.is_predicted) {
      QColor veil = c.candidate;
      veil.setAlpha(60);
      QPen pen(c.candidate, 1.5);
      pen.setDashPattern({3, 2});
      painter.setPen(pen);
      painter.setBrush(veil);
      painter.drawRect(left.adjusted(1, 1, -1, -1));
    } else {
      painter.fillRect(left, c.ink2);
    }
  }
  if (error.noise && *error.noise > 0) {
    const QRectF floor(bar.left(), bar.top(), find_x(*error.noise) - bar.left(), bar.height());
    painter.fillRect(floor, noise_hatching(c.control_edge));
    painter.setPen(QPen(c.ink2, 1));
    painter.drawLine(QPointF(floor.right(), bar.top() - 3), QPointF(floor.right(), bar.bottom() + 3));
  }
  painter.setPen(QPen(c.control_edge, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(
      QRectF(bar.left(), bar.top(), find_x(*error.now) - bar.left(), bar.height()).adjusted(0.5, 0.5, -0.5, -0.5));
}

/// A value against minus and plus three prior sigmas, its sigma as a whisker.
void paint_plausible(QPainter& painter, const ModelParameter& p, const QRectF& bar) {
  const Colors& c = colors();
  constexpr double most = 3;
  const auto find_x = [&](double sizes) {
    return bar.center().x() + bar.width() / 2 * std::clamp(sizes / most, -1.0, 1.0);
  };
  painter.fillRect(bar, c.sunken);
  painter.fillRect(QRectF(find_x(-1), bar.top(), find_x(1) - find_x(-1), bar.height()), c.hairline);
  painter.setPen(QPen(c.control_edge, 1));
  painter.drawLine(QPointF(bar.center().x(), bar.top() - 1), QPointF(bar.center().x(), bar.bottom() + 1));
  if (!p.value) return;
  const double value = *p.value / *p.plausible, sigma = p.sigma.value_or(0) / *p.plausible;
  const QColor ink = std::abs(value) > most ? c.bad : c.ink1;
  painter.setPen(QPen(ink, 1));
  painter.drawLine(QPointF(find_x(value - sigma), bar.center().y()), QPointF(find_x(value + sigma), bar.center().y()));
  painter.fillRect(QRectF(find_x(value) - 1.5, bar.top() - 2, 3, bar.height() + 4), ink);
}

/// "arm_2 compliance"; the joint alone where all numbers are of one kind, which their unit tells.
QString display_name(const ModelParameter& p, const std::vector<ModelParameter>& all) {
  const bool is_one_kind =
      std::all_of(all.begin(), all.end(), [&](const ModelParameter& other) { return other.name == p.name; });
  if (p.of.isEmpty()) return p.name;
  return is_one_kind ? p.of : p.of + QStringLiteral(" ") + p.name;
}

void paint_size(QPainter& painter, const ModelParameter& p, const QString& name, const QRectF& row) {
  const Colors& c = colors();
  const QString value = with_sigma_unit_text(p.value, p.sigma, p.unit);
  painter.setFont(number_font(TextRole::small));
  // A long name takes room from the bar, down to half of it.
  const double wanted = QFontMetricsF(painter.font()).horizontalAdvance(value) + 2 +
                        QFontMetricsF(small()).horizontalAdvance(name) + 2 * layout_gap;
  const double bar = std::clamp(row.width() - wanted, 32.0, 64.0), most = row.width() - bar - 2 * layout_gap - 44;
  const double needed = std::min(QFontMetricsF(painter.font()).horizontalAdvance(value) + 2, most);
  painter.setPen(c.ink1);
  const QRectF middle(row.right() - bar - layout_gap - needed, row.top(), needed, row.height());
  draw_text(painter, middle, Qt::AlignRight | Qt::AlignVCenter, value);
  painter.setFont(small());
  painter.setPen(c.ink2);
  const QRectF left(row.left(), row.top(), middle.left() - layout_gap - row.left(), row.height());
  // Names of joints differ at their ends.
  draw_text(painter, left, Qt::AlignLeft | Qt::AlignVCenter,
            QFontMetricsF(painter.font()).elidedText(name, Qt::ElideLeft, left.width()));
  if (p.plausible && *p.plausible > 0)
    paint_plausible(painter, p, QRectF(row.right() - bar, row.center().y() - 3, bar, 6));
}

/// The prediction, and what the measured number says of it; the field itself is a widget.
void paint_check(QPainter& painter, const CardCheck& check, const CardLayout& l) {
  const Colors& c = colors();
  painter.setPen(c.ink1);
  draw_lines(painter, small(), l.prediction, check.prediction, 3);
  painter.setFont(small());
  painter.setPen(c.ink2);
  draw_text(painter, l.measured_label, Qt::AlignLeft | Qt::AlignVCenter, measured_label());
  draw_text(painter, l.unit, Qt::AlignLeft | Qt::AlignVCenter, check.unit);
  const bool is_hint = check.answer.isEmpty();
  painter.setPen(is_hint ? c.ink3 : check.is_inside ? c.good : c.bad);
  draw_lines(painter, small(), l.answer,
             is_hint ? card_text("Try it on the robot and type what it shows.") : check.answer, 2);
}

void paint_more(QPainter& painter, const QRectF& row, std::size_t hidden) {
  painter.setFont(small());
  painter.setPen(colors().ink3);
  draw_text(painter, row, Qt::AlignLeft | Qt::AlignVCenter, card_text("and %1 more numbers").arg(hidden));
}

}  // namespace

QString indistinguishable_text(const CardState& state) {
  return state.indistinguishable_from.isEmpty()
             ? QString()
             : card_text("Cannot be told from %1 on these poses.").arg(state.indistinguishable_from);
}

QString check_text(const CardState& state) {
  return state.check.isEmpty() ? QString() : card_text("Check: %1").arg(state.check);
}

QString error_left_text(const ErrorLeft& error) {
  QString text = QStringLiteral("%1 → %2").arg(short_text(error.now), with_unit_text(error.left, error.unit));
  if (error.is_predicted) text += QStringLiteral(" ") + card_text("predicted");
  return text;
}

CardLayout lay_out(const CardState& state, double width) {
  CardLayout l;
  l.drawing = {outer_margin, outer_margin, drawing_size, drawing_size};
  double left = l.drawing.right() + 12, wide = width - left - outer_margin;
  const double title = lines_height(text_font(TextRole::title), state.title, wide, most_title_lines);
  l.title = {left, outer_margin - 2, wide, std::max(title, 22.0)};
  double y = l.title.bottom() + 2;
  const auto text = [&](const QFont& font, const QString& said_text, int most_lines) {
    const double high = lines_height(font, said_text, wide, most_lines);
    const QRectF area = high > 0 ? QRectF(left, y, wide, high) : QRectF();
    if (high > 0) y += high + 3;
    return area;
  };
  // Beside the title where that has room: names of joints are never shortened for it.
  const double beside =
      l.title.left() + QFontMetricsF(text_font(TextRole::title)).horizontalAdvance(state.title) + layout_gap;
  const double room = l.title.right() - beside;
  if (!state.where.isEmpty() && l.title.height() <= 24 &&
      QFontMetricsF(body()).horizontalAdvance(state.where) + 2 < room)
    l.where = {beside, l.title.top() + 3, room, l.title.height() - 3};
  else
    l.where = text(body(), state.where, most_where_lines);
  const bool is_honest = state.kind != CardKind::candidate;
  l.words = text(body(), state.words, is_honest ? 6 : most_words_lines);
  if (state.error.now && state.error.left) {
    l.error = {left, y, wide, error_row};
    y += error_row + 3;
  }
  l.caution = text(small(), state.caution, most_caution_lines);
  l.evidence = text(small(), state.evidence, most_evidence_lines);
  const std::size_t shown = std::min<std::size_t>(state.sizes.size(), most_sizes);
  const std::size_t rows = shown + (state.sizes.size() > shown ? 1 : 0);
  for (std::size_t i = 0; i < rows; ++i, y += size_row) l.sizes.push_back({left, y, wide, size_row});
  if (rows > 0) y += 3;
  l.told_from = text(small(), indistinguishable_text(state), 2);
  if (state.check_number && y > l.drawing.bottom()) {  // below the drawing there is room
    left = outer_margin;
    wide = width - 2 * outer_margin;
  }
  l.check = text(small(), check_text(state), 2);
  if (state.check_number && !is_honest) {
    l.prediction = text(small(), state.check_number->prediction, 3);
    const double label = QFontMetricsF(small()).horizontalAdvance(measured_label()) + layout_gap;
    l.measured_label = {left, y, label, field_height};
    l.field = {left + label, y, field_width, field_height};
    l.unit = {l.field.right() + layout_gap, y, wide - label - field_width - layout_gap, field_height};
    y += field_height + 3;
    // As high as any answer, so that nothing moves away under the pointer when it comes.
    l.answer = {left, y, wide, 2 * QFontMetricsF(small()).lineSpacing()};
    y += l.answer.height() + 3;
  }
  const bool has_buttons = !is_honest || !state.action.isEmpty();
  y = std::max(y, least_card - outer_margin - (has_buttons ? control_height + 4 : 0));
  if (has_buttons) {
    l.buttons = {left, y + 2, wide, static_cast<double>(control_height)};
    y = l.buttons.bottom();
  }
  l.height = std::max(std::ceil(y + outer_margin), least_card);
  return l;
}

namespace {

QString about_size(const ModelParameter& size) {
  return card_text("%1 %2: the size that the fit wants, against what is plausible (± %3).")
      .arg(size.of, size.name, with_unit_text(size.plausible, size.unit))
      .trimmed();
}

QString about_error(const ErrorLeft& error) {
  return card_text(
             "The error that would be left on observations that the fit has not seen: %1. Today %2; the noise "
             "(hatched) is %3.")
      .arg(with_unit_text(error.left, error.unit), with_unit_text(error.now, error.unit),
           with_unit_text(error.noise, error.unit));
}

}  // namespace

CardTip card_tip(const CardState& state, const CardLayout& l, const QPointF& at) {
  if (l.error.contains(at)) return {l.error, about_error(state.error)};
  for (std::size_t i = 0; i < l.sizes.size() && i < state.sizes.size(); ++i)
    if (l.sizes[i].contains(at)) return {l.sizes[i], about_size(state.sizes[i])};
  const auto texts = {
      std::tuple(l.where, state.where, body(), most_where_lines),
      std::tuple(l.words, state.words, body(), state.kind == CardKind::candidate ? most_words_lines : 6),
      std::tuple(l.caution, state.caution, small(), most_caution_lines),
      std::tuple(l.evidence, state.evidence, small(), most_evidence_lines),
      std::tuple(l.told_from, indistinguishable_text(state), small(), 2),
      std::tuple(l.check, check_text(state), small(), 2)};
  for (const auto& [area, text, font, lines] : texts)
    if (area.contains(at)) return {area, is_shortened(font, text, area.width(), lines) ? text : QString()};
  if (state.check_number && l.answer.contains(at))
    return {l.answer, is_shortened(small(), state.check_number->answer, l.answer.width(), 2)
                          ? state.check_number->answer
                          : QString()};
  return {};
}

void paint_card(QPainter& painter, const CardState& state, const CardLayout& l) {
  const Colors& c = colors();
  if (state.kind == CardKind::candidate)
    paint_effect(painter, l.drawing, state.effect, c);
  else
    paint_honest(painter, state, l);
  paint_title(painter, state, l);
  painter.setPen(c.ink1);
  draw_lines(painter, body(), l.words, state.words, state.kind == CardKind::candidate ? most_words_lines : 6);
  if (!l.error.isEmpty()) paint_error(painter, state.error, l.error);
  painter.setPen(c.care);
  draw_lines(painter, small(), l.caution, state.caution, most_caution_lines);
  painter.setPen(c.ink2);
  draw_lines(painter, small(), l.evidence, state.evidence, most_evidence_lines);
  for (std::size_t i = 0; i < l.sizes.size(); ++i) {
    if (i < most_sizes)
      paint_size(painter, state.sizes[i], display_name(state.sizes[i], state.sizes), l.sizes[i]);
    else
      paint_more(painter, l.sizes[i], state.sizes.size() - most_sizes);
  }
  painter.setPen(c.care);
  draw_lines(painter, small(), l.told_from, indistinguishable_text(state), 2);
  painter.setPen(c.ink2);
  draw_lines(painter, small(), l.check, check_text(state), 2);
  if (!l.field.isEmpty()) paint_check(painter, *state.check_number, l);
}

}  // namespace handsight::widgets
