#include <algorithm>

#include "abflat/io.h"
#include "io/ply_value.h"
#include "io/rewrite_ply.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

std::string rewritten(const PolygonMesh& mesh, const SplitVertices& vertices,
                      std::string_view source) {
  const Result<PlyHeader> header = readPlyHeader(source, {});
  const PlyPlan plan = makePlyPlan(header.value(), mesh, vertices);
  const PlyRewrite rewrite{header.value(), plan, mesh, vertices};
  const std::string_view body = source.substr(header.value().text.size());
  TextWriter out(source.size() + 40 * (vertices.uv.size() / 2 + 4));
  putPlyHeader(out, header.value(), plan, vertices.uv.size() / 2, mesh.faceCount());
  if (header.value().encoding == PlyEncoding::Text)
    rewritePlyText(out, rewrite, body);
  else
    rewritePlyBinary(out, rewrite, body);
  return out.take();
}

/// Binary, little endian.
class FreshPly {
 public:
  FreshPly(const PolygonMesh& mesh, const SplitVertices& vertices)
      : mesh_(mesh),
        vertices_(vertices),
        xyzType_(smallestType(mesh.positions)),
        uvType_(smallestType(vertices.uv)),
        out_(512 + 40 * (mesh.vertexCount() + vertices.copied.size()) +
             5 * (mesh.faceVertices.size() + mesh.faceCount())) {
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
      if (mesh.faceOffsets[f + 1] - mesh.faceOffsets[f] > 255) countType_ = PlyType::Int32;
  }

  std::string run() {
    const std::size_t count = mesh_.vertexCount();
    putHeader(static_cast<std::uint32_t>(count + vertices_.copied.size()));
    for (std::size_t v = 0; v < count; ++v) putVertex(v, v);
    for (std::size_t i = 0; i < vertices_.copied.size(); ++i)
      putVertex(vertices_.copied[i], count + i);
    for (std::size_t f = 0; f < mesh_.faceCount(); ++f) {
      putNumber(mesh_.faceOffsets[f + 1] - mesh_.faceOffsets[f], countType_);
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c)
        putNumber(vertices_.ofCorner[c], indexType_);
    }
    return out_.take();
  }

 private:
  void putHeader(std::uint32_t vertexCount) {
    // Two billion vertices do not fit into an int, but some programs know no other index type.
    if (vertexCount > 0x7fffffff) indexType_ = PlyType::Uint32;
    out_.put("ply\nformat binary_little_endian 1.0\ncomment abflat\nelement vertex ");
    out_.put(vertexCount);
    out_.put('\n');
    for (const std::string_view name : {"x", "y", "z"}) putProperty(xyzType_, name);
    if (!vertices_.uv.empty())
      for (const std::string_view name : {"s", "t"}) putProperty(uvType_, name);
    out_.put("element face ");
    out_.put(static_cast<std::uint32_t>(mesh_.faceCount()));
    out_.put("\nproperty list ");
    out_.put(nameOf(countType_));
    out_.put(' ');
    out_.put(nameOf(indexType_));
    out_.put(" vertex_indices\nend_header\n");
  }

  void putProperty(PlyType type, std::string_view name) {
    out_.put("property ");
    out_.put(nameOf(type));
    out_.put(' ');
    out_.put(name);
    out_.put('\n');
  }

  void putNumber(double value, PlyType type) {
    out_.endAt(storeNumber(out_.room(sizeOf(type)), value, type, false));
  }

  void putVertex(std::size_t v, std::size_t written) {
    for (std::size_t d = 0; d < 3; ++d) putNumber(mesh_.positions[3 * v + d], xyzType_);
    if (vertices_.uv.empty()) return;
    putNumber(vertices_.uv[2 * written], uvType_);
    putNumber(vertices_.uv[2 * written + 1], uvType_);
  }

  const PolygonMesh& mesh_;
  const SplitVertices& vertices_;
  PlyType xyzType_, uvType_;
  PlyType countType_ = PlyType::Uint8, indexType_ = PlyType::Int32;
  TextWriter out_;
};

}  // namespace

std::string writePly(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const std::vector<std::uint32_t>& cornerUv, std::string_view sourcePly) {
  const SplitVertices vertices = splitVertices(mesh.vertexCount(), mesh.faceVertices, uv, cornerUv);
  if (hasByteOrderMark(sourcePly)) sourcePly.remove_prefix(kByteOrderMark.size());
  return sourcePly.empty() || uv.empty() ? FreshPly(mesh, vertices).run()
                                         : rewritten(mesh, vertices, sourcePly);
}

}  // namespace abflat
