// Generated functions, compiled for this machine and loaded.
#pragma once

#include <string>
#include <vector>

#include "emit/unit.hpp"

namespace treedyn {

/// A shared library; its file is gone while it is in use.
class SharedLibrary {
 public:
  /// Compiles files as C++11; headers may be among them.
  /// \param what  begins the message of an error: who asks for it
  /// \throws InputError without a compiler that can
  SharedLibrary(std::string what, const std::vector<emit::File>& files,
                const std::vector<std::string>& options);
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;
  ~SharedLibrary();

  /// A function with C linkage. \throws InputError if it is not there
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return reinterpret_cast<Function>(address(name));
  }

 private:
  [[nodiscard]] void* address(const char* name) const;

  std::string what_;
  void* handle_ = nullptr;
};

}  // namespace treedyn
