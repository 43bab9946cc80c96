#include "abflat/io.h"
#include "io/number_text.h"
#include "io/obj_lines.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

void appendTexcoords(std::string& out, const std::vector<double>& uv, std::string_view eol) {
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) {
    out += "vt ";
    appendDouble(out, uv[i]);
    out += ' ';
    appendDouble(out, uv[i + 1]);
    out += eol;
  }
}

/// One corner with its vertex and normal as they were written and the new texcoord in between.
void appendCorner(std::string& out, std::string_view corner, std::uint32_t texcoord) {
  const std::size_t first = std::min(corner.find('/'), corner.size());
  const std::size_t second =
      first < corner.size() ? corner.find('/', first + 1) : std::string_view::npos;
  out += ' ';
  out += corner.substr(0, first);
  out += '/';
  appendInteger(out, texcoord + 1);
  if (second != std::string_view::npos) out += corner.substr(second);
}

/// `f` with its corners and their new texcoords, of which `next` is the first.
void appendFace(std::string& out, std::string_view corners,
                const std::vector<std::uint32_t>& cornerUv, std::size_t& next) {
  out += 'f';
  for (std::string_view word = takeWord(corners); !word.empty(); word = takeWord(corners))
    appendCorner(out, word, cornerUv[next++]);
}

/// `l` with its vertices: the texcoords they referred to are gone. Nobody has checked these words:
/// what is not v/vt stays as it is.
void appendPolyline(std::string& out, std::string_view points) {
  out += 'l';
  for (std::string_view word = takeWord(points); !word.empty(); word = takeWord(points)) {
    const std::string_view vertex = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    out += ' ';
    out += parseInteger(vertex, index) ? vertex : word;
  }
}

std::string rewriteObj(std::string_view source, const std::vector<double>& uv,
                       const std::vector<std::uint32_t>& cornerUv) {
  std::string out, storage;
  out.reserve(source.size() + 24 * uv.size() + 8 * cornerUv.size());
  if (hasByteOrderMark(source)) {
    out += kByteOrderMark;
    source.remove_prefix(kByteOrderMark.size());
  }
  const std::string_view firstEnd = lineEnd(source.substr(0, lineSize(source)));
  const std::string_view eol = firstEnd.empty() ? "\n" : firstEnd;
  ObjLines lines(source);
  ObjLine line;
  std::size_t corner = 0;
  while (lines.next(line)) {
    const bool isFace = line.kind == ObjLine::Kind::Face;
    const bool isMapped =
        line.kind == ObjLine::Kind::Polyline && line.arguments.find('/') != std::string_view::npos;
    if (line.kind == ObjLine::Kind::Texcoord) continue;
    if (!isFace && !isMapped) {
      out += line.text;
      continue;
    }
    const std::string_view arguments = argumentsOf(line, storage);
    const std::string_view ownEnd = lineEnd(line.text), end = ownEnd.empty() ? eol : ownEnd;
    if (isFace && corner == 0) appendTexcoords(out, uv, end);
    if (isFace) appendFace(out, arguments, cornerUv, corner);
    if (isMapped) appendPolyline(out, arguments);
    if (!line.comment.empty()) out.append(" ").append(line.comment);
    out += end;
  }
  return out;
}

std::string freshObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const std::vector<std::uint32_t>& cornerUv) {
  std::string out;
  out.reserve(30 * mesh.positions.size() + 24 * uv.size() + 16 * cornerUv.size());
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    out += 'v';
    for (std::size_t d = 0; d < 3; ++d) {
      out += ' ';
      appendDouble(out, mesh.positions[3 * v + d]);
    }
    out += '\n';
  }
  appendTexcoords(out, uv, "\n");
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    out += 'f';
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      out += ' ';
      appendInteger(out, mesh.faceVertices[c] + 1);
      if (uv.empty()) continue;
      out += '/';
      appendInteger(out, cornerUv[c] + 1);
    }
    out += '\n';
  }
  return out;
}

}  // namespace

std::string writeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const std::vector<std::uint32_t>& cornerUv, std::string_view sourceObj) {
  return sourceObj.empty() ? freshObj(mesh, uv, cornerUv) : rewriteObj(sourceObj, uv, cornerUv);
}

}  // namespace abflat
