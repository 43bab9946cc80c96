#include "terminal/terminal.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace abflat::cli {

std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const bool isLong = byte == 0xC2 && next >= 0x80 && next < 0xA0;  // U+0080 to U+009F
    out += byte < 0x20 || byte == 0x7F || isLong ? '?' : text[i];
    i += isLong;
  }
  return out;
}

std::string sentence(const std::string& message) {
  const char last = message.empty() ? '.' : message.back();
  return last == '.' || last == '?' || last == '!' ? message : message + ".";
}

void complain(const std::string& message) {
  std::fprintf(stderr, "abflat: %s\n", printable(sentence(message)).c_str());
}

bool isErrorTerminal() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && std::string_view(term ? term : "") != "dumb";
}

void ProgressLine::show(const Progress& p) {
  if (!isEnabled_) return;
  std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * p.fraction, nameOf(p));
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
