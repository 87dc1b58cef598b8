// SPDX-License-Identifier: Apache-2.0
#include "print/tag_places_xml.h"

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/numbers.h"

namespace handsight {
namespace {

constexpr Bounds sizes{1e-5, 100};                   // m
constexpr Bounds sigmas{0, 1};                       // m
constexpr Bounds sigma_angles{0, std::numbers::pi};  // rad

Vector3 vector_in(const XmlNode& node, const char* attribute, const Bounds& within) {
  const auto numbers = find_numbers(node, attribute, 3, within);
  return numbers ? Vector3(numbers->data()) : Vector3::Zero();
}

/// What the target says for all of its tags.
struct OfAll {
  std::optional<double> size, sigma, sigma_angle;
};

TagPlace read_place(const XmlNode& node, const OfAll& all) {
  TagPlace place;
  place.xyz = vector_in(node, "xyz", bounds::length);
  place.rpy = vector_in(node, "rpy", bounds::joint);
  const auto size = find_positive(node, "size", sizes);
  if (!size && !all.size)
    refuse(node, "has no size, and neither has the target, expected the side of the black square in m.");
  place.size = size ? *size : *all.size;
  const auto sigma = find_number(node, "sigma", sigmas), sigma_angle = find_number(node, "sigma_angle", sigma_angles);
  place.sigma = sigma ? *sigma : all.sigma.value_or(0);
  place.sigma_angle = sigma_angle                 ? *sigma_angle
                      : sigma || !all.sigma_angle ? usual_sigma_angle(place)
                                                  : *all.sigma_angle;
  return place;
}

void set(tinyxml2::XMLElement& element, const char* attribute, double number) {
  element.SetAttribute(attribute, format_number(number).c_str());
}

}  // namespace

const std::vector<std::string>& tag_attributes() {
  static const std::vector<std::string> all{"id", "xyz", "rpy", "size", "sigma", "sigma_angle"};
  return all;
}

const tinyxml2::XMLElement* find_tag(const XmlNode& target) { return target.element->FirstChildElement("tag"); }

double usual_sigma_angle(const TagPlace& place) { return std::min(place.sigma * std::sqrt(2) / place.size, 1.0); }

void read_tag_places(const XmlNode& node, Target& target) {
  const OfAll all{find_positive(node, "size", sizes), target.sigma ? find_number(node, "sigma", sigmas) : std::nullopt,
                  find_number(node, "sigma_angle", sigma_angles)};
  for (const XmlNode& tag : children(node, "tag")) {
    target.ids.push_back(static_cast<int>(required_integer(tag, "id", 0, 1'000'000)));
    target.places.push_back(read_place(tag, all));
  }
  target.tag = all.size ? *all.size : target.places.front().size;
  if (target.sigma) target.sigma = 0;
}

void write_tag_places(tinyxml2::XMLElement& element, const Target& target) {
  for (std::size_t k = 0; k < target.places.size(); ++k) {
    const TagPlace& place = target.places[k];
    tinyxml2::XMLElement& tag = *element.InsertNewChildElement("tag");
    tag.SetAttribute("id", target.ids[k]);
    tag.SetAttribute("xyz", format_numbers({place.xyz.data(), 3}).c_str());
    tag.SetAttribute("rpy", format_numbers({place.rpy.data(), 3}).c_str());
    if (place.size != target.tag) set(tag, "size", place.size);
    if (place.sigma != 0) set(tag, "sigma", place.sigma);
    if (place.sigma != 0 || place.sigma_angle != 0) set(tag, "sigma_angle", place.sigma_angle);
  }
}

}  // namespace handsight
