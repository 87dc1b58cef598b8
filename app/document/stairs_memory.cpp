// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/stairs_memory.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "document/journal.h"

namespace handsight::app {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

fs::path file_of(const fs::path& session_file) {
  return state_folder() / "stairs" / (compute_digest(fs::weakly_canonical(session_file).string()) + ".json");
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> number_of(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number() ? std::optional(json[key].get<double>()) : std::nullopt;
}

Json errors_json(const ErrorSummary& e) {
  return {{"px", number(e.rms_pixel)},
          {"m", number(e.rms_m)},
          {"mean", number(e.mean_m)},
          {"max", number(e.max_m)},
          {"hand", number(e.hand_m)}};
}

ErrorSummary errors_of(const Json& json, const char* key) {
  if (!json.contains(key)) return {};
  const Json& e = json[key];
  return {number_of(e, "px"), number_of(e, "m"), number_of(e, "mean"), number_of(e, "max"), number_of(e, "hand")};
}

}  // namespace

std::vector<RememberedStair> remembered_stairs(const fs::path& session_file) {
  std::vector<RememberedStair> stairs;
  try {
    const Json list = Json::parse(read_file(file_of(session_file)));
    for (const Json& one : list)
      stairs.push_back({one.at("index").get<int>(), QString::fromStdString(one.at("action").get<std::string>()),
                        QString::fromStdString(one.at("cause").get<std::string>()), errors_of(one, "fitted"),
                        errors_of(one, "held_out")});
  } catch (const std::exception&) {
    stairs.clear();  // never written, or broken: a picture, no more
  }
  return stairs;
}

void remember_stairs(const fs::path& session_file, const std::vector<RememberedStair>& stairs) {
  Json list = Json::array();
  for (const RememberedStair& s : stairs)
    list.push_back({{"index", s.index},
                    {"action", s.action.toStdString()},
                    {"cause", s.cause.toStdString()},
                    {"fitted", errors_json(s.fitted)},
                    {"held_out", errors_json(s.held_out)}});
  std::error_code error;
  fs::create_directories(file_of(session_file).parent_path(), error);
  try {
    replace_file(file_of(session_file), list.dump(1, ' ', false, Json::error_handler_t::replace));
  } catch (const InputError&) {
    return;
  }
}

}  // namespace handsight::app
