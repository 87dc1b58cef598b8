// SPDX-License-Identifier: Apache-2.0
// What numbers in files and options may be: far wider than any robot needs, narrow enough that nothing that is computed
// from them leaves the range of a double. docs/formats.md lists them for people.
#pragma once

#include <cstddef>

namespace handsight {

/// A closed range.
struct Bounds {
  double lowest = 0, highest = 0;

  bool hold(double number) const { return number >= lowest && number <= highest; }  // not for NaN
};

namespace bounds {

inline constexpr Bounds finite{-1.7976931348623157e308, 1.7976931348623157e308};  // directions: normalised anyway
inline constexpr Bounds any{-1e30, 1e30};          // where nothing more is known of the number
inline constexpr Bounds length{-1e5, 1e5};         // m: places, links, shapes, tracked points
inline constexpr Bounds joint{-1e6, 1e6};          // rad or m: readings, angles, speeds (1/s), mimic numbers, scales
inline constexpr Bounds torque{-1e9, 1e9};         // N m, N
inline constexpr Bounds mass{0, 1e6};              // kg
inline constexpr Bounds gravity{-1e4, 1e4};        // m/s^2
inline constexpr Bounds stiffness{1e-6, 1e15};     // N m/rad, N/m
inline constexpr Bounds pixel{-1e7, 1e7};          // px
inline constexpr Bounds focal_length{0.1, 1e7};    // px
inline constexpr Bounds distortion{-1e9, 1e9};     // k1, k2, p1, p2, k3
inline constexpr Bounds sigma_pixel{1e-9, 1e4};    // px
inline constexpr Bounds sigma_point{1e-12, 1e3};   // m
inline constexpr Bounds repeatability{1e-9, 1};    // rad, m
inline constexpr Bounds time{-1e20, 1e20};         // s
inline constexpr Bounds effect_value{-1e9, 1e9};   // any number of an effect that is typed in
inline constexpr std::size_t longest_name = 500;   // bytes: titles, names of links and joints, paths
inline constexpr std::size_t longest_text = 4000;  // bytes: every other attribute that is no list of numbers
inline constexpr double most_pixels = 64e6;        // of one image

}  // namespace bounds
}  // namespace handsight
