#include "batch/batch_progress.h"

#include <cmath>
#include <cstdio>

namespace abflat::cli {

std::string durationText(double seconds) {
  constexpr long kMinute = 60, kHour = 3600;
  const long all = std::lround(seconds);
  const auto part = [](long count, const char* unit) { return std::to_string(count) + unit; };
  if (all >= kHour) return part(all / kHour, " h ") + part(all % kHour / kMinute, " min");
  if (all >= kMinute) return part(all / kMinute, " min ") + part(all % kMinute, " s");
  return part(all, " s");
}

double BatchProgress::workOf(const Task& task) {
  constexpr double kLeast = 20000;  // starting the program takes as long as that many bytes
  return static_cast<double>(task.bytes) + kLeast;
}

void BatchProgress::add(const Task& task, bool isGood) {
  done_ += task.inputs.size();
  if (!isGood) failed_ += task.inputs.size();
  workDone_ += workOf(task);
}

double BatchProgress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void BatchProgress::show(std::size_t running) {
  if (!isEnabled_) return;
  std::fprintf(stderr, "\r\033[K%zu of %zu done", done_, count_);
  if (failed_ > 0) std::fprintf(stderr, ", %zu not good", failed_);
  std::fprintf(stderr, ", %zu running", running);
  if (done_ > 0) {
    const double left = (work_ - workDone_) * seconds() / workDone_;
    std::fprintf(stderr, ", %.1f per second, %s left", static_cast<double>(done_) / seconds(),
                 durationText(left).c_str());
  }
  std::fflush(stderr);
  isShown_ = true;
}

void BatchProgress::clear() {
  if (!isShown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  isShown_ = false;
}

}  // namespace abflat::cli
