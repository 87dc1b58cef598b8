// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of several sessions: what has changed between which, and the two whose plots are shown.
#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <algorithm>

#include "compare/compare_cells.h"
#include "compare/compare_page.h"
#include "compare/compare_texts.h"
#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
void ComparePage::show_several(std::shared_ptr<const ComparedSeveral> several) {
  is_running_ = false;
  several_ = std::move(several);
  const SeveralComparison& c = several_->comparison;
  const bool is_same = c.verdict == ComparisonVerdict::unchanged;
  verdict_ = is_same ? Verdict::same : Verdict::changed;
  said_->setText((is_same ? QString::fromUtf8("✓  ") : QString::fromUtf8("▲  ")) + translated(c.sentence));
  QStringList more = hand_sentences(c);
  for (const Message& note : c.notes) more << translated(note);
  more << several_->notes;
  more_->setText(more.join(' '));
  for (QComboBox* box : shown_sides_) {
    box->clear();
    for (const ComparedSide& side : several_->sides) box->addItem(side.name);
  }
  const int last = static_cast<int>(several_->sides.size()) - 1;
  const ChangeCandidate* first = c.changes.empty() ? nullptr : &c.changes.front().reported;
  const int before = first ? several_->side(first->before.back()) : 0,
            after = first ? several_->side(first->after.front()) : last;
  show_sides(std::max(before, 0), after < 0 ? last : after);
}

/// Their plots; what is said of all stays.
void ComparePage::show_sides(int before, int after) {
  auto pair = std::make_shared<ComparedPair>();
  pair->before = several_->sides[static_cast<std::size_t>(before)];
  pair->after = several_->sides[static_cast<std::size_t>(after)];
  if (pair->before.version->fit) pair->tcp_from_body = pair->before.version->fit->tcp_from_body;
  pair_ = std::move(pair);
  shown_sides_[0]->setCurrentIndex(before);
  shown_sides_[1]->setCurrentIndex(after);
  refresh();
}

void ComparePage::refresh_several_lists() {
  const SeveralComparison& c = several_->comparison;
  changes_title_->setText(c.changes.empty() ? tr("What is shared") : tr("What has changed, and what is shared"));
  changes_title_->setToolTip(
      tr("How likely it is; a click on a change shows the plots of two sessions that it lies "
         "between"));
  changes_->setHorizontalHeaderItem(1, head_cell(tr("likely")));
  const std::vector<SeveralLine> lines = several_lines(c);
  changes_->setRowCount(static_cast<int>(lines.size()));
  sides_of_rows_.clear();
  for (int r = 0; r < changes_->rowCount(); ++r) {
    const SeveralLine& line = lines[static_cast<std::size_t>(r)];
    QTableWidgetItem* name = cell(line.name, false, line.is_change);
    name->setToolTip(line.name);
    changes_->setItem(r, 0, name);
    changes_->setItem(r, 1, cell(line.likely, true, line.is_change));
    sides_of_rows_.push_back(
        {line.before.empty() ? -1 : several_->side(line.before), line.after.empty() ? -1 : several_->side(line.after)});
  }
  const std::vector<NumberLine> numbers = number_lines(c);
  numbers_title_->setText(tr("By how much"));
  numbers_title_->setVisible(!numbers.empty());
  numbers_->setVisible(!numbers.empty());
  numbers_->setRowCount(static_cast<int>(numbers.size()));
  for (int r = 0; r < numbers_->rowCount(); ++r) {
    const NumberLine& line = numbers[static_cast<std::size_t>(r)];
    const QString cells[] = {line.name, line.change, line.unit, widgets::fixed_text(line.sigmas, 1)};
    for (int column = 0; column < 4; ++column)
      numbers_->setItem(r, column, cell(cells[column], column == 1 || column == 3, false));
  }
}

}  // namespace handsight::app
