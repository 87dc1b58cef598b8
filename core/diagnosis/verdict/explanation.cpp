// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/explanation.h"

#include <fmt/format.h>

#include <cmath>

#include "base/percent.h"
#include "diagnosis/evidence/scatter_levels.h"
#include "diagnosis/verdict/robot_check.h"
#include "effects/units.h"

namespace handsight {
namespace {

std::string odds(double ln_bayes_factor) {
  if (ln_bayes_factor > 13.8) return "more than a million to one";
  if (ln_bayes_factor > 0) return fmt::format("about {:.0f} to 1", std::exp(ln_bayes_factor));
  return "none";
}

std::string noise_text(const Diagnosis& d) {
  if (!d.noise) return "unknown";
  const bool in_pixels = !d.model.session.is_tracker();
  const double of_length = d.report.rms_of_noise_m.value_or(as_told(*d.noise, false));
  return told_size(in_pixels ? *d.noise : of_length, in_pixels);
}

/// "compliance of arm_2 1.2e-04 +- 3e-06 rad/(N m)"
std::string numbers_text(const DiagnosisCandidate& c, const Session& session) {
  std::string text;
  int listed_ones = 0;
  for (std::size_t t = 0; t < c.terms.size(); ++t) {
    const Effect& effect = effect_of(c.terms[t]);
    const std::string place = place_name(effect, c.terms[t].joint, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      if (++listed_ones > 6) return text + ", ...";
      text += fmt::format("{}{}{} {:.3g} +- {:.1g} {}", text.empty() ? "" : ", ", effect.parameters[p].name,
                          place.empty() ? "" : " of " + place, c.terms[t].values[p], c.sigmas[t][p],
                          unit_at(effect, p, c.terms[t].joint, session.robot));
    }
  }
  return text;
}

std::string speaks_for(const DiagnosisCandidate& c, const Diagnosis& d) {
  for (const DiagnosisPattern& p : d.patterns) {
    const bool own = p.against.joint < 0 || c.where.empty();
    for (const EffectTerm& term : c.terms)
      if (own || term.joint == p.against.joint)
        return fmt::format(" The residual \"{}\" follows the {}.", p.residual.name, p.against.name);
  }
  return "";
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::string error_text(const ErrorSummary& e) {
  if (e.rms_pixel) return fmt::format("{:.3g} px", *e.rms_pixel);
  if (e.rms_m) return fmt::format("{:.3g} mm", 1e3 * *e.rms_m);
  return "unknown";
}

std::string told_size(double error, bool in_pixels) {
  const double size = in_pixels ? error : 1e3 * error;
  const char* unit = in_pixels ? "px" : "mm";
  if (!(std::abs(size) > 0)) return fmt::format("0 {}", unit);
  int exponent = static_cast<int>(std::floor(std::log10(std::abs(size))));
  if (std::round(std::abs(size) / std::pow(10, exponent - 1)) >= 100) ++exponent;  // 0.996 is 1.0
  return fmt::format("{:.{}f} {}", size, std::max(1 - exponent, 0), unit);
}

std::string told_error(const ErrorSummary& e) {
  if (e.rms_pixel) return told_size(*e.rms_pixel, true);
  return e.rms_m ? told_size(*e.rms_m, false) : "unknown";
}

std::string explain(const DiagnosisCandidate& c, const Diagnosis& d, const Session& session) {
  if (c.unnamed) {
    const LocaliserTerm& best = c.unnamed->localiser.best;
    const std::string site = best.site == LocaliserSite::tcp ? "the hand against the last link"
                             : best.site == LocaliserSite::mount
                                 ? (session.is_tracker() ? "the tracker" : "the cameras against their link")
                                 : session.robot.joints[static_cast<std::size_t>(best.joint)].name;
    return fmt::format(
        "Something that moves {} follows the {} ({}) in a form that is not in the catalogue; odds against nothing "
        "missing: {}.",
        site, c.unnamed->localiser.variable->name, best.shape.text, odds(c.ln_bayes_factor));
  }
  const Effect& effect = effect_of(c.terms.front());
  std::string text = effect.cause;
  if (c.ln_bayes_factor < 0) {
    text += c.visibility < 30 ? " These poses could not show it: " + effect.visibility
                              : " Nothing in the residuals speaks for it.";
    return text;
  }
  text += fmt::format(" Odds against nothing missing: {}; {}.", odds(c.ln_bayes_factor), numbers_text(c, session));
  text += speaks_for(c, d);
  if (!c.plausible) text += " Its size is more than three times what is plausible.";
  if (!c.cannot_be_told_from.empty())
    text += " On these poses it cannot be told from " + listed(c.cannot_be_told_from) + ".";
  text += " Check: " + effect.check;
  return c.check ? text + " " + prediction_text(*c.check) : text;
}

std::string too_few_text(int observations, int degrees, int unknowns) {
  return fmt::format(
      "{} usable observations leave {} degrees of freedom beside {} parameters; a diagnosis needs at least 10 "
      "observations and twice as many degrees of freedom as parameters: measure more poses.",
      observations, degrees, unknowns);
}

std::string missing_text(const DiagnosisCandidate& best, bool rival, const Diagnosis& d) {
  const Effect& effect = effect_of(best.terms.front());
  std::string text =
      fmt::format("The model misses by {} (held out) where the noise is {}. {}{}: {}", told_error(d.report.held_out),
                  noise_text(d), effect.title, best.where.empty() ? "" : " (" + listed(best.where) + ")", effect.cause);
  if (best.held_out) text += fmt::format(" With it the held-out error falls to {}.", told_error(*best.held_out));
  if (rival) {
    std::vector<std::string> rivals = best.cannot_be_told_from;
    text += fmt::format(" On these poses it cannot be told from {}; plan poses that would.", listed(rivals));
  }
  return text;
}

std::string too_little_text(const DiagnosisCandidate& best, const Diagnosis& d) {
  const std::string follows =
      d.patterns.empty() ? "" : " What is left follows the " + d.patterns.front().against.name + ".";
  return fmt::format(
      "The model misses by {} (held out) where the noise is {}, and the best of the catalogue, {}{}, explains only "
      "{} % of the excess.{}",
      told_error(d.report.held_out), noise_text(d), best.id, best.where.empty() ? "" : " at " + listed(best.where),
      whole_percent(best.explained.value_or(0)), follows);
}

std::string follows_unnamed_text(const DiagnosisCandidate& c, const Session&) {
  return fmt::format("The residuals follow the {} in a form that is not in the catalogue: {}.",
                     c.unnamed->localiser.variable->name, c.unnamed->localiser.best.shape.text);
}

std::string follows_pattern_text(const DiagnosisPattern& p) {
  return fmt::format("The residual \"{}\" follows the {}, and nothing of the catalogue explains it.", p.residual.name,
                     p.against.name);
}

std::string adequate_text(const Diagnosis& d, bool has_scatter) {
  std::string text = fmt::format(
      "Nothing is missing that these {} observations could show: the held-out error is {} and "
      "the noise {}.",
      d.report.used, told_error(d.report.held_out), noise_text(d));
  if (has_scatter || d.scatter.is_any()) {
    const std::string size = scatter_text(d.scatter);
    text += fmt::format(" What is left is scatter from pose to pose that follows nothing{}.",
                        size.empty() ? "" : ", as of " + size);
  }
  if (!d.model.lone.empty()) text += fmt::format(" {}", lone_text(d.model.lone, d.model.session.is_tracker()));
  if (!d.model.wrong.empty())
    text +=
        fmt::format(" {} wrong point{} left out.", d.model.wrong.size(), d.model.wrong.size() == 1 ? " was" : "s were");
  return text;
}

std::string too_much_scatter_text(const Diagnosis& d) {
  const std::string size = scatter_text(d.scatter);
  const Fit& fit = d.model.fit;
  std::string text = fmt::format(
      "What is left, {} held out, is {:.1f} times the noise ({}) and follows nothing that was "
      "measured",
      told_error(d.report.held_out), fit.residual_rms / *d.noise, noise_text(d));
  if (!size.empty()) text += fmt::format("; from pose to pose it is as of {}", size);
  return text +
         ". Robots scatter less (0.3 mrad a joint and 0.3 mm at the hand, where <robot repeatability=\"\"> "
         "declares nothing else), so something is missing that is not known here. To find out: measure some "
         "poses again at the end, come to some from both sides, and record times, velocities and torques.";
}

std::string unknown_noise_text(const Diagnosis& d) {
  return fmt::format(
      "Nothing of the catalogue passes, but the noise of the measurements is not known (no sigma declared, no repeated "
      "poses, and no three markers that tell it), so that nobody can say whether {} is all noise: declare sigma "
      "(convert --sigma, or sigma of <tracker> or <pose_sensor>) or repeat poses.",
      told_error(d.report.held_out));
}

}  // namespace handsight
