// SPDX-License-Identifier: Apache-2.0
#include "live/known_again.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace handsight {
namespace {

/// Numbers in few bits, by which they are known again (Fowler's, Noll's and Vo's sum).
class Bits {
 public:
  void add(std::uint64_t whole) {
    constexpr std::uint64_t prime = 1099511628211U;
    for (int shift = 0; shift < 64; shift += 8) bits_ = (bits_ ^ ((whole >> shift) & 0xff)) * prime;
  }
  /// To 1e-9.
  template <class Vector>
  void add_rounded(const Vector& numbers) {
    for (const double x : numbers) add(static_cast<std::uint64_t>(std::llround(1e9 * x)));
  }
  std::uint64_t bits() const { return bits_; }

 private:
  std::uint64_t bits_ = 14695981039346656037U;
};

}  // namespace

std::uint64_t bits_of_line(double time, const Eigen::VectorXd& position) {
  Bits bits;
  bits.add(std::bit_cast<std::uint64_t>(time));
  bits.add_rounded(position);
  return bits.bits();
}

std::uint64_t bits_of_measured(const Observation& o, std::int64_t number) {
  Bits bits;
  bits.add(static_cast<std::uint64_t>(number));
  bits.add_rounded(o.position);
  if (o.target_pose) bits.add_rounded(o.target_pose->translation);
  for (const Sighting& s : o.sightings)
    if (s.point && !o.target_pose) bits.add_rounded(*s.point);
  return bits.bits();
}

bool holds(const Ascending& all, std::uint64_t bits) { return std::binary_search(all.begin(), all.end(), bits); }

void put_into(Ascending& all, std::uint64_t bits) { all.insert(std::upper_bound(all.begin(), all.end(), bits), bits); }

void take_out(Ascending& all, std::uint64_t bits) {
  const auto [begin, end] = std::equal_range(all.begin(), all.end(), bits);
  all.erase(begin, end);
}

void make_ascending(Ascending& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

}  // namespace handsight
