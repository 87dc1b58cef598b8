// SPDX-License-Identifier: Apache-2.0
// When an image that somebody writes is whole.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/message.h"
#include "camera/camera.h"

namespace handsight {

/// Image files at one look after the other. What is not looked at is forgotten.
class ImageArrival {
 public:
  /// `settles_in`: how long a file must have been as it is before it is opened, as far as two looks at least can tell;
  /// without it at once.
  explicit ImageArrival(std::optional<std::chrono::milliseconds> settles_in) : settles_in_(settles_in) {}

  void begin_look();
  /// Once for each file and look, before what follows is asked of it.
  void look_at(const std::filesystem::path& file);
  bool may_be_opened(const std::filesystem::path& file) const;
  /// Has it been as it is for so long that what is wrong with it is to be said? As long as it settles in, else two
  /// seconds.
  bool is_overdue(const std::filesystem::path& file) const;
  /// Why it is no whole image of the camera, a sentence; empty: it is one.
  const Message& fault(const std::filesystem::path& file, const Camera& camera);

 private:
  struct Stamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type written;
    std::chrono::steady_clock::time_point since;  // it is as it is
    bool is_as_before = false;                    // at the last look
    std::optional<Message> fault;
    bool is_last_word = false;  // nothing more is expected of it until it is written again
  };
  std::chrono::milliseconds age(const Stamp& stamp) const;

  std::optional<std::chrono::milliseconds> settles_in_;
  std::chrono::steady_clock::time_point now_;
  std::map<std::string, Stamp> stamps_, before_;
};

}  // namespace handsight
