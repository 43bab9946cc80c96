// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "abflat/generated/mesh_summary.h"
#include "abflat/generated/names.h"
#include "abflat/generated/verify_options.h"
#include "abflat/status.h"

namespace abflat {

/// Something that a layout does not keep to.
struct VerifyFinding {
  /// What is asked.
  VerifyRule rule = VerifyRule::Flipped;
  /// What was found and where, one sentence.
  std::string message;
  /// Faces of the input where it was found: all, or the first hundred.
  std::vector<std::uint32_t> faces;
  /// The islands of these.
  std::vector<std::uint32_t> islands;
  /// What was measured.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// What it should be at least, or at most.
  double limit = std::numeric_limits<double>::quiet_NaN();
};

template <class Visitor>
void visitFields(const VerifyFinding& r, Visitor& v) {
  v.field("rule", r.rule);
  v.field("message", r.message);
  v.field("faces", r.faces);
  v.field("islands", r.islands);
  v.field("value", r.value);
  v.field("limit", r.limit);
}

/// Seconds that each stage of verify took.
struct VerifyTimings {
  /// Reading the input, in seconds.
  double read = 0;
  /// Checking and measuring the result, in seconds.
  double check = 0;
  /// The whole run, in seconds.
  double total = 0;
};

template <class Visitor>
void visitFields(const VerifyTimings& r, Visitor& v) {
  v.field("read", r.read);
  v.field("check", r.check);
  v.field("total", r.total);
}

/// The report of verify.
struct VerifyReport {
  /// Name of the input.
  std::string path;
  /// The mesh that the program compares it with, empty if there is none.
  std::string against;
  /// The input.
  MeshSummary input;
  /// The options as asked.
  VerifyOptionValues options;
  /// Uv islands: faces joined where they have an edge and its texcoords in common.
  std::size_t islands = 0;
  /// Islands most of whose area runs clockwise.
  std::size_t mirrored = 0;
  /// Faces without texcoords at every corner.
  std::size_t unmapped = 0;
  /// Faces of islands, decided exactly on the numbers in the file; one may be counted for several
  /// reasons: how many overlap another, or themselves, stacked ones included.
  std::size_t facesOverlapping = 0;
  /// Faces of islands, decided exactly on the numbers in the file; one may be counted for several
  /// reasons: how many run clockwise, be it with their whole island.
  std::size_t facesFlipped = 0;
  /// Faces of islands, decided exactly on the numbers in the file; one may be counted for several
  /// reasons: how many have no area in uv.
  std::size_t facesEmpty = 0;
  /// Faces of islands, decided exactly on the numbers in the file; one may be counted for several
  /// reasons: how many are not within one tile.
  std::size_t facesOutside = 0;
  /// Islands that overlap: how many overlap themselves.
  std::size_t overlappingThemselves = 0;
  /// Islands that overlap: pairs of which one covers a part of the other.
  std::size_t overlappingPairs = 0;
  /// Islands that overlap: pairs that cover the same place.
  std::size_t overlappingStacked = 0;
  /// UDIM numbers of the tiles that islands are in, 1001 for u and v from 0 to 1.
  std::vector<std::uint32_t> tiles;
  /// In texels: between the two islands that are nearest to each other; those that are stacked
  /// count as one.
  double distanceIslands = std::numeric_limits<double>::quiet_NaN();
  /// In texels: between an island and the edge of its tile; negative if it leaves the tile.
  double distanceEdge = std::numeric_limits<double>::quiet_NaN();
  /// Width of the narrowest island in texels, across the shorter side of its smallest box.
  double narrowest = std::numeric_limits<double>::quiet_NaN();
  /// Texels per mesh unit: mean by area.
  double texelDensityMean = std::numeric_limits<double>::quiet_NaN();
  /// Texels per mesh unit: least of a face.
  double texelDensityMin = std::numeric_limits<double>::quiet_NaN();
  /// Texels per mesh unit: most of a face.
  double texelDensityMax = std::numeric_limits<double>::quiet_NaN();
  /// Texels per mesh unit: of the densest island to the least dense one.
  double texelDensityRatio = std::numeric_limits<double>::quiet_NaN();
  /// Symmetric Dirichlet energy / 4, the mean over all islands by 3D area, each island at its own
  /// scale; faces without area in uv are left out.
  double symmetricDirichlet = std::numeric_limits<double>::quiet_NaN();
  /// The same, of the island where it is largest.
  double worstStretch = std::numeric_limits<double>::quiet_NaN();
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): mean by 3D area.
  double quasiConformalMean = std::numeric_limits<double>::quiet_NaN();
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): maximum.
  double quasiConformalMax = std::numeric_limits<double>::quiet_NaN();
  /// Share of the tiles that islands cover; stacked ones count once, other overlaps twice.
  double utilization = 0;
  /// What the layout does not keep to; of each rule all, or the first hundred.
  std::vector<VerifyFinding> findings;
  /// Remarks about the input, one sentence each.
  std::vector<std::string> notes;
  /// Whether nothing was found.
  bool valid = false;
  /// Seconds that each stage took.
  VerifyTimings timings;
  /// Why there is no result.
  Status error;
};

template <class Visitor>
void visitFields(const VerifyReport& r, Visitor& v) {
  v.field("against", r.against);
  v.inputSummary("input", r);
  v.options("options", r.options);
  v.field("islands", r.islands);
  v.field("mirrored", r.mirrored);
  v.field("unmapped", r.unmapped);
  v.begin("faces");
  v.field("overlapping", r.facesOverlapping);
  v.field("flipped", r.facesFlipped);
  v.field("empty", r.facesEmpty);
  v.field("outside", r.facesOutside);
  v.end();
  v.begin("overlapping");
  v.field("themselves", r.overlappingThemselves);
  v.field("pairs", r.overlappingPairs);
  v.field("stacked", r.overlappingStacked);
  v.end();
  v.field("tiles", r.tiles);
  v.begin("distance");
  v.field("islands", r.distanceIslands);
  v.field("edge", r.distanceEdge);
  v.end();
  v.field("narrowest", r.narrowest);
  v.begin("texelDensity");
  v.field("mean", r.texelDensityMean);
  v.field("min", r.texelDensityMin);
  v.field("max", r.texelDensityMax);
  v.field("ratio", r.texelDensityRatio);
  v.end();
  v.field("symmetricDirichlet", r.symmetricDirichlet);
  v.field("worstStretch", r.worstStretch);
  v.begin("quasiConformal");
  v.field("mean", r.quasiConformalMean);
  v.field("max", r.quasiConformalMax);
  v.end();
  v.field("utilization", r.utilization);
  v.field("findings", r.findings);
  v.field("notes", r.notes);
  v.field("valid", r.valid);
  v.field("timings", r.timings);
  v.reportError("error", r.error);
}

}  // namespace abflat
