// SPDX-License-Identifier: Apache-2.0
// A bag in MCAP or of ROS 1 is read as far as it goes, to finite numbers, or refused with a sentence.
#include <sys/mman.h>
#include <unistd.h>

#include "fuzz.h"
#include "readers/bag_contents.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

/// A file that is nowhere but in memory.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("bag", MFD_CLOEXEC)) {
    demand(write(descriptor_, data, size) == static_cast<ssize_t>(size), "a file in memory");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

const Robot& robot() {
  static const Robot two = parse_urdf(
      "<robot name=\"r\"><link name=\"l0\"/><link name=\"l1\"/><link name=\"l2\"/>"
      "<joint name=\"a\" type=\"continuous\"><parent link=\"l0\"/><child link=\"l1\"/></joint>"
      "<joint name=\"bb\" type=\"continuous\"><parent link=\"l1\"/><child link=\"l2\"/></joint></robot>",
      "robot.urdf", nullptr);
  return two;
}

}  // namespace
}  // namespace handsight

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handsight;
  const MemoryFile file(data, size);
  const bool is_mcap = size > 1 && data[0] == 0x89;
  try {
    Bag bag;
    bag.name = "bag";
    bag.files.push_back(is_mcap ? open_mcap_bag(file.path(), "bag") : open_ros1_bag(file.path(), "bag"));
    bag.topics = bag.files[0]->topics();
    const BagContents contents = read_bag_contents(bag, robot());
    for (const Eigen::VectorXd& q : contents.joints.positions) demand(q.allFinite(), "readings are finite");
    for (const auto& [name, frame] : contents.frames)
      for (const Rigid& pose : frame.series.poses)
        demand(pose.translation.allFinite() && pose.rotation.allFinite(), "poses are finite");
    for (const Message& message : contents.notes) {
      const std::string note = message;
      demand(is_utf8(note) && note.size() < 700, "notes are sentences", note);
    }
  } catch (const InputError& error) {
    const std::string sentence = error.what();
    demand(sentence.size() >= 20 && sentence.size() <= 600 && is_utf8(sentence), "a refusal is a sentence", sentence);
  }
  return 0;
}
