#include "abflat/texcoord_faces.h"

#include <algorithm>

#include "base/guarded.h"

namespace abflat {

Result<std::vector<std::uint32_t>> facesWithTexcoords(const PolygonMesh& mesh) {
  return guarded([&]() -> Result<std::vector<std::uint32_t>> {
    if (mesh.faceTexcoords.empty())
      return Status{StatusCode::InvalidOption, "the mesh has no texcoords to keep"};
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
      const std::uint32_t* corners = mesh.faceTexcoords.data();
      const std::uint32_t* begin = corners + mesh.faceOffsets[f];
      const std::uint32_t* end = corners + mesh.faceOffsets[f + 1];
      if (std::find(begin, end, kNoTexcoord) == end) faces.push_back(f);
    }
    return faces;
  });
}

}  // namespace abflat
