#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "abflat/compare.h"
#include "commands/commands.h"
#include "files/input_file.h"
#include "files/out_of_memory.h"
#include "files/output_file.h"
#include "files/paths.h"
#include "terminal/terminal.h"

namespace abflat::cli {
namespace {

/// A distortion, as a column of the table; less is better.
struct Measure {
  const char* title;
  int decimals;
  double MethodResult::*value;
};
constexpr std::array<Measure, 4> kMeasures = {{
    {"angular", 5, &MethodResult::angularDistortion},
    {"length", 4, &MethodResult::lengthDistortion},
    {"area", 4, &MethodResult::areaDistortion},
    {"conformal", 4, &MethodResult::quasiConformalMean},
}};

template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// Aligned decimals if the number is small enough; rounding noise is shown as 0.
std::string measureText(const Measure& measure, double value) {
  constexpr double kWidest = 1e4, kNoise = 1e-12;
  const double narrowest = std::pow(10.0, 1 - measure.decimals);
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return "infinite";
  if (value >= kWidest) return formatted("%.2e", value);
  if (value > kNoise && value < narrowest) return formatted("%.1e", value);
  return formatted("%.*f", measure.decimals, value);
}

/// The least value among the valid layouts, as printed: values that look equal are equally good.
std::string bestText(const std::vector<MethodResult>& rows, const Measure& measure) {
  double least = NAN;
  for (const MethodResult& row : rows)
    if (row.valid) least = std::fmin(least, row.*measure.value);
  return measureText(measure, least);
}

std::string rowText(const MethodResult& row, const std::vector<MethodResult>& rows) {
  std::string out = formatted("%-27s%9.3f", row.title.c_str(), row.seconds);
  for (const Measure& m : kMeasures) {
    const std::string value = measureText(m, row.*m.value);
    out += formatted("%11s%c", value.c_str(), row.valid && value == bestText(rows, m) ? '*' : ' ');
  }
  out += row.uv.empty() ? formatted("%8s%11s", "-", "-")
                        : formatted("%8zu%11zu", row.flippedTriangles, row.boundaryCrossings);
  return out + (row.valid ? "  yes\n" : "  no\n");
}

std::string comparisonTable(const Comparison& comparison, const std::string& name) {
  const MeshSummary& input = comparison.input;
  std::string out =
      name + formatted(": %zu %s, %zu vertices, %zu on the boundary\n\n", input.triangles,
                       input.triangles == 1 ? "triangle" : "triangles", input.vertices,
                       input.boundaryEdges);
  out += formatted("%-27s%9s", "method", "seconds");
  for (const Measure& m : kMeasures) out += formatted("%11s ", m.title);
  out += formatted("%8s%11s  %s\n", "flipped", "crossings", "valid");
  for (const MethodResult& row : comparison.methods) out += rowText(row, comparison.methods);
  out +=
      "\n* least of the valid layouts. Angular, length, area: distortion, 0 is none; conformal: 1 "
      "is perfect.\n";
  for (const MethodResult& row : comparison.methods)
    if (!row.valid) out += row.title + ": " + row.problem + "\n";
  return out;
}

}  // namespace

int runCompare(const CompareCommand& command) {
  const std::string name = inputName(command.input);
  const auto ended = [](const Status& status) {
    complain(status.message);
    return exitCodeOf(status.code);
  };
  OutputFile out(command.json.empty() ? kStandardStream : command.json);
  if (const Status s = out.check(); !s.ok()) return ended(s);
  const Result<InputFile> input = readInput(command.input, {Repeated::Join, command.allowsOutside});
  if (!input.ok()) return ended(input.status());
  ProgressLine line(isErrorTerminal());
  CompareOptions options;
  options.progress = [&](const Progress& p) {
    line.show(p);
    return true;
  };
  const Result<Comparison> comparison =
      orOutOfMemory(name, [&] { return compare(input.value().mesh, options); });
  line.clear();
  if (!comparison.ok())
    return ended({comparison.status().code, comparison.status().code == StatusCode::OutOfMemory
                                                ? comparison.status().message
                                                : name + ": " + comparison.status().message});
  const Status written =
      out.writeNow(command.json.empty() ? comparisonTable(comparison.value(), printable(name))
                                        : compareJson(comparison.value(), name));
  return written.ok() ? static_cast<int>(ExitCode::Valid) : ended(written);
}

}  // namespace abflat::cli
