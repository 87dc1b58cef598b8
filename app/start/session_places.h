// SPDX-License-Identifier: GPL-3.0-or-later
// Where sessions are: those opened lately, and the samples that come with the program.
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

namespace handsight::app {

struct RecentSession {
  std::filesystem::path file;
  QString title;
  QString state;  // how it stood when it was left: "0.20 px, noise 0.20 px: nothing is missing"; may be empty
  std::vector<double> ratios;  // of its observations, at most 60: rms of one coordinate over the noise
};

/// Newest first, only those that are still there.
std::vector<RecentSession> recent_sessions();
void remember_session(const std::filesystem::path& file, const QString& title);
/// How the session stands; nothing happens where it was never remembered.
void remember_state(const std::filesystem::path& file, const QString& state, const std::vector<double>& ratios);

/// The first image of a session in this folder, read from names alone; empty where it has none.
std::filesystem::path first_image(const std::filesystem::path& session_folder);

struct SampleSession {
  std::string name;  // of its folder
  QString title, sentence;
  std::filesystem::path folder;
};

/// The sample sessions that are found: beside the program's source, or where it was installed.
std::vector<SampleSession> sample_sessions();

/// The user's own copy of a sample, made the first time: work in it is kept, the sample stays as it is. InputError
/// where it cannot be made.
std::filesystem::path working_copy(const SampleSession& sample);

/// Throws the copy away and makes it anew.
std::filesystem::path fresh_copy(const SampleSession& sample);

/// The sample that a session is a copy of; empty where it is none.
std::string take_sample(const std::filesystem::path& session_file);

}  // namespace handsight::app
