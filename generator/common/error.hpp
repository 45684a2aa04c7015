// Errors: mistakes of an input (reported with their place) and broken invariants (fatal).
#pragma once

#include <stdexcept>
#include <string>

namespace treedyn {

/// A place in an input file; line and column count from 1, 0 means unknown.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column", without the parts that are unknown.
std::string to_string(const Location& where);

/// A mistake in an input. `what()` is the one line that `main` prints: "file:line:column: message".
class InputError : public std::runtime_error {
 public:
  InputError(const Location& where, const std::string& message);
  /// The message without its place.
  [[nodiscard]] const std::string& message() const { return message_; }
  [[nodiscard]] const Location& where() const { return where_; }

 private:
  Location where_;
  std::string message_;
};

/// An input that is right, but beyond what the program carries.
class TooLarge : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A remark that does not stop the program (`info`, `vet` and `generate` print it).
struct Warning {
  Location where;
  std::string message;
};

[[noreturn]] void broken_invariant(const char* condition, const char* file, int line);

}  // namespace treedyn

/// States an invariant of ours; if it does not hold the program stops.
#define TREEDYN_EXPECT(condition) \
  ((condition) ? void() : ::treedyn::broken_invariant(#condition, __FILE__, __LINE__))
