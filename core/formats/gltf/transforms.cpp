#include "gltf/transforms.h"

#include <algorithm>
#include <array>
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

/// How much larger areas become, squared: the mean over all directions, up to a constant factor.
double areaScale(const Matrix& m) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = 4 * ((i + 1) % 3), b = 4 * ((i + 2) % 3);
      const std::size_t p = (j + 1) % 3, q = (j + 2) % 3;
      const double cofactor = m[a + p] * m[b + q] - m[a + q] * m[b + p];
      sum += cofactor * cofactor;
    }
  return sum;
}

/// Scalar products of the axes: what is left of a placement without position and rotation.
std::array<double, 9> scales(const Matrix& m) {
  std::array<double, 9> out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) out[3 * i + j] += m[4 * i + k] * m[4 * j + k];
  return out;
}

bool isScaledAlike(const Matrix& m, const Matrix& n) {
  constexpr double kTolerance = 1e-3;  // well above the rounding of exporters
  const std::array<double, 9> a = scales(m), b = scales(n);
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max({largest, std::abs(a[i]), std::abs(b[i])});
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference <= kTolerance * largest;
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
    double& largest = areaScale_[node.mesh];
    const bool isFlat = node.skin == kNone && determinantOf(matrix) == 0;
    const Matrix& used = node.skin != kNone || isFlat ? kIdentity : matrix;
    const double scale = isFlat ? 0 : areaScale(used);
    const bool isFirst = largest == 0 && scale > 0;
    place.isUsed = true;
    ++place.nodes;
    if (largest > 0 && scale > 0 && !isScaledAlike(place.matrix, used)) place.hasScales = true;
    // Nodes that differ by rounding only count as equally large.
    constexpr double kTolerance = 1e-6;
    if (place.nodes > 1 && !isFirst && !(scale > largest * (1 + kTolerance))) return;
    place.matrix = used;
    place.determinant = determinantOf(used);
    largest = scale;
  }

  const Document& document_;
  std::vector<MeshPlace> places_;
  std::vector<bool> isVisited_;
  std::vector<double> areaScale_ = std::vector<double>(places_.size());  ///< of `places_`; 0: flat
};

}  // namespace

Result<std::vector<MeshPlace>> meshPlaces(const Document& document) {
  if (document.roots) return SceneWalk(document).run();
  return std::vector<MeshPlace>(document.meshes.size(), {true, kIdentity, 1, 1, false});
}

}  // namespace abflat::gltf
