#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "abflat/verify.h"
#include "verify/chart_gaps.h"
#include "verify/find_overlaps.h"

namespace abflat {

/// Faces and islands of a finding, and findings of a rule.
constexpr std::size_t kMostListed = 100;

/// All that is known of a layout.
struct JudgedLayout {
  const MappedTriangles& triangles;
  const std::vector<std::uint32_t>& islandOfTriangle;
  const LayoutMeasures& measures;
  const FoundOverlaps& overlaps;
  const std::vector<std::uint8_t>& faults;     ///< per triangle, see UvFault
  const std::vector<std::uint8_t>& isOutside;  ///< per island
  const std::vector<double>& toEdge;           ///< per island, in texels
  const OutlineEdges& outlines;                ///< in texels
  const std::vector<std::uint32_t>& unmapped;  ///< faces
};

/// What a layout does not keep to, rule by rule.
std::vector<VerifyFinding> findingsOf(const JudgedLayout& layout, const VerifyOptions& options,
                                      const VerifyReport& measured);

}  // namespace abflat
