// SPDX-License-Identifier: Apache-2.0
// Shapes that a deviation without a name may have: functions of one variable (or of two angles) with coefficients.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/message.h"
#include "diagnosis/curves/variables.h"

namespace handsight {

enum class ShapeFamily {
  wave,           // sin(k v), cos(k v); over the session for time, in periods
  line,           // v
  signed_square,  // v |v|
  cube,           // v^3
  saturation,     // tanh(k v)
  step,           // 1 beyond k, 0 before
  decay,          // exp(-v / k), v the share of the session
  product,        // v times another joint's angle
  bend,           // v and v^2: of a place in the image
};

struct CurveShape {
  ShapeFamily family = ShapeFamily::wave;
  double setting = 0;                 // k of the family; 0 where it has none
  Message text;                       // as a user reads it: "sine and cosine of 3.3 times it"
  std::vector<std::string> formulas;  // per function, as effects.xml writes it; empty: cannot be written as one
  Eigen::MatrixXd values;             // observations x functions
  bool at_joint = true, at_rigid = true;
};

/// A variable with everything that its shapes need.
struct ShapeVariable {
  const Variable* variable = nullptr;
  const Variable* other = nullptr;  // of a product
};

/// The shape of a family with this setting.
CurveShape make_shape(const ShapeVariable& v, ShapeFamily family, double setting);

/// All shapes of one variable that are tried. `angles` are the variables that products may take.
std::vector<CurveShape> list_shapes(const Variable& v, const std::vector<Variable>& angles);

/// Settings between this one's neighbours in the list that is tried: where a finer search looks. Equal: nothing to do.
std::pair<double, double> setting_range(const CurveShape& shape);

}  // namespace handsight
