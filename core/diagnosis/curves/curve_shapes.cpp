// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/curve_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "diagnosis/curves/formula_numbers.h"
#include "diagnosis/curves/place_formulas.h"

namespace handsight {
namespace {

constexpr std::array frequencies{0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0};  // per rad
constexpr std::array quantiles{0.15, 0.3, 0.45, 0.6, 0.75, 0.88};                    // where steps are tried
constexpr std::array decays{0.05, 0.12, 0.3};                                        // of the session
constexpr int most_half_periods = 8;                                                 // of a wave over the session

double root_mean_square(const Eigen::VectorXd& x) {
  const double size = std::sqrt(x.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(x.size(), 1)));
  return size > 0 ? size : 1;
}

/// "(tau_arm_2/12.3)": a torque in units of what is usual on these poses, an angle as it is.
std::string scaled_name(const ShapeVariable& v, double unit) {
  const std::string& name = v.variable->formula;
  return unit == 1 ? name : "(" + name + "/" + short_number(unit) + ")";
}

double usual_size(const Variable& v) {
  return v.kind == VariableKind::torque ? shortened_number(root_mean_square(v.values)) : 1.0;
}

Eigen::ArrayXd share_of_session(const Eigen::VectorXd& t) {
  const double whole = t.maxCoeff() > 0 ? t.maxCoeff() : 1;
  return t.array() / whole;
}

void set_one(CurveShape& s, const Eigen::ArrayXd& values, const std::string& formula) {
  s.values = values.matrix();
  s.formulas = {formula};
}

void set_wave(const ShapeVariable& v, CurveShape& s) {
  const bool over_time = v.variable->kind == VariableKind::time;
  const double factor = shortened_number(over_time ? 2 * std::numbers::pi * s.setting : s.setting);
  const Eigen::ArrayXd phase =
      factor * (over_time ? share_of_session(v.variable->values) : Eigen::ArrayXd(v.variable->values.array()));
  s.values.resize(phase.size(), 2);
  s.values.col(0) = phase.sin();
  s.values.col(1) = phase.cos();
  for (const char* function : {"sin", "cos"})
    s.formulas.push_back(fmt::format("{}({}*{})", function, short_number(factor), v.variable->formula));
  s.text = over_time ? message("a wave of {:.3g} periods over the session", s.setting)
                     : message("sine and cosine of {:.3g} times it", factor);
}

void set_bend(const ShapeVariable& v, CurveShape& s) {
  const Eigen::VectorXd& x = v.variable->values;
  const double middle = shortened_number(x.mean());
  const double reach = shortened_number(std::max((x.maxCoeff() - x.minCoeff()) / 2, 1e-12));
  const Eigen::ArrayXd u = (x.array() - middle) / reach;
  s.values.resize(x.size(), 2);
  s.values.col(0) = u;
  s.values.col(1) = u * u;
  const std::string name = centred_text(v.variable->formula, middle, reach);
  s.formulas = {name, name + "^2"};
  s.text = "a curve of it";
}

double quantile(Eigen::VectorXd x, double share) {
  std::sort(x.begin(), x.end());
  return x[std::clamp<Eigen::Index>(static_cast<Eigen::Index>(share * static_cast<double>(x.size())), 0, x.size() - 1)];
}

}  // namespace

CurveShape make_shape(const ShapeVariable& v, ShapeFamily family, double setting) {
  CurveShape s{family, shortened_number(setting)};
  const double unit = usual_size(*v.variable);
  const Eigen::ArrayXd u = v.variable->values.array() / unit;
  const std::string name = scaled_name(v, unit), k = short_number(setting);
  switch (family) {
    case ShapeFamily::wave:
      set_wave(v, s);
      break;
    case ShapeFamily::line:
      set_one(s, u, name);
      s.text = "in proportion to it";
      break;
    case ShapeFamily::signed_square:
      set_one(s, u * u.abs(), name + "*abs(" + name + ")");
      s.text = "its square, signed";
      break;
    case ShapeFamily::cube:
      set_one(s, u * u * u / 3, name + "^3/3");
      s.text = "its cube";
      break;
    case ShapeFamily::saturation:
      set_one(s, (s.setting * u).tanh(), "tanh(" + k + "*" + name + ")");
      s.text = s.setting > 2 ? "a steep saturation of it" : "a saturation of it";
      break;
    case ShapeFamily::step:
      set_one(s, (v.variable->values.array() > s.setting).cast<double>(),
              "(" + v.variable->formula + " > " + k + " ? 1 : 0)");
      s.text = message("a step at {}{}", k, v.variable->unit.empty() ? std::string() : " " + v.variable->unit);
      break;
    case ShapeFamily::decay:
      set_one(s, (-share_of_session(v.variable->values) / s.setting).exp(),
              "exp(-" + v.variable->formula + "/" + k + ")");
      s.text = message("dying away within {} % of the session", number(short_number(100 * s.setting)));
      break;
    case ShapeFamily::product:
      set_one(s, v.variable->values.array() * v.other->values.array(), v.variable->formula + "*" + v.other->formula);
      s.text = message("its product with the {}", v.other->name);
      break;
    case ShapeFamily::bend:
      set_bend(v, s);
      break;
  }
  if (v.variable->formula.empty()) s.formulas.clear();
  return s;
}

std::vector<CurveShape> list_shapes(const Variable& variable, const std::vector<Variable>& angles) {
  const ShapeVariable v{&variable};
  std::vector<CurveShape> shapes;
  const auto add = [&](ShapeFamily family, double setting, bool at_joint, bool at_rigid) {
    shapes.push_back(make_shape(v, family, setting));
    shapes.back().at_joint = at_joint;
    shapes.back().at_rigid = at_rigid;
  };
  switch (variable.kind) {
    case VariableKind::angle:
      // What the catalogue has at joints itself (waves of one and two turns, a line) is left to it.
      for (const double k : frequencies) add(ShapeFamily::wave, k, k > 2, true);
      add(ShapeFamily::signed_square, 0, true, true);
      for (const double share : quantiles) add(ShapeFamily::step, quantile(variable.values, share), true, true);
      for (const Variable& other : angles)
        if (other.kind == VariableKind::angle && other.joint > variable.joint)
          shapes.push_back(make_shape({&variable, &other}, ShapeFamily::product, 0));
      break;
    case VariableKind::torque:
      add(ShapeFamily::signed_square, 0, true, false);
      add(ShapeFamily::cube, 0, true, false);
      add(ShapeFamily::saturation, 1, true, false);
      add(ShapeFamily::saturation, 3, true, false);
      break;
    case VariableKind::time:
      for (int k = 1; k <= most_half_periods; ++k) add(ShapeFamily::wave, k / 2.0, true, true);
      for (const double k : decays) add(ShapeFamily::decay, k, true, true);
      break;
    case VariableKind::image_u:
    case VariableKind::image_v:
    case VariableKind::depth:
      add(ShapeFamily::bend, 0, false, true);
      break;
    default:
      break;
  }
  return shapes;
}

std::pair<double, double> setting_range(const CurveShape& s) {
  switch (s.family) {
    case ShapeFamily::wave:
      return {std::max(0.3, s.setting - 0.6), s.setting + 0.6};
    case ShapeFamily::saturation:
      return {s.setting / 3, s.setting * 3};
    case ShapeFamily::decay:
      return {s.setting / 2.5, s.setting * 2.5};
    case ShapeFamily::step:
      return {s.setting - 0.4, s.setting + 0.4};
    default:
      return {s.setting, s.setting};
  }
}

}  // namespace handsight
