// SPDX-License-Identifier: Apache-2.0
// What a certificate is made from, of a fit of the session or of a calibration file.
#pragma once

#include <string>

#include "certify/certificate.h"

namespace handsight {

/// `options` are those of the fit, `model_from` a phrase that says where its model comes from.
CertificateRequest certificate_request(const Session& session, const Fit& fit, const FitOptions& options,
                                       const ModelUncertainty& model_uncertainty, const std::string& software,
                                       const std::string& model_from);

/// Was the calibration made from this session's own observations? Then it has seen them: its numbers are estimated
/// again in every fold.
bool is_of_session(const Calibration& calibration, const Session& session);

/// The numbers of a calibration of another session of the robot are held as they are (slips and drifts, which were that
/// session's own, left out), and where sensor and body sit is fitted. InputError where it does not fit the robot.
CertificateRequest certificate_request(const Session& session, const Calibration& calibration,
                                       const std::filesystem::path& file, const std::string& software);

}  // namespace handsight
