// SPDX-License-Identifier: Apache-2.0
#include "base/image_names.h"

#include <gtest/gtest.h>

namespace handsight::test {
namespace {

std::int64_t number(const std::string& name) {
  const auto moment = moment_in_name(name);
  return moment ? moment->number : -1;
}

TEST(ImageNames, DatesAndTimesAreInOrderOfTime) {
  const std::vector<std::string> in_order{"shot_2024-07-23_16-02-40", "shot_2024-07-23_16-02-47",
                                          "shot_2024-07-23_16-03-01", "shot_2024-07-23_17-00-00",
                                          "shot_2024-07-24_00-00-00", "shot_2025-01-01_00-00-00"};
  for (std::size_t i = 1; i < in_order.size(); ++i) EXPECT_LT(number(in_order[i - 1]), number(in_order[i]));
  EXPECT_LT(number("IMG_20240723_160240123"), number("IMG_20240723_160240124"));
  EXPECT_LT(number("2024-07-23T16:02:40.9"), number("2024-07-23T16:02:41.1"));
  EXPECT_LT(number("1305031102.975304"), number("1305031103.011201"));
  EXPECT_EQ(number("left_20240723160240"), number("right_20240723160240"));
}

TEST(ImageNames, OtherNumbersAreNoDates) {
  for (const char* name :
       {"img_0012", "0-1", "camera_2024_000001", "20249923_160240", "1403636579763555584", "", "pose"})
    EXPECT_EQ(number(name), -1) << name;
}

TEST(ImageNames, FoldersAreToldByTheFirstNameInWhichTheyDiffer) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(telling_names({"a/cam0/data", "a/cam1/data/"}), (Names{"cam0", "cam1"}));
  EXPECT_EQ(telling_names({"x/left", "y/right"}), (Names{"left", "right"}));
  EXPECT_EQ(telling_names({"images"}), (Names{"images"}));
  EXPECT_EQ(telling_names({"same", "same"}), (Names{"same", "same"}));
}

}  // namespace
}  // namespace handsight::test
