#include "leftovers.h"

#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

namespace abflat::cli {
namespace {

struct Slot {
  volatile std::sig_atomic_t used = 0;
  char path[PATH_MAX] = {};
};

// The layout and the report. A signal handler has no arguments: what it removes must be global.
Slot slots[2];  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

extern "C" void removeAndEnd(int signal) {
  for (const Slot& slot : slots)
    if (slot.used) unlink(slot.path);
  // The default action again: whoever started the program sees which signal ended it.
  std::signal(signal, SIG_DFL);
  raise(signal);
}

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP};

void watchSignals() {
  for (int signal : kEndingSignals) {
    struct sigaction action {};
    // A signal that was ignored from the start (nohup) stays ignored.
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) {
      action.sa_handler = removeAndEnd;
      sigaction(signal, &action, nullptr);
    }
  }
}

}  // namespace

SignalPause::SignalPause() {
  sigset_t paused;
  sigemptyset(&paused);
  for (int signal : kEndingSignals) sigaddset(&paused, signal);
  pthread_sigmask(SIG_BLOCK, &paused, &before_);
}

SignalPause::~SignalPause() {
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  errno = error;
}

void removeOnSignal(const std::string& path) {
  if (path.size() >= PATH_MAX) return;  // no such file can be opened
  watchSignals();
  for (Slot& slot : slots) {
    if (slot.used) continue;
    std::memcpy(slot.path, path.c_str(), path.size() + 1);
    slot.used = 1;
    return;
  }
}

void keepOnSignal(const std::string& path) {
  for (Slot& slot : slots)
    if (slot.used && path == slot.path) slot.used = 0;
}

}  // namespace abflat::cli
