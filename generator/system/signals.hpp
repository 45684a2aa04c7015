// Signals that wait while files are half done.
#pragma once

#include <csignal>

namespace treedyn {

/// While it lives, SIGINT, SIGQUIT, SIGTERM and SIGHUP wait; then they do what they do.
class HeldSignals {
 public:
  HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals();

  /// Waits for the end of a child process and passes on to its group a signal that arrives.
  /// \returns its status as waitpid does.
  static int wait_for(pid_t process);

 private:
  sigset_t before_;
};

}  // namespace treedyn
