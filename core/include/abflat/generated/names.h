// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstdint>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

namespace abflat {

/// What made the layout of a chart.
enum class Solver : std::uint8_t {
  ActiveSet = 0,  ///< Newton's method with an active set
  InteriorPoint = 1,  ///< an interior point method, where the layout of the active set cannot be drawn
  Tutte = 2,  ///< Tutte's embedding on a circle, where nothing else is valid or all else is stretched beyond use
  Known = 3,  ///< the layout of an earlier run
  Given = 4,  ///< the texcoords of the input
  Projection = 5,  ///< projection of a flat chart onto its plane
};

inline const char* nameOf(Solver code) {
  switch (code) {
    case Solver::ActiveSet:
      return "activeSet";
    case Solver::InteriorPoint:
      return "interiorPoint";
    case Solver::Tutte:
      return "tutte";
    case Solver::Known:
      return "known";
    case Solver::Given:
      return "given";
    case Solver::Projection:
      return "projection";
  }
  return "";
}

/// What a chart looks like.
enum class ChartShape : std::uint8_t {
  Other = 0,  ///< none of the others
  Rectangle = 1,  ///< a rectangle, less than three times as long as wide
  Strip = 2,  ///< a rectangle at least three times as long as wide
  Disc = 3,  ///< a disc, or a regular polygon with eight corners or more
  Ring = 4,  ///< a disc with a hole
};

inline const char* nameOf(ChartShape code) {
  switch (code) {
    case ChartShape::Other:
      return "other";
    case ChartShape::Rectangle:
      return "rectangle";
    case ChartShape::Strip:
      return "strip";
    case ChartShape::Disc:
      return "disc";
    case ChartShape::Ring:
      return "ring";
  }
  return "";
}

/// What is wrong with a face in uv.
enum class UvFault : std::uint8_t {
  Overlapping = 1,  ///< it overlaps another face, or itself
  Flipped = 2,  ///< it runs clockwise
  Empty = 4,  ///< it has no area
  Outside = 8,  ///< it is not within one tile
};

inline const char* nameOf(UvFault code) {
  switch (code) {
    case UvFault::Overlapping:
      return "overlapping";
    case UvFault::Flipped:
      return "flipped";
    case UvFault::Empty:
      return "empty";
    case UvFault::Outside:
      return "outside";
  }
  return "";
}

/// A stage of a run.
enum class Stage : std::uint8_t {
  Read = 0,  ///< reading the input
  Connectivity = 1,  ///< finding the surface and its boundary
  Surface = 2,  ///< finding the surface in the mesh
  Seams = 3,  ///< choosing seams
  Solve = 4,  ///< flattening: the angles alone, or in unwrap all of it
  Layout = 5,  ///< turning angles into positions
  Refine = 6,  ///< trading angles for lengths
  Pack = 7,  ///< packing the charts
  Check = 8,  ///< checking and measuring the result
  Write = 9,  ///< writing the result
};

inline const char* nameOf(Stage code) {
  switch (code) {
    case Stage::Read:
      return "read";
    case Stage::Connectivity:
      return "connectivity";
    case Stage::Surface:
      return "surface";
    case Stage::Seams:
      return "seams";
    case Stage::Solve:
      return "solve";
    case Stage::Layout:
      return "layout";
    case Stage::Refine:
      return "refine";
    case Stage::Pack:
      return "pack";
    case Stage::Check:
      return "check";
    case Stage::Write:
      return "write";
  }
  return "";
}

/// What verify asks of a layout.
enum class VerifyRule : std::uint8_t {
  Flipped = 0,  ///< a face runs clockwise, or against the rest of its island
  Empty = 1,  ///< a face with area has none in uv
  Overlap = 2,  ///< an island overlaps itself
  OverlapBetween = 3,  ///< an island overlaps another
  Stacked = 4,  ///< islands cover the same place
  Outside = 5,  ///< an island is not within one tile
  Padding = 6,  ///< two islands are too near each other
  Margin = 7,  ///< an island is too near the edge of its tile
  Thin = 8,  ///< an island is too narrow
  Density = 9,  ///< a face has too few or too many texels per mesh unit
  DensityRatio = 10,  ///< islands differ too much in texels per mesh unit
  Stretch = 11,  ///< an island is stretched too much
  Utilization = 12,  ///< islands cover too little of the tiles
  Islands = 13,  ///< there are too many islands
  Unmapped = 14,  ///< a face has no texcoords
  Geometry = 15,  ///< faces are not those of the mesh that it is compared with
  Order = 16,  ///< faces or vertices are in another order than in that mesh
  Attributes = 17,  ///< normals, colors, materials or others are not those of that mesh
};

inline const char* nameOf(VerifyRule code) {
  switch (code) {
    case VerifyRule::Flipped:
      return "flipped";
    case VerifyRule::Empty:
      return "empty";
    case VerifyRule::Overlap:
      return "overlap";
    case VerifyRule::OverlapBetween:
      return "overlapBetween";
    case VerifyRule::Stacked:
      return "stacked";
    case VerifyRule::Outside:
      return "outside";
    case VerifyRule::Padding:
      return "padding";
    case VerifyRule::Margin:
      return "margin";
    case VerifyRule::Thin:
      return "thin";
    case VerifyRule::Density:
      return "density";
    case VerifyRule::DensityRatio:
      return "densityRatio";
    case VerifyRule::Stretch:
      return "stretch";
    case VerifyRule::Utilization:
      return "utilization";
    case VerifyRule::Islands:
      return "islands";
    case VerifyRule::Unmapped:
      return "unmapped";
    case VerifyRule::Geometry:
      return "geometry";
    case VerifyRule::Order:
      return "order";
    case VerifyRule::Attributes:
      return "attributes";
  }
  return "";
}

inline const char* textOf(VerifyRule code) {
  switch (code) {
    case VerifyRule::Flipped:
      return "a face runs clockwise, or against the rest of its island";
    case VerifyRule::Empty:
      return "a face with area has none in uv";
    case VerifyRule::Overlap:
      return "an island overlaps itself";
    case VerifyRule::OverlapBetween:
      return "an island overlaps another";
    case VerifyRule::Stacked:
      return "islands cover the same place";
    case VerifyRule::Outside:
      return "an island is not within one tile";
    case VerifyRule::Padding:
      return "two islands are too near each other";
    case VerifyRule::Margin:
      return "an island is too near the edge of its tile";
    case VerifyRule::Thin:
      return "an island is too narrow";
    case VerifyRule::Density:
      return "a face has too few or too many texels per mesh unit";
    case VerifyRule::DensityRatio:
      return "islands differ too much in texels per mesh unit";
    case VerifyRule::Stretch:
      return "an island is stretched too much";
    case VerifyRule::Utilization:
      return "islands cover too little of the tiles";
    case VerifyRule::Islands:
      return "there are too many islands";
    case VerifyRule::Unmapped:
      return "a face has no texcoords";
    case VerifyRule::Geometry:
      return "faces are not those of the mesh that it is compared with";
    case VerifyRule::Order:
      return "faces or vertices are in another order than in that mesh";
    case VerifyRule::Attributes:
      return "normals, colors, materials or others are not those of that mesh";
  }
  return "";
}

constexpr int kVerifyRuleCount = 18;

/// A method of compare.
enum class MethodKey : std::uint8_t {
  AbflatAuto = 0,  ///< flatten with t = auto
  AbflatConvex = 1,  ///< flatten with t = 1
  AbflatFree = 2,  ///< flatten with t = 2
  AbflatBalanced = 3,  ///< flatten with t = auto and balance = 0.5
  SymmetricDirichlet = 4,  ///< least symmetric Dirichlet energy (Smith and Schaefer 2015): flatten with t = auto and balance = 1
  Mips = 5,  ///< least MIPS energy (Hormann and Greiner 2000): flatten with t = auto and balance = 10⁻⁶, where the other term moves nothing
  Tutte = 6,  ///< on a circle, every interior vertex at the mean of its neighbours (Tutte 1963); valid except for rounding
  MeanValue = 7,  ///< on a circle, mean value coordinates (Floater 2003); valid except for rounding
  Harmonic = 8,  ///< on a circle, cotangent weights for the least Dirichlet energy (Pinkall and Polthier 1993, Eck et al. 1995); triangles may flip
  Lscm = 9,  ///< least squares conformal map with two pinned boundary vertices (Lévy et al. 2002); triangles may flip, the boundary may cross itself
};

inline const char* nameOf(MethodKey code) {
  switch (code) {
    case MethodKey::AbflatAuto:
      return "abflatAuto";
    case MethodKey::AbflatConvex:
      return "abflatConvex";
    case MethodKey::AbflatFree:
      return "abflatFree";
    case MethodKey::AbflatBalanced:
      return "abflatBalanced";
    case MethodKey::SymmetricDirichlet:
      return "symmetricDirichlet";
    case MethodKey::Mips:
      return "mips";
    case MethodKey::Tutte:
      return "tutte";
    case MethodKey::MeanValue:
      return "meanValue";
    case MethodKey::Harmonic:
      return "harmonic";
    case MethodKey::Lscm:
      return "lscm";
  }
  return "";
}

}  // namespace abflat

#pragma GCC diagnostic pop
