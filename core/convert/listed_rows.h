// SPDX-License-Identifier: Apache-2.0
// Measurements as programs print them, a message or a list each, as a table. Internal to convert.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "readers/table.h"

namespace handsight {

/// Maps of YAML or JSON: `ros2 topic echo` of joint states and of poses (of a PoseArray where each has one), JSON a
/// line, lists of maps (also within a map of their own). A row each; lists of joint angles have the robot's `joints` as
/// names. Nothing where the text is none of these. InputError where it is no YAML.
std::optional<Table> parse_listed_rows(const std::string& text, const std::string& file,
                                       const std::vector<std::string>& joints);

/// Are there several documents, as `ros2 topic echo` parts messages?
bool has_several_documents(const std::string& text);

/// What tf2_echo prints, lists in brackets a line, arrays as NumPy prints them. Nothing where the text is none of
/// these.
std::optional<Table> parse_printed_rows(const std::string& text, const std::string& file);

/// Text with separators and without a header, its columns named by `columns` ("joint_1[deg]"; "-": left_out_N).
std::optional<Table> parse_headed_table(const std::string& text, const std::string& file,
                                        const std::vector<std::string>& joints,
                                        const std::vector<std::string>& columns);

/// The table that a text is, in whatever form: one of these, or of text with separators (parse_recorded_table).
/// `columns` name those of a table that has no header and as many ("-": left out).
std::optional<Table> parse_measured_table(const std::string& text, const std::string& file,
                                          const std::vector<std::string>& joints,
                                          const std::vector<std::string>& columns = {});

}  // namespace handsight
