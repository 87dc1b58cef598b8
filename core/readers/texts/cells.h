// SPDX-License-Identifier: Apache-2.0
// What stands in the cells of a table as people and programs write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

using TextCells = std::vector<std::string>;

/// The cells between separators (' ': any white space), without white space about them; a separator within double
/// quotes is none. Views into `line`; the last is empty where the line ends with a separator.
std::vector<std::string_view> cell_views(std::string_view line, char separator);

/// Without the quotes about it, double or single.
std::string_view unquoted(std::string_view cell);

/// The same cells as texts of their own, without quotes about them.
TextCells split_cells(std::string_view line, char separator);

/// ';', tab or ',' whichever comes first in this order outside of quotes; else ' '.
char cell_separator(std::string_view line);

/// The number of a cell; NaN where it says that there is none (empty, "nan", "null", "-", "inf" ...). A date with its
/// time of day, or a time of day alone, is seconds. Nothing where it is a word.
std::optional<double> cell_number(const std::string& cell, bool decimal_commas);

/// Seconds since 1970 (UTC where it says nothing else) of "2024-07-23T16:02:40.5Z" or "23.07.2024 16:02:40", or since
/// midnight of "16:02:40.5"; nothing where it is none of these.
std::optional<double> clock_seconds(std::string_view cell);

/// Does the name end as those of images do?
bool is_image_file_name(const std::string& cell);

/// "deg" for all that people write for degrees, "in" for inches, and so on.
std::string plain_unit(const std::string& unit);

/// m of one of this unit (of plain_unit); nothing where it is none of a length.
std::optional<double> metres_of_unit(const std::string& unit);

}  // namespace handsight
