#include "system/compiler.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/identifier.hpp"

namespace treedyn {

namespace fs = std::filesystem;

namespace {

/// An absolute path: one that begins with '-' would be an option to a compiler.
std::string temporary_path() {
  std::error_code problem;
  const char* const chosen = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): one thread
  if (chosen != nullptr && *chosen == '\0') {
    ::unsetenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): one thread
  }
  const fs::path folder = fs::temp_directory_path(problem);
  if (problem) {
    throw InputError({}, fmt::format("TMPDIR: '{}' is no folder; expected one for temporary files",
                                     shown(chosen == nullptr ? "/tmp" : chosen)));
  }
  const std::string path = fs::absolute(folder).string();
  ::setenv("TMPDIR", path.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread; for compilers
  return path + "/treedyn-XXXXXX";
}

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(temporary_path()) {
  if (::mkdtemp(path_.data()) == nullptr) {
    throw InputError({path_, 0, 0},
                     fmt::format("cannot make a temporary folder: {}; expected one in TMPDIR",
                                 std::generic_category().message(errno)));
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

bool succeeds(std::vector<std::string> words, const std::string& output) {
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  const HeldSignals held;
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, arguments.front(), &actions, &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  const int status = error == 0 ? HeldSignals::wait_for(process) : 0;
  return error == 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<std::string> find_compiler(const std::string& scratch) {
  const char* const chosen = std::getenv("CXX");  // NOLINT(concurrency-mt-unsafe): one thread
  for (const char* const candidate : {chosen != nullptr ? chosen : "", "c++", "g++", "clang++"}) {
    std::vector<std::string> compiler = words_in(candidate);
    std::vector<std::string> version = compiler;
    version.emplace_back("--version");
    if (!compiler.empty() && succeeds(version, scratch)) {
      return compiler;
    }
  }
  return {};
}

}  // namespace treedyn
