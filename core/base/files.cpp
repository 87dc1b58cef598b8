// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/text.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

[[noreturn]] void refuse_file(const fs::path& path, std::string_view what, int error) {
  throw InputError(fmt::format("{}: the file {}: {}.", shown_path(path), what, std::strerror(error)));
}

/// Closes the descriptor at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }
  bool close() {
    const int closing = value_;
    value_ = -1;
    return closing < 0 || ::close(closing) == 0;
  }

 private:
  int value_;
};

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A new file beside the target, with the permissions that the user's new files have.
int make_temporary(const fs::path& folder, std::string& name) {
  static std::atomic<int> count{0};
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = (folder / fmt::format(".handsight-{}-{}.tmp", ::getpid(), ++count)).string();
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/// Gives the new file the permissions of the one that it replaces.
bool keep_permissions(int descriptor, const fs::path& replaced) {
  struct stat old {};
  return ::stat(replaced.c_str(), &old) != 0 || ::fchmod(descriptor, old.st_mode & 07777) == 0;
}

/// Where the bytes really are: through links, even those to a file that does not exist yet.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error || target.empty() ? path : target;
}

}  // namespace

std::string read_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.value() < 0) refuse_file(path, "cannot be opened", errno);
  std::string content;
  std::string block(std::size_t{1} << 16, '\0');
  while (true) {
    const ssize_t count = ::read(file.value(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_file(path, "cannot be read", errno);
    if (count == 0) return content;
    content.append(block, 0, static_cast<std::size_t>(count));
    if (content.size() > largest_file) refuse_file(path, "is longer than 1 GiB", EFBIG);
  }
}

void replace_file(const fs::path& path, std::string_view content) {
  const fs::path target = resolved(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::string temporary;
  Descriptor file(make_temporary(folder, temporary));
  if (file.value() < 0) refuse_file(path, "cannot be written", errno);
  const bool complete = write_all(file.value(), content) && keep_permissions(file.value(), target) &&
                        ::fsync(file.value()) == 0 && file.close() && ::rename(temporary.c_str(), target.c_str()) == 0;
  if (!complete) {
    const int error = errno;
    ::unlink(temporary.c_str());
    refuse_file(path, "cannot be written, and is as it was", error);
  }
  const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.value() >= 0) ::fsync(parent.value());  // the rename itself; not every file system can
}

}  // namespace handsight
