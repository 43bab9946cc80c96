#include "terminal.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace abflat::cli {

void complain(const std::string& message) { std::fprintf(stderr, "abflat: %s\n", message.c_str()); }

bool isErrorTerminal() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && std::string_view(term ? term : "") != "dumb";
}

void ProgressLine::show(const Progress& p) {
  if (!isEnabled_) return;
  std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * p.fraction, p.stage);
  if (p.newtonStep > 0)
    std::fprintf(stderr, ": Newton step %d, residual %.1e", p.newtonStep, p.constraintResidual);
  std::fflush(stderr);
  isShown_ = true;
}

void ProgressLine::clear() {
  if (!isShown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  isShown_ = false;
}

}  // namespace abflat::cli
