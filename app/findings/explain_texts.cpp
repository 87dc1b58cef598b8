// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings/explain_texts.h"

#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/judging.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "words/counted.h"
#include "workbench/model_effects.h"

namespace handsight::app {

QString error_with_unit(double error, bool in_pixels) {
  return widgets::with_unit_text(in_pixels ? error : 1e3 * error, in_pixels ? QObject::tr("px") : QObject::tr("mm"));
}

QString cannot_be_split_text() { return QObject::tr("Cannot be split with one marker"); }

QString figures_sentence(const ModelVersion& model, widgets::SizeUnit unit) {
  if (!model.fit || model.report->used < fewest_that_tell || !error_and_noise(model).error) return {};
  using widgets::SizeUnit;
  const VersionSizes sizes = list_sizes(model, model.fit->noise);
  const bool is_known = sizes.noise.pixel || sizes.noise.millimetre;
  // In units of itself the noise would be 1, which tells nothing.
  const bool in_sigma = shown_in(unit, sizes.error()).unit == SizeUnit::sigma;
  QString error = text_in(unit, sizes.error());
  if (sizes.error().pixel && sizes.error().millimetre)
    error = unit == SizeUnit::millimetre
                ? QObject::tr("%1 at the hand (%2)").arg(error, text_in(SizeUnit::pixel, sizes.error()))
                : QObject::tr("%1 (%2 at the hand)").arg(error, text_in(SizeUnit::millimetre, sizes.error()));
  const QString noise = is_known ? text_in(in_sigma ? SizeUnit::pixel : unit, sizes.noise) : QObject::tr("unknown");
  return (error_and_noise(model).held_out
              ? QObject::tr("Error on observations that the fit has not seen: %1; noise: %2.")
              : QObject::tr("Error on the observations that were fitted: %1; noise: %2."))
      .arg(error, noise);
}

namespace {

QString unknown_noise_sentence() {
  return QObject::tr(
      "The noise is not known, so that nobody can say whether the error is much: declare it (sigma), or repeat some "
      "poses.");
}

}  // namespace

QString comparison_sentence(const ModelVersion& model) {
  if (!model.fit) return model.refusal;
  const StoryError e = error_and_noise(model);
  if (model.report->used < fewest_that_tell)
    return QObject::tr("%1 alone cannot show an error: label or play more.")
        .arg(counted(model.report->used, "%n observation(s)"));
  if (!e.error) return QObject::tr("The error is not known.");
  if (!e.noise) return unknown_noise_sentence();
  // So many observations may show that it is not the noise alone, however near it comes.
  if (*e.ratio() < most_beside_repeatability && model.fit->covariance_kind == CovarianceKind::repeatability)
    return QObject::tr("The model comes near the noise, but what is left is more than noise.");
  if (*e.ratio() < most_beside_repeatability)
    return QObject::tr("The model agrees with the measurements down to the noise.");
  return QObject::tr("The model misses by more than the noise.");
}

namespace {

using widgets::SessionState;

std::optional<widgets::ErrorAttribution> shown(const ErrorAttribution& attribution, bool in_pixels) {
  if (attribution.cause == ErrorCause::none) return std::nullopt;
  return widgets::ErrorAttribution{attribution.cameras, attribution.body, attribution.robot, !in_pixels};
}

/// Who answers for most of it; how much of it stands in the bar beside the sentence.
QString attribution_sentence(const std::optional<widgets::ErrorAttribution>& attribution, bool in_pixels) {
  if (!attribution) return {};
  const std::pair<double, QString> parts[] = {
      {attribution->robot, QObject::tr("the robot")},
      {attribution->body, QObject::tr("the marker body")},
      {attribution->cameras, in_pixels ? QObject::tr("the cameras") : QObject::tr("the tracker")}};
  const auto& most = *std::max_element(std::begin(parts), std::end(parts),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr double nearly_all = 0.95, half = 0.5;
  return (most.first >= nearly_all ? QObject::tr("The error comes from %1.")
          : most.first >= half     ? QObject::tr("Most of the error comes from %1.")
                                   : QObject::tr("The largest part of the error comes from %1."))
      .arg(most.second);
}

/// How far the hand is off, where the header has another unit.
QString hand_sentence(const ModelVersion& model, widgets::SizeUnit unit) {
  const ResidualSize error = list_sizes(model, model.fit->noise).error();
  if (unit == widgets::SizeUnit::millimetre || !error.pixel || !error.millimetre) return {};
  return QObject::tr("The hand is off by %1.").arg(text_in(widgets::SizeUnit::millimetre, error));
}

QString adequate_sentence(const Diagnosis& d) {
  QString text = QObject::tr("The model agrees with the measurements down to the noise.");
  QStringList unseen;
  for (const std::string& id : unseen_effects(d)) unseen << effect_text(id, {});
  constexpr qsizetype most = 3;
  if (unseen.size() > most) unseen = unseen.mid(0, most) << QObject::tr("%1 more").arg(unseen.size() - most);
  if (!unseen.isEmpty()) text += ' ' + QObject::tr("These poses could not show: %1.").arg(unseen.join(", "));
  return text;
}

/// At the noise with curves: what follows what, without a name.
QString curves_sentence(const ModelVersion& model, const Diagnosis& d) {
  QStringList list;
  for (const EffectTerm& curve : list_curves(*model.fit)) {
    QString title = make_title(curve, d.model.session.robot);
    title[0] = title[0].toLower();
    list << title;
  }
  return QObject::tr("The model agrees with the measurements down to the noise, but not all of it has a name: %1.")
      .arg(list.join("; "));
}

/// "0.25 mrad", and which joint is the worst where they differ.
QString joints_text(const Repeatability& repeatability, const std::vector<std::string>& joints) {
  const auto text = [](double rad) { return widgets::short_text(1e3 * rad); };
  const std::vector<double>& of_joint = repeatability.of_joint;
  if (of_joint.empty() || of_joint.size() != joints.size())
    return QObject::tr("%1 mrad").arg(text(repeatability.joints));
  const auto worst = std::ranges::max_element(of_joint);
  return QObject::tr("%1 mrad (%2: %3 mrad)")
      .arg(text(repeatability.joints),
           QString::fromStdString(joints[static_cast<std::size_t>(worst - of_joint.begin())]),
           text(repeatability.joints * *worst));
}

QString repeatability_sentence(const Diagnosis& d) {
  if (!d.repeatability.is_any())
    return QObject::tr(
        "What is left is more than noise, differs from pose to pose and follows nothing that was measured. No effect "
        "can remove it.");
  const QString place = widgets::short_text(1e3 * d.repeatability.place);
  if (d.repeatability.joints == 0)
    return QObject::tr(
               "What is left differs from pose to pose without a pattern: the hand's place does not repeat better than "
               "%1 mm. No effect can remove it.")
        .arg(place);
  const QString joints = joints_text(d.repeatability, d.model.session.joints);
  if (d.repeatability.place >= least_reported_place)
    return QObject::tr(
               "What is left differs from pose to pose without a pattern: the joints do not repeat better than %1, nor "
               "the hand's place better than %2 mm. No effect can remove it.")
        .arg(joints, place);
  return QObject::tr(
             "What is left differs from pose to pose without a pattern: the joints do not repeat better than %1. No "
             "effect can remove it.")
      .arg(joints);
}

/// Sentences with a space between them; the narrow space between a figure and its unit stays as it is.
QString one_after_another(QStringList sentences) {
  sentences.removeAll(QString());
  return sentences.join(' ');
}

/// What would have passed but is rare: it may be there all the same.
QString held_back_sentence(const Diagnosis& d) {
  QStringList names;
  for (const DiagnosisCandidate& c : d.candidates)
    if (!c.held_back.empty()) names << display_name(c, d.model.session);
  if (names.isEmpty()) return {};
  return QObject::tr("May be there, but is too rare to be named on this evidence: %1.").arg(names.join("; "));
}

QString what_is_left_follows(const Diagnosis& d) {
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.unnamed && can_be_added(c) && c.ln_bayes_factor >= d.threshold) {
      return curve_sentence(c.terms.front(), d.model.session.robot) + '.';
    } else if (c.unnamed && c.ln_bayes_factor >= d.threshold)
      return QObject::tr("It follows the %1 (%2).")
          .arg(translated(c.unnamed->empirical_error.variable->name),
               QString::fromStdString(c.unnamed->empirical_error.best.shape.text));
  if (!follows_a_pattern(d))
    return repeats_too_badly(d) ? QObject::tr("It follows nothing that was measured, and robots scatter less.")
                                : QString();
  return QObject::tr("It follows the %1.").arg(translated(d.patterns.front().against.name));
}

/// What no robot is built like is said wherever it is in the model.
QString stand_in_sentence(const Story& story) {
  QStringList names;
  for (const StandIn& one : story.stands_in) names << effect_text(one.id, one.where);
  if (names.isEmpty()) return {};
  return QObject::tr("No robot is built so, it stands in for another cause: %1.").arg(names.join("; "));
}

/// What to do about what is left: masses first, where there are none.
QString advice(const Story& story, const Diagnosis& d) {
  if (story.cannot_bend)
    return QObject::tr(
        "No link of the robot has a mass, so that nothing that bends could be tried: give the masses in the robot's "
        "file.");
  return what_is_left_follows(d);
}

QString unexplained_sentence(const Story& story, const Diagnosis& d) {
  if (const StoryCause* lead = story.lead(); lead && !lead->unnamed)
    return QObject::tr(
               "Something real is left: %1 explains a part of it, and nothing in the catalogue explains the rest. %2")
        .arg(display_name(d.candidates[lead->candidate], d.model.session), advice(story, d))
        .trimmed();
  return QObject::tr("Something real is left, and nothing in the catalogue explains it. %1")
      .arg(advice(story, d))
      .trimmed();
}

/// "; with it the error would be down at the noise": what the cause would bring.
QString brings_text(const Story& story, const StoryCause& lead) {
  if (!lead.left || !story.error.error || !(*story.error.error > 0)) return {};
  if (story.error.noise && *lead.left < most_beside_repeatability * *story.error.noise)
    return QObject::tr("; with it the error would be down at the noise");
  const double share = *lead.left / *story.error.error;
  return share < 1 ? QObject::tr("; with it %1 % of the error would be left").arg(std::lround(100 * share)) : QString();
}

/// What, where, what it would bring, whose: names first, so that they are read where there is little room.
QString missing_sentence(const ModelVersion& model, const Story& story, const Diagnosis& d, widgets::SizeUnit unit) {
  const StoryCause& lead = story.causes.front();
  const QString name = display_name(d.candidates[lead.candidate], d.model.session);
  QString text = QObject::tr("Most likely missing: %1%2.").arg(name, brings_text(story, lead));
  if (story.state == StoryState::implausible)
    text = (find_disbelief(d.candidates[lead.candidate]) == Disbelief::leaves_much
                ? QObject::tr("No plausible cause explains it: %1 would help, but it is more than three times what is "
                              "usual, and leaves much.")
                : QObject::tr("No plausible cause explains it: %1 would help, but no robot is built so."))
               .arg(name);
  if (story.state == StoryState::ambiguous)
    text = QObject::tr("%1 or %2: on these poses they look the same.")
               .arg(name.left(1).toUpper() + name.mid(1), effect_text(lead.indistinguishable_from.front(), {}));
  return one_after_another(
      {text, hand_sentence(model, unit),
       attribution_sentence(shown(story.attribution, story.error.in_pixels), story.error.in_pixels),
       story.error.noise ? QString() : unknown_noise_sentence()});
}

SessionState shown_state(const Story& story, bool is_running) {
  switch (story.state) {
    case StoryState::not_looked:
      if (is_running) return SessionState::looking;
      return story.error.noise ? SessionState::waiting : SessionState::noise_unknown;
    case StoryState::too_few_observations:
      return SessionState::too_few;
    case StoryState::noise_unknown:
      return SessionState::noise_unknown;
    case StoryState::at_the_noise:
      return story.stands_in.empty() ? SessionState::adequate : SessionState::stand_in;
    case StoryState::unnamed_at_the_noise:
      return SessionState::unnamed;
    case StoryState::repeatability:
      return SessionState::repeatability;
    case StoryState::missing:
      return SessionState::missing;
    case StoryState::implausible:
      return SessionState::implausible;
    case StoryState::ambiguous:
      return SessionState::ambiguous;
    case StoryState::unexplained:
    case StoryState::refused:
      return SessionState::unexplained;
  }
  return SessionState::waiting;
}

QString with_held_back(const QString& sentence, const Diagnosis& d) {
  return one_after_another({sentence, held_back_sentence(d)});
}

QString sentence_of(const ModelVersion& model, const Story& story, const Diagnosis* d, widgets::SizeUnit unit) {
  if (!d || story.state == StoryState::not_looked) {
    if (story.error.ratio().value_or(0) < most_beside_repeatability) return comparison_sentence(model);
    return one_after_another(
        {comparison_sentence(model), hand_sentence(model, unit),
         attribution_sentence(shown(story.attribution, story.error.in_pixels), story.error.in_pixels)});
  }
  switch (story.state) {
    case StoryState::too_few_observations:
      return translated(d->reason);
    case StoryState::at_the_noise:
      return with_held_back(adequate_sentence(*d), *d);
    case StoryState::unnamed_at_the_noise:
      return with_held_back(curves_sentence(model, *d), *d);
    case StoryState::repeatability:
      return with_held_back(repeatability_sentence(*d), *d);
    case StoryState::missing:
    case StoryState::ambiguous:
    case StoryState::implausible:
      return missing_sentence(model, story, *d, unit);
    case StoryState::unexplained:
      return with_held_back(unexplained_sentence(story, *d), *d);
    case StoryState::refused:
      return QObject::tr(
          "Something is left, and what would explain it does not lower the error on observations that the fit has not "
          "seen: it was not added.");
    default:
      return comparison_sentence(model);
  }
}

}  // namespace

widgets::SessionVerdict session_verdict(const ModelVersion& model, const Story& story, const Diagnosis* d,
                                        bool is_running, widgets::SizeUnit unit) {
  widgets::SessionVerdict v;
  v.sentence = comparison_sentence(model);
  if (!model.fit) return v;
  v.figures = figures_sentence(model, unit);
  const VersionSizes sizes = list_sizes(model, model.fit->noise);
  v.unit = unit;
  v.error_px = sizes.error().pixel;
  v.error_mm = sizes.error().millimetre;
  v.error_sigma = sizes.error().sigma;
  v.noise_px = sizes.noise.pixel;
  v.noise_mm = sizes.noise.millimetre;
  v.attribution = shown(story.attribution, story.error.in_pixels);
  const auto& source = model.fit->problem.source;
  if (source && source->chain.is_touch)
    v.why_no_attribution = QObject::tr("Cannot be split by touches");
  else if (model.fit->problem.marker_count == 1)
    v.why_no_attribution = cannot_be_split_text();
  else if (!story.error.noise)
    v.why_no_attribution = QObject::tr("whose fault: noise unknown");
  v.state = shown_state(story, is_running);
  v.sentence = sentence_of(model, story, d, unit);
  // What is in the model and stands in for something else belongs before what agrees by it.
  const QString stand_in = stand_in_sentence(story);
  if (!stand_in.isEmpty())
    v.sentence = story.state == StoryState::missing || story.state == StoryState::ambiguous
                     ? v.sentence + ' ' + stand_in
                     : stand_in + ' ' + v.sentence;
  if (const QString alone = lone_sentence(model); !alone.isEmpty()) v.sentence = alone + ' ' + v.sentence;
  return v;
}

QString mistake_sentence(const std::vector<Blunder>& blunders) {
  QStringList list;
  for (const Blunder& b : blunders) list << translated(b.text);
  return list.join(' ');
}

widgets::SessionVerdict session_verdict(const Workbench& workbench, const ModelVersionPointer& model) {
  widgets::SessionVerdict v =
      session_verdict(*model, workbench.find_story(model), workbench.find_diagnosis(model).get(),
                      workbench.diagnosing.is_running(), workbench.units.unit());
  if (workbench.blunders().empty()) return v;
  // What a wrong session shows is neither the robot's fault nor anybody's.
  v.state = widgets::SessionState::mistake;
  v.figures.clear();
  v.sentence = mistake_sentence(workbench.blunders()) + ' ' +
               QObject::tr("Put that right first: until then no other number tells anything.");
  v.attribution.reset();
  v.why_no_attribution = QObject::tr("the session itself is wrong");
  return v;
}

}  // namespace handsight::app
