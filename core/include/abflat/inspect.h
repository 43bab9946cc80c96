#pragma once

#include <string>

#include "abflat/export.h"
#include "abflat/generated/mesh_summary.h"
#include "abflat/mesh.h"

namespace abflat {

/// Counts only. `disk` is Ok when `flatten` accepts the mesh; otherwise it says why not, with
/// counts and the first place.
ABFLAT_API MeshSummary inspect(const PolygonMesh& mesh);

/// JSON object with the fields of MeshSummary, as in docs/report.md.
ABFLAT_API std::string inspectJson(const MeshSummary& summary, const std::string& path);

}  // namespace abflat
