// SPDX-License-Identifier: Apache-2.0
// What images show that do not show the target that was described: another board, a mirror image, white for black.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "print/target.h"
#include "vision/image/image.h"

namespace handsight {

struct TargetGuess {
  std::optional<Target> target;  // that is found in most of the images; nothing where none is
  Message text;                  // one sentence or two for people; empty where nothing can be said
};

/// Looks at all of the images for tags of every dictionary, and at the corners of chessboards. What fits is tried: only
/// a target that is found is named. `names` are how it is written: as options of a command (`--first-id 24`), or as
/// attributes of <target> (`first_id="24"`).
enum class TargetWording { options, attributes };
TargetGuess guess_target(const std::vector<Image>& images, const Target& described, TargetWording wording);

/// What the images show where nobody has described it: a chessboard, a ChArUco board or a grid of tags, else single
/// tags that most of the images show. Its lengths are to each other as they are; how long they are no image tells.
/// Nothing where no such thing is found in most of the images.
std::optional<Target> shown_target(const std::vector<Image>& images);

}  // namespace handsight
