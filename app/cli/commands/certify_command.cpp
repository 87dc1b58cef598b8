// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "certify/certificate_pdf.h"
#include "certify/request.h"
#include "command.h"
#include "diagnosis/selection/improvement.h"
#include "estimation/fit/part_fit.h"
#include "options/named_effects.h"
#include "printing/certificate_output.h"
#include "printing/outputs.h"
#include "session/calibration_xml.h"
#include "session/joined.h"

namespace handsight::cli {
namespace {

constexpr char software[] = "handsight " HANDSIGHT_VERSION;

struct CertifyArguments {
  std::string session, part, calibration, file;
  std::vector<std::string> effects;
  Output output;
};

/// The model that `improve` finds.
CertificateRequest from_improvement(const Session& session, Progress& progress) {
  ImprovementOptions options;
  options.with_choosing = false;
  options.on_progress = [&](double done) {
    progress.at(static_cast<std::size_t>(60 * done));
    return true;
  };
  const Improvement m = improve(session, options);
  return certificate_request(session, m.last.model.fit, m.last.model_options,
                             m.inclusion_probabilities.model_uncertainty, software, "found by improve in this session");
}

CertificateRequest from_effects(const Session& session, const std::vector<std::string>& effects) {
  FitOptions options;
  add_effects(effects, session, options.effects, options.estimated);
  return certificate_request(session, fit(session, options), options, {}, software,
                             fmt::format("the effects {}, fitted in this session", fmt::join(effects, " ")));
}

/// One session of a collection, with the robot that all of them tell.
PartFit part_of_collection(const CertifyArguments& o, const std::string& title, const Session& joined,
                           Progress& progress) {
  const int part = part_named(joined, title);
  if (!o.calibration.empty() || !o.effects.empty()) {
    PartFit alone;
    alone.session = part_session(joined, part);
    return alone;
  }
  ImprovementOptions options;
  options.on_progress = [&](double done) {
    progress.at(static_cast<std::size_t>(60 * done));
    return true;
  };
  return fit_of_part(joined, improve(joined, options).last.model.fit, part);
}

/// The robot stays as all sessions tell it; what is the session's own is fitted.
CertificateRequest from_collection(const PartFit& part, const std::string& title) {
  FitOptions options;
  options.effects = list_terms(part.fit);
  return certificate_request(part.session, fit(part.session, options), options, {}, software,
                             fmt::format("found by improve in the collection {}", title));
}

CertificateRequest request_of(const CertifyArguments& o, const Session& session, Progress& progress) {
  if (!o.calibration.empty()) {
    if (!o.effects.empty())
      throw InputError(message("{}: a calibration holds its effects already; leave --effects out.", o.calibration));
    return certificate_request(session, read_calibration(o.calibration), o.calibration, software);
  }
  return o.effects.empty() ? from_improvement(session, progress) : from_effects(session, o.effects);
}

/// The session of a collection that is certified: the one that was named, else the first that is not touched.
std::string part_to_certify(const Session& session, const std::string& named) {
  if (!named.empty()) return named;
  const auto first =
      std::find_if(session.parts.begin(), session.parts.end(), [](const SessionPart& p) { return p.fixture < 0; });
  return first == session.parts.end() ? "" : first->title;
}

void refuse_touches(const Session& session, const std::string& part) {
  const bool all_touch = !session.parts.empty() && part.empty();
  const auto named = session.parts.empty() || part.empty() ? -1 : part_named(session, part);
  if (session.is_touch() || all_touch || (named >= 0 && session.parts[static_cast<std::size_t>(named)].fixture >= 0))
    throw InputError(
        "A certificate needs measurements of where the hand is, and a touch tells one to three numbers of it; measure "
        "some poses with a tracker or cameras, and certify that session with the calibration.");
}

int run(const CertifyArguments& o) {
  note_input(o.calibration);
  Session session = open_searched_session(o.session, o.output);
  require_output(o.file, "--out");
  if (session.robot.is_of_poses)
    throw InputError(
        "A certificate is of a robot with joints, and the session knows only where its flange is said to be; record "
        "the "
        "joint angles and convert them with the robot's URDF.");
  Progress progress("certify", 100);
  const std::string part_title = part_to_certify(session, o.part);
  refuse_touches(session, part_title);
  if (session.parts.empty() && !o.part.empty()) part_named(session, o.part);
  std::optional<CertificateRequest> of_part;
  if (!session.parts.empty()) {
    const std::string title = session.title;
    const PartFit part = part_of_collection(o, part_title, session, progress);
    if (o.calibration.empty() && o.effects.empty()) of_part = from_collection(part, title);
    session = part.session;
  }
  const CertificateRequest request = of_part ? *of_part : request_of(o, session, progress);
  const Certificate c = make_certificate(session, request, [&](double done) {
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
  command.option("--session", options->part,
                 "Of a collection: the session that is certified; absent: its first that is not touched");
  command.option("CALIBRATION", options->calibration,
                 "A calibration XML; without it and --effects the model is the one that improve finds");
  command.option("--effects", options->effects, "Effects in the model, in place of a calibration");
  command.option("--out", options->file, "The PDF to write; - is standard output").required();
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
