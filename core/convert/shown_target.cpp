// SPDX-License-Identifier: Apache-2.0
#include "convert/shown_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "print/target_xml.h"
#include "targets/target_guess.h"
#include "vision/image/image_file.h"

namespace handsight {
namespace {

constexpr std::size_t most_images = 4;

/// Spread over all instants, of the first camera that has one.
std::vector<Image> some_images(const std::vector<InstantImages>& instants) {
  std::vector<Image> images;
  const std::size_t step = std::max<std::size_t>(1, instants.size() / most_images);
  for (std::size_t i = 0; i < instants.size() && images.size() < most_images; i += step) {
    const auto& files = instants[i].files;
    const auto file = std::find_if(files.begin(), files.end(), [](const auto& f) { return !f.empty(); });
    if (file == files.end()) continue;
    try {
      images.push_back(read_image(*file));
    } catch (const InputError&) {  // another one will do
    }
  }
  return images;
}

/// "charuco columns=8 rows=6 square=?mm marker=?mm dictionary=DICT_5X5_100", as --target takes it once the lengths are
/// put in.
std::string words_without_lengths(const Target& target) {
  constexpr std::array lengths{"square", "marker", "separation", "tag", "size"};
  std::string text;
  for (const auto& [name, value] : target_words(target)) {
    const bool is_length = std::find(lengths.begin(), lengths.end(), name) != lengths.end();
    std::string word = is_length ? "?mm" : value;
    std::replace(word.begin(), word.end(), ' ', ',');
    text += name == "kind" ? word : fmt::format(" {}={}", name, word);
  }
  return text;
}

}  // namespace

Message shown_target_text(const std::vector<InstantImages>& instants) {
  const std::vector<Image> images = some_images(instants);
  const auto shown = shown_target(images);
  if (!shown) return {};
  const Message sizes =
      shown->kind == TargetKind::charuco ? message("; a marker is {:.2f} of a square", shown->tag / shown->square)
      : is_tag_grid(*shown) ? message("; the separation is {:.2f} of a marker", shown->separation / shown->tag)
                            : Message();
  return message("The images show one: say what with --target \"{}\", the measured lengths in place of ?{}.",
                 words_without_lengths(*shown), sizes);
}

}  // namespace handsight
