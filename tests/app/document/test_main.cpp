// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <stdlib.h>

#include <QCoreApplication>

#include "app/document/killed_writer.h"
#include "temporary_folder.h"

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  if (argc > 1 && std::string(argv[1]) == "--write-until-killed")
    return handsight::test::write_until_killed(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const handsight::TemporaryFolder state;  // journals of tests do not meet the user's
  ::setenv("XDG_STATE_HOME", state.path.c_str(), 1);
  return RUN_ALL_TESTS();
}
