// SPDX-License-Identifier: Apache-2.0
// Two states of the detector in one process, in turn: how much longer the first takes than the second, on images that
// both see. Usage: benchmark_detector_beside [--rounds N] FIRST SECOND [IMAGE ...] [--markdown]: shared libraries that
// the targets detector_now and, with -DHANDSIGHT_DETECTOR_BEFORE=FOLDER/core, detector_before make; without images the
// real boards, where they are there, and rendered scenes.
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "trials/table.h"
#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_truth.h"

namespace {

using namespace handsight;
using Detect = int (*)(const unsigned char*, int, int, double*, int);

Detect load(const std::string& file) {
  void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto detect = library ? reinterpret_cast<Detect>(dlsym(library, "handsight_detect")) : nullptr;
  if (!detect) fmt::print(stderr, "{}\n", dlerror()), std::exit(2);
  return detect;
}

double milliseconds(Detect detect, const Image& image) {
  const auto begin = std::chrono::steady_clock::now();
  detect(image.pixels.data(), image.width, image.height, nullptr, 0);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void compare(const std::string& name, const std::vector<Image>& images, Detect first, Detect second, int rounds,
             trials::Table& table) {
  double of_first = 0, of_second = 0;
  int corners_of_first = 0, corners_of_second = 0;
  std::vector<double> ratios;
  for (const Image& image : images) {
    double least_first = 1e9, least_second = 1e9;
    for (int i = 0; i < rounds; ++i) {
      const bool swaps = i % 2;
      const double before = milliseconds(swaps ? second : first, image),
                   after = milliseconds(swaps ? first : second, image);
      const double a = swaps ? after : before, b = swaps ? before : after;
      least_first = std::min(least_first, a), least_second = std::min(least_second, b), ratios.push_back(a / b);
    }
    const auto count = [&](Detect detect) {
      return detect(image.pixels.data(), image.width, image.height, nullptr, 0);
    };
    of_first += least_first, of_second += least_second;
    corners_of_first += count(first), corners_of_second += count(second);
  }
  const auto many = static_cast<double>(images.size());
  table.print({name, of_first / of_second, median(ratios)});
  fmt::print("  {:.3f} and {:.3f} ms (means of the least of {}); {} and {} corners\n", of_first / many,
             of_second / many, rounds, corners_of_first, corners_of_second);
  std::fflush(stdout);
}

std::vector<Image> drawn(const corner_images::Conditions& conditions, int count) {
  std::mt19937 random(3);
  std::vector<Image> images;
  for (int i = 0; i < count; ++i) images.push_back(corner_images::take(conditions, random).image);
  return images;
}

std::vector<Image> read(const std::vector<std::string>& files) {
  std::vector<Image> images;
  for (const std::string& file : files) {
    const cv::Mat mat = cv::imread(file, cv::IMREAD_GRAYSCALE);
    if (!mat.empty()) images.push_back(corner_images::as_image(mat));
  }
  return images;
}

std::vector<std::string> real_boards() {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real" / "opencv_stereo";
  std::vector<std::string> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path().string());
  std::erase_if(files, [](const std::string& file) { return !file.ends_with(".jpg"); });
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int count, char** words) {
  const trials::TableOutput output = trials::take_table_output(count, words);
  std::vector<std::string> arguments(words + 1, words + count);
  int rounds = 15;
  if (arguments.size() > 1 && arguments[0] == "--rounds") {
    rounds = std::max(1, std::atoi(arguments[1].c_str()));
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() < 2) return fmt::print(stderr, "Two libraries are needed.\n"), 2;
  const Detect first = load(arguments[0]), second = load(arguments[1]);
  trials::Table table(
      {{.heading = "images", .width = 28}, {"time over the detector before", 2}, {"median of pairs", 2}}, output);
  if (arguments.size() > 2) {
    compare("images", read({arguments.begin() + 2, arguments.end()}), first, second, rounds, table);
    return 0;
  }
  if (const auto images = read(real_boards()); !images.empty())
    compare("real boards, 640 x 480", images, first, second, rounds, table);
  using namespace corner_images;
  compare("boards, 640 x 480", drawn({.width = 640, .height = 480}, 6), first, second, rounds, table);
  compare("before things, 640 x 480", drawn({.width = 640, .height = 480, .ground = Ground::things}, 6), first, second,
          rounds, table);
  std::mt19937 random(2);
  compare("texture and 54 markers", {busy_scene(54, 3, random)}, first, second, rounds, table);
  const Conditions twelve{.width = 4000, .height = 3000, .cell = {90, 110}, .tilt = {0, 0.5}, .blur = {0.8, 1.4}};
  Conditions things = twelve;
  things.ground = Ground::things;
  compare("12 megapixels, plain", drawn(twelve, 1), first, second, rounds, table);
  compare("12 megapixels, before things", drawn(things, 1), first, second, rounds, table);
}
