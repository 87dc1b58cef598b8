// SPDX-License-Identifier: Apache-2.0
// A camera that is not the detector's own idea of one: it averages over the pixel's area and knows lens distortion,
// blur, glare, Bayer patterns with usual demosaicing, gamma, sharpening, clipping and JPEG. It looks at boards before
// things that are none.
#pragma once

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "vision/corners/corner_images.h"

namespace handsight::corner_images {

enum class Mosaic { none, bilinear, edge_aware };
enum class Ground { plain, things, texture };

using Range = std::array<double, 2>;

/// What a picture is drawn from, each uniformly; grey levels are those of linear light, 255 the brightest.
struct Conditions {
  int width = 320, height = 240;
  Range cell{10, 24};         // px, of a cell seen at right angles
  Range tilt{0, 0.9};         // rad
  Range contrast{60, 180};    // grey levels
  Range blur{0.4, 1.6};       // px, of the lens
  Range noise{0.7, 3};        // grey levels
  Range distortion{-.1, .1};  // radial, at half the picture's diagonal
  Range gradient{0, 0};       // 1/px, of the light
  Range gamma{1, 1};
  Range sharpening{0, 0};   // of the difference to what is blurred
  Range halo{1, 1};         // px, by how much
  Range glare{0, 0};        // grey levels, of a soft spot of added light
  Range exposure{1, 1};     // more than 1 clips white
  Range shade{1, 1};        // light beyond a shadow's edge through the board
  Range penumbra{2, 2};     // px, of that edge
  Range shade_bend{0, 0};   // 1/px, of that edge
  Range quality{100, 100};  // of the JPEG; 100: none
  Mosaic mosaic = Mosaic::none;
  Ground ground = Ground::plain;
  bool with_board = true;
  bool with_exact = false;  // tells Picture::exact too
};

struct TrueCorner {
  Eigen::Vector2d position{0, 0};  // px
  double smallest_cell = 0;        // px, the shortest way across a cell
  double bound = 0;                // px an axis, of Cramer and Rao's; 0: not worked out
  double shadow_distance = 1e9;    // px, to the shadow's edge
  double visible = 1;              // of the contrast, what clipping leaves
  double contrast = 0;             // grey levels, what light and clipping leave
  Eigen::Vector2d in_cells{0, 0};  // on the board
};

/// A shadow's straight edge: light falls by `depth` of itself beyond a line, softly.
struct ShadowLine {
  double direction = 0, distance = 1e9, depth = 0;  // rad and px, from the corner
};

struct Picture {
  Image image;
  std::vector<TrueCorner> corners;      // of the board, where no margin is left out
  std::vector<Eigen::Vector2d> at_rim;  // where the board's outermost edges meet: neither right nor wrong
  double cell = 0, tilt = 0, blur = 0, contrast = 0, noise = 0;
  cv::Mat exact;                                               // without noise, rounding and compression, if asked for
  std::function<Eigen::Vector2d(double u, double v)> cells;    // where on the board a point of the image is
  std::function<double(double u, double v)> light;             // the light's factor there
  std::function<ShadowLine(const TrueCorner& corner)> shadow;  // as seen from a corner
};

/// Things of all sizes before each other, as photographs have them, with the bars, chains and crossing lines that look
/// like corners to some; smooth texture that fills everything with saddles.
inline cv::Mat ground_of(Ground ground, int width, int height, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  if (ground == Ground::texture) {
    const double pitch = uniform(3, 9);
    cv::Mat coarse(static_cast<int>(height / pitch) + 4, static_cast<int>(width / pitch) + 4, CV_32F), fine;
    cv::randu(coarse, 20, 220);
    for (int v = 0; v < coarse.rows; ++v)
      for (int u = 0; u < coarse.cols; ++u) coarse.at<float>(v, u) = static_cast<float>(uniform(20, 220));
    cv::resize(coarse, fine, {width, height}, 0, 0, cv::INTER_CUBIC);
    return fine;
  }
  cv::Mat mat(height, width, CV_8U, cv::Scalar(uniform(40, 200)));
  if (ground == Ground::things) {
    const auto grey = [&] { return cv::Scalar(uniform(15, 240)); };
    const auto place = [&] {
      const double y = uniform(0, height), x = uniform(0, width);  // in an order that no compiler chooses
      return cv::Point(static_cast<int>(x * 16), static_cast<int>(y * 16));
    };
    const int count = static_cast<int>(width * height / 250.0);
    for (int n = 0; n < count; ++n) {
      const double size = 3 / std::sqrt((n + 1.0) / count);  // many small ones, few large: an inverse cube
      const cv::Point at = place();
      const int kind = static_cast<int>(uniform(0, 10)), s = static_cast<int>(16 * std::min(size, 0.25 * width));
      const double angle = uniform(0, 2 * M_PI);
      const auto off = [&](double along, double across) {
        return cv::Point(at.x + static_cast<int>(s * (along * std::cos(angle) - across * std::sin(angle))),
                         at.y + static_cast<int>(s * (along * std::sin(angle) + across * std::cos(angle))));
      };
      if (kind < 4) {
        cv::circle(mat, at, s, grey(), cv::FILLED, cv::LINE_AA, 4);
      } else if (kind < 8) {
        const double across = uniform(0.2, 1);
        const std::vector<cv::Point> box{off(-1, -across), off(1, -across), off(1, across), off(-1, across)};
        cv::fillConvexPoly(mat, box, grey(), cv::LINE_AA, 4);
      } else if (kind == 8) {
        cv::line(mat, off(-6, 0), off(6, 0), grey(), 1 + n % 3, cv::LINE_AA, 4);
      } else if (n % 4 == 0) {  // a chain
        const cv::Scalar both = grey();
        for (int k = -4; k <= 4; ++k) cv::circle(mat, off(1.1 * k, 0), s / 2, both, cv::FILLED, cv::LINE_AA, 4);
      }
    }
  }
  cv::Mat real;
  mat.convertTo(real, CV_32F);
  return real;
}

namespace camera_detail {

struct Taken {  // one picture's numbers
  int columns = 0, rows = 0;
  View view;
  double distortion = 0, half_diagonal = 1;
  Eigen::Vector2d middle{0, 0};
  Light light;
  double gamma = 1;

  Eigen::Vector2d straight(double u, double v) const {
    const Eigen::Vector2d off = Eigen::Vector2d(u, v) - middle;
    return middle + off * (1 + distortion * off.squaredNorm() / (half_diagonal * half_diagonal));
  }
  Eigen::Vector2d cells(double u, double v) const {
    const Eigen::Vector2d at = straight(u, v);
    return view.cells(at.x(), at.y());
  }
  Eigen::Vector2d make_image(double i, double j) const {
    const Eigen::Vector2d at = (view.cells_from_image.inverse() * Eigen::Vector3d(i, j, 1)).hnormalized();
    Eigen::Vector2d bent = at;
    for (int n = 0; n < 30; ++n) bent += at - straight(bent.x(), bent.y());
    return bent;
  }
  bool in_paper(const Eigen::Vector2d& c) const {
    return std::abs(c.x()) < 0.5 * columns + 0.6 && std::abs(c.y()) < 0.5 * rows + 0.6;
  }
  double paper(const Eigen::Vector2d& c) const {
    const Eigen::Vector2d at(c.x() + 0.5 * columns, c.y() + 0.5 * rows);
    const bool inside = at.x() > 0 && at.y() > 0 && at.x() < columns && at.y() < rows;
    const bool black = inside && ((static_cast<int>(at.x()) + static_cast<int>(at.y())) & 1) == 0;
    return black ? light.black : light.white;
  }
};

// Mean light of each of fine x fine parts of every pixel; parts that an edge crosses are read at 9 points.
inline cv::Mat fine_image(const Taken& taken, const cv::Mat& ground, int fine) {
  const int width = ground.cols, height = ground.rows;
  cv::Mat image(fine * height, fine * width, CV_32F);
  const auto behind = [&](double u, double v) {
    return ground.at<float>(std::clamp(static_cast<int>(std::lround(v)), 0, height - 1),
                            std::clamp(static_cast<int>(std::lround(u)), 0, width - 1));
  };
  const auto value = [&](double u, double v) -> double {
    const Eigen::Vector2d at = taken.cells(u, v);
    return taken.columns > 0 && taken.in_paper(at) ? taken.paper(at) : behind(u, v);
  };
  const double step = 1.0 / fine;
  std::vector<Eigen::Vector2d> upper(static_cast<std::size_t>(fine * width) + 1), lower(upper.size());
  const auto corners_of_row = [&](int y, std::vector<Eigen::Vector2d>& to) {
    for (int x = 0; x <= fine * width; ++x) to[x] = taken.cells(x * step - 0.5, y * step - 0.5);
  };
  corners_of_row(0, lower);
  for (int y = 0; y < fine * height; ++y) {
    std::swap(upper, lower);
    corners_of_row(y + 1, lower);
    for (int x = 0; x < fine * width; ++x) {
      const std::array<Eigen::Vector2d, 4> c{upper[x], upper[x + 1], lower[x], lower[x + 1]};
      const Eigen::Vector2d half(0.5 * taken.columns, 0.5 * taken.rows);
      bool same = true;
      for (int k = 1; k < 4 && same; ++k)
        same = (c[k] + half).array().floor().isApprox((c[0] + half).array().floor()) &&
               taken.in_paper(c[k]) == taken.in_paper(c[0]);
      const double u = (x + 0.5) * step - 0.5, v = (y + 0.5) * step - 0.5;
      double sum = 0;
      if (same) {
        sum = value(u, v);
      } else {
        for (int i = 0; i < 9; ++i)
          sum += value((x + (i + 0.5) / 9) * step - 0.5, (y + ((2 * i + 5) % 9 + 0.5) / 9) * step - 0.5) / 9;
      }
      image.at<float>(y, x) =
          static_cast<float>(sum * light_at(taken.light, Eigen::Vector2d(u, v) - taken.view.corner));
    }
  }
  return image;
}

// The raw picture through a colour filter and back; the scene is grey.
inline cv::Mat demosaiced(const cv::Mat& linear, Mosaic mosaic) {
  cv::Mat raw, colour, channels[3];
  linear.convertTo(raw, CV_16U, 200);
  cv::demosaicing(raw, colour, mosaic == Mosaic::bilinear ? cv::COLOR_BayerBG2BGR : cv::COLOR_BayerBG2BGR_EA);
  cv::split(colour, channels);
  cv::Mat grey = (0.114 * channels[0] + 0.587 * channels[1] + 0.299 * channels[2]);
  cv::Mat real;
  grey.convertTo(real, CV_32F, 1.0 / 200);
  return real;
}

// What happens in the camera after the sensor.
struct Development {
  Mosaic mosaic = Mosaic::none;
  double gamma = 1, sharpening = 0, halo = 1;
};

inline void develop(const Development& development, cv::Mat& image) {
  if (development.mosaic != Mosaic::none) image = demosaiced(image, development.mosaic);
  if (development.gamma != 1) {
    image /= 255;
    cv::pow(image, 1 / development.gamma, image);
    image *= 255;
  }
  if (development.sharpening > 0) {
    cv::Mat soft;
    cv::GaussianBlur(image, soft, {0, 0}, development.halo);
    image += development.sharpening * (image - soft);
  }
}

}  // namespace camera_detail

inline Picture take(const Conditions& conditions, std::mt19937& random) {
  const auto within = [&](const Range& r) { return std::uniform_real_distribution<double>(r[0], r[1])(random); };
  const int width = conditions.width, height = conditions.height;
  camera_detail::Taken taken;
  Picture picture;
  picture.cell = within(conditions.cell), picture.tilt = within(conditions.tilt);
  picture.contrast = within(conditions.contrast), picture.blur = within(conditions.blur);
  taken.middle = {0.5 * (width - 1), 0.5 * (height - 1)}, taken.half_diagonal = 0.5 * std::hypot(width, height);
  taken.distortion = within(conditions.distortion);
  const double off_y = within({-.1, .1}) * height, off_x = within({-.1, .1}) * width;
  const Eigen::Vector2d centre(taken.middle.x() + off_x, taken.middle.y() + off_y);
  const double second_turn = within({0, 2 * M_PI}), first_turn = within({0, 2 * M_PI});
  taken.view = find_view(centre, picture.cell, picture.tilt, first_turn, second_turn, 1.2 * width);
  if (conditions.with_board) {
    taken.columns = std::clamp(static_cast<int>(0.8 * width / picture.cell), 3, 40);
    taken.rows = std::clamp(static_cast<int>(0.8 * height / picture.cell), 3, 30);
  }
  Light& light = taken.light;
  light.black = within({12, std::max(235 - picture.contrast, 13.0)}), light.white = light.black + picture.contrast;
  const double turn = within({0, 2 * M_PI});
  light.gradient = within(conditions.gradient) * Eigen::Vector2d(std::cos(turn), std::sin(turn));
  light.shade = within(conditions.shade), light.shade_angle = within({0, 2 * M_PI});
  light.shade_distance = within({-.2, .2}) * height;
  const auto drawn = [&](const Range& r) { return r[0] < r[1] ? within(r) : r[0]; };  // what all have is not drawn
  light.penumbra = drawn(conditions.penumbra), light.shade_bend = drawn(conditions.shade_bend);
  const int fine = width * height > 1e6 ? 2 : 4;
  const cv::Mat ground = ground_of(conditions.ground, width, height, random);
  cv::Mat image = camera_detail::fine_image(taken, ground, fine);
  if (picture.blur > 0) {
    const int size = 2 * static_cast<int>(std::ceil(4 * picture.blur * fine)) + 1;
    cv::GaussianBlur(image, image, {size, size}, picture.blur * fine, picture.blur * fine, cv::BORDER_REPLICATE);
  }
  if (fine > 1) {
    cv::Mat whole;
    cv::resize(image, whole, {width, height}, 0, 0, cv::INTER_AREA);
    image = whole;
  }
  // Light that comes from beside: neither what the paper reflects nor blurred by the lens.
  const double glare = within(conditions.glare), spot = within({0.1, 0.35}) * width;
  const double shine_down = within({-.25, .25}) * height, shine_across = within({-.25, .25}) * width;
  const Eigen::Vector2d shine = centre + Eigen::Vector2d(shine_across, shine_down);
  const double exposure = within(conditions.exposure), noise = within(conditions.noise);
  std::normal_distribution<float> normal(0, static_cast<float>(noise));
  cv::Mat exact(conditions.with_exact ? height : 0, conditions.with_exact ? width : 0, CV_32F);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      float& at = image.at<float>(v, u);
      if (glare > 0)
        at +=
            static_cast<float>(glare * std::exp(-0.5 * (Eigen::Vector2d(u, v) - shine).squaredNorm() / (spot * spot)));
      if (conditions.with_exact) exact.at<float>(v, u) = std::clamp(static_cast<float>(exposure) * at, 0.f, 255.f);
      at = std::clamp(static_cast<float>(exposure) * at + normal(random), 0.f, 255.f);
    }
  camera_detail::Development development{conditions.mosaic, within(conditions.gamma), within(conditions.sharpening)};
  if (development.sharpening > 0) development.halo = within(conditions.halo);
  camera_detail::develop(development, image);
  if (conditions.with_exact) camera_detail::develop(development, exact), picture.exact = exact;
  cv::Mat whole;
  image.convertTo(whole, CV_8U);
  const double quality = within(conditions.quality);
  if (quality < 100) {
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", whole, bytes, {cv::IMWRITE_JPEG_QUALITY, static_cast<int>(quality)});
    whole = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  }
  picture.image = as_image(whole), picture.noise = noise;
  picture.cells = [taken](double u, double v) { return taken.cells(u, v); };
  picture.light = [taken](double u, double v) {
    return light_at(taken.light, Eigen::Vector2d(u, v) - taken.view.corner);
  };
  picture.shadow = [taken](const TrueCorner& corner) {
    const Light& own = taken.light;
    if (own.shade == 1) return ShadowLine{};
    const Eigen::Vector2d off = corner.position - taken.view.corner;
    const double distance =
        own.shade_distance - off.x() * std::cos(own.shade_angle) - off.y() * std::sin(own.shade_angle);
    return ShadowLine{own.shade_angle, distance, 1 - own.shade};
  };
  const double margin = 8 + 2 * picture.blur;
  for (int j = 0; j <= taken.rows && conditions.with_board; ++j)
    for (int i = 0; i <= taken.columns; ++i) {
      const double x = i - 0.5 * taken.columns, y = j - 0.5 * taken.rows;
      TrueCorner corner;
      corner.position = taken.make_image(x, y), corner.in_cells = {x, y};
      const bool in_view = corner.position.x() > margin && corner.position.y() > margin &&
                           corner.position.x() < width - 1 - margin && corner.position.y() < height - 1 - margin;
      if (i == 0 || j == 0 || i == taken.columns || j == taken.rows || !in_view) {
        picture.at_rim.push_back(corner.position);
        continue;
      }
      const Eigen::Vector2d right = taken.make_image(x + 1, y) - corner.position,
                            down = taken.make_image(x, y + 1) - corner.position;
      const double area = std::abs(right.x() * down.y() - right.y() * down.x());
      corner.smallest_cell = area / std::max(right.norm(), down.norm());
      Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
      shift(0, 2) = -x, shift(1, 2) = -y;
      View local = taken.view;
      const Eigen::Vector2d ideal = (local.cells_from_image.inverse() * Eigen::Vector3d(x, y, 1)).hnormalized();
      local.corner = ideal, local.cells_from_image = shift * local.cells_from_image;
      if (picture.cell < 40)
        corner.bound = std::sqrt(bound(local, exposure * picture.contrast, picture.blur, noise).trace() / 2);
      const double lit = light_at(light, corner.position - taken.view.corner);
      const double added = glare * std::exp(-0.5 * (corner.position - shine).squaredNorm() / (spot * spot));
      const auto seen = [&](double paper) { return std::min(exposure * (paper * lit + added), 255.0); };
      corner.contrast = seen(light.white) - seen(light.black);
      corner.visible = corner.contrast / (exposure * lit * picture.contrast);
      if (light.shade != 1) {
        const Eigen::Vector2d off = corner.position - taken.view.corner;
        const Eigen::Vector2d to_shadow(std::cos(light.shade_angle), std::sin(light.shade_angle));
        const double aside = to_shadow.x() * off.y() - to_shadow.y() * off.x();
        corner.shadow_distance =
            std::abs(light.shade_distance + 0.5 * light.shade_bend * aside * aside - to_shadow.dot(off));
      }
      picture.corners.push_back(corner);
    }
  return picture;
}

}  // namespace handsight::corner_images
