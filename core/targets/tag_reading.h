// SPDX-License-Identifier: Apache-2.0
// Which tag a quadrilateral holds: by likeness of its modules to every code that may be there, blurred as the image is.
// With blurred images this tells more than modules that are called black or white one by one.
#pragma once

#include <optional>
#include <vector>

#include "print/dictionary.h"
#include "targets/quads.h"

namespace handsight {

/// A tag that may be in the image.
struct TagCandidate {
  int tag = 0;  // index that the reading reports
  TagPattern pattern;
};

/// A tag that was read. `corners` go clockwise from the tag's own top left corner.
struct TagReading {
  int tag = 0;
  Quad corners;
  double likeness = 0;  // correlation of the modules with the code, up to 1
  double lead = 0;      // over the likeness of the best other code
};

/// Mean grey levels of the inner parts of side x side modules in a quad, row by row.
std::vector<float> module_values(const Image& image, const Quad& quad, int side);

/// Candidates prepared for comparison, all of the same number of modules.
class TagReader {
 public:
  explicit TagReader(const std::vector<TagCandidate>& candidates);

  /// The tag in the quad; nothing where none is alike enough, or two are.
  std::optional<TagReading> read(const Image& image, const Quad& quad) const;

 private:
  struct Template {
    int tag = 0, turns = 0;
    std::vector<float> values;  // mean 0, length 1
  };
  int side_ = 0;
  std::vector<Template> templates_;
};

/// All tags among the quads: where several quads read as the same tag at the same place the most alike is kept; at
/// different places all are kept.
std::vector<TagReading> read_tags(const Image& image, const std::vector<Quad>& quads, const TagReader& reader);

}  // namespace handsight
