#include "files/leftovers.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

namespace abflat::cli {
namespace {

/// A path to remove. Slots are reused but never freed, since a signal may come at any time.
struct Slot {
  std::atomic<bool> isUsed{false};
  char path[PATH_MAX] = {};
  std::atomic<Slot*> next{nullptr};
};

// A signal handler has no arguments, so its data must be global and lock-free.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
Slot slots;
/// kRunning, kEnding, or kPaused + the pending signal (0: none).
std::atomic<int> state{0};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

constexpr int kRunning = 0, kEnding = 1, kPaused = 1 << 8;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<Slot*>::is_always_lock_free);

void removeAndEnd(int signal) {
  for (const Slot* slot = &slots; slot != nullptr; slot = slot->next)
    if (slot->isUsed) unlink(slot->path);
  // Restores the default action, so that the parent process sees which signal ended the program.
  std::signal(signal, SIG_DFL);
  sigset_t own;
  sigemptyset(&own);
  sigaddset(&own, signal);
  pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  raise(signal);
}

extern "C" void onSignal(int signal) {
  const int error = errno;
  int now = state;
  while (now != kEnding) {
    const int next = now == kRunning ? kEnding : kPaused + signal;
    if (!state.compare_exchange_weak(now, next)) continue;
    if (next == kEnding) removeAndEnd(signal);
    break;
  }
  errno = error;
}

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

void watchSignals() {
  for (const int signal : kEndingSignals) {
    struct sigaction action {};
    // A signal that was ignored from the start (nohup) stays ignored.
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) {
      action.sa_handler = onSignal;
      action.sa_flags = SA_RESTART;
      sigaction(signal, &action, nullptr);
    }
  }
}

}  // namespace

SignalPause::SignalPause() {
  watchSignals();
  int now = kRunning;
  // Another thread may already be ending the program.
  while (!state.compare_exchange_weak(now, kPaused)) {
    if (now == kEnding) pause();
    now = kRunning;
  }
}

SignalPause::~SignalPause() {
  const int error = errno;
  const int signal = state.exchange(kRunning) - kPaused;
  if (signal != 0) raise(signal);
  errno = error;
}

bool SignalPause::hasSignal() const { return state != kPaused; }

void removeOnSignal(const std::string& path) {
  if (path.size() >= PATH_MAX) return;  // no such file can be opened
  Slot* slot = &slots;
  while (slot->isUsed) {
    if (slot->next == nullptr) slot->next = new Slot;
    slot = slot->next;
  }
  std::memcpy(slot->path, path.c_str(), path.size() + 1);
  slot->isUsed = true;
}

void keepOnSignal(const std::string& path) {
  for (Slot* slot = &slots; slot != nullptr; slot = slot->next)
    if (slot->isUsed && path == slot->path) slot->isUsed = false;
}

}  // namespace abflat::cli
