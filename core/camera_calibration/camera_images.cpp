// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/camera_images.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/image_names.h"
#include "base/letters.h"
#include "base/text.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_cameras = 8;

bool is_image(const fs::path& file) {
  const std::string ending = lower_case(file.extension().string());
  constexpr std::array<std::string_view, 9> endings{".png", ".jpg", ".jpeg", ".tif", ".tiff",
                                                    ".pgm", ".bmp", ".ppm",  ".webp"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

struct Listed {
  std::vector<fs::path> images;
  int others = 0;
};

void list_folder(const fs::path& folder, Listed& listed, std::vector<fs::path>& folders) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory(error))
      folders.push_back(entry.path());
    else if (is_image(entry.path()))
      listed.images.push_back(entry.path());
    else
      ++listed.others;
  }
  if (error) throw InputError(message("{}: the folder cannot be read: {}.", shown_path(folder), system_text(error)));
}

/// The name of a file without its ending; a date and time in it is one number.
std::string stem_of(const fs::path& file) {
  std::string stem = file.stem().string();
  if (const auto moment = moment_in_name(stem))
    stem.replace(moment->begin, moment->end - moment->begin, std::to_string(moment->number));
  return stem;
}

/// A name as text between runs of digits, and the runs.
struct Parts {
  std::vector<std::string> texts, numbers;
};

Parts list_parts(const std::string& stem) {
  Parts parts{{""}, {}};
  bool in_number = false;
  for (const char c : stem) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (is_digit && !in_number) parts.numbers.emplace_back();
    if (!is_digit && in_number) parts.texts.emplace_back();
    in_number = is_digit;
    (is_digit ? parts.numbers.back() : parts.texts.back()) += c;
  }
  if (in_number) parts.texts.emplace_back();
  return parts;
}

/// The index of the run of digits that takes most values; equal: the last. -1: no name has digits.
int moment_of(const std::vector<fs::path>& files) {
  std::map<std::size_t, std::set<std::string>> values;
  for (const fs::path& file : files) {
    const Parts parts = list_parts(stem_of(file));
    for (std::size_t i = 0; i < parts.numbers.size(); ++i) values[i].insert(parts.numbers[i]);
  }
  int best = -1;
  std::size_t most = 0;
  for (const auto& [i, set] : values)
    if (set.size() >= most) most = set.size(), best = static_cast<int>(i);
  return best;
}

std::string without_zeros(const std::string& digits) {
  const auto first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

/// Camera and moment of one file.
std::pair<std::string, std::string> locate(const fs::path& file, int moment) {
  const Parts parts = list_parts(stem_of(file));
  if (moment < 0 || static_cast<std::size_t>(moment) >= parts.numbers.size()) return {"camera", file.stem().string()};
  std::string rest;
  for (std::size_t i = 0; i < parts.texts.size(); ++i) {
    rest += parts.texts[i];
    if (i < parts.numbers.size() && static_cast<int>(i) != moment) rest += parts.numbers[i];
  }
  rest = trimmed(rest, "_-. ");
  return {rest.empty() ? "camera" : rest, without_zeros(parts.numbers[static_cast<std::size_t>(moment)])};
}

using ByCamera = std::map<std::string, std::map<std::string, fs::path>>;

void add(ByCamera& cameras, const std::string& camera, const std::string& moment, const fs::path& file) {
  const auto [at, is_new] = cameras[camera].emplace(moment, file);
  if (!is_new)
    throw InputError(
        message("{} and {}: both are moment {} of camera {} by their names; name files so that only the number "
                "of the moment changes, or give each camera a folder.",
                shown_path(at->second), shown_path(file), shortened(moment), shortened(camera)));
}

void add_folder(ByCamera& cameras, const std::string& name, const std::vector<fs::path>& files) {
  const int moment = moment_of(files);
  for (const fs::path& file : files) {
    const Parts parts = list_parts(stem_of(file));
    const bool has = moment >= 0 && static_cast<std::size_t>(moment) < parts.numbers.size();
    add(cameras, name, has ? without_zeros(parts.numbers[static_cast<std::size_t>(moment)]) : file.stem().string(),
        file);
  }
}

/// Numbers by size, then texts.
bool before(const std::string& a, const std::string& b) {
  const auto is_number = [](const std::string& s) {
    return !s.empty() && std::all_of(s.begin(), s.end(), [](unsigned char c) { return std::isdigit(c); });
  };
  if (is_number(a) && is_number(b)) return a.size() != b.size() ? a.size() < b.size() : a < b;
  return a < b;
}

bool camera_before(const std::string& a, const std::string& b) {
  const auto rank = [](const std::string& name) {
    return name.find("left") != std::string::npos ? 0 : name.find("right") != std::string::npos ? 2 : 1;
  };
  return rank(a) != rank(b) ? rank(a) < rank(b) : a < b;
}

std::optional<std::int64_t> time_of(const std::string& key) {
  if (key.size() < 10 || key.size() > 18 + (key[0] < '9')) return std::nullopt;  // 64 bits
  if (!std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isdigit(c); })) return std::nullopt;
  return std::stoll(key);
}

/// The times that name a camera's images; empty where not all are times.
std::vector<std::int64_t> list_times(const std::map<std::string, fs::path>& images) {
  std::vector<std::int64_t> times;
  for (const auto& [key, file] : images) {
    const auto time = time_of(key);
    if (!time) return {};
    times.push_back(*time);
  }
  std::sort(times.begin(), times.end());
  return times;
}

std::int64_t usual_step(const std::vector<std::int64_t>& times) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (steps.empty()) return 0;
  std::sort(steps.begin(), steps.end());
  return steps[steps.size() / 2];
}

/// Cameras that are named by times of their own: each image with the nearest in time of the first camera, no farther
/// than a fifth of a step. Said, as a board that moves is seen at two places then.
void bring_times_together(ByCamera& cameras, std::vector<Message>& notes) {
  const std::vector<std::int64_t> first =
      cameras.empty() ? std::vector<std::int64_t>() : list_times(cameras.begin()->second);
  if (first.size() < 2) return;
  for (auto camera = std::next(cameras.begin()); camera != cameras.end(); ++camera) {
    const std::vector<std::int64_t> own = list_times(camera->second);
    if (own.empty() || std::any_of(own.begin(), own.end(),
                                   [&](std::int64_t t) { return std::binary_search(first.begin(), first.end(), t); }))
      continue;
    const std::int64_t widest = usual_step(first) / 5;
    std::map<std::string, fs::path> together;
    for (const auto& [key, file] : camera->second) {
      const std::int64_t time = *time_of(key);
      const auto after = std::lower_bound(first.begin(), first.end(), time);
      std::int64_t nearest = after == first.end() ? first.back() : *after;
      if (after != first.begin() && time - *std::prev(after) < std::abs(nearest - time)) nearest = *std::prev(after);
      together.emplace(std::abs(nearest - time) <= widest ? std::to_string(nearest) : key, file);
    }
    if (together.size() != camera->second.size()) continue;  // two would be of one moment
    camera->second = std::move(together);
    notes.push_back(
        message("the images of camera {} have other times than those of camera {}; each is taken as of the "
                "moment of the nearest one. A board that moved between is seen at two places",
                camera->first, cameras.begin()->first));
  }
}

GroupedImages grouped(const ByCamera& cameras) {
  GroupedImages result;
  std::set<std::string> frames;
  for (const auto& [name, files] : cameras) {
    CameraImages camera{name, {}, {}};
    for (const auto& [key, file] : files) camera.keys.push_back(key), frames.insert(key);
    std::sort(camera.keys.begin(), camera.keys.end(), before);
    for (const std::string& key : camera.keys) camera.files.push_back(files.at(key));
    result.cameras.push_back(std::move(camera));
  }
  std::sort(result.cameras.begin(), result.cameras.end(),
            [](const auto& a, const auto& b) { return camera_before(a.name, b.name); });
  result.frames.assign(frames.begin(), frames.end());
  std::sort(result.frames.begin(), result.frames.end(), before);
  return result;
}

void note(GroupedImages& result, int others) {
  for (const CameraImages& camera : result.cameras)
    result.notes.push_back(message("camera {}: {} images, {} to {}", camera.name, camera.files.size(),
                                   camera.files.front().filename().string(), camera.files.back().filename().string()));
  for (const CameraImages& camera : result.cameras) {
    const std::size_t missing = result.frames.size() - camera.files.size();
    if (missing > 0)
      result.notes.push_back(
          message("camera {} has no image of {} of the {} moments", camera.name, missing, result.frames.size()));
  }
  if (others > 0)
    result.notes.push_back(others == 1 ? Message("one file is no image by its name and was left out")
                                       : message("{} files are no images by their names and were left out", others));
}

/// Folders in the one that was named: each with images is a camera's; else those in them ("cam0/data").
void add_inner_folders(ByCamera& cameras, const std::vector<fs::path>& folders, Listed& listed) {
  std::vector<fs::path> with_images, deeper;
  std::vector<std::vector<fs::path>> images;
  for (const fs::path& folder : folders) {
    Listed here;
    list_folder(folder, here, deeper);
    listed.others += here.others;
    if (here.images.empty()) continue;
    with_images.push_back(folder);
    images.push_back(here.images);
  }
  for (const fs::path& folder : with_images.empty() ? deeper : std::vector<fs::path>()) {
    Listed here;
    std::vector<fs::path> deepest;
    list_folder(folder, here, deepest);
    if (here.images.empty()) continue;
    with_images.push_back(folder);
    images.push_back(here.images);
  }
  const std::vector<std::string> names = telling_names(with_images);
  for (std::size_t i = 0; i < names.size(); ++i) add_folder(cameras, names[i], images[i]);
}

}  // namespace

GroupedImages group_images(const std::vector<fs::path>& paths) {
  ByCamera cameras;
  std::vector<fs::path> loose, folders;
  Listed listed;
  std::error_code error;
  for (const fs::path& path : paths) {
    if (!fs::exists(path, error)) throw InputError(message("{}: there is no such image or folder.", shown_path(path)));
    if (fs::is_directory(path, error))
      folders.push_back(path);
    else
      loose.push_back(path);
  }
  const bool folder_is_camera = folders.size() > 1;
  std::vector<fs::path> inner;
  const std::vector<std::string> names = telling_names(folders);
  for (std::size_t i = 0; i < folders.size(); ++i) {
    Listed here;
    list_folder(folders[i], here, inner);
    listed.others += here.others;
    if (folder_is_camera && !here.images.empty())
      add_folder(cameras, names[i], here.images);
    else
      loose.insert(loose.end(), here.images.begin(), here.images.end());
  }
  if (loose.empty() && cameras.empty()) add_inner_folders(cameras, inner, listed);
  const int moment = moment_of(loose);
  for (const fs::path& file : loose) {
    const auto [camera, key] = locate(file, moment);
    add(cameras, camera, key, file);
  }
  if (cameras.empty())
    throw InputError("No images were found; expected folders or files of PNG, JPEG, TIFF, PGM or BMP.");
  if (cameras.size() > most_cameras)
    throw InputError(message("The names of the images speak of {} cameras ({}, {}, ...); expected at most {}.",
                             cameras.size(), shortened(cameras.begin()->first),
                             shortened(std::next(cameras.begin())->first), most_cameras));
  std::vector<Message> of_times;
  bring_times_together(cameras, of_times);
  GroupedImages result = grouped(cameras);
  result.notes = std::move(of_times);
  note(result, listed.others);
  return result;
}

}  // namespace handsight
