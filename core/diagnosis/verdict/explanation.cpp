// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/explanation.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "base/percent.h"
#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/robot_check.h"
#include "effects/units.h"

namespace handsight {
namespace {

Message odds(double ln_bayes_factor) {
  if (ln_bayes_factor > 13.8) return "more than a million to one";
  if (ln_bayes_factor > 0) return message("about {:.0f} to one", std::exp(ln_bayes_factor));
  return "none";
}

Message noise_text(const Diagnosis& d) {
  if (!d.noise) return "unknown";
  const bool in_pixels = !d.model.session.is_tracker();
  return reported_size(*reported_noise(d.noise, d.report.rms_of_noise_m, in_pixels), in_pixels);
}

/// "compliance of arm_2 1.2e-04 +- 3e-06 rad/(N m)"
Message numbers_text(const DiagnosisCandidate& c, const Session& session) {
  std::vector<Message> texts;
  int listed_ones = 0;
  for (std::size_t t = 0; t < c.terms.size(); ++t) {
    const Effect& effect = term_effect(c.terms[t]);
    const std::string place = place_name(effect, c.terms[t].place, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      if (++listed_ones > 6) return joined(texts) + ", ...";
      const Message name = looked_up(effect.parameters[p].name);
      texts.push_back(message("{} {:.3g} +- {:.1g} {}", place.empty() ? name : message("{} of {}", name, place),
                              c.terms[t].values[p], c.sigmas[t][p],
                              unit_at(effect, p, c.terms[t].place, session.robot)));
    }
  }
  return joined(texts);
}

Message speaks_for(const DiagnosisCandidate& c, const Diagnosis& d) {
  for (const DiagnosisPattern& p : d.patterns) {
    const bool own = p.against.joint < 0 || c.where.empty();
    for (const EffectTerm& term : c.terms)
      if (own || term.place == p.against.joint)
        return message(" The residual \"{}\" follows the {}.", p.residual.name, p.against.name);
  }
  return "";
}

}  // namespace

Message listed(const std::vector<std::string>& names) { return joined(verbatim(names), ", ", " and "); }

Message listed_places(const std::vector<std::string>& where) {
  std::vector<Message> places;
  for (const std::string& place : where) {
    int n = 0, length = 0;
    const auto is_all = [&] { return length == static_cast<int>(place.size()); };
    if (std::sscanf(place.c_str(), "marker %d%n", &n, &length) == 1 && is_all())
      places.push_back(message("marker {}", n));
    else if (std::sscanf(place.c_str(), "from observation %d on%n", &n, &length) == 1 && is_all())
      places.push_back(message("from observation {} on", n));
    else
      places.push_back(verbatim(place));
  }
  return joined(places, ", ", " and ");
}

Message error_text(const ErrorSummary& e) {
  if (e.rms_pixel) return message("{:.3g} px", *e.rms_pixel);
  if (e.rms_m) return message("{:.3g} mm", 1e3 * *e.rms_m);
  return "unknown";
}

Message reported_size(double error, bool in_pixels) {
  const double size = in_pixels ? error : 1e3 * error;
  const char* unit = in_pixels ? "px" : "mm";
  if (!(std::abs(size) > 0)) return message("0 {}", unit);
  int exponent = static_cast<int>(std::floor(std::log10(std::abs(size))));
  if (std::round(std::abs(size) / std::pow(10, exponent - 1)) >= 100) ++exponent;  // 0.996 is 1.0
  return message("{:.{}f} {}", size, std::max(1 - exponent, 0), unit);
}

Message reported_error(const ErrorSummary& e) {
  if (e.rms_pixel) return reported_size(*e.rms_pixel, true);
  return e.rms_m ? reported_size(*e.rms_m, false) : Message("unknown");
}

Message explain(const DiagnosisCandidate& c, const Diagnosis& d, const Session& session) {
  if (c.unnamed) {
    const EmpiricalErrorTerm& best = c.unnamed->empirical_error.best;
    const Message site = best.site == EmpiricalErrorSite::tcp ? "the hand against the last link"
                         : best.site == EmpiricalErrorSite::mount
                             ? Message(session.is_tracker() ? "the tracker" : "the cameras against their link")
                             : verbatim(session.robot.joints[static_cast<std::size_t>(best.joint)].name);
    return message(
        "Something that moves {} follows the {} ({}) in a form that is not in the catalogue; odds against nothing "
        "missing: {}.",
        site, c.unnamed->empirical_error.variable->name, best.shape.text, odds(c.ln_bayes_factor));
  }
  const Effect& effect = term_effect(c.terms.front());
  Message text = looked_up(effect.cause);
  if (c.ln_bayes_factor < 0 && c.held_back.empty()) {
    text += c.visibility < 30 ? message(" These poses could not show it: {}", looked_up(effect.visibility))
                              : " Nothing in the residuals speaks for it.";
    return text;
  }
  if (!c.held_back.empty()) text += message(" Not named: {}.", c.held_back);
  text += message(" Odds against nothing missing: {}; {}.", odds(c.ln_bayes_factor), numbers_text(c, session));
  text += speaks_for(c, d);
  if (c.ln_of_small && is_likelier_beside_small(d.candidates.front(), c) && &c != &d.candidates.front())
    text += message(" Alone {} is likelier; beside small deviations at each joint, which every robot has, this is.",
                    d.candidates.front().id);
  if (!c.plausible) text += " Its size is more than three times what is usual.";
  if (!c.indistinguishable_from.empty())
    text += message(" On these poses it cannot be told from {}.", listed(c.indistinguishable_from));
  text += message(" Check: {}", looked_up(effect.check));
  return c.check ? text + message(" {}", prediction_text(*c.check)) : text;
}

Message too_few_text(int observations, int degrees, int unknowns) {
  return message(
      "{} usable observations leave {} degrees of freedom beside {} parameters; a diagnosis needs at least 10 "
      "observations and twice as many degrees of freedom as parameters: measure more poses.",
      observations, degrees, unknowns);
}

Message missing_text(const DiagnosisCandidate& best, bool rival, const Diagnosis& d) {
  const Effect& effect = term_effect(best.terms.front());
  Message text =
      message("The model misses by {} (held out) where the noise is {}. {}{}: {}", reported_error(d.report.held_out),
              noise_text(d), looked_up(effect.title),
              best.where.empty() ? Message() : message(" ({})", listed(best.where)), looked_up(effect.cause));
  if (best.held_out) text += message(" With it the held-out error falls to {}.", reported_error(*best.held_out));
  if (rival) {
    std::vector<std::string> competing = best.indistinguishable_from;
    text += message(" On these poses it cannot be told from {}; plan poses that would.", listed(competing));
  }
  return text;
}

Message too_little_text(const DiagnosisCandidate& best, const Diagnosis& d) {
  const Message follows =
      d.patterns.empty() ? Message() : message(" What is left follows the {}.", d.patterns.front().against.name);
  return message(
      "The model misses by {} (held out) where the noise is {}, and the best of the catalogue, {}{}, explains only "
      "{} % of the excess.{}",
      reported_error(d.report.held_out), noise_text(d), best.id,
      best.where.empty() ? Message() : message(" at {}", listed(best.where)), whole_percent(best.explained.value_or(0)),
      follows);
}

Message follows_unnamed_text(const DiagnosisCandidate& c, const Session&) {
  return message("The residuals follow the {} in a form that is not in the catalogue: {}.",
                 c.unnamed->empirical_error.variable->name, c.unnamed->empirical_error.best.shape.text);
}

Message follows_pattern_text(const DiagnosisPattern& p) {
  return message("The residual \"{}\" follows the {}, and nothing of the catalogue explains it.", p.residual.name,
                 p.against.name);
}

Message adequate_text(const Diagnosis& d, bool has_repeatability) {
  Message text = message(
      "Nothing is missing that these {} observations could show: the held-out error is {} and "
      "the noise {}.",
      d.report.used, reported_error(d.report.held_out), noise_text(d));
  if (has_repeatability || d.repeatability.is_any()) {
    const Message size = repeatability_text(d.repeatability, d.model.session.joints);
    text += message(" What is left is scatter from pose to pose that follows nothing{}.",
                    size.empty() ? Message() : message(", as of {}", size));
  }
  if (!d.model.lone.empty()) text += message(" {}", lone_text(d.model.lone, d.model.session.is_tracker()));
  if (!d.model.wrong.empty())
    text += message(" {} wrong point{} left out.", d.model.wrong.size(), d.model.wrong.size() == 1 ? " was" : "s were");
  return text;
}

Message poor_repeatability_text(const Diagnosis& d) {
  const Message size = repeatability_text(d.repeatability, d.model.session.joints);
  const Fit& fit = d.model.fit;
  Message text = message(
      "What is left, {} held out, is {:.1f} times the noise ({}) and follows nothing that was "
      "measured",
      reported_error(d.report.held_out), fit.residual_rms / *d.noise, noise_text(d));
  if (!size.empty()) text += message("; from pose to pose it is as of {}", size);
  return text +
         ". Robots scatter less (0.3 mrad a joint and 0.3 mm at the hand, where <robot repeatability=\"\"> "
         "declares nothing else), so something is missing that is not known here. To find out: measure some "
         "poses again at the end, come to some from both sides, and record times, velocities and torques.";
}

Message unknown_noise_text(const Diagnosis& d) {
  return message(
      "Nothing of the catalogue passes, but the noise of the measurements is not known (no sigma declared, no repeated "
      "poses, and no three markers that tell it), so that nobody can say whether {} is all noise: declare sigma "
      "(convert --sigma, or sigma of <tracker> or <pose_sensor>) or repeat poses.",
      reported_error(d.report.held_out));
}

}  // namespace handsight
