// SPDX-License-Identifier: Apache-2.0
#include "outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path>& inputs() {
  static std::vector<fs::path> all;
  return all;
}

/// Does it begin like a session, a robot or another file that people write or that cannot be made again?
bool is_source(const fs::path& file) {
  std::string head(16384, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  std::string_view rest = head;
  while (true) {  // to the outermost element
    rest.remove_prefix(std::min(rest.find('<'), rest.size()));
    const std::string_view end = rest.starts_with("<!--") ? "-->" : rest.starts_with("<?") ? "?>" : "";
    if (end.empty()) break;
    rest.remove_prefix(std::min(rest.find(end), rest.size() - 1) + 1);
  }
  const std::string_view tag = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
  return tag == "<handsight_session" || tag == "<handsight_truth" || tag == "<handsight_effects" || tag == "<robot";
}

}  // namespace

void note_input(const fs::path& file) {
  if (!file.empty()) inputs().push_back(file);
}

void note_inputs(const Session& session) {
  for (const fs::path& file : list_files(session)) note_input(file);
}

void require_output(const std::string& file, const char* option) {
  std::error_code error;
  if (file.empty() || file == "-" || !fs::exists(file, error)) return;
  if (fs::is_directory(file, error))
    throw InputError(message("{} {}: is a folder; name a file in it.", option, shown_path(file)));
  if (!fs::is_regular_file(file, error))
    throw InputError(
        message("{} {}: is a device or a pipe and is not written over; name a file, or - for standard "
                "output.",
                option, shown_path(file)));
  const bool is_input = std::any_of(inputs().begin(), inputs().end(),
                                    [&](const fs::path& input) { return fs::equivalent(input, file, error); });
  if (is_input || is_source(file))
    throw InputError(message("{} {}: {} and is not written over; name another file.", option, shown_path(file),
                             is_input ? "is what this command reads" : "holds a session, a robot or their like"));
}

void write_output(const std::string& file, std::string_view content, const char* option) {
  require_output(file, option);
  replace_file(file, content);
}

}  // namespace handsight::cli
