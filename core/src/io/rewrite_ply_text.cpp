#include "base/number_text.h"
#include "io/rewrite_ply.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// The source has already been read, so its rows are well formed.
class TextRewriter {
 public:
  TextRewriter(TextWriter& out, const PlyRewrite& rewrite, std::string_view body)
      : out_(out), rewrite_(rewrite), rest_(body) {}

  void run() {
    const PlyHeader& header = rewrite_.header;
    for (std::size_t i = 0; i < header.elements.size(); ++i) {
      if (header.elements[i].properties.empty()) continue;
      if (i == header.vertex)
        putVertices();
      else if (i == header.face && header.hasStrips)
        putTriangles(header.elements[i]);
      else
        putRows(header.elements[i], i == header.face);
    }
    out_.put(rest_);
  }

 private:
  /// The row is returned without its line end; blank lines are copied.
  bool nextRow(std::string_view& row) {
    while (!rest_.empty()) {
      row = rest_.substr(0, lineSize(rest_));
      rest_.remove_prefix(row.size());
      const std::size_t last = row.find_last_not_of(" \t\r\n");
      if (last != std::string_view::npos) {
        eol_ = lineEnd(row).empty() ? rewrite_.header.lineEnd : lineEnd(row);
        row = row.substr(0, last + 1);
        return true;
      }
      out_.put(row);
    }
    return false;
  }

  void putVertices() {
    const std::size_t count = rewrite_.mesh.vertexCount();
    std::vector<std::string_view> rows;
    if (!rewrite_.vertices.copied.empty()) rows.resize(count);
    std::string_view row;
    for (std::size_t v = 0; v < count && nextRow(row); ++v) {
      putVertex(row, v);
      if (!rows.empty()) rows[v] = row;
    }
    for (std::size_t i = 0; i < rewrite_.vertices.copied.size(); ++i)
      putVertex(rows[rewrite_.vertices.copied[i]], count + i);
  }

  void putVertex(std::string_view row, std::size_t v) {
    if (!rewrite_.plan.dropsFromVertex) {
      out_.put(row);
      out_.put(' ');
    } else {
      const std::vector<PlyProperty>& properties =
          rewrite_.header.elements[rewrite_.header.vertex].properties;
      for (std::size_t p = 0; p < properties.size(); ++p)
        putField(properties[p], rewrite_.plan.vertex[p].source == PlyTarget::Source::Dropped, row);
    }
    putUv(v);
    out_.put(eol_);
  }

  void putUv(std::size_t v) {
    out_.put(rewrite_.vertices.uv[2 * v]);
    out_.put(' ');
    out_.put(rewrite_.vertices.uv[2 * v + 1]);
  }

  /// Takes a property off the row, and copies it with a blank after it unless it is dropped.
  void putField(const PlyProperty& property, bool isDropped, std::string_view& row) {
    std::size_t words = 1 + (property.isList ? listSize(row) : 0);
    for (; words > 0; --words) {
      const std::string_view word = takeWord(row);
      if (isDropped) continue;
      out_.put(word);
      out_.put(' ');
    }
  }

  static std::size_t listSize(std::string_view row) {
    double size = 0;
    parseDouble(takeWord(row), size);
    return static_cast<std::size_t>(size);
  }

  void putRows(const PlyElement& element, bool isFace) {
    std::string_view row;
    for (std::uint64_t i = 0; i < element.count && nextRow(row); ++i) {
      if (isFace)
        putFace(element, static_cast<std::size_t>(i), row);
      else
        out_.put(row);
      out_.put(eol_);
    }
  }

  /// In place of strips.
  void putTriangles(const PlyElement& strips) {
    std::string_view row;
    for (std::uint64_t i = 0; i < strips.count; ++i) nextRow(row);
    for (std::size_t f = 0; f < rewrite_.mesh.faceCount(); ++f) {
      putCorners(f, false);
      out_.unput();
      out_.put(eol_);
    }
  }

  void putFace(const PlyElement& element, std::size_t f, std::string_view row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyTarget::Source source = rewrite_.plan.face[p].source;
      const bool isCopied = source == PlyTarget::Source::Copied;
      putField(element.properties[p], !isCopied, row);
      if (!isCopied) putCorners(f, source == PlyTarget::Source::Texcoords);
    }
    out_.unput();
  }

  void putCorners(std::size_t f, bool areTexcoords) {
    const std::uint32_t begin = rewrite_.mesh.faceOffsets[f],
                        end = rewrite_.mesh.faceOffsets[f + 1];
    out_.put((areTexcoords ? 2 : 1) * (end - begin));
    out_.put(' ');
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t vertex = rewrite_.vertices.ofCorner[c];
      if (areTexcoords)
        putUv(vertex);
      else
        out_.put(vertex);
      out_.put(' ');
    }
  }

  TextWriter& out_;
  const PlyRewrite& rewrite_;
  std::string_view rest_;
  std::string_view eol_;
};

}  // namespace

void rewritePlyText(TextWriter& out, const PlyRewrite& rewrite, std::string_view body) {
  TextRewriter(out, rewrite, body).run();
}

}  // namespace abflat
