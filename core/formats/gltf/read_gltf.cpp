#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "abflat/gltf.h"
#include "base/guarded.h"
#include "gltf/budget.h"
#include "gltf/container.h"
#include "gltf/elements.h"
#include "gltf/own_meshes.h"
#include "gltf/source.h"
#include "gltf/transforms.h"
#include "gltf/triangles.h"
#include "io/settle_normals.h"
#include "io/settle_texcoords.h"

namespace abflat {
namespace gltf {
namespace {

constexpr std::size_t kMostVertices = std::numeric_limits<std::uint32_t>::max() - 1;

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::array<double, 3> moved(const Matrix& m, const double* p) {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
  return out;
}

/// By the cofactors of the matrix, so that it stays normal to the surface; faces outwards as
/// before, even if the matrix mirrors.
std::array<double, 3> movedNormal(const Matrix& m, const double* n) {
  const auto cofactor = [&](std::size_t row, std::size_t column) {
    const std::size_t r = (row + 1) % 3, s = (row + 2) % 3;
    const std::size_t c = 4 * ((column + 1) % 3), d = 4 * ((column + 2) % 3);
    return m[c + r] * m[d + s] - m[d + r] * m[c + s];
  };
  std::array<double, 3> out{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    determinant += m[i] * cofactor(i, 0);
    for (std::size_t k = 0; k < 3; ++k) out[i] += cofactor(i, k) * n[k];
  }
  if (determinant < 0)
    for (double& x : out) x = -x;
  return out;
}

class ModelReader {
 public:
  ModelReader(Source& source, GltfModel& model, const GltfReadOptions& options)
      : source_(source),
        document_(source.document),
        model_(model),
        texcoord_("TEXCOORD_" + std::to_string(options.texcoord)),
        budget_(options.ownTexels ? Budget::ofCopies(document_.size) : Budget(document_.size)) {}

  Status read() {
    Result<std::vector<MeshPlace>> places = meshPlaces(document_);
    if (!places.ok()) return places.status();
    model_.mesh.faceOffsets = {0};
    for (std::size_t m = 0; m < document_.meshes.size(); ++m) {
      unused_ += !places.value()[m].isUsed;
      if (!places.value()[m].isUsed) continue;
      groupOf_.clear();
      const std::size_t before = source_.parts.size();
      for (std::size_t p = 0; p < document_.meshes[m].size(); ++p)
        if (Status s = readPrimitive(m, p, places.value()[m]); !s.ok()) return s;
      if (source_.parts.size() > before && places.value()[m].nodes > 1)
        countShared(places.value()[m]);
    }
    model_.mesh.faceTexcoords = model_.mesh.faceVertices;
    settleTexcoords(model_.mesh);
    takeVertexNormals(model_.mesh);
    if (source_.parts.empty() || source_.parts.front().mesh == source_.parts.back().mesh)
      model_.mesh.vertexObjects = {};  // one object
    source_.vertexCount = static_cast<std::uint32_t>(model_.mesh.vertexCount());
    source_.faceVertices = model_.mesh.faceVertices;
    if (materials_.size() < 2 && materials_.count(kNone) == materials_.size())
      model_.mesh.faceMaterials = {};
    else
      nameMaterials();
    addNotes();
    return {};
  }

 private:
  Status failure(std::size_t mesh, std::size_t primitive, const std::string& sentence) const {
    return {StatusCode::ParseError,
            document_.fileName + ": " + primitivePlace(mesh, primitive) + sentence};
  }

  Status readPrimitive(std::size_t m, std::size_t p, const MeshPlace& place) {
    const Primitive& primitive = document_.meshes[m][p];
    const std::size_t positions = accessorNamed(primitive.attributes, "POSITION");
    if (!hasTriangles(primitive.mode) || positions == kNone) {
      ++leftOut_;
      return {};
    }
    Part part{
        m, p, 0, static_cast<std::uint32_t>(model_.mesh.faceCount()), 0, place.determinant < 0};
    if (Status s = findGroup(m, p, place.matrix, part.group); !s.ok()) return s;
    const std::size_t corners = cornersOf(primitive, document_.accessors[positions].count);
    if (!budget_.take(corners)) return tooMuch(m, p);
    std::vector<std::uint32_t> vertices;
    if (Status s = readVertices(m, p, source_.groups[part.group], vertices); !s.ok()) return s;
    const std::vector<std::uint32_t> triangles = asTriangles(primitive.mode, std::move(vertices));
    if (triangles.size() > kMostVertices - model_.mesh.faceVertices.size())
      return failure(m, p, " brings the mesh to more triangles than are supported");
    addFaces(triangles, part, primitive.material);
    source_.parts.push_back(part);
    return {};
  }

  Status tooMuch(std::size_t mesh, std::size_t primitive) const {
    return failure(mesh, primitive,
                   " expands the file far beyond its " + std::to_string(document_.size) +
                       " bytes: too many meshes share the same data");
  }

  /// Known before any are created: one triangle per entry of a strip or fan.
  std::size_t cornersOf(const Primitive& primitive, std::size_t vertices) const {
    const std::size_t perEntry = primitive.mode == Mode::Triangles ? 1 : 3;
    if (primitive.indices == kNone) return perEntry * vertices;
    const Accessor& indices = document_.accessors[primitive.indices];
    return perEntry * indices.count + (indices.sparse ? indices.sparse->count : 0);
  }

  /// Vertices, plus the values of their attributes.
  std::size_t elementsOfGroup(const Primitive& primitive, std::size_t vertices) const {
    std::size_t out = vertices;
    for (const Attributes* list : allAttributes(primitive))
      for (const auto& attribute : *list) {
        const Accessor& accessor = document_.accessors[attribute.second];
        if (accessor.view != kNone) out += vertices;
        if (accessor.sparse) out += accessor.sparse->count;
      }
    return out;
  }

  /// Vertex indices, one for each corner, strip or fan entry.
  Status readVertices(std::size_t m, std::size_t p, const VertexGroup& group,
                      std::vector<std::uint32_t>& out) const {
    const Primitive& primitive = document_.meshes[m][p];
    if (primitive.indices == kNone) {
      for (std::uint32_t v = 0; v < group.vertexCount; ++v) out.push_back(v);
      return {};
    }
    const Accessor& indices = document_.accessors[primitive.indices];
    if (!isUnsigned(indices.shape.type) || indices.shape.components() != 1)
      return failure(m, p, ".indices must be unsigned integers");
    if (!hasSparseOrder(document_, indices))
      return failure(m, p, ".indices has sparse indices that are out of order or out of range");
    out = integersOf(document_, indices);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (out[i] >= group.vertexCount)
        return failure(m, p,
                       ".indices: entry " + std::to_string(i) + " is vertex " +
                           std::to_string(out[i]) + ", but there are only " +
                           std::to_string(group.vertexCount) + " vertices (indices start at 0)");
    return {};
  }

  Status findGroup(std::size_t m, std::size_t p, const Matrix& matrix, std::size_t& group) {
    const Primitive& primitive = document_.meshes[m][p];
    Attributes sorted = primitive.attributes;
    std::sort(sorted.begin(), sorted.end());
    for (const Attributes& target : primitive.targets)
      for (const auto& attribute : target) sorted.push_back(attribute);
    const auto known = groupOf_.emplace(std::move(sorted), source_.groups.size());
    group = known.first->second;
    return known.second ? addGroup(m, p, matrix) : Status{};
  }

  Status addGroup(std::size_t m, std::size_t p, const Matrix& matrix) {
    const Primitive& primitive = document_.meshes[m][p];
    PolygonMesh& mesh = model_.mesh;
    const Accessor& positions =
        document_.accessors[accessorNamed(primitive.attributes, "POSITION")];
    if (positions.shape.components() != 3 || positions.shape.columns != 1)
      return failure(m, p, ".attributes.POSITION must have three coordinates per vertex");
    if (positions.count > kMostVertices - mesh.vertexCount())
      return failure(m, p, " brings the mesh to more than 4294967294 vertices");
    if (!budget_.take(elementsOfGroup(primitive, positions.count))) return tooMuch(m, p);
    for (const Attributes* list : allAttributes(primitive))
      for (const auto& [name, accessor] : *list)
        if (const std::string s = problemOf(accessor, positions.count); !s.empty())
          return failure(m, p, std::string(": ").append(name).append(s));
    VertexGroup group{m, p, static_cast<std::uint32_t>(mesh.vertexCount()),
                      static_cast<std::uint32_t>(positions.count)};
    const std::vector<double> local = numbersOf(document_, positions);
    for (std::size_t v = 0; v < positions.count; ++v) {
      const std::array<double, 3> at = moved(matrix, &local[3 * v]);
      for (const double x : at)
        if (!std::isfinite(x))
          return failure(m, p,
                         ".attributes.POSITION: vertex " + std::to_string(v) +
                             " has a coordinate that is not finite");
      mesh.positions.insert(mesh.positions.end(), at.begin(), at.end());
    }
    mesh.vertexObjects.resize(mesh.vertexCount(), static_cast<std::uint32_t>(m));
    addTexcoords(primitive, positions.count);
    addNormals(primitive, positions.count, matrix);
    source_.groups.push_back(group);
    return {};
  }

  /// What is wrong with an accessor that should have `count` elements; empty if nothing is.
  std::string problemOf(std::size_t accessor, std::size_t count) const {
    const Accessor& a = document_.accessors[accessor];
    const std::string place = " (accessors[" + std::to_string(accessor) + "])";
    if (a.count != count)
      return place + " has " + std::to_string(a.count) + " elements, but POSITION has " +
             std::to_string(count);
    return hasSparseOrder(document_, a)
               ? ""
               : place + " has sparse indices that are out of order or out of range";
  }

  static std::vector<const Attributes*> allAttributes(const Primitive& primitive) {
    std::vector<const Attributes*> out = {&primitive.attributes};
    for (const Attributes& target : primitive.targets) out.push_back(&target);
    return out;
  }

  /// One per vertex, so that texcoords have the same indices as vertices.
  void addTexcoords(const Primitive& primitive, std::size_t count) {
    std::vector<double>& out = model_.mesh.texcoords;
    const std::size_t found = accessorNamed(primitive.attributes, texcoord_);
    if (found == kNone || document_.accessors[found].shape.components() != 2) {
      out.resize(out.size() + 2 * count, std::numeric_limits<double>::quiet_NaN());  // none
      return;
    }
    const std::vector<double> uv = numbersOf(document_, document_.accessors[found]);
    for (std::size_t i = 0; i + 1 < uv.size(); i += 2)
      out.insert(out.end(), {uv[i], 1 - uv[i + 1]});  // v of glTF points down
  }

  /// One per vertex, likewise.
  void addNormals(const Primitive& primitive, std::size_t count, const Matrix& matrix) {
    std::vector<double>& out = model_.mesh.normals;
    const std::size_t found = accessorNamed(primitive.attributes, "NORMAL");
    if (found == kNone || document_.accessors[found].shape.components() != 3) {
      out.resize(out.size() + 3 * count, 0);  // none
      return;
    }
    const std::vector<double> local = numbersOf(document_, document_.accessors[found]);
    for (std::size_t i = 0; i + 2 < local.size(); i += 3) {
      const std::array<double, 3> n = movedNormal(matrix, &local[i]);
      out.insert(out.end(), n.begin(), n.end());
    }
  }

  void addFaces(const std::vector<std::uint32_t>& triangles, Part& part, std::size_t material) {
    PolygonMesh& mesh = model_.mesh;
    const std::uint32_t first = source_.groups[part.group].firstVertex;
    const auto number =
        static_cast<std::uint32_t>(materials_.emplace(material, materials_.size()).first->second);
    for (std::size_t c = 0; c < triangles.size(); c += 3) {
      const std::size_t next = part.isMirrored ? 2 : 1;
      for (const std::size_t k : {c, c + next, c + 3 - next})
        mesh.faceVertices.push_back(first + triangles[k]);
      mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
      mesh.faceMaterials.push_back(number);
    }
    part.faceCount = static_cast<std::uint32_t>(triangles.size() / 3);
  }

  void nameMaterials() {
    model_.mesh.materialNames.resize(materials_.size());
    for (const auto& [material, number] : materials_) {
      if (material == kNone) continue;
      const Json* const name = document_.json["materials"][material].find("name");
      if (name && name->text()) model_.mesh.materialNames[number] = *name->text();
    }
  }

  void countShared(const MeshPlace& place) {
    ++shared_;
    sharing_ += place.nodes;
    hasScales_ = hasScales_ || place.hasScales;
  }

  void addNotes() {
    if (shared_ > 0)
      model_.notes.push_back(
          std::to_string(sharing_) + " nodes share " +
          counted(shared_, "mesh and its", "meshes and their") + " texels. " +
          (hasScales_ ? "Their scales differ, so each layout is sized for the largest node. "
                      : "") +
          "With the option own-texels each node gets texels of its own");
    if (leftOut_ > 0)
      model_.notes.push_back(
          counted(leftOut_, "point or line primitive was", "point or line primitives were") +
          " left unchanged");
    if (unused_ > 0)
      model_.notes.push_back(counted(unused_, "mesh that the scene does not use was",
                                     "meshes that the scene does not use were") +
                             " left unchanged");
  }

  Source& source_;
  const Document& document_;
  GltfModel& model_;
  const std::string texcoord_;  ///< the attribute to read
  Budget budget_;
  std::map<Attributes, std::size_t> groupOf_;  ///< of the current mesh, by sorted accessors
  std::map<std::size_t, std::size_t> materials_;
  std::size_t leftOut_ = 0, unused_ = 0;
  std::size_t shared_ = 0, sharing_ = 0;  ///< meshes used by several nodes, and these
  bool hasScales_ = false;                ///< among them
};

}  // namespace
}  // namespace gltf

bool looksLikeGltf(std::string_view bytes) { return gltf::looksLikeGltf(bytes); }

namespace {

Result<GltfModel> modelOf(std::string_view bytes, const std::string& fileName,
                          const ReadResource& readResource, const GltfReadOptions& options) {
  Result<gltf::Document> document = gltf::readDocument(bytes, fileName, readResource);
  if (!document.ok()) return document.status();
  auto source = std::make_shared<gltf::Source>();
  source->document = std::move(document.value());
  if (options.ownTexels) gltf::giveOwnMeshes(source->document);
  GltfModel out;
  if (Status s = gltf::ModelReader(*source, out, options).read(); !s.ok()) return s;
  out.source = std::move(source);
  return out;
}

}  // namespace

Result<GltfModel> readGltf(std::string_view bytes, const std::string& fileName,
                           const ReadResource& readResource, const GltfReadOptions& options) {
  return guarded([&] { return modelOf(bytes, fileName, readResource, options); });
}

}  // namespace abflat
