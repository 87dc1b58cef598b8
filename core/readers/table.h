// SPDX-License-Identifier: Apache-2.0
// A table of numbers as people and programs write them: CSV with commas, semicolons, tabs or spaces.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace handsight {

struct TableColumn {
  std::string name;  // as written, without its unit; empty where there is no header
  std::string unit;  // of "shoulder [deg]", "x(mm)", "q1_deg"; lower case; empty where none is named
  std::vector<std::string> words =
      {};  // one a row, of a column of words (of images, fixtures, states); empty: of numbers
};

struct Table {
  std::string file;  // as sentences call it
  std::vector<TableColumn> columns;
  std::vector<std::vector<double>> rows;  // NaN: an empty cell, or "nan", or a word
  std::vector<int> lines;                 // of the rows
  std::vector<std::string> row_words;     // what stood before the numbers of each, without a header; empty: nothing
  bool has_header = false;
  std::vector<Message> notes;  // decimal commas, what else was understood; a sentence each

  std::size_t width() const { return columns.size(); }
};

/// InputError with the line where a cell is no number (names of images may be, in a column of theirs), or rows differ
/// in length. Nothing where the text is no table at all: no row of two numbers or more. A first line of these names is
/// a header, even where they are numbers ("1", "2": servos are often called so).
std::optional<Table> parse_table(std::string_view text, const std::string& file,
                                 const std::vector<std::string>& names = {});

/// The column of that name, upper or lower case; nothing where there is none. InputError where there are two.
std::optional<std::size_t> find_column(const Table& table, const std::string& name);

/// The first of these that is there.
std::optional<std::size_t> find_column(const Table& table, std::initializer_list<const char*> names);

/// Has the column names of images: by what it is called, or by what stands in it?
bool tells_images(const TableColumn& column);

/// m of one of the column's unit; nothing where it names none of a length.
std::optional<double> unit_of_lengths(const Table& table, std::size_t column);

/// The column's times in s, by its unit or size (ms, us, ns), begin at their own zero where they are epochs; empty
/// where the table has none. A sentence in `notes` where the unit was guessed.
std::vector<double> list_times(const Table& table, std::vector<Message>& notes);

/// Sorts rows by time where they are not; says so. Rows of the same time are refused with a sentence.
void sort_by_time(Table& table, std::vector<double>& times, std::vector<Message>& notes);

/// InputError where a cell of these columns is empty.
void require_full(const Table& table, const std::vector<std::size_t>& columns);

}  // namespace handsight
