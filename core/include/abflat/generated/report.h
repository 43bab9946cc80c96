// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/generated/chart_report.h"
#include "abflat/generated/flatten_options.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/status.h"

namespace abflat {

/// The report of flatten.
struct Report {
  /// Name of the input.
  std::string path;
  /// The input.
  MeshSummary input;
  /// The options as asked.
  FlattenOptionValues options;
  /// Threads that the solver used.
  std::uint32_t threads = 1;
  /// One entry per chart; a disk has one.
  std::vector<ChartReport> charts;
  /// Whether every chart is valid and converged.
  bool valid = false;
  /// Seconds that each stage took.
  Timings timings;
  /// Why there is no result.
  Status error;
};

template <class Visitor>
void visitFields(const Report& r, Visitor& v) {
  v.inputSummary("input", r);
  v.options("options", r.options);
  v.field("threads", r.threads);
  v.field("charts", r.charts);
  v.field("valid", r.valid);
  v.field("timings", r.timings);
  v.reportError("error", r.error);
}

}  // namespace abflat
