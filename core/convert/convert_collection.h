// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot from one recording: two hands, several sensors.
#pragma once

#include <filesystem>
#include <vector>

#include "base/message.h"
#include "convert/conversion.h"
#include "session/collection.h"

namespace handsight {

struct ConvertedCollection {
  Collection collection;             // as written; its file is collection.xml of the folder
  std::vector<Conversion> sessions;  // in its order
  std::vector<Message> notes;        // what they share, what files are of which
};

struct CollectionOptions {
  std::filesystem::path out;             // the folder to make; each session is a folder in it
  std::string title;                     // empty: the folder's name
  bool one_sensor = false;               // sensors whose files do not tell it are one, at one place
  std::vector<ConvertOptions> sessions;  // their `out` is not used; without a title they are called by what differs
};

/// Makes the folder. Sessions whose images, frame of /tf or table are the same and whose mount is, have one rig; those
/// of one hand that see one target have one body. InputError where the sessions cannot be distinguished, have no robot
/// in common, or one of them cannot be made (with its name): then nothing of it stays. ConversionStopped.
ConvertedCollection convert_collection(const std::vector<std::filesystem::path>& files,
                                       const CollectionOptions& options);

}  // namespace handsight
