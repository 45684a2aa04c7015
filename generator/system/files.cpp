#include "system/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "system/signals.hpp"

namespace treedyn {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw InputError({path, 0, 0},
                   fmt::format("{}: {}", what, std::generic_category().message(error)));
}

/// Makes missing folders; unmakes them unless `keep` is called.
class Folders {
 public:
  void make(const fs::path& folder) {
    std::error_code ignored;
    if (folder.empty() || fs::is_directory(folder, ignored)) {
      return;
    }
    make(folder.parent_path());
    const int error = ::mkdir(folder.c_str(), 0777) == 0 ? 0 : errno;
    if (error == 0) {
      made_.push_back(folder);
    } else if (error != EEXIST || !fs::is_directory(folder, ignored)) {
      fail(folder.string(), "cannot make the output folder", error == EEXIST ? ENOTDIR : error);
    }
  }
  void keep() { made_.clear(); }

  Folders() = default;
  Folders(const Folders&) = delete;
  Folders& operator=(const Folders&) = delete;
  ~Folders() {
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
      ::rmdir(folder->c_str());
    }
  }

 private:
  std::vector<fs::path> made_;
};

/// Keeps others that write sets of files out of a folder, where the file system has locks. A caller
/// may have locked the folder itself, so nobody is waited for longer than two seconds.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(
            ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr int kMostTries = 200;
    for (int k = 0;
         k < kMostTries && ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
         ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }

 private:
  int descriptor_;
};

/// Where a symbolic link to a file leads; of anything else its own path.
std::string end_of_links(const std::string& path) {
  std::error_code ignored;
  const bool leads = fs::is_symlink(path, ignored) && fs::is_regular_file(path, ignored);
  const std::string end = leads ? fs::canonical(path, ignored).string() : "";
  return end.empty() ? path : end;
}

/// A complete copy of a file's new content beside its place. What stood there is put back, and the
/// copy removed, unless `keep` is called.
class Temporary {
 public:
  explicit Temporary(const OutputFile& file) : target_(end_of_links(file.path)) {
    const fs::path folder = fs::path(target_).parent_path();
    path_ =
        (folder / (".treedyn-" + fs::path(target_).filename().string().substr(0, 200) + "-XXXXXX"))
            .string();
    const int descriptor = ::mkstemp(path_.data());
    if (descriptor < 0) {
      path_.clear();
      fail(target_, "cannot write", errno);
    }
    const int error = write_all(descriptor, file.text);
    const int close_error = ::close(descriptor) == 0 ? 0 : errno;
    if (error != 0 || close_error != 0) {
      ::unlink(path_.c_str());
      fail(target_, "cannot write", error != 0 ? error : close_error);
    }
  }
  Temporary(Temporary&& other) noexcept
      : target_(std::move(other.target_)),
        path_(std::exchange(other.path_, {})),
        old_(std::exchange(other.old_, {})),
        is_replaced_(std::exchange(other.is_replaced_, false)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
    if (is_replaced_ && old_.empty()) {
      ::unlink(target_.c_str());
    } else if (is_replaced_) {
      ::rename(old_.c_str(), target_.c_str());
    } else if (!old_.empty()) {
      ::unlink(old_.c_str());
    }
  }

  void put_in_place() {
    set_aside();
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      fail(target_, "cannot write", errno);
    }
    path_.clear();
    is_replaced_ = true;
  }
  void keep() {
    if (!old_.empty()) {
      ::unlink(old_.c_str());
    }
    old_.clear();
    is_replaced_ = false;
  }

 private:
  /// Keeps what stands in the file's place, if anything does, by another link or, where there are
  /// none, by a copy. A link to a file of others might stay in a folder where only they may remove
  /// it.
  void set_aside() {
    const std::string old = path_ + "~";
    struct stat status {};
    if (::lstat(target_.c_str(), &status) != 0 && errno == ENOENT) {
      return;
    }
    const bool is_ours = ::geteuid() == 0 || status.st_uid == ::geteuid();
    if (is_ours && ::link(target_.c_str(), old.c_str()) == 0) {
      old_ = old;
    } else {
      std::error_code ignored;
      if (fs::is_directory(target_, ignored)) {
        fail(target_, "cannot write", EISDIR);
      }
      old_ = old;
      std::error_code error;
      fs::copy_file(target_, old, error);
      if (error) {
        fail(target_, "cannot write", error.value());
      }
    }
  }

  /// Permissions of the file that stands in the place if its owner and group can be kept, too, else
  /// those of a new one.
  [[nodiscard]] mode_t mode(int descriptor) const {
    struct stat status {};
    if (::stat(target_.c_str(), &status) == 0 &&
        ::fchown(descriptor, status.st_uid, status.st_gid) == 0) {
      return status.st_mode & 0777;
    }
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }

  [[nodiscard]] int write_all(int descriptor, std::string_view text) const {
    if (::fchmod(descriptor, mode(descriptor)) != 0 && errno != EPERM) {  // some mounts have none
      return errno;
    }
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor, text.data(), text.size());
      if (written < 0 && errno != EINTR) {
        return errno;
      }
      text.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  }

  std::string target_;
  std::string path_;          ///< of the copy; empty: it is in place
  std::string old_;           ///< of what stood there; empty: nothing
  bool is_replaced_ = false;  ///< the copy stands there
};

}  // namespace

std::optional<std::string> read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (file == nullptr) {
    return std::nullopt;
  }
  std::string text;
  std::array<char, 1 << 16> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), count);
  }
  return std::ferror(file.get()) != 0 ? std::nullopt : std::optional(std::move(text));
}

namespace {

/// That a file which will change may be written: one that may not could still be replaced.
void check_permission(const std::string& path) {
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0 && errno != ENOENT) {
    fail(path, "cannot write", errno);
  }
}

/// Only what is a file, or nothing yet, can be written as a whole.
void check_target(const std::string& path) {
  constexpr std::size_t kLongestName = 255;  // NAME_MAX
  const std::string name = fs::path(path).filename().string();
  if (name.size() > kLongestName) {
    throw InputError({path, 0, 0},
                     fmt::format("file name of {} bytes is too long; expected at most {}",
                                 name.size(), kLongestName));
  }
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) {
    fail(path, "cannot write", EISDIR);
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw InputError({path, 0, 0}, "is no regular file; expected one, or nothing there");
  }
}

}  // namespace

void check_folder(const std::string& folder) {
  std::error_code ignored;
  fs::path there = fs::absolute(folder, ignored);
  while (there.has_relative_path() && !fs::exists(fs::symlink_status(there, ignored))) {
    there = there.parent_path();
  }
  if (!fs::is_directory(there, ignored)) {
    fail(there.string(), "cannot write", ENOTDIR);
  }
  if (::faccessat(AT_FDCWD, there.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    fail(there.string(), "cannot write", errno);
  }
}

int write_files(const std::vector<OutputFile>& files) {
  if (files.empty()) {
    return 0;
  }
  const HeldSignals signals;
  for (const OutputFile& file : files) {
    check_target(file.path);
  }
  Folders folders;
  const fs::path folder = fs::path(files.front().path).parent_path();
  folders.make(folder);
  const FolderLock lock(folder);
  std::vector<Temporary> temporaries;
  temporaries.reserve(files.size());
  for (const OutputFile& file : files) {
    if (!file.always && read_file(file.path) == file.text) {
      continue;
    }
    folders.make(fs::path(file.path).parent_path());
    check_permission(file.path);
    temporaries.emplace_back(file);
  }
  for (Temporary& temporary : temporaries) {
    temporary.put_in_place();
  }
  for (Temporary& temporary : temporaries) {
    temporary.keep();
  }
  folders.keep();
  return static_cast<int>(temporaries.size());
}

}  // namespace treedyn
