// SPDX-License-Identifier: Apache-2.0
// A calibration is read or refused with a sentence; what was read is written, read again and written the
// same.
#include <optional>

#include "fuzz.h"
#include "session/calibration_xml.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::optional<handsight::Calibration> calibration;
  try {
    calibration =
        handsight::parse_calibration(std::string(reinterpret_cast<const char*>(data), size), "calibration.xml");
  } catch (const handsight::InputError& error) {
    handsight::demand_sentence(error);
    return 0;
  }
  const std::string text = handsight::calibration_text(*calibration);
  const std::string again = handsight::calibration_text(handsight::parse_calibration(text, "calibration.xml"));
  handsight::demand(text == again, "a calibration reads back", text);
  return 0;
}
