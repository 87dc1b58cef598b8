// SPDX-License-Identifier: Apache-2.0
#include "convert/sample_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/file_kind.h"
#include "readers/texts/plain_text.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t fewest_samples = 5;  // folders
constexpr std::size_t most_of_sample = 8;  // images: one of each camera

/// Of one sample, by name.
struct SampleFiles {
  std::vector<std::string> images, others;
};

bool has_digit(const std::string& text) { return text.find_first_of("0123456789") != std::string::npos; }

SampleFiles sample_in(const fs::path& folder) {
  SampleFiles sample;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::string name = entry.path().filename().string();
    (is_image_name(entry.path()) ? sample.images : sample.others).push_back(name);
  }
  std::sort(sample.images.begin(), sample.images.end());
  std::sort(sample.others.begin(), sample.others.end());
  return sample;
}

std::vector<fs::path> numbered_folders(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error) && has_digit(entry.path().filename().string())) all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

/// Folders of cameras have numbers in their images' names.
bool may_be_a_sample(const SampleFiles& s) {
  return !s.images.empty() && s.images.size() <= most_of_sample &&
         std::all_of(s.images.begin(), s.images.end(),
                     [](const std::string& name) { return name.find_first_not_of("0123456789") < name.find('.'); });
}

/// `sample` is one of `folder`; a folder is made for each camera, and one table of the rows of all samples.
std::string commands(const fs::path& folder, const fs::path& sample, const SampleFiles& files) {
  const std::string from = shortened(shown_path(folder), 80);
  std::string made, copied, tables;
  for (const std::string& name : files.images) {
    const fs::path image = name;
    made += " " + image.stem().string();
    copied += fmt::format(" cp {0}/$d/{1} {2}/$d{3};", from, name, image.stem().string(), image.extension().string());
  }
  for (const std::string& name : files.others) {
    const std::string text = read_text(sample / name);
    const bool has_header = text.find('\n') < text.find_last_not_of("\r\n");
    tables += fmt::format("; ({}for d in $(ls -v {}); do tail -n 1 {}/$d/{}; done) > {}",
                          has_header ? fmt::format("head -n 1 {}/{}; ", shortened(shown_path(sample), 80), name) : "",
                          from, from, name, name);
  }
  return fmt::format("mkdir{}; for d in $(ls -v {}); do{} done{}", made, from, copied, tables);
}

}  // namespace

void refuse_sample_folders(const fs::path& folder) {
  const std::vector<fs::path> all = numbered_folders(folder);
  if (all.size() < fewest_samples) return;
  const SampleFiles first = sample_in(all.front());
  const bool are_samples = may_be_a_sample(first) && std::all_of(all.begin(), all.end(), [&](const fs::path& one) {
                             return sample_in(one).images == first.images;
                           });
  if (!are_samples) return;
  throw InputError(message(
      "{}: holds a folder for each sample ({}); what is read is a folder of images for each camera and one table "
      "with a line for each sample: `{}`",
      shown_path(folder), shown_path(all.front().filename()), commands(folder, all.front(), first)));
}

}  // namespace handsight
