#include "gltf/decompress.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gltf/decoded_views.h"
#include "gltf/decompress_draco.h"
#include "gltf/decompress_meshopt.h"
#include "gltf/draco_extension.h"
#include "gltf/meshopt_extension.h"

namespace abflat::gltf {
namespace {

bool isCompression(const Json& name) {
  return name == kDracoExtension || name == kMeshoptExtensions[0] || name == kMeshoptExtensions[1];
}

/// Removes the names from the lists of extensions; a list must not become empty.
void forgetNames(Json& json) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    const auto list = json.find(key);
    if (list == json.end() || !list->is_array()) continue;
    const auto kept = std::remove_if(list->begin(), list->end(), isCompression);
    if (kept == list->end()) continue;
    list->erase(kept, list->end());
    if (list->empty()) json.erase(key);
  }
}

/// Drops the bytes of buffers that no view refers to any more.
void dropUnused(Document& document) {
  std::vector<bool> isUsed(document.buffers.size());
  for (const Json& view : document.json["bufferViews"])
    isUsed[view["buffer"].get<std::size_t>()] = true;
  for (std::size_t b = 0; b < isUsed.size(); ++b)
    if (!isUsed[b]) std::string().swap(document.buffers[b]);
}

}  // namespace

void decompress(Document& document, Complaints& complaints) {
  DecodedViews views(document);
  if (decompressViews(document, views, complaints)) document.packings.emplace_back("meshopt");
  if (complaints.none() && decompressPrimitives(document, views, complaints))
    document.packings.emplace_back("Draco");
  if (!complaints.none()) return;
  forgetNames(document.json);
  views.finish();
  if (!document.packings.empty()) dropUnused(document);
}

}  // namespace abflat::gltf
