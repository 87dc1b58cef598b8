// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/touch_form.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "convert/touch_table.h"
#include "session/fixtures/list.h"
#include "widgets/base/picture_choice.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"
#include "workbench/heading.h"

namespace handsight::app {
namespace {

/// What a name lets one think of; the first kind where it does not.
int likely_kind(const QString& name) {
  const auto kinds = fixture_kinds();
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const char* word : kinds[k]->perhaps)
      if (name.contains(QLatin1String(word), Qt::CaseInsensitive)) return static_cast<int>(k);
  return 0;
}

const FixtureKind& kind_at(int row) { return *fixture_kinds()[static_cast<std::size_t>(std::max(0, row))]; }

/// What has to be said of such a fixture, or may be.
QString hint_of(int kind) {
  return kind_at(kind).frame_through ? QObject::tr("nothing need be known of it") : QString(kind_at(kind).example);
}

std::vector<widgets::PictureOption> list_pictures() {
  std::vector<widgets::PictureOption> pictures;
  for (const FixtureKind* kind : fixture_kinds())
    pictures.push_back({kind->picture, translated(kind->title()), translated(kind->what())});
  return pictures;
}

}  // namespace

QStringList fixtures_in(const std::filesystem::path& file, const Robot& robot) {
  QStringList names;
  std::error_code error;
  const std::string ending = file.extension().string();
  const bool is_text = ending == ".csv" || ending == ".txt" || ending == ".tsv";
  if (!is_text || !std::filesystem::is_regular_file(file, error)) return names;
  try {
    auto table = parse_touch_table(read_file(file), file.filename().string(), &robot, {});
    if (!table || !names_fixtures(*table)) return names;
    std::vector<Message> notes;
    constexpr bool in_degrees = true;  // the names do not depend on it
    for (const TouchRow& row : read_touch_table(std::move(*table), robot, {}, in_degrees, notes).rows)
      if (const QString name = QString::fromStdString(row.fixture); !names.contains(name)) names << name;
  } catch (const InputError&) {
    return {};  // what is wrong in it is said where it is read
  }
  return names;
}

TouchForm::TouchForm(QWidget* parent) : QWidget(parent) {
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(6);
  auto* rows = new QFormLayout;
  rows->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  sigma_ = new QDoubleSpinBox(this);
  sigma_->setObjectName("touch_sigma");
  sigma_->setRange(0, 10000);
  sigma_->setDecimals(1);
  sigma_->setSuffix(QString::fromUtf8(" µm"));
  sigma_->setSpecialValueText(tr("not known: estimated"));
  sigma_->setMinimumHeight(widgets::control_height);
  apart_ = new QLineEdit(this);
  apart_->setObjectName("touch_apart");
  apart_->setPlaceholderText(QStringLiteral("socket_1 socket_2 by=0.05 sigma=1e-5"));
  apart_->setMinimumHeight(widgets::control_height);
  rows->addRow(tr("How exactly a touch tells (sigma)"), sigma_);
  rows->addRow(tr("Known distances, m; a semicolon between them"), apart_);
  column_->addLayout(rows);
}

TouchForm::Row TouchForm::add_row(const QString& name) {
  Row row;
  row.page = new QWidget(this);
  auto* column = new QVBoxLayout(row.page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  row.kind = new widgets::PictureChoice("fixture_" + name, list_pictures(), static_cast<int>(fixture_kinds().size()));
  row.known = new QLineEdit;
  row.known->setObjectName("known_of_" + name);
  row.known->setAccessibleName(tr("What is known of %1").arg(name));
  row.known->setMinimumHeight(widgets::control_height);
  const auto ask = [known = row.known](int kind) { known->setPlaceholderText(hint_of(kind)); };
  connect(row.kind, &widgets::PictureChoice::chosen, this, ask);
  row.kind->choose(likely_kind(name));
  ask(likely_kind(name));
  column->addWidget(heading(tr("What is %1?").arg(name), row.page));
  column->addWidget(row.kind);
  column->addWidget(row.known);
  return row;
}

void TouchForm::ask(const QStringList& fixtures) {
  std::vector<Row> rows;
  for (const QString& name : fixtures) {
    const auto before = names_.indexOf(name);
    rows.push_back(before < 0 ? add_row(name) : rows_[static_cast<std::size_t>(before)]);
  }
  for (const Row& row : rows_) {
    column_->removeWidget(row.page);
    const bool stays = std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.page == row.page; });
    if (!stays) row.page->deleteLater();
  }
  rows_ = std::move(rows);
  names_ = fixtures;
  for (std::size_t i = 0; i < rows_.size(); ++i) column_->insertWidget(static_cast<int>(i), rows_[i].page);
}

std::vector<std::string> TouchForm::described() const {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    list.push_back((QLatin1String(kind_at(rows_[i].kind->current()).tag) + ' ' + names_[static_cast<qsizetype>(i)] +
                    ' ' + rows_[i].known->text())
                       .trimmed()
                       .toStdString());
  return list;
}

std::vector<std::string> TouchForm::apart() const {
  std::vector<std::string> list;
  for (const QString& one : apart_->text().split(';', Qt::SkipEmptyParts))
    if (!one.trimmed().isEmpty()) list.push_back(one.trimmed().toStdString());
  return list;
}

std::optional<double> TouchForm::sigma() const {
  return sigma_->value() > 0 ? std::optional(1e-6 * sigma_->value()) : std::nullopt;
}

}  // namespace handsight::app
