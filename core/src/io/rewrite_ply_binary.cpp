#include "io/ply_row.h"
#include "io/rewrite_ply.h"

namespace abflat {
namespace {

/// The source has already been read, so its rows are well formed.
class BinaryRewriter {
 public:
  BinaryRewriter(TextWriter& out, const PlyRewrite& rewrite, std::string_view body)
      : out_(out),
        rewrite_(rewrite),
        isBigEndian_(rewrite.header.encoding == PlyEncoding::BigEndian),
        at_(body.data()),
        end_(at_ + body.size()) {}

  void run() {
    const PlyHeader& header = rewrite_.header;
    for (std::size_t i = 0; i < header.elements.size(); ++i) {
      const PlyElement& element = header.elements[i];
      if (element.properties.empty()) continue;
      if (i == header.vertex)
        putVertices(element);
      else if (i != header.face)
        putRows(element);
      else if (header.hasStrips)
        putTriangles(element);
      else
        putFaces(element);
    }
    put(at_, end_);
  }

 private:
  void put(const char* begin, const char* end) {
    out_.put({begin, static_cast<std::size_t>(end - begin)});
  }

  PlyField take(const PlyProperty& property) {
    PlyField field;
    if (scanField(property, at_, end_, isBigEndian_, field) == PlyScan::Ok) at_ = field.end;
    return field;
  }

  void skipRow(const PlyElement& element) {
    if (element.hasLists)
      for (const PlyProperty& property : element.properties) take(property);
    else
      at_ += element.leastBytes;
  }

  void putRows(const PlyElement& element) {
    const char* const begin = at_;
    for (std::uint64_t i = 0; i < element.count; ++i) skipRow(element);
    put(begin, at_);
  }

  void putVertices(const PlyElement& element) {
    const std::size_t count = rewrite_.mesh.vertexCount();
    std::vector<const char*> rows;
    rows.reserve(count);
    for (std::size_t v = 0; v < count; ++v) {
      rows.push_back(at_);
      putVertex(element, v);
    }
    const char* const next = at_;
    for (std::size_t i = 0; i < rewrite_.vertices.copied.size(); ++i) {
      at_ = rows[rewrite_.vertices.copied[i]];
      putVertex(element, count + i);
    }
    at_ = next;
  }

  /// Takes the row and writes it as vertex v.
  void putVertex(const PlyElement& element, std::size_t v) {
    const char* const row = at_;
    if (rewrite_.plan.dropsFromVertex) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyField field = take(element.properties[p]);
        if (rewrite_.plan.vertex[p].source == PlyTarget::Source::Copied)
          put(field.begin, field.end);
      }
    } else {
      skipRow(element);
      put(row, at_);
    }
    putUv(v);
  }

  void putUv(std::size_t v) {
    putNumber(rewrite_.vertices.uv[2 * v], rewrite_.plan.uvType);
    putNumber(rewrite_.vertices.uv[2 * v + 1], rewrite_.plan.uvType);
  }

  void putNumber(double value, PlyType type) {
    out_.endAt(storeNumber(out_.room(sizeOf(type)), value, type, isBigEndian_));
  }

  /// In place of strips.
  void putTriangles(const PlyElement& strips) {
    for (std::uint64_t i = 0; i < strips.count; ++i) skipRow(strips);
    for (std::size_t f = 0; f < rewrite_.mesh.faceCount(); ++f)
      putCorners(f, rewrite_.plan.face.front());
  }

  void putFaces(const PlyElement& element) {
    for (std::size_t f = 0; f < rewrite_.mesh.faceCount(); ++f)
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyField field = take(element.properties[p]);
        if (rewrite_.plan.face[p].source == PlyTarget::Source::Copied)
          put(field.begin, field.end);
        else
          putCorners(f, rewrite_.plan.face[p]);
      }
  }

  void putCorners(std::size_t f, const PlyTarget& target) {
    const std::uint32_t begin = rewrite_.mesh.faceOffsets[f],
                        end = rewrite_.mesh.faceOffsets[f + 1];
    const bool areTexcoords = target.source == PlyTarget::Source::Texcoords;
    putNumber((areTexcoords ? 2 : 1) * (end - begin), target.countType);
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t vertex = rewrite_.vertices.ofCorner[c];
      if (areTexcoords)
        putUv(vertex);
      else
        putNumber(vertex, target.type);
    }
  }

  TextWriter& out_;
  const PlyRewrite& rewrite_;
  bool isBigEndian_;
  const char *at_, *end_;
};

}  // namespace

void rewritePlyBinary(TextWriter& out, const PlyRewrite& rewrite, std::string_view body) {
  BinaryRewriter(out, rewrite, body).run();
}

}  // namespace abflat
