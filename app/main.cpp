// SPDX-License-Identifier: GPL-3.0-or-later
// handsight: the window.
#include <QApplication>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include "base/threads.h"
#include "widgets/scene/robot_view.h"
#include "window/appearance.h"
#include "window/main_window.h"

namespace {

constexpr const char* usage =
    "handsight [SESSION]            opens the window, on a session (its folder or session.xml) where one is named\n"
    "handsight --sample NAME        opens your own copy of a sample session: first_steps, hundred_poses, "
    "thesis_simulation\n"
    "handsight --theme light|dark   instead of the desktop's\n"
    "handsight --version\n";

struct Arguments {
  std::string session, sample, theme, refusal;
  bool wants_help = false, wants_version = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    const auto value = [&](std::string& into) {
      if (i + 1 < argc) {
        into = argv[++i];
      } else {
        a.refusal = text + " wants a value; handsight --help says which.";
      }
    };
    if (text == "--help" || text == "-h") {
      a.wants_help = true;
    } else if (text == "--version") {
      a.wants_version = true;
    } else if (text == "--sample") {
      value(a.sample);
    } else if (text == "--theme") {
      value(a.theme);
      if (a.theme != "light" && a.theme != "dark") a.refusal = "--theme is light or dark, not \"" + a.theme + "\".";
    } else if (text.starts_with("-")) {
      a.refusal = "The option " + text + " does not exist; handsight --help lists those that do.";
    } else if (a.session.empty()) {
      a.session = text;
    } else {
      a.refusal = "One session at a time: \"" + a.session + "\" and \"" + text + "\" are two.";
    }
  }
  return a;
}

/// Qt ends the process by abort() where it finds no display: asked before.
bool has_display() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform && *platform && std::strncmp(platform, "xcb", 3) != 0 && std::strncmp(platform, "wayland", 7) != 0)
    return true;  // the user's own choice
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

int refuse(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace handsight;
  const Arguments arguments = parse(argc, argv);
  if (!arguments.refusal.empty()) return refuse(arguments.refusal);
  if (arguments.wants_help) return std::fputs(usage, stdout), 0;
  if (arguments.wants_version) return std::puts("handsight " HANDSIGHT_VERSION), 0;
  if (!has_display())
    return refuse("There is no display to open a window on; handsight-cli does the same work without one.");
  widgets::set_surface_format();
  QApplication application(argc, argv);
  most_threads() = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);  // one paints
  QApplication::setApplicationName("handsight");
  QApplication::setApplicationVersion(HANDSIGHT_VERSION);
  app::Appearance appearance(application, QString::fromStdString(arguments.theme));
  app::MainWindow window;
  window.offer(appearance);
  if (!arguments.session.empty()) {
    window.open(QString::fromStdString(arguments.session));
  } else if (!arguments.sample.empty()) {
    window.open_sample(QString::fromStdString(arguments.sample));
  }
  window.show();
  return QApplication::exec();
}
