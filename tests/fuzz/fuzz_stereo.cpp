// SPDX-License-Identifier: Apache-2.0
// A stereo calibration of OpenCV's is read to two cameras of finite numbers, or refused with a sentence.
#include <cmath>

#include "fuzz.h"
#include "readers/stereo_calibration.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handsight;
  try {
    std::vector<Message> notes;
    const StereoRig rig =
        parse_stereo_calibration({{std::string(reinterpret_cast<const char*>(data), size), "stereo.yaml"}}, &notes);
    for (const Camera* camera : {&rig.left, &rig.right})
      for (const double number : {camera->fx, camera->fy, camera->cx, camera->cy, camera->k1, camera->k3})
        demand(std::isfinite(number), "cameras are of finite numbers");
    demand(rig.right_from_left.translation.allFinite() && rig.right_from_left.rotation.allFinite(), "a finite motion");
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    demand(sentence.size() >= 20 && sentence.size() <= 600 && is_utf8(sentence), "a refusal is a sentence", sentence);
  }
  return 0;
}
