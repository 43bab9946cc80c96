#include "io/format_functions.h"

#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"

namespace abflat {
namespace {

/// The faces of a PLY are written from the mesh, in which they have been turned.
std::string writePlyOf(const PolygonMesh& mesh, const std::vector<double>& uv,
                       const std::vector<std::uint32_t>& cornerUv, std::string_view source,
                       const std::vector<std::uint32_t>&) {
  return writePly(mesh, uv, cornerUv, source);
}

}  // namespace

constexpr FormatFunctions kFormatFunctions[kMeshFormatCount] = {
    {MeshFormat::Stl, true, looksLikeStl, readStl, nullptr},
    {MeshFormat::Ply, false, looksLikePly, readPly, writePlyOf},
    {MeshFormat::Off, false, looksLikeOff, readOff, nullptr},
    {MeshFormat::Obj, false, looksLikeObj, readObj, writeObj},
};

namespace {

constexpr bool hasFunctions(MeshFormat format) {
  int rows = 0;
  for (const FormatFunctions& row : kFormatFunctions)
    if (row.format == format && row.read != nullptr &&
        (row.write != nullptr) == (precisionOf(format) != Precision::None))
      ++rows;
  return rows == 1;
}

constexpr bool isComplete() {
  for (int i = 0; i < kMeshFormatCount; ++i)
    if (!hasFunctions(static_cast<MeshFormat>(i))) return false;
  return true;
}

static_assert(isComplete(), "each format has a reader, and a writer if the schema says so");

}  // namespace

const FormatFunctions& functionsOf(MeshFormat format) {
  const FormatFunctions* found = kFormatFunctions;
  while (found->format != format) ++found;
  return *found;
}

}  // namespace abflat
