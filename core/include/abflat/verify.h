#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/compare_meshes.h"
#include "abflat/export.h"
#include "abflat/generated/verify_options.h"
#include "abflat/generated/verify_report.h"
#include "abflat/mesh.h"
#include "abflat/progress.h"

namespace abflat {

struct VerifyOptions : VerifyOptionValues {
  ProgressCallback progress;
};

struct VerifyResult {
  std::vector<std::uint32_t> islandOfFace;     ///< or kNoIsland
  std::vector<std::uint32_t> triangleCorners;  ///< 3 face corners per triangle, by face
  std::vector<std::uint8_t> faults;            ///< per triangle, a sum of the bits of UvFault
  VerifyReport report;  ///< the caller fills in path, the read time, and the total
};

/// Judges the layout that a mesh has, whichever program made it: turned and empty faces, overlaps
/// and what leaves its tile exactly, on the numbers that the texcoords are; distances, widths,
/// texel densities and stretch in double precision. Islands are faces joined where they have an
/// edge and its texcoords in common. n log n, but for layouts in which very many triangles overlap.
/// Errors: InvalidMesh, EmptyMesh, NoTexcoords, Aborted.
ABFLAT_API Result<VerifyResult> verifyLayout(const PolygonMesh& mesh, const VerifyOptions& options);

/// Adds what distinguishes the mesh from another that it was made from to what was found.
ABFLAT_API void addDifferences(const std::vector<MeshDifference>& differences,
                               VerifyReport& report);

/// The report as JSON text, indented by two spaces; keys as in docs/report.md.
ABFLAT_API std::string verifyReportJson(const VerifyReport& report);

}  // namespace abflat
