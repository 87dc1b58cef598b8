// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbench/preferences.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "document/journal.h"

namespace handsight::app {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path preferences_file() { return state_folder() / "preferences.json"; }

Json read_preferences() {
  try {
    Json all = Json::parse(read_file(preferences_file()));
    if (all.is_object()) return all;
  } catch (const std::exception&) {
    // Never chose anything, or the file is broken: then everything is as at first.
  }
  return Json::object();
}

}  // namespace

QString preference(const QString& name) {
  const Json all = read_preferences();
  const auto found = all.find(name.toStdString());
  return found != all.end() && found->is_string() ? QString::fromStdString(found->get<std::string>()) : QString();
}

void remember_preference(const QString& name, const QString& choice) {
  Json all = read_preferences();
  all[name.toStdString()] = choice.toStdString();
  std::error_code error;
  std::filesystem::create_directories(state_folder(), error);
  try {
    replace_file(preferences_file(), all.dump(1, ' ', false, Json::error_handler_t::replace));
  } catch (const InputError&) {
    // Where nothing can be kept the choice holds for this window, which is no reason to refuse it.
  }
}

}  // namespace handsight::app
