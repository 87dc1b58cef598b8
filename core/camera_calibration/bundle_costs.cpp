// SPDX-License-Identifier: Apache-2.0
#include "camera_calibration/bundle_costs.h"

#include <span>

#include "camera_calibration/bent_board.h"

namespace handsight {
namespace {

/// d (motion x) / d six: the motion's own numbers, 3 x 6.
Eigen::Matrix<double, 3, 6> moved_by(const double* six, const Vector3& turned_point) {
  Eigen::Matrix<double, 3, 6> m;
  m.leftCols<3>().setIdentity();
  m.rightCols<3>() = -cross_matrix<double>(turned_point) * left_jacobian(Vector3(six[3], six[4], six[5]));
  return m;
}

/// Ceres's losses act on whole blocks; here each point has its own weight, settled between solutions.
class ImageCost : public ceres::CostFunction {
 public:
  ImageCost(const BoardImages& images, int camera, const LensModel& model, std::vector<TargetPixel> points,
            std::vector<double> weights, ShapeBlock shape)
      : images_(images),
        middle_(shape == ShapeBlock::bend ? find_middle(images.points) : Vector3::Zero()),
        is_first_(camera == 0),
        model_(model),
        points_(std::move(points)),
        weights_(std::move(weights)),
        shape_(shape) {
    set_num_residuals(2 * static_cast<int>(points_.size()));
    auto& sizes = *mutable_parameter_block_sizes();
    sizes.push_back(static_cast<int>(model.numbers.size()));
    sizes.push_back(6);
    if (!is_first_) sizes.push_back(6);
    if (shape_ != ShapeBlock::none) sizes.push_back(3);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const auto count = model_.numbers.size();
    const std::span<const double> numbers(parameters[0], count);
    const Rigid pose = make_rigid(parameters[1]), placement = is_first_ ? Rigid{} : make_rigid(parameters[2]);
    const std::size_t last = parameter_block_sizes().size() - 1;
    LensProjection p;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Matrix3 by_shape;
      const Vector3 turned = pose.rotation * place(i, parameters[last], by_shape);
      const Vector3 in_first = turned + pose.translation;
      const Vector3 turned_again = placement.rotation * in_first;
      const Vector3 in_camera = turned_again + placement.translation;
      if (!model_.sees(numbers, in_camera)) return false;
      model_.project(numbers, in_camera, p);
      const double weight = weights_[i];
      const auto row = static_cast<Eigen::Index>(2 * i);
      Eigen::Map<Vector2>(residuals + row) = weight * (p.pixel - points_[i].pixel);
      if (!jacobians) continue;
      if (jacobians[0]) take_rows(jacobians[0], static_cast<Eigen::Index>(count), row) = weight * p.by_numbers;
      if (jacobians[1])
        take_rows(jacobians[1], 6, row) = weight * p.by_point * placement.rotation * moved_by(parameters[1], turned);
      if (!is_first_ && jacobians[2])
        take_rows(jacobians[2], 6, row) = weight * p.by_point * moved_by(parameters[2], turned_again);
      if (shape_ != ShapeBlock::none && jacobians[last])
        take_rows(jacobians[last], 3, row) = weight * p.by_point * placement.rotation * pose.rotation * by_shape;
    }
    return true;
  }

 private:
  using Block = Eigen::Map<Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor>>;
  static Block take_rows(double* jacobian, Eigen::Index columns, Eigen::Index row) {
    return {jacobian + row * columns, 2, columns};
  }

  Vector3 place(std::size_t i, const double* shape, Matrix3& by_shape) const {
    if (shape_ == ShapeBlock::point) {
      by_shape.setIdentity();
      return Vector3(shape[0], shape[1], shape[2]);
    }
    const Vector3& described = images_.points[static_cast<std::size_t>(points_[i].number)];
    return shape_ == ShapeBlock::none
               ? described
               : bent_point(described, middle_, Vector3(shape[0], shape[1], shape[2]), &by_shape);
  }

  const BoardImages& images_;
  Vector3 middle_;
  bool is_first_;
  const LensModel& model_;
  std::vector<TargetPixel> points_;
  std::vector<double> weights_;
  ShapeBlock shape_;
};

class PlaceCost : public ceres::SizedCostFunction<3, 3> {
 public:
  PlaceCost(const Vector3& described, const Vector3& weight) : described_(described), weight_(weight) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    Eigen::Map<Vector3>(residuals, 3) =
        weight_.cwiseProduct(Vector3(parameters[0][0], parameters[0][1], parameters[0][2]) - described_);
    if (jacobians && jacobians[0])
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(jacobians[0], 3, 3) = weight_.asDiagonal();
    return true;
  }

 private:
  Vector3 described_, weight_;
};

}  // namespace

Six make_six(const Rigid& motion) {
  const Vector3 w = vector_from_rotation(motion.rotation);
  return {motion.translation.x(), motion.translation.y(), motion.translation.z(), w.x(), w.y(), w.z()};
}

Rigid make_rigid(const double* six) { return small_motion<double>(Vector6(Eigen::Map<const Vector6>(six))); }

std::unique_ptr<ceres::CostFunction> image_cost(const BoardImages& images, int camera, const LensModel& model,
                                                std::vector<TargetPixel> points, std::vector<double> weights,
                                                ShapeBlock shape) {
  return std::make_unique<ImageCost>(images, camera, model, std::move(points), std::move(weights), shape);
}

std::unique_ptr<ceres::CostFunction> place_cost(const Vector3& described, const Vector3& weight) {
  return std::make_unique<PlaceCost>(described, weight);
}

}  // namespace handsight
