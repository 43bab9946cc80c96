#include "unwrap/turned.h"

#include <utility>

#include "abflat/orient.h"
#include "base/counted.h"
#include "unwrap/stage_span.h"

namespace abflat {
namespace {

void reorderCorners(const std::vector<std::uint32_t>& order, UnwrapResult& result) {
  result.cornerUv = reordered(result.cornerUv, order);
  result.cornerVertex = reordered(result.cornerVertex, order);
  for (std::uint32_t& corner : result.triangleCorners) corner = order[corner];
}

}  // namespace

std::string orientationNote(const RepairReport& repair, bool isOriented) {
  const std::size_t edges = repair.orientationConflicts.size();
  if (edges == 0) return {};
  return counted(edges, "edge became a seam", "edges became seams") +
         " because the two faces there run in opposite directions" +
         (isOriented ? ", which no turning of faces changes, as on a Moebius strip"
                     : ". Turn faces alike with the option orient");
}

Result<UnwrapResult> unwrapTurned(const InputMesh& mesh, const UnwrapOptions& options,
                                  const Listener& listener, UnwrapMesh unwrapAsItIs) {
  PolygonMesh turned = mesh.copy();
  std::vector<std::uint32_t> faces =
      facesToTurn(turned, [&] { return kSurface.of(listener).tell(); });
  if (listener.isStopped()) return Status{StatusCode::Aborted, "cancelled"};
  if (faces.empty()) {
    turned = PolygonMesh();
    return unwrapAsItIs(mesh, options, listener);
  }
  turnFaces(faces, turned);
  Result<UnwrapResult> result = unwrapAsItIs(turned, options, listener);
  if (!result.ok()) return result;
  reorderCorners(turnedCorners(turned, faces), result.value());
  result.value().report.repair.turnedFaces = std::move(faces);
  return result;
}

void turnFaces(PolygonMesh& mesh, UnwrapResult& result) {
  const std::vector<std::uint32_t>& faces = result.report.repair.turnedFaces;
  if (faces.empty()) return;
  turnFaces(faces, mesh);
  reorderCorners(turnedCorners(mesh, faces), result);
}

}  // namespace abflat
