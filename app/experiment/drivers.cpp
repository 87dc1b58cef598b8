// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/drivers.h"

#include <QCoreApplication>
#include <QStandardPaths>

#include "base/text.h"
#include "blunders/mended.h"
#include "document/journal.h"
#include "workbench/preferences.h"

namespace handsight::app {
namespace {

namespace fs = std::filesystem;

constexpr char preference_name[] = "drivers";
constexpr int most_remembered = 8;
constexpr std::size_t observations_to_try = 6, touches_to_try = 30;  // every fixture often enough to be fitted

fs::path folder_of_tries() { return state_folder() / "experiments"; }

/// As the shell reads it back.
QString shell_word(const std::string& text) {
  return '\'' + QString::fromStdString(text).replace('\'', QLatin1String("'\\''")) + '\'';
}

/// Spread over all that can be used.
Session with_few(Session session) {
  std::vector<Observation> used, few;
  for (const Observation& o : session.observations)
    if (is_used(o) && !o.sightings.empty()) used.push_back(o);
  if (used.empty()) used = session.observations;
  const std::size_t count = std::min(session.is_touch() ? touches_to_try : observations_to_try, used.size());
  for (std::size_t i = 0; i < count; ++i) few.push_back(used[i * used.size() / count]);
  session.observations = few;
  return session;
}

/// The third joint that turns, where there are so many.
std::string joint_to_be_off(const Session& session) {
  std::string name;
  int turning = 0;
  for (const std::string& joint : session.joints) {
    const Joint& j = session.robot.joints[static_cast<std::size_t>(find_joint(session.robot, joint))];
    if (j.kind == JointKind::prismatic) continue;
    name = joint;
    if (++turning == 3) break;
  }
  return name;
}

}  // namespace

QStringList recent_drivers() { return preference(preference_name).split('\n', Qt::SkipEmptyParts); }

void remember_driver(const QString& command) {
  const QString line = command.simplified();
  if (line.isEmpty()) return;
  QStringList all = recent_drivers();
  all.removeAll(line);
  all.prepend(line);
  remember_preference(preference_name, all.mid(0, most_remembered).join('\n'));
}

fs::path session_to_try(const Session& session) {
  const std::string name = folder(session).filename().string();
  fs::path place = folder_of_tries() / name;
  for (int i = 2; fs::exists(place); ++i) place = folder_of_tries() / fmt::format("{}_{}", name, i);
  // The robot is a copy too: it stays what it is, however much is measured here and there.
  write_mended(session, {}, place / "robot");
  return write_mended(with_few(session), {}, place / "session").file;
}

bool is_to_try(const fs::path& session_file) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(session_file, error).parent_path();
  return place.filename() == "session" &&
         place.parent_path().parent_path() == fs::weakly_canonical(folder_of_tries(), error);
}

QString simulated_driver(const Session& session) {
  const QString name = QStringLiteral("handsight-driver-simulated");
  const QString here = QCoreApplication::applicationDirPath();  // installed, or where it was built
  QString program = QStandardPaths::findExecutable(name, {here, here + QStringLiteral("/app/cli")});
  if (program.isEmpty()) program = QStandardPaths::findExecutable(name);
  if (program.isEmpty()) return {};
  const fs::path robot = folder(session).parent_path() / "robot";
  QString command = shell_word(program.toStdString()) + ' ' + shell_word(robot.string());
  if (const std::string joint = joint_to_be_off(session); !joint.empty())
    command += QStringLiteral(" --effect ") + shell_word(fmt::format("joint_offset:{}.offset=0.004", joint));
  return command + QStringLiteral(" --in-real-time");
}

}  // namespace handsight::app
