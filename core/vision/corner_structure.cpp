// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_structure.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr int kHalf = 16;                          // directions on half a circle
constexpr std::array<float, 2> kRadii{2.5f, 4.f};  // px: outside of the blur, inside of the cell

struct Circles {
  std::array<std::array<float, 2>, 2 * kHalf * kRadii.size()> points;  // px, circle by circle
};

const Circles& circles() {
  static const Circles made = [] {
    Circles c;
    std::size_t n = 0;
    for (const float radius : kRadii)
      for (int i = 0; i < 2 * kHalf; ++i, ++n) {
        const double angle = M_PI * i / kHalf;
        c.points[n] = {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle))};
      }
    return c;
  }();
  return made;
}

float bilinear(const Image& image, float u, float v) {
  const int x = static_cast<int>(u), y = static_cast<int>(v);  // u and v are not negative
  const float fu = u - static_cast<float>(x), fv = v - static_cast<float>(y);
  const std::uint8_t *a = image.row(y) + x, *b = a + image.width;
  const float upper = a[0] + fu * static_cast<float>(a[1] - a[0]);
  const float lower = b[0] + fu * static_cast<float>(b[1] - b[0]);
  return upper + fv * (lower - upper);
}

// The mean over the circles, of even[i] = I at angle i and opposite, and the squared difference of these two.
struct Profile {
  std::array<float, kHalf> even{};
  std::array<std::array<float, kHalf>, kRadii.size()> single{};  // sum of both, circle by circle
  float odd_square = 0;
};

Profile profile_round(const Image& image, float u, float v) {
  Profile profile;
  std::array<float, 2 * kHalf> ring{};
  const std::array<float, 2>* point = circles().points.data();
  for (auto& single : profile.single)
    for (int i = 0; i < 2 * kHalf; ++i, ++point) {
      const float value = bilinear(image, u + (*point)[0], v + (*point)[1]);
      ring[i] += value, single[i % kHalf] += value;
    }
  constexpr float kScale = 1.f / kRadii.size();
  std::array<float, kHalf> raw;
  for (int i = 0; i < kHalf; ++i) {
    raw[i] = 0.5f * kScale * (ring[i] + ring[i + kHalf]);
    const float odd = 0.5f * kScale * (ring[i] - ring[i + kHalf]);
    profile.odd_square += odd * odd / kHalf;
  }
  for (int i = 0; i < kHalf; ++i)  // noise must not make crossings of its own
    profile.even[i] = 0.25f * (raw[(i + kHalf - 1) % kHalf] + 2 * raw[i] + raw[(i + 1) % kHalf]);
  return profile;
}

// Contrast on the inner circle over that on the outer one (1 of sharp sectors, 0.39 of a bare saddle), with the sectors
// as both together tell them.
float flatness(const Profile& profile, float middle) {
  float inner = 0, outer = 0;
  for (int i = 0; i < kHalf; ++i) {
    const float sign = profile.even[i] < middle ? -1.f : 1.f;
    inner += sign * (profile.single.front()[i] - 2 * middle);
    outer += sign * (profile.single.back()[i] - 2 * middle);
  }
  return inner / std::max(outer, 1e-3f);
}

}  // namespace

std::optional<Lighting> may_be_cross(const Image& image, const Eigen::Vector2i& pixel, double min_contrast,
                                     double noise) {
  constexpr std::array<std::array<int, 2>, 8> kHalfCircle{
      {{3, 0}, {3, 1}, {2, 2}, {1, 3}, {0, 3}, {-1, 3}, {-2, 2}, {-3, 1}}};
  const std::uint8_t* const at = image.row(pixel.y()) + pixel.x();
  std::array<int, 8> sum;
  int opposite = 0, across = 0;
  for (int i = 0; i < 8; ++i) {
    const int offset = kHalfCircle[i][1] * image.width + kHalfCircle[i][0];
    sum[i] = at[offset] + at[-offset];
    opposite += std::abs(at[offset] - at[-offset]);
  }
  for (int i = 0; i < 4; ++i) across += std::abs(sum[i] - sum[i + 4]);
  // A sharp right-angled corner gives 8 times its contrast, 2.5 px of blur and 53 deg leave about 2.6 times.
  // Noise makes 9 sigma of the opposite ones' differences.
  if (!(across > 1.5 * min_contrast)) return std::nullopt;
  const auto beyond = [&](double times) {
    return across > times / 1.5 * opposite && across > times * (opposite - 9 * noise);
  };
  if (beyond(1.5)) return Lighting::even;
  return beyond(0.9) ? std::optional(Lighting::shadowed) : std::nullopt;
}

std::optional<CrossStructure> cross_structure(const Image& image, const Eigen::Vector2d& centre, double min_contrast,
                                              Lighting light) {
  const float reach = kRadii.back() + 1, u = static_cast<float>(centre.x()), v = static_cast<float>(centre.y());
  if (!(u >= reach && v >= reach && u < image.width - reach - 1 && v < image.height - reach - 1)) return std::nullopt;
  const Profile profile = profile_round(image, u, v);
  std::array<float, kHalf> sorted = profile.even;
  std::sort(sorted.begin(), sorted.end());
  constexpr int kFew = kHalf / 5;
  float black = 0, white = 0;
  for (int i = 0; i < kFew; ++i) black += sorted[i] / kFew, white += sorted[kHalf - 1 - i] / kFew;
  const float contrast = white - black, middle = 0.5f * (white + black);
  // Blur of 2.5 px leaves half the contrast at these radii.
  if (contrast < 0.4 * min_contrast) return std::nullopt;
  CrossStructure cross;
  cross.asymmetry = std::sqrt(profile.odd_square) / contrast;
  // Shade over half of the patch makes opposite sectors differ, but less than black from white.
  if (cross.asymmetry > (light == Lighting::even ? 0.32 : 0.5)) return std::nullopt;
  // Measured on right angles: 0.77 at 0.9 px of blur, 0.55 at 2 px; and the circles then miss a part of the contrast.
  // Never sharper than 0.9 px: a start that is off by more than the blur would see no slope.
  cross.blur = std::clamp(2.0 - 5.0 * (flatness(profile, middle) - 0.55), 0.9, 2.5);
  int crossings = 0;
  for (int i = 0; i < kHalf; ++i) {
    const float here = profile.even[i] - middle, next = profile.even[(i + 1) % kHalf] - middle;
    if ((here < 0) == (next < 0)) continue;
    if (crossings == 2) return std::nullopt;
    cross.edges[crossings++] = std::fmod(M_PI / kHalf * (i + here / (here - next)), M_PI);
  }
  if (crossings != 2) return std::nullopt;
  if (cross.edges[0] > cross.edges[1]) std::swap(cross.edges[0], cross.edges[1]);
  const double between = 0.5 * (cross.edges[0] + cross.edges[1]);
  const int index = static_cast<int>(std::lround(between * kHalf / M_PI)) % kHalf;
  cross.level = middle;
  cross.half_contrast = (profile.even[index] > middle ? -0.5 : 0.5) * contrast * (1 + 0.25 * cross.blur * cross.blur);
  // Two thirds: this is a guess yet.
  if (3 * std::abs(cross.half_contrast) < min_contrast) return std::nullopt;
  return cross;
}

}  // namespace handsight
