// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/explain_texts.h"

#include "bench/model_effects.h"
#include "diagnosis/evidence/scatter_levels.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/judging.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {

QString error_with_unit(double error, bool in_pixels) {
  return widgets::with_unit_text(in_pixels ? error : 1e3 * error, in_pixels ? QObject::tr("px") : QObject::tr("mm"));
}

namespace {

/// An error and the noise beside it, in words.
struct Told {
  QString error, noise;
  QString both;     // "0.21 px against 0.20 px"
  QString at_hand;  // " (12 mm at the hand)": the other way to tell it
};

Told told(const VersionSizes& sizes, widgets::SizeUnit unit) {
  using widgets::SizeUnit;
  Told t{.error = text_in(unit, sizes.error())};
  const bool in_sigma = shown_in(unit, sizes.error()).unit == SizeUnit::sigma;
  // In units of itself the noise would be 1, which tells nothing.
  t.noise = text_in(in_sigma ? SizeUnit::pixel : unit, sizes.noise);
  t.both = in_sigma ? QObject::tr("%1, the noise being %2").arg(t.error, t.noise)
                    : QObject::tr("%1 against %2").arg(t.error, t.noise);
  if (unit != SizeUnit::millimetre && sizes.error().pixel && sizes.error().millimetre)
    t.at_hand = QObject::tr(" (%1 at the hand)").arg(text_in(SizeUnit::millimetre, sizes.error()));
  if (unit == SizeUnit::millimetre && sizes.error().pixel)
    t.at_hand = QObject::tr(" at the hand (%1)").arg(text_in(SizeUnit::pixel, sizes.error()));
  return t;
}

}  // namespace

QString comparison_sentence(const ModelVersion& model, widgets::SizeUnit unit) {
  if (!model.fit) return model.refusal;
  const ErrorAndNoise e = error_and_noise(model);
  if (model.report->used < fewest_that_tell)
    return QObject::tr("%1 alone cannot show an error: label or play more.")
        .arg(counted(model.report->used, "%n observation(s)"));
  if (!e.error) return QObject::tr("The error is not known.");
  const Told t = told(sizes_of(model, model.fit->noise), unit);
  if (!e.noise)
    return QObject::tr(
               "The model misses by %1. Without three markers the noise is not known, so that the program cannot "
               "say whether that is much.")
        .arg(t.error);
  // So many observations may show that it is not the noise alone, however near it comes.
  if (*e.ratio() < 1.25 && model.fit->covariance_kind == CovarianceKind::scatter)
    return QObject::tr("The model comes near the noise (%1), but what is left is more than noise.").arg(t.both);
  if (*e.ratio() < 1.25)
    return QObject::tr("The model agrees with the measurements down to the noise (%1).").arg(t.both);
  return QObject::tr("The model misses by %1%2 where the noise is %3.").arg(t.error, t.at_hand, t.noise);
}

std::optional<widgets::Blame> session_blame(const Inspection& all) {
  if (all.blame.letter == 0) return std::nullopt;
  return widgets::Blame{all.blame.cameras, all.blame.body, all.blame.robot, !all.in_pixels};
}

namespace {

using widgets::SessionState;

/// The best with a name, of a size that is plausible; where there is none such of half the evidence at least, the best
/// with a name. None of the refused; null where nothing is left.
const DiagnosisCandidate* best_named(const Diagnosis& d, const std::set<std::string>& refused) {
  const DiagnosisCandidate* best = nullptr;
  for (const DiagnosisCandidate& c : d.candidates) {
    if (c.unnamed || refused.contains(c.id)) continue;
    const bool is_near = !best || c.ln_bayes_factor >= 0.5 * best->ln_bayes_factor;
    if (c.plausible && is_near && c.ln_bayes_factor >= d.threshold) return &c;
    if (!best) best = &c;
  }
  return best;
}

/// Whose fault the error is, in the light of what was found missing.
std::optional<widgets::Blame> blame_with_cause(const Inspection& all, const Diagnosis& d) {
  const Blame blame = blame_by_finding(all.blame, d);
  if (blame.letter == 0) return std::nullopt;
  return widgets::Blame{blame.cameras, blame.body, blame.robot, !all.in_pixels};
}

QString blame_sentence(const std::optional<widgets::Blame>& blame, bool in_pixels) {
  if (!blame) return {};
  const std::pair<double, QString> parts[] = {
      {blame->robot, QObject::tr("the robot")},
      {blame->body, QObject::tr("the marker body")},
      {blame->cameras, in_pixels ? QObject::tr("the cameras") : QObject::tr("the tracker")}};
  const auto& most = *std::max_element(std::begin(parts), std::end(parts),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
  return QObject::tr("%1 % of it comes from %2.").arg(std::lround(100 * most.first)).arg(most.second);
}

QString adequate_sentence(const Diagnosis& d, const Told& t) {
  QString text = QObject::tr("The model agrees with the measurements down to the noise (%1).").arg(t.both);
  QStringList unseen;
  // What is in the model was seen, if not in every place that it could have.
  const std::vector<EffectTerm> seen = terms_of(d.model.fit);
  for (const std::string& id : d.invisible)
    if (std::none_of(seen.begin(), seen.end(), [&](const EffectTerm& term) { return term.id == id; }))
      unseen << effect_of(id, {});
  constexpr qsizetype most = 3;
  if (unseen.size() > most) unseen = unseen.mid(0, most) << QObject::tr("%1 more").arg(unseen.size() - most);
  if (!unseen.isEmpty()) text += ' ' + QObject::tr("These poses could not show: %1.").arg(unseen.join(", "));
  return text;
}

/// At the noise with curves: what follows what, without a name.
QString curves_sentence(const ModelVersion& model, const Diagnosis& d, const Told& t) {
  QStringList list;
  for (const EffectTerm& curve : curves_of(*model.fit)) {
    QString title = title_of(curve, d.model.session.robot);
    title[0] = title[0].toLower();
    list << title;
  }
  return QObject::tr("The model agrees with the measurements down to the noise (%1), but not all of it has a name: %2.")
      .arg(t.both, list.join("; "));
}

QString scatter_sentence(const Diagnosis& d, const Told& t) {
  const QString place = widgets::short_text(1e3 * d.scatter.place);
  if (d.scatter.joints == 0)
    return QObject::
        tr("What is left (%1, noise %2) differs from pose to pose without a pattern: the hand's place does not repeat "
           "better than %3 mm. No effect can remove it.")
            .arg(t.error, t.noise, place);
  if (d.scatter.place >= least_told_place)
    return QObject::tr(
               "What is left (%1, noise %2) differs from pose to pose without a pattern: the joints do not repeat "
               "better than %3 mrad, nor the hand's place better than %4 mm. No effect can remove it.")
        .arg(t.error, t.noise, widgets::short_text(1e3 * d.scatter.joints), place);
  return QObject::tr(
             "What is left (%1, noise %2) differs from pose to pose without a pattern: the joints do not repeat better "
             "than %3 mrad. No effect can remove it.")
      .arg(t.error, t.noise, widgets::short_text(1e3 * d.scatter.joints));
}

bool is_scatter(const Diagnosis& d, const ErrorAndNoise& e) {
  return d.verdict == Verdict::adequate && d.scatter.is_any() && e.ratio().value_or(0) >= 1.25;
}

bool lacks_noise(const Diagnosis& d) { return !weighing(d.model.fit).knowledge.known; }

QString what_is_left_follows(const Diagnosis& d) {
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.unnamed && can_be_added(c) && c.ln_bayes_factor >= d.threshold) {
      QString title = name_of(c, d.model.session);
      title[0] = title[0].toUpper();
      return title + '.';
    } else if (c.unnamed && c.ln_bayes_factor >= d.threshold)
      return QObject::tr("It follows the %1 (%2).")
          .arg(translated(c.unnamed->localiser.variable->name),
               QString::fromStdString(c.unnamed->localiser.best.shape.text));
  if (!follows_a_pattern(d))
    return scatters_too_much(d) ? QObject::tr("It follows nothing that was measured, and robots scatter less.")
                                : QString();
  return QObject::tr("It follows the %1.").arg(translated(d.patterns.front().against.name));
}

QString unexplained_sentence(const Diagnosis& d, const ErrorAndNoise& e, const Told& t) {
  return QObject::tr("Something real is left (%1 where the noise is %2), and nothing in the catalogue explains it. %3")
      .arg(t.error, e.noise ? t.noise : QObject::tr("unknown"), what_is_left_follows(d));
}

/// What, where, how much, whose: names first, so that they are read where there is little room.
QString missing_sentence(const ModelVersion& model, const Diagnosis& d, const std::optional<widgets::Blame>& blame,
                         widgets::SizeUnit unit, const DiagnosisCandidate& best) {
  const ErrorAndNoise e = error_and_noise(model);
  const Told t = told(sizes_of(model, model.fit->noise), unit);
  // How many mm that is at the hand stands beside it.
  QString misses = e.error && e.noise
                       ? QObject::tr("The model misses by %1 where the noise is %2.").arg(t.error, t.noise)
                       : comparison_sentence(model, unit);
  const QString whose = blame_sentence(blame, e.in_pixels);
  if (!whose.isEmpty()) misses += ' ' + whose;
  const QString name = name_of(best, d.model.session);
  if (!best.plausible)
    return misses + ' ' +
           QObject::tr("No plausible cause explains it: %1 would help, but at more than three times what is plausible.")
               .arg(name);
  if (d.verdict == Verdict::ambiguous && !best.cannot_be_told_from.empty())
    return QObject::tr("%1 or %2: on these poses they look the same.")
               .arg(name.left(1).toUpper() + name.mid(1), effect_of(best.cannot_be_told_from.front(), {})) +
           ' ' + misses;
  return QObject::tr("Most likely missing: %1.").arg(name) + ' ' + misses;
}

widgets::SessionVerdict verdict_of_model(const ModelVersion& model, const Diagnosis* d, bool is_running,
                                         widgets::SizeUnit unit, const std::set<std::string>& refused) {
  widgets::SessionVerdict v;
  v.sentence = comparison_sentence(model, unit);
  if (!model.fit) return v;
  const ErrorAndNoise e = error_and_noise(model);
  const VersionSizes sizes = sizes_of(model, model.fit->noise);
  const Told t = told(sizes, unit);
  v.unit = unit;
  v.error_px = sizes.error().pixel;
  v.error_mm = sizes.error().millimetre;
  v.error_sigma = sizes.error().sigma;
  v.noise_px = sizes.noise.pixel;
  v.noise_mm = sizes.noise.millimetre;
  v.blame = session_blame(*model.inspection);
  v.state = SessionState::looking;
  if (!d) {
    if (!is_running) v.state = e.noise ? SessionState::waiting : SessionState::noise_unknown;
    const QString whose = e.ratio().value_or(0) >= 1.25 ? blame_sentence(v.blame, e.in_pixels) : QString();
    if (!whose.isEmpty()) v.sentence += ' ' + whose;
    return v;
  }
  switch (d->verdict) {
    case Verdict::too_few_observations:
      v.state = SessionState::too_few;
      v.sentence = translated(d->reason);
      break;
    case Verdict::adequate:
      if (!curves_of(*model.fit).empty()) {
        v.state = SessionState::unexplained;
        v.sentence = curves_sentence(model, *d, t);
        break;
      }
      v.state = is_scatter(*d, e) ? SessionState::scatter : SessionState::adequate;
      v.sentence = is_scatter(*d, e) ? scatter_sentence(*d, t) : adequate_sentence(*d, t);
      break;
    case Verdict::missing_effect:
    case Verdict::ambiguous: {
      const DiagnosisCandidate* best = best_named(*d, refused);
      if (!best || best->ln_bayes_factor < d->threshold) {
        v.blame = blame_with_cause(*model.inspection, *d);
        v.state = SessionState::unexplained;
        v.sentence = QObject::tr(
                         "Something is left (%1), and what would explain it does not lower the error on observations "
                         "that the fit has not seen: it was not added.")
                         .arg(t.both);
        break;
      }
      v.state = d->verdict == Verdict::ambiguous ? SessionState::ambiguous : SessionState::missing;
      v.blame = blame_with_cause(*model.inspection, *d);
      v.sentence = missing_sentence(model, *d, v.blame, unit, *best);
      break;
    }
    case Verdict::unexplained:
      v.blame = blame_with_cause(*model.inspection, *d);
      v.state = lacks_noise(*d) ? SessionState::noise_unknown : SessionState::unexplained;
      v.sentence = lacks_noise(*d) ? comparison_sentence(model, unit) : unexplained_sentence(*d, e, t);
      break;
  }
  return v;
}

}  // namespace

widgets::SessionVerdict session_verdict(const ModelVersion& model, const Diagnosis* d, bool is_running,
                                        widgets::SizeUnit unit, const std::set<std::string>& refused) {
  widgets::SessionVerdict v = verdict_of_model(model, d, is_running, unit, refused);
  if (const QString alone = lone_sentence(model); !alone.isEmpty()) v.sentence = alone + ' ' + v.sentence;
  return v;
}

}  // namespace handsight::app
