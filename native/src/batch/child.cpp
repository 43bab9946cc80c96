#include "batch/child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <vector>

#include "files/system_call.h"

#if defined(__linux__)
#include <sys/prctl.h>
#elif defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

namespace abflat::cli {
namespace {

constexpr int kCannotStart = 127;

/// The child has only calls that are safe after fork.
struct ChildSetup {
  const char* program;
  std::vector<char*> words;
  const char* said;
  rlim_t mostMemory;
  pid_t parent;
};

[[noreturn]] void becomeChild(const ChildSetup& setup) {
#if defined(__linux__)
  // Elsewhere a child whose parent is gone ends its mesh, in a folder that the next run removes.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != setup.parent) _exit(kCannotStart);
#endif
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int said = open(setup.said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int nothing = open("/dev/null", O_RDONLY);
  if (said < 0 || nothing < 0) _exit(kCannotStart);
  if (dup2(nothing, STDIN_FILENO) < 0 || dup2(said, STDOUT_FILENO) < 0 ||
      dup2(said, STDERR_FILENO) < 0)
    _exit(kCannotStart);
  close(said);
  close(nothing);
  if (setup.mostMemory > 0) {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0) _exit(kCannotStart);
    if (limit.rlim_max == RLIM_INFINITY || limit.rlim_max > setup.mostMemory)
      limit.rlim_cur = setup.mostMemory;
    setrlimit(RLIMIT_AS, &limit);
  }
  execv(setup.program, setup.words.data());
  _exit(kCannotStart);
}

}  // namespace

std::string ownProgram() {
#if defined(__linux__)
  return "/proc/self/exe";
#elif defined(__APPLE__)
  std::array<char, PATH_MAX> path{};
  auto size = static_cast<std::uint32_t>(path.size());
  return _NSGetExecutablePath(path.data(), &size) == 0 ? path.data() : "";
#else
  return {};
#endif
}

pid_t startChild(const ChildStart& start) {
  constexpr double kMegabyte = 1024.0 * 1024.0;
  std::vector<std::string> words = start.words;
  ChildSetup setup{start.program.c_str(),
                   {},
                   start.said.c_str(),
                   static_cast<rlim_t>(start.memoryLimit * kMegabyte),
                   getpid()};
  for (std::string& word : words) setup.words.push_back(word.data());
  setup.words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) becomeChild(setup);
  return child;
}

std::optional<ChildEnd> endOf(pid_t child) {
  int status = 0;
  rusage usage{};
  if (uninterrupted([&] { return wait4(child, &status, WNOHANG, &usage); }) != child) return {};
#if defined(__APPLE__)
  constexpr double kPerMegabyte = 1024.0 * 1024.0;
#else
  constexpr double kPerMegabyte = 1024;
#endif
  ChildEnd out;
  if (WIFSIGNALED(status)) out.signal = WTERMSIG(status);
  if (WIFEXITED(status)) out.exitCode = WEXITSTATUS(status);
  out.peakMemory = static_cast<double>(usage.ru_maxrss) / kPerMegabyte;
  return out;
}

}  // namespace abflat::cli
