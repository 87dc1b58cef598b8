// SPDX-License-Identifier: Apache-2.0
// A MuJoCo model as its files write it: includes brought in, default classes and the compiler's settings known.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/xml.h"
#include "geometry/rigid.h"

namespace handsight::mjcf {

/// Attributes of one default class by element ("joint", "geom"), those of the classes around it included.
using ElementDefaults = std::map<std::string, std::map<std::string, std::string>>;

struct Model {
  std::shared_ptr<tinyxml2::XMLDocument> document;
  std::string file;                // as sentences call it
  bool is_in_degrees = true;       // compiler angle=""
  std::string euler = "xyz";       // compiler eulerseq="": small letters turn with the body, capitals stay
  std::string mesh_folder;         // compiler meshdir="", else assetdir=""
  std::optional<bool> from_geoms;  // compiler inertiafromgeom=""; nothing: auto
  std::map<std::string, ElementDefaults> classes;  // "" is the outermost
  std::map<std::string, std::string> meshes;       // files of the assets by name
};

/// Reads the file and what it includes from its folder. InputError where one is missing or is no MJCF.
Model read_model(const std::filesystem::path& path, const std::string& file);

/// An element with its default class.
struct Element {
  const Model& model;
  XmlNode node;
  std::string around;  // the childclass of the bodies around it

  /// What it says itself, or its class does.
  std::optional<std::string> text(const char* attribute) const;
  /// InputError where these are not `count` finite numbers (`least` of them at least, where it is not 0).
  std::optional<std::vector<double>> numbers(const char* attribute, std::size_t count, std::size_t least = 0) const;
  double number(const char* attribute, double missing) const;
  Vector3 vector(const char* attribute, const Vector3& missing) const;
  double radians(double angle) const { return model.is_in_degrees ? angle * (3.14159265358979323846 / 180) : angle; }
};

/// pos with quat (w x y z), axisangle, euler, xyaxes or zaxis.
Rigid locate(const Element& element);

}  // namespace handsight::mjcf
