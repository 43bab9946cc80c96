#include "gltf/transforms.h"

#include <cmath>
#include <cstdint>

namespace abflat::gltf {
namespace {

constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k)
        out[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return out;
}

double determinantOf(const Matrix& m) {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) +
         m[8] * (m[1] * m[6] - m[5] * m[2]);
}

bool isFinite(const Matrix& m) {
  for (const double x : m)
    if (!std::isfinite(x)) return false;
  return std::isfinite(determinantOf(m));
}

/// Visits nodes in the order of the scene, parents first.
class SceneWalk {
 public:
  explicit SceneWalk(const Document& document)
      : document_(document), places_(document.meshes.size()), isVisited_(document.nodes.size()) {}

  Result<std::vector<MeshPlace>> run() {
    std::vector<Visit> stack;
    push(*document_.roots, kIdentity, stack);
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      if (isVisited_[visit.node])
        return failure(visit.node,
                       "is reached twice. A node must have at most one parent and must not be "
                       "its own descendant");
      isVisited_[visit.node] = true;
      const Node& node = document_.nodes[visit.node];
      const Matrix matrix = product(visit.parent, node.local);
      if (!isFinite(matrix)) return failure(visit.node, "has a transform that is not finite");
      use(node, matrix);
      push(node.children, matrix, stack);
    }
    return std::move(places_);
  }

 private:
  struct Visit {
    std::size_t node;
    Matrix parent;
  };

  static void push(const std::vector<std::size_t>& nodes, const Matrix& parent,
                   std::vector<Visit>& stack) {
    for (std::size_t i = nodes.size(); i-- > 0;) stack.push_back({nodes[i], parent});
  }

  Status failure(std::size_t node, const std::string& sentence) const {
    return {StatusCode::ParseError,
            document_.fileName + ": nodes[" + std::to_string(node) + "] " + sentence};
  }

  void use(const Node& node, const Matrix& matrix) {
    if (node.mesh == kNone) return;
    MeshPlace& place = places_[node.mesh];
    const bool isFlat = determinantOf(matrix) == 0;
    if (place.isUsed && (!isFlattened_[node.mesh] || isFlat)) return;
    place = {true, kIdentity, 1};
    isFlattened_[node.mesh] = isFlat;
    if (node.skin == kNone && !isFlat) place = {true, matrix, determinantOf(matrix)};
  }

  const Document& document_;
  std::vector<MeshPlace> places_;
  std::vector<bool> isVisited_;
  std::vector<bool> isFlattened_ = std::vector<bool>(places_.size());  ///< by all nodes so far
};

}  // namespace

Result<std::vector<MeshPlace>> meshPlaces(const Document& document) {
  if (document.roots) return SceneWalk(document).run();
  return std::vector<MeshPlace>(document.meshes.size(), {true, kIdentity, 1});
}

}  // namespace abflat::gltf
