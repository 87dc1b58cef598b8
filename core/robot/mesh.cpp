// SPDX-License-Identifier: Apache-2.0
#include "robot/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "base/bounds.h"
#include "base/error.h"
#include "base/files.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "robot/collada_text.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = std::size_t{256} << 20;  // bytes
constexpr std::size_t most_triangles = 5'000'000;

/// Calls `take(line, number of the line)` for each line of a text.
template <class Take>
void for_each_line(std::string_view text, const Take& take) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    take(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool is_coordinate(double number) { return bounds::joint.hold(number); }

Eigen::Vector3f point_of(const std::vector<std::string_view>& words, const std::string& file, int line) {
  Eigen::Vector3f point;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = words.size() > i + 1 ? parse_number(words[i + 1]) : std::nullopt;
    if (!number || !is_coordinate(*number))
      refuse(
          file, line,
          message("the point has {}, expected three finite numbers.",
                  words.size() > i + 1 ? verbatim(in_quotes(words[i + 1])) : message("{} numbers", words.size() - 1)));
    point[static_cast<Eigen::Index>(i)] = static_cast<float>(*number);
  }
  return point;
}

void require_few(std::size_t triangles, const std::string& file, int line) {
  if (triangles > most_triangles)
    refuse(file, line, message("the mesh has more than {} triangles, expected a simpler one.", most_triangles));
}

/// The point that "7", "7/1", "7//3" or "-1" names: from 1, or back from the last one so far.
std::uint32_t corner_of(std::string_view word, std::size_t points, const std::string& file, int line) {
  const auto index = parse_integer(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(points);
  const std::int64_t place = !index ? -1 : *index > 0 ? *index - 1 : *index < 0 ? count + *index : -1;
  if (!index || *index > count || *index < -count || place < 0)
    refuse(file, line,
           message("the face names the point {}, expected one of the {} points before it.", in_quotes(word), points));
  return static_cast<std::uint32_t>(place);
}

void add_face(const std::vector<std::string_view>& words, Mesh& mesh, const std::string& file, int line) {
  if (words.size() < 4)
    refuse(file, line, message("the face has {} corners, expected at least three.", words.size() - 1));
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 1; i < words.size(); ++i) corners.push_back(corner_of(words[i], mesh.points.size(), file, line));
  for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  require_few(mesh.triangles.size(), file, line);
}

/// Gathers triangles whose corners come as points: equal ones become one.
class Gatherer {
 public:
  void add(const Eigen::Vector3f& point) {
    const std::array<float, 3> key{point.x(), point.y(), point.z()};
    const auto [found, is_new] = indices_.emplace(key, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back(point);
    corner_[count_++] = found->second;
    if (count_ < 3) return;
    mesh.triangles.push_back(corner_);
    count_ = 0;
  }
  bool is_whole() const { return count_ == 0; }
  Mesh mesh;

 private:
  std::map<std::array<float, 3>, std::uint32_t> indices_;
  std::array<std::uint32_t, 3> corner_{};
  std::size_t count_ = 0;
};

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

float little_endian_float(std::string_view bytes) {
  const std::uint32_t bits = little_endian(bytes);
  float number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

constexpr std::size_t stl_head = 84, stl_triangle = 50;  // bytes

Mesh parse_binary_stl(std::string_view bytes, const std::string& file) {
  require_few((bytes.size() - stl_head) / stl_triangle, file, 0);
  Gatherer gatherer;
  for (bytes.remove_prefix(stl_head); bytes.size() >= stl_triangle; bytes.remove_prefix(stl_triangle))
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // the first vector is the normal
      Eigen::Vector3f point;
      for (std::size_t i = 0; i < 3; ++i)
        point[static_cast<Eigen::Index>(i)] = little_endian_float(bytes.substr(12 * corner + 4 * i, 4));
      if (!std::all_of(point.begin(), point.end(), is_coordinate))
        refuse(file, 0, "a corner of a triangle is not finite or too far away, expected finite numbers.");
      gatherer.add(point);
    }
  return std::move(gatherer.mesh);
}

Mesh parse_text_stl(std::string_view text, const std::string& file) {
  Gatherer gatherer;
  for_each_line(text, [&](std::string_view line, int number) {
    const std::vector<std::string_view> words = split_words(line);
    if (words.empty() || words[0] != "vertex") return;
    gatherer.add(point_of(words, file, number));
    require_few(gatherer.mesh.triangles.size(), file, number);
  });
  if (!gatherer.is_whole()) refuse(file, 0, "the last triangle is cut off, expected three corners.");
  return std::move(gatherer.mesh);
}

bool is_inside(const fs::path& file, const fs::path& home) {
  return std::mismatch(home.begin(), home.end(), file.begin(), file.end()).first == home.end();
}

/// The session's folder where the URDF lies in one below it, else the URDF's own.
fs::path home_of(const fs::path& urdf_folder) {
  std::error_code error;
  fs::path home = fs::weakly_canonical(urdf_folder.empty() ? fs::path(".") : urdf_folder, error), above = home;
  for (int levels = 0; levels < 4; ++levels, above = above.parent_path())
    if (fs::is_regular_file(above / "session.xml", error)) return above;
  return home;
}

}  // namespace

Mesh parse_obj(std::string_view text, const std::string& file) {
  Mesh mesh;
  for_each_line(text, [&](std::string_view line, int number) {
    const std::vector<std::string_view> words = split_words(line.substr(0, line.find('#')));
    if (words.empty()) return;
    if (words[0] == "v") mesh.points.push_back(point_of(words, file, number));
    if (words[0] == "f") add_face(words, mesh, file, number);
  });
  return mesh;
}

Mesh parse_stl(std::string_view bytes, const std::string& file) {
  const bool has_head = bytes.size() >= stl_head;
  const std::size_t reported = has_head ? stl_head + stl_triangle * std::size_t{little_endian(bytes.substr(80, 4))} : 0;
  if (has_head && reported == bytes.size()) return parse_binary_stl(bytes, file);
  if (bytes.starts_with("solid")) return parse_text_stl(bytes, file);
  refuse(
      file, 0,
      message("the file has {} bytes and its head speaks of {}, expected a whole STL file.", bytes.size(), reported));
}

Mesh read_mesh(const fs::path& file) {
  const std::string ending = lower_case(file.extension().string());
  const std::string name = file.filename().string();
  if (ending != ".stl" && ending != ".obj" && ending != ".dae")
    refuse(name, 0, "the mesh is of a kind that is not read, expected an STL, an OBJ or a Collada (.dae) file.");
  const std::string bytes = read_file(file);
  if (bytes.size() > largest_file)
    refuse(name, 0, message("the mesh has {} MB, expected at most {}.", bytes.size() >> 20, largest_file >> 20));
  Mesh mesh = ending == ".stl"   ? parse_stl(bytes, name)
              : ending == ".dae" ? parse_collada(bytes, name)
                                 : parse_obj(bytes, name);
  if (mesh.triangles.empty()) refuse(name, 0, "the mesh has no triangle, expected at least one.");
  return mesh;
}

std::optional<fs::path> find_mesh(const std::string& written, const fs::path& urdf_folder) {
  std::string name = written;
  for (const char* scheme : {"package://", "file://"})
    if (name.starts_with(scheme)) name.erase(0, std::strlen(scheme));
  const fs::path path(name), home = home_of(urdf_folder);
  fs::path without_package;
  for (auto part = path.begin(); part != path.end(); ++part)
    if (part != path.begin()) without_package /= *part;
  std::error_code error;
  for (const fs::path& candidate :
       {urdf_folder / path, urdf_folder / without_package.relative_path(), urdf_folder / path.filename()}) {
    fs::path real = fs::weakly_canonical(candidate, error);
    if (!error && is_inside(real, home) && fs::is_regular_file(real, error)) return real;
  }
  return std::nullopt;
}

}  // namespace handsight
