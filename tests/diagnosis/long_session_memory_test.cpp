// SPDX-License-Identifier: Apache-2.0
// Of a hundred thousand observations every copy counts: how many there are at most while the window fits one.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstring>
#include <fstream>

#include "diagnosis/attribution/inspection.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "simulated_stand.h"

namespace handsight {
namespace {

/// Of this process, bytes: VmRSS, what it holds; VmHWM, the most that it has held.
double memory(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(what)) return 1024 * std::stod(line.substr(std::strlen(what) + 1));
  return 0;
}

/// From now on VmHWM is the most that is held after this.
bool forget_the_most() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

TEST(LongSession, IsFittedAndInspectedInFewCopies) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer holds memory of its own";
#endif
  const Session session = simulated({}, 8, 20000);
  const auto held = [] { return static_cast<double>(mallinfo2().uordblks); };
  const double before_copy = held();
  auto copy = std::make_unique<Session>(session);
  const double size = held() - before_copy;
  copy.reset();
  malloc_trim(0);
  const double before = memory("VmRSS");
  if (!forget_the_most()) GTEST_SKIP() << "the system does not tell what was held at most";
  CleanFit clean = fit_without_outliers(session, {});
  const FitReport reported = report(clean.session, clean.fit, {});
  clean.session = {};
  clean.fit.problem.observations.resize(3000);  // as the window keeps it
  const Inspection all = inspect(session, clean.fit, reported, {});
  const double copies = (memory("VmHWM") - before) / size;
  RecordProperty("copies", std::to_string(copies));
  EXPECT_EQ(all.rows.size(), 20000u);
  EXPECT_LT(copies, 6.5);
}

}  // namespace
}  // namespace handsight
