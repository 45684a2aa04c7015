#include "system/signals.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <initializer_list>

namespace treedyn {

namespace {

/// What waits; SIGCHLD so that it can be waited for.
sigset_t held() {
  sigset_t result;
  ::sigemptyset(&result);
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGCHLD}) {
    ::sigaddset(&result, signal);
  }
  return result;
}

}  // namespace

HeldSignals::HeldSignals() : before_() {
  const sigset_t more = held();
  ::sigprocmask(SIG_BLOCK, &more, &before_);
}

HeldSignals::~HeldSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

int HeldSignals::wait_for(pid_t process) {
  const sigset_t waiting = held();
  int status = 0;
  int passed_on = 0;
  while (::waitpid(process, &status, passed_on == 0 ? WNOHANG : 0) == 0) {
    const int signal = ::sigwaitinfo(&waiting, nullptr);
    if (signal > 0 && signal != SIGCHLD) {
      passed_on = signal;
      ::kill(-process, signal);
    }
  }
  if (passed_on != 0) {
    ::kill(::getpid(), passed_on);  // waits until nothing holds it
  }
  return status;
}

}  // namespace treedyn
