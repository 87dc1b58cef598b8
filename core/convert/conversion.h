// SPDX-License-Identifier: Apache-2.0
// What a conversion may be asked, and what it gives.
#pragma once

#include <exception>
#include <functional>

#include "base/message.h"
#include "readers/series.h"
#include "session/session.h"

namespace handsight {

struct ConvertOptions {
  std::filesystem::path out;    // the folder to make
  std::filesystem::path robot;  // URDF; empty: among the files, in the bag, or none (poses of the flange alone)
  std::string tcp, mount;       // links; mount empty: the root link
  std::string title;
  bool degrees = false;  // tables of joints or of poses whose header does not say so
  std::string angles;    // what the angles of tables of poses are (angle_kind_names); empty: found out
  std::optional<double> sigma, sigma_angle;  // of the sensor: m, rad; unknown ones are estimated
  bool eye_on_base = false;                  // easy_handeye's files that do not say where the camera is
  int markers = 3;                           // of sessions with images and anonymous markers
  std::optional<Target> target;              // what images show, where its points name themselves
  std::string target_frame;                  // of a bag's /tf: the target that a detector publishes
  std::string camera;                        // of a bag: stands in the topics of the images to take; empty: all
  std::vector<std::string> fixtures;         // of tables of touches: "plane table sigma=2e-5" (convert_touch.cpp)
  std::vector<std::string> apart;            // and their distances: "socket_1 socket_2 by=0.05 sigma=1e-5"
  std::vector<std::string> columns;          // of tables without a header; "-": left out
  bool estimate_lag = false;
  PairingOptions pairing;
  std::function<bool()> goes_on;  // asked from time to time before session.xml is written: is it still wanted?
};

/// Where ConvertOptions::goes_on said no: nothing that was written stays.
struct ConversionStopped : std::exception {
  const char* what() const noexcept override { return "The conversion was stopped."; }
};

struct Conversion {
  Session session;
  std::vector<Message> took;   // what each file was taken for
  std::vector<Message> notes;  // what was understood, what is missing, what was left out
  std::string sensor, target;  // what measured and what it saw, as files or topics call them; empty: not given
};

/// Throws ConversionStopped where it is no longer wanted.
inline void ask_whether_to_go_on(const ConvertOptions& o) {
  if (o.goes_on && !o.goes_on()) throw ConversionStopped();
}

}  // namespace handsight
