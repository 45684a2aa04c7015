#include "dynamics/shared_library.hpp"

#include <dlfcn.h>

#include <utility>

#include "common/error.hpp"
#include "system/compiler.hpp"
#include "system/files.hpp"

namespace treedyn {

SharedLibrary::SharedLibrary(std::string what, const std::vector<emit::File>& files,
                             const std::vector<std::string>& options)
    : what_(std::move(what)) {
  const TemporaryFolder folder;
  std::vector<std::string> command = find_compiler(folder.file("version"));
  if (command.empty()) {
    throw InputError({}, what_ + ": no C++ compiler found; expected $CXX, c++, g++ or clang++");
  }
  command.insert(command.end(), {"-std=c++11", "-O2", "-shared", "-fPIC"});
  command.insert(command.end(), options.begin(), options.end());
  std::vector<OutputFile> written;
  for (const emit::File& file : files) {
    written.push_back({folder.file(file.name), file.text});
    if (file.name.ends_with(".cpp")) {
      command.push_back(folder.file(file.name));
    }
  }
  write_files(written);
  command.insert(command.end(), {"-o", folder.file("library.so")});
  if (!succeeds(command, folder.file("log"))) {
    throw InputError({},
                     what_ + ": the generated functions do not compile; expected a C++11 compiler");
  }
  handle_ = ::dlopen(folder.file("library.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    throw InputError({}, what_ + ": the compiled functions cannot be loaded");
  }
}

SharedLibrary::~SharedLibrary() { ::dlclose(handle_); }

void* SharedLibrary::address(const char* name) const {
  void* const result = ::dlsym(handle_, name);
  if (result == nullptr) {
    throw InputError({}, what_ + ": the compiled functions cannot be loaded");
  }
  return result;
}

}  // namespace treedyn
