#include "batch/batch_text.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

#include "batch/batch_progress.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

struct StatusTotal {
  std::size_t count = 0;
  double seconds = 0, peakMemory = 0;
};

std::map<MeshStatus, StatusTotal> totalsOf(const ManifestLines& lines) {
  std::map<MeshStatus, StatusTotal> out;
  for (const auto& [name, line] : lines) {
    StatusTotal& total = out[line.status];
    total.count += line.inputs.size();
    total.seconds += line.seconds;
    total.peakMemory = std::max(total.peakMemory, line.peakMemory);
  }
  return out;
}

}  // namespace

std::string batchText(const ManifestLines& lines, const std::string& manifest) {
  constexpr int kWord = 16, kCount = 8, kTime = 14, kMemory = 12;
  std::ostringstream out;
  out << std::left << std::setw(kWord) << "status" << std::right << std::setw(kCount) << "meshes"
      << std::setw(kTime) << "time" << std::setw(kMemory) << "peak MB"
      << "\n";
  for (const auto& [status, total] : totalsOf(lines))
    out << std::left << std::setw(kWord) << wordFor(status) << std::right << std::setw(kCount)
        << total.count << std::setw(kTime) << durationText(total.seconds) << std::setw(kMemory)
        << std::fixed << std::setprecision(0) << total.peakMemory << "\n";
  constexpr std::size_t kShown = 10;
  std::size_t bad = 0;
  for (const auto& [name, line] : lines)
    if (!line.isGood() && ++bad <= kShown)
      out << printable(name) << ": " << wordFor(line.status) << ": "
          << printable(sentence(line.message)) << "\n";
  if (bad > kShown) out << "and " << bad - kShown << " more. ";
  if (bad > 0) out << "See " << printable(manifest) << "\n";
  return out.str();
}

}  // namespace abflat::cli
