// SPDX-License-Identifier: GPL-3.0-or-later
#include "wizard/target_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "print/circle_grid.h"
#include "print/dictionary.h"
#include "print/target_xml.h"
#include "targets/sheet.h"
#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

QSpinBox* count_box(const char* name, int value) {
  auto* box = new QSpinBox;
  box->setObjectName(name);
  box->setRange(1, 64);
  box->setValue(value);
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

QDoubleSpinBox* length_box(const char* name, double value_mm) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(3);
  box->setRange(0.1, 5000);
  box->setValue(value_mm);
  box->setSuffix(" mm");
  box->setFocusPolicy(Qt::StrongFocus);
  return box;
}

std::string metres(const QDoubleSpinBox* millimetres) { return format_number(millimetres->value() / 1000); }

}  // namespace

TargetForm::TargetForm(QWidget* parent) : QWidget(parent) {
  rows_ = new QFormLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(4);
  columns_ = count_box("target_columns", 8);
  rows_count_ = count_box("target_rows", 11);
  numbers_hint_ = new QLabel(this);
  counts_ = new QWidget;
  auto* counts = new QHBoxLayout(counts_);
  counts->setContentsMargins(0, 0, 0, 0);
  counts->addWidget(columns_);
  counts->addWidget(new QLabel("×"));
  counts->addWidget(rows_count_);
  counts->addWidget(numbers_hint_, 1);
  square_ = length_box("target_square", 22);
  tag_ = length_box("target_tag", 16);
  spacing_ = new QDoubleSpinBox;
  spacing_->setObjectName("target_spacing");
  spacing_->setRange(0.01, 5);
  spacing_->setValue(0.3);
  spacing_->setFocusPolicy(Qt::StrongFocus);
  dictionary_ = new QComboBox;
  dictionary_->setObjectName("target_dictionary");
  dictionary_->setFocusPolicy(Qt::StrongFocus);
  for (const std::string& name : dictionary_names()) dictionary_->addItem(QString::fromStdString(name));
  layout_ = new QComboBox;
  layout_->setObjectName("target_layout");
  layout_->setFocusPolicy(Qt::StrongFocus);
  layout_->addItem(tr("in columns (symmetric)"), "symmetric");
  layout_->addItem(tr("every second row half a step aside (asymmetric)"), "asymmetric");
  ids_ = new QLineEdit("0 1 2");
  ids_->setObjectName("target_ids");
  said_ = new QLabel(this);
  said_->setObjectName("target_said");
  said_->setWordWrap(true);
  said_->setFont(widgets::text_font(widgets::TextRole::small));
  sheet_ = new QPushButton(tr("Save a sheet to print…"));
  sheet_->setObjectName("target_sheet");
  sheet_->setAutoDefault(false);
  rows_->addRow(tr("Size"), counts_);
  rows_->addRow(tr("Side of a square"), square_);
  rows_->addRow(tr("Side of a tag"), tag_);
  rows_->addRow(tr("Gap between tags / side"), spacing_);
  rows_->addRow(tr("Dictionary"), dictionary_);
  rows_->addRow(tr("Numbers of the tags"), ids_);
  rows_->addRow(tr("The circles stand"), layout_);
  rows_->addRow(said_);
  rows_->addRow(sheet_);
  rows_->setAlignment(sheet_, Qt::AlignLeft);
  for (QSpinBox* box : {columns_, rows_count_}) connect(box, &QSpinBox::valueChanged, this, &TargetForm::read);
  for (QDoubleSpinBox* box : {square_, tag_, spacing_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &TargetForm::read);
  for (QComboBox* box : {dictionary_, layout_}) connect(box, &QComboBox::currentIndexChanged, this, &TargetForm::read);
  connect(ids_, &QLineEdit::textChanged, this, &TargetForm::read);
  connect(sheet_, &QPushButton::clicked, this, &TargetForm::choose_sheet);
  ask(TargetKind::charuco, false);
}

void TargetForm::ask(TargetKind kind, bool printed) {
  kind_ = kind;
  is_printed_ = printed;
  are_circles_ = false;
  struct Usual {
    int columns, rows;
    double square, tag;
    const char* dictionary;
  };
  const Usual usual = kind == TargetKind::chessboard  ? Usual{9, 6, 25, 25, ""}
                      : kind == TargetKind::charuco   ? Usual{8, 11, 22, 16, "DICT_5X5_100"}
                      : kind == TargetKind::aprilgrid ? Usual{6, 6, 25, 25, "tag36h11"}
                                                      : Usual{1, 1, 25, 50, "tag36h11"};
  {
    const QSignalBlocker a(columns_), b(rows_count_), c(square_), d(tag_), e(dictionary_);
    columns_->setValue(usual.columns);
    rows_count_->setValue(usual.rows);
    square_->setValue(usual.square);
    tag_->setValue(usual.tag);
    dictionary_->setCurrentText(usual.dictionary);
  }
  numbers_hint_->setText(kind == TargetKind::chessboard  ? tr("inner corners")
                         : kind == TargetKind::aprilgrid ? tr("tags")
                                                         : tr("squares"));
  show_rows(printed);
  read();
}

void TargetForm::ask_circles() {
  kind_ = TargetKind::chessboard;
  is_printed_ = false;
  are_circles_ = true;
  {
    const QSignalBlocker a(columns_), b(rows_count_), c(square_), d(tag_), e(layout_);
    columns_->setValue(4);
    rows_count_->setValue(11);
    square_->setValue(20);
    tag_->setValue(15);
    layout_->setCurrentIndex(layout_->findData("asymmetric"));
  }
  numbers_hint_->setText(tr("circles"));
  show_rows(false);
  read();
}

void TargetForm::show_row(QWidget* field, bool visible) {
  field->setVisible(visible);
  if (QWidget* label = rows_->labelForField(field)) label->setVisible(visible);
}

void TargetForm::show_rows(bool printed) {
  const bool is_tags = kind_ == TargetKind::tags, is_chessboard = kind_ == TargetKind::chessboard && !are_circles_;
  const auto name = [&](QWidget* field, const QString& text) {
    if (auto* label = qobject_cast<QLabel*>(rows_->labelForField(field))) label->setText(text);
  };
  name(square_, are_circles_ ? tr("Distance of two circles") : tr("Side of a square"));
  name(tag_, are_circles_ ? tr("Diameter of a circle") : tr("Side of a tag"));
  square_->setToolTip(are_circles_
                          ? tr("OpenCV's unit: in an asymmetric grid from a row to the next one, half the step "
                               "along a row")
                          : QString());
  show_row(counts_, !printed && !is_tags);
  show_row(square_, !printed && (is_chessboard || are_circles_ || kind_ == TargetKind::charuco));
  show_row(tag_, !printed && !is_chessboard);
  show_row(spacing_, !printed && kind_ == TargetKind::aprilgrid);
  show_row(dictionary_, !printed && !is_chessboard && !are_circles_);
  show_row(ids_, !printed && is_tags);
  show_row(layout_, are_circles_);
}

TargetForm::Words TargetForm::circle_words() const {
  return {{"kind", std::string(circles_kind)},
          {"columns", std::to_string(columns_->value())},
          {"rows", std::to_string(rows_count_->value())},
          {"spacing", metres(square_)},
          {"diameter", metres(tag_)},
          {"layout", layout_->currentData().toString().toStdString()}};
}

TargetForm::Words TargetForm::words() const {
  Words words{{"kind", std::string(display_name(kind_))}};
  if (kind_ != TargetKind::tags) {
    words.emplace_back("columns", std::to_string(columns_->value()));
    words.emplace_back("rows", std::to_string(rows_count_->value()));
  }
  if (kind_ == TargetKind::chessboard || kind_ == TargetKind::charuco) words.emplace_back("square", metres(square_));
  if (kind_ == TargetKind::charuco) words.emplace_back("marker", metres(tag_));
  if (kind_ == TargetKind::aprilgrid) {
    words.emplace_back("tag", metres(tag_));
    words.emplace_back("spacing", format_number(spacing_->value()));
  }
  if (kind_ == TargetKind::tags) {
    words.emplace_back("size", metres(tag_));
    words.emplace_back("ids", ids_->text().replace(',', ' ').toStdString());
  }
  if (kind_ != TargetKind::chessboard) words.emplace_back("dictionary", dictionary_->currentText().toStdString());
  return words;
}

void TargetForm::read() {
  QString sentence;
  target_.reset();
  try {
    target_ = target_from_words(are_circles_ ? circle_words() : words(), "The target");
    sentence = translated(describe_target(*target_)) + ".";
    if (is_printed_) sentence += " " + tr("Print it at 100 %, check its ruler, and glue it to something flat.");
    if (looks_the_same_turned(*target_))
      sentence +=
          " " + (are_circles_ ? tr("It looks the same after half a turn: an asymmetric grid of an odd number of "
                                   "rows has two ends that can be told apart.")
                              : tr("It looks the same after half a turn: one column more or less tells its "
                                   "ends apart."));
  } catch (const InputError& error) {
    sentence = QString::fromUtf8("✗ ") + translated_error(error);
  }
  sheet_->setEnabled(target_.has_value());
  said_->setText(sentence);
  emit changed();
}

void TargetForm::choose_sheet() {
  auto* dialog = new QFileDialog(this, tr("Save a sheet to print"), "board.pdf", tr("PDF (*.pdf)"));
  dialog->setObjectName("sheet_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("pdf");
  connect(dialog, &QFileDialog::fileSelected, this, &TargetForm::save_sheet);
  dialog->open();
}

void TargetForm::save_sheet(const QString& file) {
  if (!target_) return;
  try {
    const Sheet sheet = make_sheet(*target_);
    replace_file(file.toStdString(), pdf_text(sheet));
    said_->setText(tr("Saved as %1: %2, %3 × %4 mm. Print it at 100 % and check its ruler.")
                       .arg(file, QString::fromStdString(sheet.paper))
                       .arg(1e3 * sheet.width, 0, 'f', 0)
                       .arg(1e3 * sheet.height, 0, 'f', 0));
  } catch (const InputError& error) {
    said_->setText(QString::fromUtf8("✗ ") + translated_error(error));
  }
}

}  // namespace handsight::app
