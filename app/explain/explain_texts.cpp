// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/explain_texts.h"

#include "document/effect_words.h"
#include "widgets/number_text.h"

namespace handsight::app {

QString error_with_unit(double error, bool in_pixels) {
  return widgets::with_unit_text(in_pixels ? error : 1e3 * error, in_pixels ? QObject::tr("px") : QObject::tr("mm"));
}

QString comparison_sentence(const ModelVersion& model) {
  if (!model.fit) return model.refusal;
  const ErrorAndNoise e = error_and_noise(model);
  if (!e.error) return QObject::tr("The error is not known.");
  const QString error = error_with_unit(*e.error, e.in_pixels);
  if (!e.noise)
    return QObject::tr(
               "The model misses by %1. Without three markers the noise is not known, so that the program cannot "
               "say whether that is much.")
        .arg(error);
  const QString noise = error_with_unit(*e.noise, e.in_pixels);
  if (*e.ratio() < 1.25)
    return QObject::tr("The model agrees with the measurements down to the noise (%1 against %2).").arg(error, noise);
  const auto m = model.report->held_out.rms_m ? model.report->held_out.rms_m : model.report->fitted.rms_m;
  const auto in_mm = [](double metres) { return widgets::with_unit_text(1e3 * metres, QObject::tr("mm")); };
  const auto noise_m = model.report->rms_of_noise_m;
  return QObject::tr("The model misses by %1%2 where the noise is %3%4.")
      .arg(error, e.in_pixels && m ? QObject::tr(" (%1 at the hand)").arg(in_mm(*m)) : QString(), noise,
           e.in_pixels && m && noise_m ? QObject::tr(" (%1)").arg(in_mm(*noise_m)) : QString());
}

std::optional<widgets::Blame> session_blame(const Inspection& all) {
  if (all.blame.letter == 0) return std::nullopt;
  return widgets::Blame{all.blame.cameras, all.blame.body, all.blame.robot};
}

namespace {

using widgets::SessionState;

const DiagnosisCandidate* best_named(const Diagnosis& d) {
  for (const DiagnosisCandidate& c : d.candidates)
    if (!c.unnamed) return &c;
  return nullptr;
}

QString blame_sentence(const std::optional<widgets::Blame>& blame) {
  if (!blame) return {};
  const std::pair<double, QString> parts[] = {{blame->robot, QObject::tr("the robot")},
                                              {blame->body, QObject::tr("the marker body")},
                                              {blame->cameras, QObject::tr("the cameras")}};
  const auto& most = *std::max_element(std::begin(parts), std::end(parts),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
  return QObject::tr("%1 % of it comes from %2.").arg(std::lround(100 * most.first)).arg(most.second);
}

QString adequate_sentence(const Diagnosis& d, const ErrorAndNoise& e) {
  QString text =
      QObject::tr("The model agrees with the measurements down to the noise (%1 against %2).")
          .arg(error_with_unit(e.error.value_or(0), e.in_pixels), error_with_unit(e.noise.value_or(0), e.in_pixels));
  QStringList unseen;
  for (const std::string& id : d.invisible) unseen << effect_of(id, {});
  constexpr qsizetype most = 3;
  if (unseen.size() > most) unseen = unseen.mid(0, most) << QObject::tr("%1 more").arg(unseen.size() - most);
  if (!unseen.isEmpty()) text += ' ' + QObject::tr("These poses could not show: %1.").arg(unseen.join(", "));
  return text;
}

QString scatter_sentence(const Diagnosis& d, const ErrorAndNoise& e) {
  return QObject::tr(
             "What is left (%1, noise %2) differs from pose to pose without a pattern: the joints do not repeat better "
             "than %3 mrad. No effect can remove it.")
      .arg(error_with_unit(e.error.value_or(0), e.in_pixels), error_with_unit(e.noise.value_or(0), e.in_pixels),
           widgets::short_text(1e3 * d.scatter));
}

bool is_scatter(const Diagnosis& d, const ErrorAndNoise& e) {
  return d.verdict == Verdict::adequate && d.scatter > 0 && e.ratio().value_or(0) >= 1.25;
}

bool lacks_noise(const Diagnosis& d) { return !weighing(d.model.fit).knowledge.known; }

QString what_is_left_follows(const Diagnosis& d) {
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.unnamed && c.ln_bayes_factor >= d.threshold)
      return QObject::tr("It follows the %1 (%2).")
          .arg(QString::fromStdString(c.unnamed->localiser.variable->name),
               QString::fromStdString(c.unnamed->localiser.best.shape));
  if (d.patterns.empty()) return {};
  return QObject::tr("It follows the %1.").arg(QString::fromStdString(d.patterns.front().against.name));
}

QString unexplained_sentence(const Diagnosis& d, const ErrorAndNoise& e) {
  return QObject::tr("Something real is left (%1 where the noise is %2), and nothing in the catalogue explains it. %3")
      .arg(error_with_unit(e.error.value_or(0), e.in_pixels),
           e.noise ? error_with_unit(*e.noise, e.in_pixels) : QObject::tr("unknown"), what_is_left_follows(d));
}

QString missing_sentence(const ModelVersion& model, const Diagnosis& d, const std::optional<widgets::Blame>& blame) {
  const DiagnosisCandidate& best = *best_named(d);
  const ErrorAndNoise e = error_and_noise(model);
  // How many mm that is at the hand stands beside it.
  QString first = e.error && e.noise
                      ? QObject::tr("The model misses by %1 where the noise is %2.")
                            .arg(error_with_unit(*e.error, e.in_pixels), error_with_unit(*e.noise, e.in_pixels))
                      : comparison_sentence(model);
  const QString whose = blame_sentence(blame);
  if (!whose.isEmpty()) first += ' ' + whose;
  const QString name = effect_of(best.id, best.where);
  if (d.verdict == Verdict::ambiguous && !best.cannot_be_told_from.empty())
    return first + ' ' +
           QObject::tr("%1 or %2: on these poses they look the same.")
               .arg(name.left(1).toUpper() + name.mid(1), effect_of(best.cannot_be_told_from.front(), {}));
  return first + ' ' + QObject::tr("Most likely missing: %1.").arg(name);
}

}  // namespace

widgets::SessionVerdict session_verdict(const ModelVersion& model, const Diagnosis* d, bool is_running,
                                        bool names_lead_on) {
  widgets::SessionVerdict v;
  v.sentence = comparison_sentence(model);
  if (!model.fit) return v;
  const ErrorAndNoise e = error_and_noise(model);
  if (e.in_pixels) {
    v.error_px = e.error;
    v.noise_px = e.noise;
  }
  const auto m = model.report->held_out.rms_m ? model.report->held_out.rms_m : model.report->fitted.rms_m;
  if (m) v.error_mm = 1e3 * *m;
  if (model.report->rms_of_noise_m) v.noise_mm = 1e3 * *model.report->rms_of_noise_m;
  v.blame = session_blame(*model.inspection);
  v.state = SessionState::looking;
  if (!d) {
    if (!is_running) v.state = e.noise ? SessionState::waiting : SessionState::noise_unknown;
    const QString whose = e.ratio().value_or(0) >= 1.25 ? blame_sentence(v.blame) : QString();
    if (!whose.isEmpty()) v.sentence += ' ' + whose;
    return v;
  }
  switch (d->verdict) {
    case Verdict::too_few_observations:
      v.state = SessionState::too_few;
      v.sentence = QString::fromStdString(d->reason);
      break;
    case Verdict::adequate:
      v.state = is_scatter(*d, e) ? SessionState::scatter : SessionState::adequate;
      v.sentence = is_scatter(*d, e) ? scatter_sentence(*d, e) : adequate_sentence(*d, e);
      break;
    case Verdict::missing_effect:
    case Verdict::ambiguous:
      v.state = d->verdict == Verdict::ambiguous ? SessionState::ambiguous : SessionState::missing;
      v.sentence = missing_sentence(model, *d, v.blame);
      break;
    case Verdict::unexplained:
      if (names_lead_on) {
        v.state = SessionState::missing;
        v.sentence = missing_sentence(model, *d, v.blame);
        break;
      }
      v.state = lacks_noise(*d) ? SessionState::noise_unknown : SessionState::unexplained;
      v.sentence = lacks_noise(*d) ? comparison_sentence(model) : unexplained_sentence(*d, e);
      break;
  }
  return v;
}

}  // namespace handsight::app
