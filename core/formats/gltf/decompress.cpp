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
  const std::string* const text = name.text();
  return text && (*text == kDracoExtension || *text == kMeshoptExtensions[0] ||
                  *text == kMeshoptExtensions[1]);
}

/// Removes the names from the lists of extensions; a list must not become empty.
void forgetNames(Json& json) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    Json* const list = json.find(key);
    if (!list || !list->isArray()) continue;
    Json::Items& names = list->items();
    const auto kept = std::remove_if(names.begin(), names.end(), isCompression);
    if (kept == names.end()) continue;
    names.erase(kept, names.end());
    if (names.empty()) json.erase(key);
  }
}

/// Drops the bytes of buffers that no view refers to any more.
void dropUnused(Document& document) {
  std::vector<bool> isUsed(document.buffers.size());
  for (const Json& view : document.json["bufferViews"].items())
    isUsed[static_cast<std::size_t>(*view["buffer"].number())] = true;
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
