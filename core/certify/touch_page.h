// SPDX-License-Identifier: Apache-2.0
// Two pages to print and take to the robot: how to touch each kind of fixture, and lines to write down what was
// touched.
#pragma once

#include <string>

namespace handsight {

/// The PDF's bytes. `software` stands in its footer.
std::string touch_page_pdf(const std::string& software);

}  // namespace handsight
