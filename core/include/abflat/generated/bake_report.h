// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/bake_options.h"
#include "abflat/generated/baking_report.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/status.h"

namespace abflat {

/// Seconds that each stage of bake took.
struct BakeTimings {
  /// Reading the input, in seconds.
  double read = 0;
  /// Writing the result, in seconds.
  double write = 0;
  /// The whole run, in seconds.
  double total = 0;
};

template <class Visitor>
void visitFields(const BakeTimings& r, Visitor& v) {
  v.field("read", r.read);
  v.field("write", r.write);
  v.field("total", r.total);
}

/// The report of bake.
struct BakeReport {
  /// Name of the input.
  std::string path;
  /// The input.
  MeshSummary input;
  /// The options as asked.
  BakeOptionValues options;
  /// Number of the set with the layout.
  std::size_t texcoord = 0;
  /// What became of the old textures.
  std::optional<BakingReport> baking;
  /// Faces without texcoords in that set at every corner.
  std::size_t unmapped = 0;
  /// Remarks about the input and the result, one sentence each.
  std::vector<std::string> notes;
  /// Whether there is a result.
  bool valid = false;
  /// Seconds that each stage took.
  BakeTimings timings;
  /// Why there is no result.
  Status error;
};

template <class Visitor>
void visitFields(const BakeReport& r, Visitor& v) {
  v.inputSummary("input", r);
  v.options("options", r.options);
  v.field("texcoord", r.texcoord);
  if (r.baking) v.field("baking", *r.baking);
  v.field("unmapped", r.unmapped);
  v.field("notes", r.notes);
  v.field("valid", r.valid);
  v.field("timings", r.timings);
  v.reportError("error", r.error);
}

}  // namespace abflat
