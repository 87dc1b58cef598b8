// SPDX-License-Identifier: Apache-2.0
// Effects as they stand in options, a line each: read to terms that a robot has, or refused with a sentence; what was
// read moves the chain by finite amounts.
#include <cmath>

#include "effects/effect.h"
#include "fuzz.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

const Chain& chain() {
  static const Chain arm = [] {
    Chain c;
    c.robot = parse_urdf(R"(<robot name="arm"><link name="a"/><link name="b"/><link name="c"><inertial><mass value="1"/>
      </inertial></link><joint name="j1" type="revolute"><parent link="a"/><child link="b"/></joint>
      <joint name="j2" type="revolute"><parent link="b"/><child link="c"/><mimic joint="j1"/></joint></robot>)",
                         "arm.urdf", nullptr);
    c.tcp_link = 2;
    c.joints = {0};
    c.gravity = {0, 0, -9.81};
    c.marker_count = 3;
    return c;
  }();
  return arm;
}

void read_line(const std::string& line) {
  std::vector<EffectTerm> terms;
  try {
    if (line.find('=') == std::string::npos)
      terms = effect_terms(line, chain());
    else
      add_effect_value(line, chain().robot, terms);
  } catch (const InputError& error) {
    demand(std::string(error.what()).size() >= 20, "a refusal is a sentence", error.what());
    return;
  }
  for (EffectTerm& term : terms)
    for (double& value : term.values) value = std::min(std::max(value, -1.0), 1.0);
  const ObservationState c = states_at(chain(), Eigen::VectorXd(Eigen::VectorXd::Constant(1, 0.3)));
  demand(moved_sites(c, terms).body.allFinite(), "sites are finite", line);
}

}  // namespace
}  // namespace handsight

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    handsight::read_line(text.substr(0, end).c_str());  // options end at a zero byte
    text.erase(0, end + 1);
  }
  return 0;
}
