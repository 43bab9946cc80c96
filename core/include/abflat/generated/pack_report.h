// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "abflat/generated/baking_report.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/generated/pack_options.h"
#include "abflat/status.h"

namespace abflat {

/// Seconds that each stage of pack took.
struct PackTimings {
  /// Reading the input, in seconds.
  double read = 0;
  /// Packing the charts, in seconds.
  double pack = 0;
  /// Checking and measuring the result, in seconds.
  double check = 0;
  /// Writing the result, in seconds.
  double write = 0;
  /// The whole run, in seconds.
  double total = 0;
};

template <class Visitor>
void visitFields(const PackTimings& r, Visitor& v) {
  v.field("read", r.read);
  v.field("pack", r.pack);
  v.field("check", r.check);
  v.field("write", r.write);
  v.field("total", r.total);
}

/// The report of pack.
struct PackReport {
  /// Name of the input.
  std::string path;
  /// The input.
  MeshSummary input;
  /// The options as asked.
  PackOptionValues options;
  /// Threads that the solver used.
  std::uint32_t threads = 1;
  /// Uv islands: faces joined where they have an edge and its texcoords in common.
  std::size_t islands = 0;
  /// Islands that lay on others, by half of the smaller one or more, and still do: how many lie on
  /// another.
  std::size_t stackedIslands = 0;
  /// Islands that lay on others, by half of the smaller one or more, and still do: how many stacks
  /// they form with those that they lie on.
  std::size_t stackedStacks = 0;
  /// Islands most of whose area runs clockwise; they stay mirrored.
  std::size_t mirrored = 0;
  /// Islands that overlapped others by less, or ones of other materials, and no longer do.
  std::size_t separated = 0;
  /// Faces without texcoords at every corner, which stay as they are.
  std::size_t unmapped = 0;
  /// Faces of islands as they lie now, decided exactly; one may be counted for several reasons: how
  /// many overlap another, or themselves.
  std::size_t facesOverlapping = 0;
  /// Faces of islands as they lie now, decided exactly; one may be counted for several reasons: how
  /// many run clockwise, be it with their whole island.
  std::size_t facesFlipped = 0;
  /// Faces of islands as they lie now, decided exactly; one may be counted for several reasons: how
  /// many have no area in uv.
  std::size_t facesEmpty = 0;
  /// Faces of islands as they lie now, decided exactly; one may be counted for several reasons: how
  /// many are not within one tile.
  std::size_t facesOutside = 0;
  /// Length in uv divided by what it was before; the mean by area, where islands differ.
  double scale = 0;
  /// Share of their tiles that islands covered in the input, or of all tiles around the layout if
  /// one is larger than a tile; what a stack covers counts once.
  double utilizationBefore = 0;
  /// Share of the tiles that they cover now.
  double utilization = 0;
  /// Texels along the longer side of a tile.
  int resolution = 0;
  /// Texels of a tile from u = 0 to 1.
  int width = 0;
  /// Texels of a tile from v = 0 to 1.
  int height = 0;
  /// Texels between islands.
  int padding = 0;
  /// Texels between islands and the edge of their tile.
  int margin = 0;
  /// Unit squares, ten in a row: UDIM 1001 and on.
  int tiles = 1;
  /// Texels per mesh unit, the mean by area; 0 if the faces have no area.
  double texelDensity = 0;
  /// Remarks about the input and the result, one sentence each; why a layout is not valid comes
  /// last.
  std::vector<std::string> notes;
  /// Whether no two islands overlap that did not lie on each other, and each lies in a tile.
  bool valid = false;
  /// Seconds that each stage took.
  PackTimings timings;
  /// What became of the old textures.
  std::optional<BakingReport> baking;
  /// Why there is no result.
  Status error;
};

template <class Visitor>
void visitFields(const PackReport& r, Visitor& v) {
  v.inputSummary("input", r);
  v.options("options", r.options);
  v.field("threads", r.threads);
  v.field("islands", r.islands);
  v.begin("stacked");
  v.field("islands", r.stackedIslands);
  v.field("stacks", r.stackedStacks);
  v.end();
  v.field("mirrored", r.mirrored);
  v.field("separated", r.separated);
  v.field("unmapped", r.unmapped);
  v.begin("faces");
  v.field("overlapping", r.facesOverlapping);
  v.field("flipped", r.facesFlipped);
  v.field("empty", r.facesEmpty);
  v.field("outside", r.facesOutside);
  v.end();
  v.field("scale", r.scale);
  v.field("utilizationBefore", r.utilizationBefore);
  v.field("utilization", r.utilization);
  v.field("resolution", r.resolution);
  v.field("width", r.width);
  v.field("height", r.height);
  v.field("padding", r.padding);
  v.field("margin", r.margin);
  v.field("tiles", r.tiles);
  v.field("texelDensity", r.texelDensity);
  v.field("notes", r.notes);
  v.field("valid", r.valid);
  v.field("timings", r.timings);
  if (r.baking) v.field("baking", *r.baking);
  v.reportError("error", r.error);
}

}  // namespace abflat
