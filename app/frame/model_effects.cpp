// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame/model_effects.h"

namespace handsight::app {
namespace {

constexpr double degrees = 57.29577951308232;

/// x y z in mm, then roll pitch yaw in degrees.
std::vector<widgets::ModelParameter> six_parameters(const Rigid& motion, const Vector6& sigma) {
  const char* names[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  const Vector3 rpy = rpy_from_rotation(motion.rotation);
  std::vector<widgets::ModelParameter> list;
  for (int i = 0; i < 6; ++i) {
    const double scale = i < 3 ? 1e3 : degrees;
    widgets::ModelParameter p{.name = names[i], .unit = i < 3 ? "mm" : "deg"};
    p.value = scale * (i < 3 ? motion.translation[i] : rpy[i - 3]);
    p.sigma = scale * sigma[i];
    list.push_back(p);
  }
  return list;
}

}  // namespace

std::vector<widgets::ModelEffect> model_effects(const Document& document) {
  const ModelVersionPointer model = document.shown_model();
  if (!model || !model->fit) return {};
  const Fit& fit = *model->fit;
  std::vector<widgets::ModelEffect> list;
  widgets::ModelEffect body{.id = "tcp_from_body", .title = QObject::tr("TCP→Body"), .is_in_model = true};
  body.is_permanent = true;
  body.help = QObject::tr(
      "Where the marker body sits on the hand. Sigma is that of the body's origin, and of the "
      "rotations about the TCP's axes.");
  body.parameters = six_parameters(fit.tcp_from_body, origin_sigma(fit));
  if (fit.covariance_kind == CovarianceKind::scatter) {
    body.note =
        QObject::tr("Sigmas from how the observations differ: the model does not agree with them to the noise.");
    body.note_is_warning = true;
  }
  list.push_back(std::move(body));
  if (document.session().mount.estimate) {
    widgets::ModelEffect mount{.id = "mount", .title = QObject::tr("Camera mount"), .is_in_model = true};
    mount.is_permanent = true;
    mount.help = QObject::tr("Where the cameras sit on %1, estimated with the rest.")
                     .arg(QString::fromStdString(document.session().mount.link));
    mount.parameters =
        six_parameters(estimate(fit).mount_from_sensor,
                       fit.parameter_covariance.bottomRightCorner<6, 6>().diagonal().cwiseMax(0).cwiseSqrt());
    list.push_back(std::move(mount));
  }
  return list;
}

}  // namespace handsight::app
