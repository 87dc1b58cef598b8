// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "certify/certificate_pdf.h"
#include "certify/request.h"
#include "command.h"
#include "diagnosis/selection/improvement.h"
#include "options/named_effects.h"
#include "printing/certificate_output.h"
#include "printing/outputs.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

constexpr char software[] = "handsight " HANDSIGHT_VERSION;

struct CertifyArguments {
  std::string session, calibration, file;
  std::vector<std::string> effects;
  Output output;
};

/// The model that `improve` finds.
CertificateRequest from_improvement(const Session& session, Progress& progress) {
  ImprovementOptions options;
  options.on_progress = [&](double done) {
    progress.at(static_cast<std::size_t>(60 * done));
    return true;
  };
  const Improvement m = improve(session, options);
  return certificate_request(session, m.last.model.fit, m.last.model_options, m.certainty.doubt, software,
                             "found by improve in this session");
}

CertificateRequest from_effects(const Session& session, const std::vector<std::string>& effects) {
  FitOptions options;
  add_effects(effects, session, options.effects, options.estimated);
  return certificate_request(session, fit(session, options), options, {}, software,
                             fmt::format("the effects {}, fitted in this session", fmt::join(effects, " ")));
}

CertificateRequest request_of(const CertifyArguments& o, const Session& session, Progress& progress) {
  if (!o.calibration.empty()) {
    if (!o.effects.empty())
      throw InputError(fmt::format("{}: a calibration holds its effects already; leave --effects out.", o.calibration));
    return certificate_request(session, read_calibration(o.calibration), o.calibration, software);
  }
  return o.effects.empty() ? from_improvement(session, progress) : from_effects(session, o.effects);
}

int run(const CertifyArguments& o) {
  note_input(o.calibration);
  const Session session = open_searched_session(o.session, o.output);
  require_output(o.file, "--out");
  if (session.robot.is_of_poses)
    throw InputError(
        "A certificate is of a robot with joints, and the session knows only where its flange is said to be; record "
        "the "
        "joint angles and convert them with the robot's URDF.");
  Progress progress("certify", 100);
  const CertificateRequest request = request_of(o, session, progress);
  const Certificate c = certificate_of(session, request, [&](double done) {
    progress.at(static_cast<std::size_t>(60 + 40 * done));
    return true;
  });
  const std::string pdf = certificate_pdf(c);
  o.output.json(certificate_json(c));
  if (o.file == "-") {
    std::cout << pdf;
    return done;
  }
  write_output(o.file, pdf, "--out");
  print_certificate(o.output, c);
  o.output.line("Written: " + o.file);
  return done;
}

}  // namespace

Command add_certify(const CommandLine& program) {
  auto options = std::make_shared<CertifyArguments>();
  const CommandLine command = program.command(
      "certify", "A certificate as PDF: errors before and after by ISO 9283, promised limits and how often they held");
  add_session_option(command, options->session);
  command.option("CALIBRATION", options->calibration,
                 "A calibration XML; without it and --effects the model is the one that improve finds");
  command.option("--effects", options->effects, "Effects in the model, in place of a calibration");
  command.option("--out", options->file, "The PDF to write; - is standard output").required();
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
