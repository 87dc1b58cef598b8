// SPDX-License-Identifier: Apache-2.0
// Which tags an image shows, of whatever dictionary, upright, in a mirror or white for black: to find out what a target
// really is that is not where it was described.
#pragma once

#include <string>
#include <vector>

#include "targets/quads.h"

namespace handsight {

/// A tag that was read by its bits; corners go clockwise from its own top left corner.
struct SurveyedTag {
  int id = 0;
  Quad corners;
};

/// The tags of one dictionary that the image shows, seen in one way.
struct TagSurvey {
  std::string dictionary;                         // the largest of those that share their first tags: DICT_4X4_1000
  int border = 1;                                 // modules
  bool is_inverted = false, is_mirrored = false;  // white for black; corners are then of the mirrored image
  std::vector<SurveyedTag> tags;
};

/// The way of seeing it that shows most tags; without tags where there are none.
TagSurvey survey_tags(const Image& image);

/// The smallest dictionary that shares its first tags with this one and has the id; the same name for others.
std::string smallest_dictionary(const std::string& largest, int id);

Image mirrored(const Image& image);
Image inverted(const Image& image);

}  // namespace handsight
