// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame/key_list.h"

#include <QKeyEvent>
#include <QPainter>

#include "widgets/theme.h"

namespace handsight::app {
namespace {

struct KeyRow {
  const char* keys;
  const char* what;  // empty: a heading
};

constexpr KeyRow rows[] = {
    {"Everywhere", ""},
    {"Ctrl+1 … Ctrl+5", "Label, Calibrate, Inspect, Explain, Export"},
    {"←  →", "previous and next observation"},
    {"Ctrl+Z, Ctrl+Shift+Z", "undo, do again"},
    {"Esc, Alt+←", "selection one up, the selection before"},
    {"M", "fold the model panel"},
    {"U", "sizes in px, in mm at the hand, in σ (residual over noise)"},
    {"Ctrl+K", "find an action, observation, joint, effect or key"},
    {"Shift+Space", "one panel fills the centre (double click on its title), Esc puts it back"},
    {"Ctrl+S, Ctrl+O, Ctrl+N", "save, open, new session"},
    {"F5", "fit again what was stopped"},
    {"Label", ""},
    {"Click, Alt+click", "marker on the nearest corner, exactly there"},
    {"Arrows, Shift+arrows", "nudge the chosen marker by 0.1 px, 1 px"},
    {"0 … 9, Delete", "renumber, remove the chosen marker"},
    {"Enter", "use the labels"},
    {"Calibrate", ""},
    {"Space, .", "play or pause, one observation"},
    {"Inspect", ""},
    {"Delete, Insert", "exclude, include the chosen observations"},
    {"0 … 9, Delete on a marker", "renumber, remove it"},
    {"Explain", ""},
    {"Tab, Enter", "look at a card, add it"},
    {"N, B held down", "noise alone, before and after"},
    {"Shift+drag", "choose observations in a plot"},
    {"3D view", ""},
    {"F, 1 … 6, 0", "show everything, standard views, the cameras' view"},
};

}  // namespace

KeyList::KeyList(QWidget* window) : QWidget(window) {
  setObjectName("key_list");
  setAttribute(Qt::WA_DeleteOnClose);
  setGeometry(window->rect());
  setFocusPolicy(Qt::StrongFocus);
}

std::vector<std::pair<QString, QString>> KeyList::keys() {
  std::vector<std::pair<QString, QString>> all;
  for (const KeyRow& row : rows)
    if (row.what[0] != '\0') all.emplace_back(tr(row.keys), tr(row.what));
  return all;
}

void KeyList::show_over(QWidget* window) {
  if (window->findChild<KeyList*>()) return;
  auto* list = new KeyList(window);
  list->show();
  list->raise();
  list->setFocus();
}

void KeyList::paintEvent(QPaintEvent*) {
  using widgets::TextRole;
  const auto& c = widgets::colors();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QColor veil = c.window;
  veil.setAlpha(200);
  p.fillRect(rect(), veil);
  constexpr int row_height = 26;
  const int count = static_cast<int>(std::size(rows));
  const QRect sheet(width() / 2 - 330, std::max(8, height() / 2 - (count * row_height + 48) / 2), 660,
                    count * row_height + 48);
  p.setPen(c.hairline);
  p.setBrush(c.panel);
  p.drawRoundedRect(sheet, 6, 6);
  int y = sheet.top() + 24;
  for (const KeyRow& row : rows) {
    const bool heading = row.what[0] == '\0';
    p.setFont(widgets::text_font(heading ? TextRole::title : TextRole::body));
    p.setPen(c.ink1);
    p.drawText(QRect(sheet.left() + 32, y, 220, row_height), Qt::AlignVCenter, tr(row.keys));
    p.setPen(c.ink2);
    if (!heading) p.drawText(QRect(sheet.left() + 252, y, 380, row_height), Qt::AlignVCenter, tr(row.what));
    y += row_height;
  }
}

void KeyList::mousePressEvent(QMouseEvent*) { close(); }
void KeyList::keyPressEvent(QKeyEvent*) { close(); }

}  // namespace handsight::app
