// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/edit.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "effects/own_effect.h"
#include "session/fixtures/find_fixture.h"
#include "session/session_xml.h"

namespace handsight::app {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json point_json(const Vector& v) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v[i]);
  return list;
}

template <class Vector>
std::optional<Vector> point_of(const Json& parent, const char* key) {
  if (!parent.contains(key)) return std::nullopt;
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = parent.at(key).at(static_cast<std::size_t>(i)).get<double>();
  return v;
}

/// Of a camera's points and images in a journal.
std::string find_key(int camera) {
  return camera == 0 ? "left" : camera == 1 ? "right" : "camera_" + std::to_string(camera);
}

/// With its parts, so that it is said in the language of who reads it; its form alone where it has no arguments.
Json message_json(const Message& message) {
  if (message.kind() == Message::Kind::form && message.arguments().empty()) return message.form();
  Json arguments = Json::array();
  for (const Message& argument : message.arguments()) arguments.push_back(message_json(argument));
  return {{"kind", static_cast<int>(message.kind())}, {"text", message.form()}, {"arguments", arguments}};
}

Message parse_message_json(const Json& json) {
  if (json.is_string()) return looked_up(json.get<std::string>());
  std::vector<Message> arguments;
  for (const Json& argument : json.at("arguments")) arguments.push_back(parse_message_json(argument));
  const int kind = std::clamp(json.at("kind").get<int>(), 0, static_cast<int>(Message::Kind::sequence));
  return {static_cast<Message::Kind>(kind), json.at("text").get<std::string>(), std::move(arguments)};
}

Json state_json(const EditableState& state) {
  Json sightings = Json::array();
  for (const Sighting& s : state.sightings) {
    Json one{{"marker", s.marker}, {"by", static_cast<int>(s.by)}};
    for (const CameraPoint& seen : s.in_cameras) {
      one[find_key(seen.camera)] = point_json(seen.pixel);
      if (seen.sigma) one[find_key(seen.camera) + "_sigma"] = {seen.sigma->u, seen.sigma->v, seen.sigma->uv};
    }
    if (s.point) one["point"] = point_json(*s.point);
    if (s.along) one["along"] = point_json(*s.along);
    if (s.reading) one["reading"] = s.reading->name;
    if (s.point_sigma) one["sigma"] = *s.point_sigma;
    sightings.push_back(std::move(one));
  }
  return {
      {"sightings", sightings}, {"decision", static_cast<int>(state.decision)}, {"reason", message_json(state.reason)}};
}

/// Of all boards of a collection together.
constexpr int most_markers = 8 * most_session_points;

int within(const Json& value, int lowest, int highest) {
  const int number = value.get<int>();
  if (number < lowest || number > highest) throw InputError("A number in the journal is out of its range.");
  return number;
}

std::optional<PixelSigma> sigma_of(const Json& parent, const char* key) {
  const auto numbers = point_of<Vector3>(parent, key);
  return numbers ? std::optional(PixelSigma{numbers->x(), numbers->y(), numbers->z()}) : std::nullopt;
}

/// Null: a point, or a coordinate of one.
const Reading* reading_of(const Json& sighting) {
  if (sighting.value("by_distance", false)) return find_reading("distance");  // before readings had names
  if (!sighting.contains("reading")) return nullptr;
  const Reading* const reading = find_reading(sighting.at("reading").get<std::string>());
  if (!reading) throw InputError("A reading in the journal is of no known kind.");
  return reading;
}

EditableState parse_state(const Json& json) {
  EditableState state;
  for (const Json& one : json.at("sightings")) {
    Sighting& s = state.sightings.emplace_back();
    s.marker = within(one.at("marker"), 0, most_markers - 1);
    s.by = static_cast<MarkedBy>(within(one.at("by"), 0, 2));
    s.point = point_of<Vector3>(one, "point");
    s.along = point_of<Vector3>(one, "along");
    s.reading = reading_of(one);
    for (int c = 0; c < max_cameras; ++c)
      if (const auto pixel = point_of<Vector2>(one, find_key(c).c_str()))
        see(s, c, *pixel, sigma_of(one, (find_key(c) + "_sigma").c_str()));
    if (one.contains("sigma")) s.point_sigma = one.at("sigma").get<double>();
  }
  state.decision = static_cast<Decision>(within(json.at("decision"), 0, 3));
  state.reason = parse_message_json(json.at("reason"));
  return state;
}

bool holds_a_number(const EffectTerm& t) {
  return std::any_of(t.held.begin(), t.held.end(), [](char held) { return held != 0; });
}

bool same_definition(const EffectTerm& a, const EffectTerm& b) {
  if (a.own == b.own) return true;
  if (!a.own || !b.own || !a.own->definition != !b.own->definition) return false;
  if (!a.own->definition) return true;  // of the session's cameras: the id says it
  return effect_definition_text(*a.own->definition) == effect_definition_text(*b.own->definition);
}

bool same_term(const EffectTerm& a, const EffectTerm& b) {
  if (a.id != b.id || a.place != b.place || a.values != b.values || a.size != b.size || !same_definition(a, b))
    return false;
  return (!holds_a_number(a) && !holds_a_number(b)) || a.held == b.held;
}

Json observation_json(const Observation& o) {
  Json json{{"id", o.id}, {"time", o.time}, {"position", point_json(o.position)}};
  for (int c = 0; c < max_cameras; ++c)
    if (const std::string& image = o.images[static_cast<std::size_t>(c)]; c < 2 || !image.empty())
      json[find_key(c)] = image;
  if (o.torque.size() > 0) json["torque"] = std::vector<double>(o.torque.begin(), o.torque.end());
  if (o.part > 0) json["part"] = o.part;  // which fixture was touched
  return json;
}

Observation parse_observation(const Json& json, const Session* session) {
  Observation o;
  o.id = json.at("id").get<std::int64_t>();
  o.time = json.at("time").get<double>();
  const auto position = json.at("position").get<std::vector<double>>();
  o.position = Eigen::Map<const Eigen::VectorXd>(position.data(), static_cast<Eigen::Index>(position.size()));
  for (int c = 0; c < max_cameras; ++c) o.images[static_cast<std::size_t>(c)] = json.value(find_key(c), std::string());
  const auto torque = json.value("torque", std::vector<double>());
  if (torque.size() == position.size())
    o.torque = Eigen::Map<const Eigen::VectorXd>(torque.data(), static_cast<Eigen::Index>(torque.size()));
  const int parts = session ? static_cast<int>(session->parts.size()) : 0;
  if (json.contains("part")) o.part = within(json["part"], 0, std::max(0, parts - 1));
  return o;
}

Json terms_json(const std::vector<EffectTerm>& terms) {
  Json list = Json::array();
  for (const EffectTerm& t : terms) {
    list.push_back({{"id", t.id}, {"place", t.place}, {"values", t.values}});
    if (is_small(t)) list.back()["size"] = t.size;
    if (holds_a_number(t)) list.back()["held"] = std::vector<int>(t.held.begin(), t.held.end());
    if (t.own && t.own->definition) list.back()["definition"] = effect_definition_text(*t.own->definition);
  }
  return list;
}

/// Made again from its definition for the session's robot; InputError where that cannot be.
std::shared_ptr<const Effect> parse_own(const Json& definition, const Session* session) {
  if (!session) throw InputError("The journal holds an effect by formula, and no robot is known to make it for.");
  const std::string text = "<handsight_effects version=\"1\">" + definition.get<std::string>() + "</handsight_effects>";
  const std::vector<EffectDefinition> read = parse_effect_definitions(text, "the journal");
  if (read.size() != 1) throw InputError("The journal holds an effect by formula that this version does not know.");
  return own_effect(read.front(), session->robot);
}

/// That of the session's cameras, which stands in place of the catalogue's; null where the catalogue's will do.
std::shared_ptr<const Effect> of_cameras(const std::string& id, const Session* session) {
  if (!session || !session->rig) return nullptr;
  for (const std::shared_ptr<const Effect>& effect : list_own_effects(*session, make_chain(*session)))
    if (effect->id == id && !effect->definition) return effect;
  return nullptr;
}

std::vector<EffectTerm> parse_terms(const Json& settings, const char* key, const Session* session) {
  std::vector<EffectTerm> terms;
  if (!settings.contains(key)) return terms;
  for (const Json& one : settings.at(key)) {
    EffectTerm term{one.at("id").get<std::string>(), within(one.at("place"), -1, 1 << 20),
                    one.at("values").get<std::vector<double>>()};
    if (one.contains("held"))
      for (const int held : one["held"].get<std::vector<int>>()) term.held.push_back(held != 0 ? 1 : 0);
    if (one.contains("size")) {
      term.size = one["size"].get<double>();
      if (!(term.size > 0 && term.size <= 1)) throw InputError("The journal holds an effect of a size that cannot be.");
    }
    term.own = one.contains("definition") ? parse_own(one["definition"], session) : of_cameras(term.id, session);
    const Effect* effect = term.own ? term.own.get() : find_effect(term.id);
    if (!effect || effect->id != term.id || effect->parameters.size() != term.values.size() ||
        (!term.held.empty() && term.held.size() != term.values.size()))
      throw InputError("The journal holds an effect that this version does not know.");
    terms.push_back(term);
  }
  return terms;
}

Json settings_json(const ModelSettings& s) {
  Json json{{"objective", static_cast<int>(s.objective)}, {"fix_markers", s.fix_markers}};
  if (!s.estimated.empty()) json["estimated"] = terms_json(s.estimated);
  if (!s.held.empty()) json["held"] = terms_json(s.held);
  if (s.by_hand > 0) json["by_hand"] = s.by_hand;
  return json;
}

ModelSettings parse_settings(const Json& json, const Session* session) {
  ModelSettings s{static_cast<Objective>(within(json.at("objective"), 0, 2)), json.at("fix_markers").get<bool>(),
                  parse_terms(json, "estimated", session), parse_terms(json, "held", session)};
  s.by_hand = std::clamp(json.value("by_hand", 0), 0, static_cast<int>(s.estimated.size()));
  return s;
}

Json reading_json(const std::optional<RobotReading>& reading) {
  if (!reading) return nullptr;
  const CheckPrediction& p = reading->predicted;
  return {{"value", reading->value},
          {"sigma", reading->sigma},
          {"predicted",
           {{"before", message_json(p.before)},
            {"after", message_json(p.after)},
            {"value", p.value},
            {"sigma", p.sigma},
            {"unit", p.unit},
            {"observation", p.observation ? Json(*p.observation) : Json(nullptr)}}}};
}

std::optional<RobotReading> parse_reading_json(const std::string& effect, const Json& json) {
  if (json.is_null()) return std::nullopt;
  RobotReading reading{effect, json.at("value").get<double>(), json.at("sigma").get<double>(), {}};
  const Json& p = json.at("predicted");
  reading.predicted = {parse_message_json(p.at("before")), parse_message_json(p.at("after")),
                       p.at("value").get<double>(),        p.at("sigma").get<double>(),
                       p.at("unit").get<std::string>(),    std::nullopt};
  if (!p.at("observation").is_null()) reading.predicted.observation = p.at("observation").get<std::int64_t>();
  return reading;
}

Json draft_json(const std::optional<LabelDraft>& draft) {
  if (!draft) return nullptr;
  Json list = Json::array();
  for (const DraftMarker& m : *draft) {
    list.push_back({{"marker", m.marker}, {"left", point_json(m.left)}, {"free", m.left_is_free}});
    if (m.right) list.back()["right"] = point_json(*m.right);
  }
  return list;
}

Vector2 point_at(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

std::optional<LabelDraft> parse_draft(const Json& json) {
  if (json.is_null()) return std::nullopt;
  LabelDraft draft;
  for (const Json& one : json)
    draft.push_back({within(one.at("marker"), 0, 63), point_at(one.at("left")), one.at("free").get<bool>(),
                     point_of<Vector2>(one, "right")});
  return draft;
}

DraftEdit parse_draft_edit(const Json& json) {
  return {json.at("observation").get<std::int64_t>(), parse_draft(json.at("before")), parse_draft(json.at("after"))};
}

ReadingEdit parse_reading_edit(const Json& json) {
  const std::string effect = json.at("effect").get<std::string>();
  if (!find_effect(effect)) throw InputError("The journal holds an effect that this version does not know.");
  return {effect, parse_reading_json(effect, json.at("before")), parse_reading_json(effect, json.at("after"))};
}

}  // namespace

bool ModelSettings::operator==(const ModelSettings& o) const {
  const auto same = [](const std::vector<EffectTerm>& a, const std::vector<EffectTerm>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_term);
  };
  return objective == o.objective && fix_markers == o.fix_markers && same(estimated, o.estimated) &&
         same(held, o.held) && by_hand == o.by_hand;
}

Edit joined(Edit earlier, const Edit& later) {
  earlier.sentence = later.sentence;
  earlier.added.insert(earlier.added.end(), later.added.begin(), later.added.end());
  for (const ObservationEdit& edit : later.observations) {
    // The one that was changed last is the likeliest to change again.
    const auto found = std::find_if(earlier.observations.rbegin(), earlier.observations.rend(),
                                    [&](const ObservationEdit& known) { return known.id == edit.id; });
    if (found == earlier.observations.rend()) {
      earlier.observations.push_back(edit);
    } else {
      found->after = edit.after;
    }
  }
  if (later.settings)
    earlier.settings = {earlier.settings ? earlier.settings->before : later.settings->before, later.settings->after};
  if (later.reading) earlier.reading = later.reading;  // readings never join others
  if (later.draft) {
    const bool is_same = earlier.draft && earlier.draft->observation == later.draft->observation;
    const auto before = is_same ? earlier.draft->before : later.draft->before;
    earlier.draft = {later.draft->observation, before, later.draft->after};
  }
  return earlier;
}

std::string edit_text(const Edit& edit) {
  Json json{{"sentence", edit.sentence.toStdString()}, {"joins", edit.joins}};
  Json observations = Json::array();
  for (const ObservationEdit& o : edit.observations)
    observations.push_back({{"id", o.id}, {"before", state_json(o.before)}, {"after", state_json(o.after)}});
  json["observations"] = std::move(observations);
  for (const Observation& o : edit.added) json["added"].push_back(observation_json(o));
  if (edit.settings)
    json["settings"] = {{"before", settings_json(edit.settings->before)},
                        {"after", settings_json(edit.settings->after)}};
  if (edit.reading)
    json["reading"] = {{"effect", edit.reading->effect},
                       {"before", reading_json(edit.reading->before)},
                       {"after", reading_json(edit.reading->after)}};
  if (edit.draft)
    json["draft"] = {{"observation", edit.draft->observation},
                     {"before", draft_json(edit.draft->before)},
                     {"after", draft_json(edit.draft->after)}};
  if (edit.collection) json["collection"] = {{"before", edit.collection->before}, {"after", edit.collection->after}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Edit parse_edit(const std::string& text, const Session* session) {
  try {
    const Json json = Json::parse(text);
    Edit edit;
    edit.sentence = QString::fromStdString(json.at("sentence").get<std::string>());
    edit.joins = json.at("joins").get<std::int64_t>();
    for (const Json& o : json.value("added", Json::array())) edit.added.push_back(parse_observation(o, session));
    for (const Json& o : json.at("observations"))
      edit.observations.push_back(
          {o.at("id").get<std::int64_t>(), parse_state(o.at("before")), parse_state(o.at("after"))});
    if (json.contains("settings"))
      edit.settings = {parse_settings(json["settings"].at("before"), session),
                       parse_settings(json["settings"].at("after"), session)};
    if (json.contains("reading")) edit.reading = parse_reading_edit(json["reading"]);
    if (json.contains("draft")) edit.draft = parse_draft_edit(json["draft"]);
    if (json.contains("collection"))
      edit.collection = CollectionEdit{json["collection"].at("before").get<std::string>(),
                                       json["collection"].at("after").get<std::string>()};
    return edit;
  } catch (const Json::exception&) {
    throw InputError("A line of the journal is no action that this version understands.");
  }
}

}  // namespace handsight::app
