#include "memory/pages.h"

#include <cstdlib>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/auxv.h>
#include <unistd.h>
#endif

namespace abflat::cli {

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kMostKept = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, kMostKept);
  mallopt(M_TRIM_THRESHOLD, kMostKept);
#endif
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

namespace {

constexpr char kTunables[] = "GLIBC_TUNABLES";

bool canAskForHugePages() {
  if (std::getenv(kTunables) || std::getenv("LD_PRELOAD")) return false;
  std::string modes;
  std::getline(std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"), modes);
  return modes.find("[madvise]") != std::string::npos;
}

/// Empty if it is not known, or the loader was started by name, whose path it would be.
std::string ownPath() {
  if (getauxval(AT_BASE) == 0) return {};
  std::string out(4096, '\0');
  const ssize_t length = readlink("/proc/self/exe", out.data(), out.size());
  const bool isWhole = length > 0 && static_cast<std::size_t>(length) < out.size();
  out.resize(isWhole ? static_cast<std::size_t>(length) : 0);
  return out;
}

}  // namespace

void beginWithHugePages(char** arguments) {
  if (!canAskForHugePages()) return;
  const std::string path = ownPath();
  if (path.empty() || setenv(kTunables, "glibc.malloc.hugetlb=1", 0) != 0) return;
  execv(path.c_str(), arguments);  // if that fails, small pages do
}

#else

void beginWithHugePages(char**) {}

#endif

}  // namespace abflat::cli
