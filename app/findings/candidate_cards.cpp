// SPDX-License-Identifier: GPL-3.0-or-later
// Cards and the table of all effects.
#include <algorithm>

#include "base/percent.h"
#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/verdict/finding.h"
#include "document/curve_words.h"
#include "document/effect_words.h"
#include "findings/explain_texts.h"
#include "findings/proof_plots.h"
#include "findings/robot_checks.h"
#include "widgets/base/number_text.h"
#include "words/core_words.h"
#include "workbench/model_effects.h"

namespace handsight::app {
namespace {

using widgets::CardKind;
using widgets::CardState;

/// The held-out error that it would leave; in mm it is known only where the candidate was fitted.
ResidualSize size_left(const DiagnosisCandidate& c, bool in_pixels, std::optional<double> noise) {
  if (c.held_out) return measure_size(*c.held_out, in_pixels, noise);
  return c.predicted_held_out ? size_of_error(*c.predicted_held_out, in_pixels, noise) : ResidualSize{};
}

/// All three in the unit in force, or all in the session's own where one of them has no value there. The error now is
/// that of the header: of a flange's poses the search has a fit of its own, which does not weigh the robot's own error.
widgets::ErrorLeft card_error(const DiagnosisCandidate& c, const ModelVersion& model, widgets::SizeUnit unit) {
  const auto noise = model.fit->noise;
  const VersionSizes sizes = list_sizes(model, noise);
  const ResidualSize left = size_left(c, model.inspection->in_pixels, noise);
  if (!left.in(unit)) unit = left.pixel ? widgets::SizeUnit::pixel : widgets::SizeUnit::millimetre;
  return {sizes.error().in(unit), left.in(unit), sizes.noise.in(unit), !c.held_out, widgets::unit_name(unit)};
}

/// What speaks for the candidate: what its own proof follows, where the points do follow it, and how much of the excess
/// it explains. That something follows, a wrong candidate has too: how much tells them apart.
QString evidence_text(const DiagnosisCandidate& c, const CandidateView* view) {
  QString text;
  if (view && !view->proof.empty() && followed(view->proof.front()) > least_followed)
    text = is_level(view->proof.front())
               ? QObject::tr("Its points say the same in every pose. ")
               : QObject::tr("Its points follow the %1. ").arg(translated(view->proof.front().against));
  if (c.explained)
    return text + QObject::tr("It explains %1 % of what exceeds the noise.")
                      .arg(QString::fromStdString(whole_percent(*c.explained)));
  return text + QObject::tr("Odds against nothing missing: %1.").arg(odds_text(c.ln_bayes_factor));
}

/// A cause in words; of a target what its numbers mean to who has it in the hand.
QString list_words(const DiagnosisCandidate& c) {
  const Effect& effect = term_effect(c.terms.front());
  if (c.unnamed) return QObject::tr("It has no name in the catalogue: the plot shows the curve that stands for it.");
  const std::vector<double>& values = c.terms.front().values;
  if (c.id == "target_scale") {
    const double sigma = c.sigmas.empty() ? 0 : c.sigmas.front().front();
    const QString percent = widgets::with_sigma_text(100 * std::abs(values.front()), 100 * sigma);
    return (values.front() > 0 ? QObject::tr("The target is %1 % larger than described: printed to fit the page, or a "
                                             "length typed wrong. Every distance seen is wrong by the same share.")
                               : QObject::tr("The target is %1 % smaller than described: printed to fit the page, or a "
                                             "length typed wrong. Every distance seen is wrong by the same share."))
        .arg(percent);
  }
  const double bend = c.id == "target_bend" ? std::max(std::abs(values[0]), std::abs(values[1])) : 0;
  if (bend > 0)
    return QObject::tr("The target is described as flat and is bent, by a radius of %1 m: its edges stand off.")
        .arg(widgets::short_text(1 / bend));
  return translated(effect.cause);
}

QString caution_text(const DiagnosisCandidate& c) {
  switch (find_disbelief(c)) {
    case Disbelief::pushes_back:
      return QObject::tr("A spring that pushes back: no joint is built so. Probably another cause.");
    case Disbelief::too_large:
      return QObject::tr("Larger than robots are built. Probably another cause.");
    case Disbelief::leaves_much:
      return QObject::tr("More than three times what is usual, and it leaves much. Probably another cause.");
    case Disbelief::none:
      break;
  }
  return c.plausible ? QString() : QObject::tr("More than three times what is usual.");
}

CardState card_of(const DiagnosisCandidate& c, const Workbench& workbench, const Diagnosis& d,
                  const ModelVersion& model) {
  const Effect& effect = term_effect(c.terms.front());
  CardState card{.id = QString::fromStdString(find_id(c)), .effect = c.id};
  card.title = make_title(c.terms.front(), workbench.document.session().robot);
  if (!c.unnamed) card.where = places_text(c.where);
  card.words = list_words(c);
  card.add_text = QObject::tr("Add %1").arg(c.unnamed ? QObject::tr("this curve") : within_sentence(card.title));
  card.error = card_error(c, model, workbench.units.unit());
  card.evidence = evidence_text(c, workbench.diagnosing.find_view(find_id(c)).get());
  card.sizes = effect_parameters(workbench.document.session(), c.terms, c.sigmas);
  std::erase_if(card.sizes, [](const widgets::ModelParameter& p) { return p.is_choice; });
  QStringList others;
  for (const std::string& id : c.indistinguishable_from) others << effect_text(id, {});
  card.indistinguishable_from = others.join(", ");
  card.can_show_poses = !others.isEmpty();
  card.check = translated(effect.check);
  card.can_what_if = find_effect(c.id) != nullptr;  // the slider asks the catalogue where it may sit
  if (!c.unnamed) card.check_number = card_check(c.check, workbench.document.find_reading(c.id));
  card.caution = caution_text(c);
  return card;
}

CardState honest_card(CardKind kind, const QString& title, const QString& words) {
  CardState card{.id = "honest", .kind = kind, .title = title, .words = words};
  card.can_add = card.can_what_if = false;
  return card;
}

CardState with_export(CardState card) {
  card.action = QObject::tr("Export it");
  card.action_id = "export";
  return card;
}

bool has_curve(const Workbench& workbench, const ModelVersionPointer& model) {
  const auto diagnosis = workbench.find_diagnosis(model);
  return diagnosis && std::any_of(diagnosis->candidates.begin(), diagnosis->candidates.end(),
                                  [](const DiagnosisCandidate& c) { return c.unnamed.has_value(); });
}

/// " What is left ..."; empty where that is the measurements' noise alone, or it is not known of this model.
QString scatter_sentence(const Workbench& workbench, const ModelVersionPointer& model) {
  const auto diagnosis = workbench.diagnosing.diagnosis();
  if (!diagnosis || !diagnosis->repeatability.is_any() || model != workbench.document.model()) return {};
  const Message size = repeatability_text(diagnosis->repeatability, diagnosis->model.session.joints);
  return size.empty()
             ? QString()
             : ' ' +
                   QObject::tr("Beyond the noise it leaves scatter from pose to pose, as of %1.").arg(translated(size));
}

/// What is said where no cause leads; the verdict's sentence stands above it and is not said again.
std::optional<CardState> honest_card_of(const Workbench& workbench, const ModelVersionPointer& model) {
  const Story& story = workbench.find_story(model);
  switch (story.state) {
    case StoryState::at_the_noise:
      if (!story.stands_in.empty())
        return with_export(honest_card(CardKind::repeatability,
                                       QObject::tr("At the noise, but by something that stands in"),
                                       QObject::tr("It holds for poses like those that were measured, and perhaps for "
                                                   "no others.")));
      return with_export(honest_card(CardKind::adequate, QObject::tr("Nothing is missing"),
                                     QObject::tr("No cause that these poses can show would lower the error on "
                                                 "observations that the fit has not seen.") +
                                         scatter_sentence(workbench, model)));
    case StoryState::unnamed_at_the_noise:
      return with_export(
          honest_card(CardKind::repeatability, QObject::tr("Down at the noise, but not all has a name"),
                      QObject::tr("A curve stands in the model for it; what causes it on the robot is not known.")));
    case StoryState::repeatability:
      return with_export(honest_card(
          CardKind::repeatability, QObject::tr("The remaining error looks random"),
          QObject::tr("There is nothing to add. Poses that are measured again tell how well the robot comes "
                      "back to them.")));
    case StoryState::too_few_observations: {
      CardState card = honest_card(CardKind::too_few, QObject::tr("Too few observations"),
                                   QObject::tr("Poses that differ from those there are tell the most."));
      card.action = QObject::tr("Plan poses");
      card.action_id = "plan";
      return card;
    }
    case StoryState::noise_unknown:
      return honest_card(
          CardKind::noise_unknown, QObject::tr("The noise is unknown"),
          story.causes.empty()
              ? QObject::tr(
                    "The program cannot say when to stop: declare the noise (sigma), or repeat some poses. No cause "
                    "of the catalogue that is not in the model explains more than chance would.")
              : QObject::tr("The program cannot say when to stop: declare the noise (sigma), or repeat some poses."));
    case StoryState::unexplained: {
      CardState card = honest_card(CardKind::unexplained, QObject::tr("Nothing with a name explains it"),
                                   QObject::tr("Look at the plots of what is left, and at the observations that it is "
                                               "largest in."));
      if (!has_curve(workbench, model)) return card;  // it follows nothing
      card.words = QObject::tr("A curve shows what it follows; it has no name in the catalogue.");
      card.action = QObject::tr("Show the curve");
      card.action_id = "curve";
      return card;
    }
    case StoryState::refused:
      return honest_card(CardKind::unexplained, QObject::tr("Nothing that helps is left"),
                         QObject::tr("Why not ...? says of every effect why it was not added."));
    default:
      return std::nullopt;
  }
}

const Refusal* find_refusal(const std::string& id, const Document& document, const std::vector<Refusal>& refused) {
  for (const Refusal& r : refused)
    if (r.id == id && still_stands(r, document)) return &r;
  return nullptr;
}

}  // namespace

QString odds_text(double ln_odds) {
  if (ln_odds > 13.8) return QObject::tr("more than a million to one");
  const double odds = std::exp(std::max(ln_odds, 0.0));
  const double place = std::pow(10, std::max(std::floor(std::log10(odds)) - 1, 0.0));
  return QObject::tr("about %1 to one").arg(std::lround(std::round(odds / place) * place));
}

CardState mistake_card() {
  return honest_card(CardKind::unexplained, QObject::tr("First the mistake"),
                     QObject::tr("Whatever is missing in the model shows once the session is put right: the bar above "
                                 "says how, and writes it."));
}

std::vector<CardState> candidate_cards(const Workbench& workbench, const ModelVersionPointer& model, const Diagnosis& d,
                                       const std::vector<Refusal>& refused) {
  const Story& story = workbench.find_story(model);
  std::vector<CardState> cards;
  for (const StoryCause& cause : story.causes) {
    cards.push_back(card_of(d.candidates[cause.candidate], workbench, d, *model));
    if (const Refusal* r = find_refusal(cause.id, workbench.document, refused)) {
      cards.back().can_add = false;
      cards.back().why_not = cards.back().caution = r->reason;
      cards.back().error.left.reset();  // what it was expected to leave: its fit has shown otherwise
    }
  }
  // Where no cause leads, that is said first.
  if (const std::optional<CardState> honest = honest_card_of(workbench, model))
    cards.insert(story.cause_leads ? cards.end() : cards.begin(), *honest);
  return cards;
}

namespace {

/// 0.1 to 99.9: nothing is quite sure.
QString percent_text(double probability) {
  return QObject::tr("%1 %").arg(widgets::short_text(std::clamp(100 * probability, 0.1, 99.9), 3));
}

/// What is likelier than one in twenty though too little speaks for it to be named, and how sure the model's names are.
void add_inclusion_probabilities(const InclusionProbabilities* inclusion_probabilities, widgets::EffectRow& row) {
  using widgets::EffectVerdict;
  if (!inclusion_probabilities) return;
  for (const InclusionProbability& n : inclusion_probabilities->names) {
    if (n.id != row.id.toStdString()) continue;
    const QString percent = percent_text(n.probability);
    if (n.is_in_model) row.reason = QObject::tr("Sure to %1.").arg(percent) + ' ' + row.reason;
    if (n.is_in_model || row.verdict == EffectVerdict::would_help) return;
    row.where = places_text(n.where);
    const bool says_nothing = row.verdict == EffectVerdict::no_sign || row.verdict == EffectVerdict::same_as;
    const QString sentence =
        QObject::tr("It is there with a probability of %1; predictions allow for it.").arg(percent);
    row.reason = says_nothing ? sentence : row.reason + ' ' + sentence;
    if (says_nothing) row.verdict = EffectVerdict::may_be_there;
  }
}

}  // namespace

std::vector<widgets::EffectRow> effect_rows(const Workbench& workbench, const ModelVersion& model, const Diagnosis& d,
                                            const std::vector<Refusal>& refused) {
  using widgets::EffectVerdict;
  std::vector<widgets::EffectRow> rows;
  const bool in_pixels = error_and_noise(model).in_pixels;
  const Session& session = workbench.document.session();
  std::optional<double> best;
  for (const DiagnosisCandidate& c : d.candidates)
    if (!c.unnamed && c.ln_bayes_factor >= d.threshold && !best) best = c.ln_bayes_factor;
  for (const Effect& effect : catalogue()) {
    widgets::EffectRow row{.id = QString::fromStdString(effect.id), .name = translated(effect.title)};
    const auto candidate = std::find_if(d.candidates.begin(), d.candidates.end(),
                                        [&](const DiagnosisCandidate& c) { return c.id == effect.id; });
    std::vector<EffectTerm> in_model;
    for (const FittedEffect& f : model.fit->effects)
      if (f.term.id == effect.id) in_model.push_back(f.term);
    const bool is_invisible = std::find(d.invisible.begin(), d.invisible.end(), effect.id) != d.invisible.end();
    if (!in_model.empty()) {
      row.verdict = EffectVerdict::in_model;
      row.where = places_text(list_places(in_model, session));
      row.reason = QObject::tr("It is estimated with the rest; the model panel shows its size.");
      if (const RobotReading* reading = workbench.document.find_reading(effect.id)) row.reason = reading_text(*reading);
    } else if (candidate == d.candidates.end()) {
      row.verdict = d.verdict == Verdict::too_few_observations ? EffectVerdict::unknown : EffectVerdict::cannot_be_seen;
      row.reason = row.verdict == EffectVerdict::unknown ? QObject::tr("Too few observations to tell.")
                                                         : QObject::tr("It has no place in this session.");
    } else if (candidate->ln_bayes_factor >= d.threshold) {
      row.where = places_text(candidate->where);
      const bool is_best = candidate->ln_bayes_factor >= best.value_or(0) - 3;
      row.verdict = is_best ? EffectVerdict::would_help : EffectVerdict::worse;
      const widgets::ShownSize left = workbench.units.shown(size_left(*candidate, in_pixels, d.noise));
      row.reason = left.value
                       ? QObject::tr("It would leave %1; odds against nothing missing %2.")
                             .arg(widgets::size_text(left), odds_text(candidate->ln_bayes_factor))
                       : QObject::tr("Odds against nothing missing %1.").arg(odds_text(candidate->ln_bayes_factor));
    } else if (!candidate->held_back.empty()) {
      row.where = places_text(candidate->where);
      row.verdict = EffectVerdict::may_be_there;
      row.reason = QObject::tr("Not named: %1.").arg(translated(candidate->held_back));
    } else if (is_invisible) {
      row.verdict = EffectVerdict::cannot_be_seen;
      row.reason = translated(effect.visibility);
    } else if (!candidate->indistinguishable_from.empty()) {
      row.verdict = EffectVerdict::same_as;
      row.same_as = effect_text(candidate->indistinguishable_from.front(), {});
      row.reason = QObject::tr("On these poses both do the same to the images.");
    } else {
      row.verdict = EffectVerdict::no_sign;
      row.reason = QObject::tr("Nothing in the residuals speaks for it beyond chance.");
    }
    if (const Refusal* r = find_refusal(effect.id, workbench.document, refused)) {
      row.verdict = EffectVerdict::worse;
      row.reason = r->reason;
    }
    add_inclusion_probabilities(workbench.diagnosing.inclusion_probabilities().get(), row);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace handsight::app
