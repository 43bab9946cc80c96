#include "batch/awaited_signals.h"

#include <sys/select.h>

#include <ctime>

namespace abflat::cli {
namespace {

// A signal handler has no arguments, so its data must be global.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t askedSignal = 0;

constexpr int kAskingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

extern "C" void noteSignal(int signal) {
  if (signal != SIGCHLD) askedSignal = signal;
}

void handle(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  // One that was ignored from the start (nohup) stays ignored.
  if (action.sa_handler == SIG_IGN && signal != SIGCHLD) return;
  action.sa_handler = noteSignal;
  action.sa_flags = 0;
  sigaction(signal, &action, nullptr);
}

}  // namespace

AwaitedSignals::AwaitedSignals() {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : kAskingSignals) sigaddset(&held, signal);
  sigaddset(&held, SIGCHLD);
  sigprocmask(SIG_BLOCK, &held, &before_);
  for (const int signal : kAskingSignals) handle(signal);
  handle(SIGCHLD);
}

AwaitedSignals::~AwaitedSignals() {
  for (const int signal : kAskingSignals) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == noteSignal) std::signal(signal, SIG_DFL);
  }
  std::signal(SIGCHLD, SIG_DFL);
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void AwaitedSignals::wait(double seconds) const {
  timespec time{};
  time.tv_sec = static_cast<std::time_t>(seconds);
  time.tv_nsec = static_cast<long>((seconds - static_cast<double>(time.tv_sec)) * 1e9);
  pselect(0, nullptr, nullptr, nullptr, &time, &before_);
}

int AwaitedSignals::asked() { return askedSignal; }

}  // namespace abflat::cli
