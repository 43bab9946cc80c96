#include "gltf/own_meshes.h"

namespace abflat::gltf {
namespace {

/// The index of a new mesh that is like another.
std::size_t copyOf(std::size_t mesh, Document& document) {
  document.meshes.push_back(std::vector<Primitive>(document.meshes[mesh]));
  Json::Items& meshes = document.json["meshes"].items();
  meshes.push_back(Json(meshes[mesh]));
  return document.meshes.size() - 1;
}

}  // namespace

void giveOwnMeshes(Document& document) {
  if (!document.roots) return;
  std::vector<bool> isVisited(document.nodes.size()), isUsed(document.meshes.size());
  std::vector<std::size_t> stack(document.roots->rbegin(), document.roots->rend());
  while (!stack.empty()) {
    const std::size_t n = stack.back();
    stack.pop_back();
    if (isVisited[n]) continue;  // an error that meshPlaces reports
    isVisited[n] = true;
    Node& node = document.nodes[n];
    stack.insert(stack.end(), node.children.rbegin(), node.children.rend());
    if (node.mesh == kNone) continue;
    if (isUsed[node.mesh]) {
      node.mesh = copyOf(node.mesh, document);
      document.json["nodes"][n]["mesh"] = node.mesh;
    } else {
      isUsed[node.mesh] = true;
    }
  }
}

}  // namespace abflat::gltf
