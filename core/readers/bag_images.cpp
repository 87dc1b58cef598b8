// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/bag_contents.h"
#include "readers/bags/messages.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

struct PixelKind {
  std::size_t channels = 0, bytes = 1;  // 0: none that is read
  bool swap_colours = false;
};

PixelKind kind_of(const std::string& e) {
  if (e == "mono8" || e == "8UC1") return {1};
  if (e == "mono16" || e == "16UC1") return {1, 2};
  if (e == "rgb8") return {3};
  if (e == "bgr8" || e == "8UC3") return {3, 1, true};
  if (e == "rgba8") return {4};
  if (e == "bgra8" || e == "8UC4") return {4, 1, true};
  return {};
}

void add_row(std::string& out, const char* row, const ros::Image& image, const PixelKind& kind) {
  if (kind.channels == 1 && kind.bytes == 1) {
    out.append(row, image.width);
    return;
  }
  for (std::size_t x = 0; x < image.width; ++x) {
    const char* const px = row + x * kind.channels * kind.bytes;
    if (kind.bytes == 2) {
      out += image.is_bigendian ? px[0] : px[1];
      out += image.is_bigendian ? px[1] : px[0];
    } else {
      for (const int c : {0, 1, 2}) out += px[kind.swap_colours ? 2 - c : c];
    }
  }
}

/// Grey or colour as PNM (netpbm): bytes as they are, 16 bit with the high byte first.
std::string pnm_of(const ros::Image& image, const std::string& what) {
  const PixelKind kind = kind_of(image.encoding);
  if (kind.channels == 0)
    throw InputError(
        message("{}: images of the encoding {} cannot be read; publish mono8, mono16, rgb8 or bgr8 "
                "(image_proc makes them of Bayer patterns).",
                what, in_quotes(image.encoding)));
  if (image.step < image.width * kind.channels * kind.bytes)
    throw InputError(message("{}: its rows are shorter than its width.", what));
  std::string out = fmt::format("P{}\n{} {}\n{}\n", kind.channels == 1 ? 5 : 6, image.width, image.height,
                                kind.bytes == 2 ? 65535 : 255);
  for (std::size_t y = 0; y < image.height; ++y) add_row(out, image.data.data() + y * image.step, image, kind);
  return out;
}

std::string ending_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xFF\xD8")) return ".jpg";
  if (bytes.starts_with("RIFF")) return ".webp";
  return "";
}

struct ImageFile {
  std::string content, ending;
};

ImageFile file_of(const BagTopic& topic, std::string_view bytes, const std::string& what) {
  const ros::Message serialized{bytes, topic.encoding == "ros1", what};
  if (topic.type != "sensor_msgs/CompressedImage") {
    ImageFile file{pnm_of(ros::read_image(serialized), what), ""};
    file.ending = file.content[1] == '5' ? ".pgm" : ".ppm";
    return file;
  }
  const ros::CompressedImage image = ros::read_compressed_image(serialized);
  if (ending_of(image.data).empty())
    throw InputError(message("{}: compressed images of the format {} cannot be read; expected PNG, JPEG or WebP.", what,
                             in_quotes(image.format)));
  return {std::string(image.data), ending_of(image.data)};
}

}  // namespace

std::vector<std::string> write_bag_images(const Bag& bag, const BagImages& images,
                                          const std::vector<std::size_t>& wanted, const fs::path& folder,
                                          const std::string& side, const std::function<void()>& at_each) {
  std::vector<std::string> names(wanted.size());
  std::map<std::size_t, std::size_t> number_of;  // by the place in the bag
  for (std::size_t i = 0; i < wanted.size(); ++i) number_of[images.places[wanted[i]]] = i;
  std::size_t place = 0;
  const Message what = message("{}, topic {}", bag.name, images.topic);
  const auto write = [&](const BagTopic& topic, std::int64_t, std::string_view bytes) {
    if (at_each) at_each();
    const auto found = number_of.find(place++);
    if (found == number_of.end()) return;
    const ImageFile file = file_of(topic, bytes, what);
    std::string& name = names[found->second];
    name = fmt::format("{:04}_{}{}", found->second, side, file.ending);
    replace_file(folder / name, file.content);
  };
  try {
    read_bag(
        bag, [&](const BagTopic& topic) { return topic.name == images.topic; }, write);
  } catch (...) {
    std::error_code error;
    for (const std::string& name : names)
      if (!name.empty()) fs::remove(folder / name, error);
    throw;
  }
  return names;
}

}  // namespace handsight
