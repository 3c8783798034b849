#include "apps/cli/interrupt.h"

#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace honeycomb::Cli {
namespace {

// A signal handler has nothing but globals to speak through.
std::atomic<int> receivedSignal{0};
static_assert(std::atomic<int>::is_always_lock_free);

void failEveryWrite() {
  rlimit fileSize{};
  if (getrlimit(RLIMIT_FSIZE, &fileSize) != 0) return;
  fileSize.rlim_cur = 0;
  setrlimit(RLIMIT_FSIZE, &fileSize);
}

// getrlimit and setrlimit are bare system calls: safe here, though POSIX doesn't list them.
void onInterrupt(int signal) {
  receivedSignal.store(signal);
  failEveryWrite();
}

void handleInterrupts(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void prepareSignals() {
  std::signal(SIGXFSZ, SIG_IGN);
}

InterruptScope::InterruptScope() {
  handleInterrupts(onInterrupt);
}

InterruptScope::~InterruptScope() {
  if (interruptSignal() == 0) handleInterrupts(SIG_DFL);
}

int interruptSignal() {
  return receivedSignal.load();
}

void dieOfInterrupt() {
  const int signal = interruptSignal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::_Exit(128 + signal);
}

}  // namespace honeycomb::Cli
