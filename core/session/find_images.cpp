// SPDX-License-Identifier: Apache-2.0
#include "session/find_images.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/image_names.h"
#include "base/letters.h"
#include "base/text.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// An image's file and its name in small letters, without its ending.
struct NamedFile {
  fs::path file;
  std::string stem;
};

struct Listing {
  fs::path folder;
  std::error_code error;
  std::vector<NamedFile> images;
};

bool is_image_ending(const std::string& ending) {
  const auto endings = {".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

Listing images_in(const fs::path& folder) {
  Listing listing{folder, {}, {}};
  for (const auto& entry : fs::directory_iterator(folder, listing.error)) {
    std::string name = lower_case(entry.path().filename().string());
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || name[0] == '.' || !is_image_ending(name.substr(dot))) continue;
    std::error_code is_gone;
    if (!entry.is_regular_file(is_gone)) continue;
    name.resize(dot);
    listing.images.push_back({entry.path(), std::move(name)});
  }
  return listing;
}

/// The date and time in a name, else its last number; nothing without one.
std::optional<std::int64_t> number_of(const std::string& stem) {
  if (const auto moment = moment_in_name(stem)) return moment->number;
  std::size_t end = stem.size();
  while (end > 0 && !is_digit(stem[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_digit(stem[begin - 1]) && end - begin < 19) --begin;  // ns since 1970 have 19
  if (end - begin == 19 && stem[begin] > '8') ++begin;
  if (begin == end) return std::nullopt;
  return std::stoll(stem.substr(begin, end - begin));
}

enum class Side { left, right, unknown };

Side side_of(const std::string& lower_stem) {
  if (lower_stem.find("left") != std::string::npos) return Side::left;
  if (lower_stem.find("right") != std::string::npos) return Side::right;
  std::string letters;
  for (const char c : lower_stem)
    if (std::isalpha(static_cast<unsigned char>(c))) letters += c;
  if (!letters.empty() && letters.back() == 'l') return Side::left;
  if (!letters.empty() && letters.back() == 'r') return Side::right;
  return Side::unknown;
}

using Images = std::map<std::int64_t, fs::path>;
/// In what of a file's name (small letters, without its ending) the number is looked for; nothing: it is another
/// camera's image.
using Naming = std::function<std::optional<std::string>(const std::string& stem)>;

/// Who looks again and again: knows some of the files, and wants to be told.
struct Listener {
  std::function<bool(const fs::path& file)> is_old;
  std::vector<Message>& refusals;
};

/// Where somebody listens it is reported, else thrown.
void refuse_images(const Message& sentence, const Listener* listener) {
  if (!listener) throw InputError(sentence);
  auto& reported = listener->refusals;
  if (std::find(reported.begin(), reported.end(), sentence) == reported.end()) reported.push_back(sentence);
}

/// `whose`: "left ", or "" where the folder is one camera's own.
Images images_by_number(const Listing& listing, const Naming& naming, const std::string& whose,
                        const Listener* listener) {
  Images found;
  std::set<std::int64_t> twice;
  for (const NamedFile& image : listing.images) {
    const auto name = naming(image.stem);
    const auto number = name ? number_of(*name) : std::nullopt;
    if (!number) continue;
    const auto [place, is_new] = found.emplace(*number, image.file);
    if (is_new || (listener && listener->is_old(image.file))) continue;
    if (listener && listener->is_old(place->second))
      place->second = image.file;
    else if (twice.insert(*number).second)
      refuse_images(message("{}: {} and {} have the same number; one image an instant and side is wanted.",
                            shown_path(listing.folder), in_quotes(place->second.filename().string()),
                            in_quotes(image.file.filename().string())),
                    listener);
  }
  if (listing.error)
    refuse_images(
        message("{}: the folder cannot be read ({}).", shown_path(listing.folder), system_text(listing.error)),
        listener);
  else if (found.empty())
    refuse_images(message("{}: has no {}images with a number in their names (PNG, JPEG, PGM, BMP or TIFF).",
                          shown_path(listing.folder), whose),
                  listener);
  for (const std::int64_t number : twice) found.erase(number);
  return found;
}

std::optional<std::string> any_name(const std::string& stem) { return stem; }

Naming naming_of(Side side) {
  return [side](const std::string& stem) { return side_of(stem) == side ? std::optional(stem) : std::nullopt; };
}

std::vector<InstantImages> by_instant(const std::vector<Images>& by_camera) {
  std::map<std::int64_t, InstantImages> instants;
  for (std::size_t c = 0; c < by_camera.size(); ++c)
    for (const auto& [number, file] : by_camera[c]) {
      InstantImages& instant = instants[number];
      instant.number = number;
      instant.files.resize(by_camera.size());
      instant.files[c] = file;
    }
  std::vector<InstantImages> list;
  for (auto& [number, instant] : instants) list.push_back(std::move(instant));
  return list;
}

bool is_same_folder(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || fs::equivalent(a, b, error);
}

/// Where a camera's name begins in that of a file. One of digits alone is no part of a longer number.
std::size_t find_name(const std::string& stem, const std::string& camera) {
  const bool is_number = std::all_of(camera.begin(), camera.end(), is_digit);
  for (std::size_t at = stem.find(camera); at != std::string::npos; at = stem.find(camera, at + 1)) {
    const std::size_t end = at + camera.size();
    if (!is_number || !((at > 0 && is_digit(stem[at - 1])) || (end < stem.size() && is_digit(stem[end])))) return at;
  }
  return std::string::npos;
}

/// The camera that a file's name names, among those that share its folder.
std::optional<std::size_t> camera_named(const std::string& stem, const std::vector<std::string>& cameras,
                                        const std::vector<std::size_t>& sharing) {
  if (sharing.size() == 1) return sharing[0];
  std::optional<std::size_t> found;
  bool is_clear = true;
  for (const std::size_t c : sharing) {
    if (find_name(stem, cameras[c]) == std::string::npos) continue;
    if (!found || cameras[c].find(cameras[*found]) != std::string::npos)
      found = c;
    else
      is_clear = is_clear && cameras[*found].find(cameras[c]) != std::string::npos;
  }
  if (found && is_clear) return found;
  const Side side = side_of(stem);
  if (cameras.size() != 2 || side == Side::unknown) return std::nullopt;
  return side == Side::left ? 0 : 1;
}

/// The name with that of its camera left out; nothing where it is another camera's.
std::optional<std::string> name_for(std::size_t camera, const std::string& stem,
                                    const std::vector<std::string>& cameras, const std::vector<std::size_t>& sharing) {
  if (camera_named(stem, cameras, sharing) != camera) return std::nullopt;
  const std::size_t at = find_name(stem, cameras[camera]);
  if (at == std::string::npos) return stem;
  return stem.substr(0, at) + ' ' + stem.substr(at + cameras[camera].size());
}

}  // namespace

std::vector<ImageFiles> find_image_pairs(const fs::path& left_folder, const fs::path& right_folder) {
  const bool is_same = is_same_folder(left_folder, right_folder);
  const auto images = [&](const fs::path& folder, Side side, const char* whose) {
    return is_same ? images_by_number(images_in(folder), naming_of(side), whose, nullptr)
                   : images_by_number(images_in(folder), any_name, "", nullptr);
  };
  const Images left = images(left_folder, Side::left, "left "), right = images(right_folder, Side::right, "right ");
  std::vector<ImageFiles> pairs;
  for (const InstantImages& i : by_instant({left, right})) pairs.push_back({i.number, i.files[0], i.files[1]});
  return pairs;
}

std::vector<InstantImages> list_instants(const std::vector<ImageFiles>& pairs) {
  std::vector<InstantImages> list;
  for (const ImageFiles& pair : pairs) list.push_back({pair.number, {pair.left, pair.right}});
  return list;
}

std::vector<InstantImages> find_images(const std::vector<fs::path>& folders) {
  if (folders.size() == 2) return list_instants(find_image_pairs(folders[0], folders[1]));
  std::vector<Images> by_camera;
  for (const fs::path& folder : folders)
    by_camera.push_back(images_by_number(images_in(folder), any_name, "", nullptr));
  return by_instant(by_camera);
}

std::vector<InstantImages> find_camera_folders(const std::vector<std::string>& cameras,
                                               const std::vector<fs::path>& folders, const IsOldImage& is_old,
                                               std::vector<Message>& refusals) {
  std::vector<std::string> names;
  for (const std::string& camera : cameras) names.push_back(lower_case(camera));
  std::map<std::size_t, Listing> listings;  // by the first camera whose folder it is
  std::vector<Images> by_camera;
  for (std::size_t c = 0; c < folders.size(); ++c) {
    std::vector<std::size_t> sharing;
    for (std::size_t other = 0; other < folders.size(); ++other)
      if (is_same_folder(folders[other], folders[c])) sharing.push_back(other);
    if (sharing[0] == c) listings.emplace(c, images_in(folders[c]));
    const auto naming = [&](const std::string& stem) { return name_for(c, stem, names, sharing); };
    const Listener listener{[&is_old, c](const fs::path& file) { return is_old(c, file); }, refusals};
    by_camera.push_back(images_by_number(listings.at(sharing[0]), naming,
                                         sharing.size() > 1 ? cameras[c] + " " : std::string(), &listener));
  }
  return by_instant(by_camera);
}

}  // namespace handsight
