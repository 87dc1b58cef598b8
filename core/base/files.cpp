// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;
constexpr std::string_view unfinished = ".handsight-";

[[noreturn]] void refuse_file(const fs::path& path, const char* what, int error) {
  throw InputError(message("{}: the file {}: {}.", shown_path(path), what, system_text(error)));
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

/// Names of what is not finished: ".handsight-PROCESS-NUMBER" and an ending.
std::string unfinished_name(std::string_view ending) {
  static std::atomic<int> count{0};
  return fmt::format("{}{}-{}{}", unfinished, ::getpid(), ++count, ending);
}

/// The process that a name of something unfinished tells; 0 where it is no such name.
pid_t maker_of(const std::string& name) {
  if (!name.starts_with(unfinished) || !(name.ends_with(".tmp") || name.ends_with(".part"))) return 0;
  const auto number = parse_integer(
      std::string_view(name).substr(unfinished.size(), name.find('-', unfinished.size()) - unfinished.size()));
  return number && *number > 0 && *number <= INT32_MAX ? static_cast<pid_t>(*number) : 0;
}

/// Removes what processes that are gone have left, once for each folder.
void remove_leftovers(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> looked_at;
  const std::scoped_lock lock(mutex);
  if (!looked_at.insert(folder).second) return;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const pid_t maker = maker_of(entry->path().filename().string());
    if (maker != 0 && ::kill(maker, 0) != 0 && errno == ESRCH) fs::remove_all(entry->path(), ignored);
  }
}

/// A new file beside the target, with the permissions that the user's new files have.
int make_temporary(const fs::path& folder, std::string& name) {
  remove_leftovers(folder);
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = (folder / unfinished_name(".tmp")).string();
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/// What stands where something is to be written must be a file that may be written over.
void require_replaceable(const fs::path& path) {
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return;
  if (S_ISDIR(there.st_mode)) refuse_file(path, "cannot be written, and is as it was", EISDIR);
  if (!S_ISREG(there.st_mode))
    throw InputError(
        message("{}: is a device or a pipe and is not written over; name a file, or - for standard "
                "output where an option takes it.",
                shown_path(path)));
  if ((there.st_mode & 0222) == 0 || ::access(path.c_str(), W_OK) != 0)
    throw InputError(message("{}: is write protected and is as it was; name another file.", shown_path(path)));
}

/// Held while a folder's file is compared and replaced; other programs that do the same wait. Where the file system
/// knows no locks, or another holds it for ten seconds, it is done without.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    for (int attempt = 0; folder_.value() >= 0 && attempt < 1000; ++attempt) {
      if (::flock(folder_.value(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
      ::usleep(10'000);
    }
  }
  void flush() const {
    if (folder_.value() >= 0) ::fsync(folder_.value());  // the rename itself; not every file system can
  }

 private:
  Descriptor folder_;
};

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
  // A pipe without a writer would be waited for before it could be looked at.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.value() < 0) refuse_file(path, "cannot be opened", errno);
  struct stat there {};
  if (::fstat(file.value(), &there) != 0) refuse_file(path, "cannot be read", errno);
  if (S_ISDIR(there.st_mode)) refuse_file(path, "cannot be read", EISDIR);
  if (!S_ISREG(there.st_mode))
    throw InputError(message("{}: is a device or a pipe and is not read; expected a regular file.", shown_path(path)));
  if (static_cast<std::uint64_t>(there.st_size) > largest_file) refuse_file(path, "is longer than 1 GiB", EFBIG);
  std::string content;
  content.reserve(static_cast<std::size_t>(there.st_size));
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

namespace {

void replace(const fs::path& path, std::string_view content, const FileDigest* expected) {
  require_replaceable(path);
  const fs::path target = resolved(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const FolderLock lock(folder);
  std::string temporary;
  Descriptor file(make_temporary(folder, temporary));
  if (file.value() < 0) refuse_file(path, "cannot be written", errno);
  bool complete = write_all(file.value(), content) && keep_permissions(file.value(), target) &&
                  ::fsync(file.value()) == 0 && file.close();
  int error = errno;
  if (complete && expected && compute_digest(target) != *expected) {
    ::unlink(temporary.c_str());
    throw InputError(
        message("{}: another program has changed the file since it was read; it is as that program left "
                "it. Run the command again on what it holds now.",
                shown_path(path)));
  }
  if (complete) {
    complete = ::rename(temporary.c_str(), target.c_str()) == 0;
    error = errno;
  }
  if (!complete) {
    ::unlink(temporary.c_str());
    refuse_file(path, "cannot be written, and is as it was", error);
  }
  lock.flush();
}

}  // namespace

void replace_file(const fs::path& path, std::string_view content) { replace(path, content, nullptr); }

void replace_unchanged_file(const fs::path& path, std::string_view content, const FileDigest& expected) {
  replace(path, content, &expected);
}

FileDigest digest_of_content(std::string_view content) {
  // FNV-1a twice, from two starts: no protection against somebody who wants two files to look alike.
  FileDigest digest{content.size(), 14695981039346656037u, 0x9e3779b97f4a7c15u};
  constexpr std::uint64_t prime = 1099511628211u;
  for (const char c : content) {
    digest.first = (digest.first ^ static_cast<unsigned char>(c)) * prime;
    digest.second = (digest.second ^ static_cast<unsigned char>(c)) * prime + (digest.second >> 32);
  }
  return digest;
}

std::optional<FileDigest> compute_digest(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error) && !error) return std::nullopt;
  return digest_of_content(read_file(path));
}

fs::path make_temporary_folder(const fs::path& parent) {
  std::error_code error;
  fs::create_directories(parent, error);
  remove_leftovers(parent);
  fs::path folder = parent / unfinished_name(".part");
  fs::create_directory(folder, error);
  if (error) throw InputError(message("{}: no folder can be made in it: {}.", shown_path(parent), system_text(error)));
  return folder;
}

}  // namespace handsight
