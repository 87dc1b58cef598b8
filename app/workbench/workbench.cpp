// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/workbench.h"

#include "diagnosis/verdict/finding.h"
#include "estimation/online/second_look.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

std::optional<widgets::NoiseShape> noise_shape(const InspectionRow& row, const Inspection& all,
                                               widgets::SizeUnit unit) {
  if (!row.ratio || !all.noise) return std::nullopt;
  if (unit == widgets::SizeUnit::millimetre) {
    const auto& noise = all.in_pixels ? row.noise_of_hand_m : row.noise_m;
    const double coordinates = all.in_pixels ? row.hand_coordinates : row.noise_coordinates;
    return noise ? std::optional(widgets::NoiseShape{1e3 * *noise, coordinates}) : std::nullopt;
  }
  return widgets::NoiseShape{unit == widgets::SizeUnit::pixel ? *all.noise : 1, double(row.coordinates)};
}

widgets::CellState cell_state(const Observation& o) {
  if (o.decision == Decision::rejected) return widgets::CellState::rejected;
  if (o.decision == Decision::excluded) return widgets::CellState::excluded;
  return o.sightings.empty() ? widgets::CellState::waiting : widgets::CellState::used;
}

}  // namespace

QString observations_text(const std::vector<std::int64_t>& ids) {
  return ids.size() == 1 ? QObject::tr("observation %1").arg(ids.front())
                         : QObject::tr("%1 observations").arg(ids.size());
}

Workbench::Workbench(QObject* parent) : QObject(parent) {
  const auto know_units = [this] {
    const Inspection* all = inspection();
    units.set_session(!document.session().is_tracker(), !all || all->noise.value_or(0) > 0);
  };
  connect(&document, &Document::opened, this, know_units);
  connect(&document, &Document::model_changed, this, know_units);
  connect(&document, &Document::model_changed, this, &Workbench::look_again);
  connect(&document, &Document::edited, this, [this] {
    // What was chosen may have gone with an undo.
    const auto& observations = document.session().observations;
    if (selection.current().observation && !selected_observation() && !observations.empty())
      selection.select_observation(observations.back().id);
  });
  connect(&document, &Document::closed, this, [this] {
    stories_.clear();
    jobs.cancel();
    background.cancel();
    explaining.cancel();
    images.clear();
    selection.clear();
  });
}

std::shared_ptr<const Diagnosis> Workbench::find_diagnosis(const ModelVersionPointer& model) const {
  return model && model == document.model() ? diagnosing.diagnosis() : nullptr;
}

const Story& Workbench::find_story(const ModelVersionPointer& model) const {
  constexpr std::size_t most_kept = 4;
  Told now{.model = model, .diagnosis = find_diagnosis(model)};
  if (model && model == document.model()) {
    now.refused = refused_now(refused, document);
    now.elsewhere = diagnosing.elsewhere();
  }
  for (const auto& [reported, story] : stories_)
    if (reported == now) return story;
  Story story = !model || !model->fit ? Story{}
                                      : handsight::find_story({.fit = *model->fit,
                                                               .report = *model->report,
                                                               .attribution = model->inspection->attribution,
                                                               .diagnosis = now.diagnosis.get(),
                                                               .refused = now.refused,
                                                               .elsewhere = now.elsewhere});
  stories_.emplace_front(std::move(now), std::move(story));
  if (stories_.size() > most_kept) stories_.pop_back();
  return stories_.front().second;
}

std::vector<BillRow> Workbench::make_bill(const ModelVersionPointer& model) const {
  if (!model || !model->fit) return {};
  const auto inclusion_probabilities = model == document.model() ? diagnosing.inclusion_probabilities() : nullptr;
  return inclusion_probabilities ? with_inclusion_probabilities(model->bill, *inclusion_probabilities) : model->bill;
}

/// What is an observation's own fault (its images, its markers) stays so, whatever all of them lack.
ErrorAttribution Workbench::attribute_error(const InspectionRow& row) const {
  const auto diagnosis = find_diagnosis(document.shown_model());
  if (row.attribution.cause != ErrorCause::robot || !diagnosis || story().causes.empty()) return row.attribution;
  return attribution_by_finding(row.attribution, *diagnosis, refused_now(refused, document));
}

const Inspection* Workbench::inspection() const {
  const ModelVersionPointer model = document.shown_model();
  return model ? model->inspection.get() : nullptr;
}

const InspectionRow* Workbench::row(std::int64_t id) const {
  const Inspection* all = inspection();
  const int index = document.find_index(id);
  if (!all || index < 0 || static_cast<std::size_t>(index) >= all->rows.size()) return nullptr;
  const InspectionRow& row = all->rows[static_cast<std::size_t>(index)];
  return row.markers.empty() ? nullptr : &row;
}

const InspectionRow* Workbench::selected_row() const {
  return selection.current().observation ? row(*selection.current().observation) : nullptr;
}

const Observation* Workbench::selected_observation() const {
  return selection.current().observation ? document.find(*selection.current().observation) : nullptr;
}

std::vector<widgets::ObservationCell> Workbench::cells() const {
  std::vector<widgets::ObservationCell> list;
  const Inspection* all = inspection();
  const auto& observations = document.session().observations;
  list.reserve(observations.size());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& o = observations[i];
    widgets::ObservationCell cell{.id = o.id, .state = cell_state(o), .note = translated(o.reason)};
    if (all && i < all->rows.size() && !all->rows[i].markers.empty()) {
      cell.rms_over_sigma = all->rows[i].ratio;
      cell.coordinates = all->rows[i].coordinates;
      cell.size = units.shown(measure_size(all->rows[i]));
      cell.noise = noise_shape(all->rows[i], *all, cell.size->unit);
    }
    if (sessions.is_any()) cell.session = o.part;
    if (const auto tried = predicted_ratios_.find(o.id); tried != predicted_ratios_.end())
      cell.predicted = tried->second;
    list.push_back(std::move(cell));
  }
  return list;
}

std::vector<widgets::ObservationCell> Workbench::shown_cells() const {
  std::vector<widgets::ObservationCell> list = cells();
  std::erase_if(list, [this](const widgets::ObservationCell& c) { return !sessions.is_observation_shown(c.id); });
  return list;
}

void Workbench::try_out(std::optional<double> error, std::unordered_map<std::int64_t, double> ratios) {
  if (!error && !predicted_error_) return;
  predicted_error_ = error;
  predicted_ratios_ = error ? std::move(ratios) : std::unordered_map<std::int64_t, double>{};
  emit tried();
}

void Workbench::set_blunders(std::vector<Blunder> found) {
  if (blunders_.empty() && found.empty()) return;
  blunders_ = std::move(found);
  emit blunders_changed();
}

void Workbench::exclude(const std::vector<std::int64_t>& ids, const Message& reason) {
  std::vector<std::pair<std::int64_t, EditableState>> after;
  std::vector<std::int64_t> changed;
  for (const std::int64_t id : ids) {
    const Observation* o = document.find(id);
    if (!o || o->decision == Decision::excluded) continue;
    after.push_back({id, {o->sightings, Decision::excluded, reason}});
    changed.push_back(id);
  }
  if (!after.empty()) document.perform(document.make_edit(tr("excluded %1").arg(observations_text(changed)), after));
}

void Workbench::include(const std::vector<std::int64_t>& ids) {
  std::vector<std::pair<std::int64_t, EditableState>> after;
  std::vector<std::int64_t> changed;
  for (const std::int64_t id : ids) {
    const Observation* o = document.find(id);
    if (!o || (o->decision != Decision::excluded && o->decision != Decision::rejected)) continue;
    after.push_back({id, {o->sightings, Decision::none, ""}});
    changed.push_back(id);
  }
  if (!after.empty()) document.perform(document.make_edit(tr("included %1").arg(observations_text(changed)), after));
}

void Workbench::look_again() {
  const ModelVersionPointer model = document.model();
  if (!model || !model->fit) return;
  std::vector<Observation> rejected;
  for (const Observation& o : document.session().observations)
    if (wants_second_look(document.session(), o) && !document.second_looks().contains(o.id)) rejected.push_back(o);
  if (rejected.empty()) return;
  background.start<SecondLooks>(
      "second look",
      tr("Looking again at %1").arg(counted(static_cast<qint64>(rejected.size()), "%n rejected observation(s)")),
      [session = document.shared_session(), model, rejected](JobControl& control) {
        SecondLooks found;
        for (std::size_t i = 0; i < rejected.size() && !control.is_cancelled(); ++i) {
          const Observation& o = rejected[i];
          const ShownImage left =
              read_shown_image(folder(*session) / o.images[0], o.images[0], session->rig->at(0).camera);
          const ShownImage right =
              read_shown_image(folder(*session) / o.images[1], o.images[1], session->rig->at(1).camera);
          if (left.image.isNull() || right.image.isNull()) continue;
          // What was looked at and not found is remembered too, so that it is not looked for again.
          found[o.id] = second_look(*session, *model->fit, o, {grey_image(left.image), grey_image(right.image)})
                            .value_or(std::vector<Sighting>{});
          control.report(static_cast<double>(i + 1) / static_cast<double>(rejected.size()));
        }
        return found;
      },
      [this](const SecondLooks& found) {
        if (document.is_open()) document.take_second_looks(found);
      });
}

}  // namespace handsight::app
