// SPDX-License-Identifier: GPL-3.0-or-later
// Paths as they are typed into a field. Internal to the wizard.
#pragma once

#include <QLineEdit>
#include <filesystem>
#include <vector>

namespace handsight::app {

inline std::filesystem::path path_of(const QLineEdit* edit) { return edit->text().trimmed().toStdString(); }

/// Several, separated by semicolons.
inline std::vector<std::filesystem::path> list_paths(const QLineEdit* edit) {
  std::vector<std::filesystem::path> list;
  for (const QString& part : edit->text().split(';'))
    if (!part.trimmed().isEmpty()) list.emplace_back(part.trimmed().toStdString());
  return list;
}

}  // namespace handsight::app
