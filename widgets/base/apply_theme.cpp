// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/apply_theme.h"

#include <QApplication>
#include <QPalette>

#include "widgets/base/control_style.h"

namespace handsight::widgets {
namespace {

QPalette palette_of(const Colors& c) {
  QPalette p;
  p.setColor(QPalette::Window, c.window);
  p.setColor(QPalette::WindowText, c.ink1);
  p.setColor(QPalette::Base, c.panel);
  p.setColor(QPalette::AlternateBase, c.window);
  p.setColor(QPalette::Text, c.ink1);
  p.setColor(QPalette::PlaceholderText, c.ink3);
  p.setColor(QPalette::Button, c.panel);
  p.setColor(QPalette::ButtonText, c.ink1);
  p.setColor(QPalette::BrightText, c.bad);
  p.setColor(QPalette::Light, c.panel);
  p.setColor(QPalette::Midlight, c.sunken);
  p.setColor(QPalette::Mid, c.hairline);
  p.setColor(QPalette::Dark, c.control_edge);
  p.setColor(QPalette::Shadow, c.control_edge);
  p.setColor(QPalette::Highlight, c.accent);
  p.setColor(QPalette::HighlightedText, c.panel);
  p.setColor(QPalette::Link, c.accent);
  p.setColor(QPalette::LinkVisited, c.accent);
  p.setColor(QPalette::ToolTipBase, c.panel);
  p.setColor(QPalette::ToolTipText, c.ink1);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, c.ink3);
  p.setColor(QPalette::Disabled, QPalette::Highlight, c.sunken);
  p.setColor(QPalette::Disabled, QPalette::HighlightedText, c.ink3);
  return p;
}

}  // namespace

void apply_theme(QApplication& application, ThemeKind kind) {
  set_colors(kind);
  QApplication::setStyle(new ControlStyle);
  const QPalette palette = palette_of(theme_colors(kind));
  // Tool tips of Fusion read the application's palette; a style sheet would switch off the style's own drawing.
  QApplication::setPalette(palette);
  // What is chosen in a list is a row that is tinted, in tables and menus of choices alike.
  QPalette lists = palette;
  lists.setColor(QPalette::Highlight, colors().selected_row);
  lists.setColor(QPalette::HighlightedText, colors().ink1);
  QApplication::setPalette(lists, "QAbstractItemView");
  QApplication::setFont(text_font(TextRole::body));
  application.setProperty("handsight_theme", kind == ThemeKind::dark ? "dark" : "light");
}

}  // namespace handsight::widgets
