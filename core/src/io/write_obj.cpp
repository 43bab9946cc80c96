#include "abflat/io.h"
#include "io/number_text.h"
#include "io/obj_lines.h"

namespace abflat {
namespace {

std::string_view lineEnd(std::string_view text) {
  const std::size_t newline = text.find('\n');
  return newline != std::string_view::npos && newline > 0 && text[newline - 1] == '\r' ? "\r\n"
                                                                                       : "\n";
}

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
  out += std::to_string(texcoord + 1);
  if (second != std::string_view::npos) out += corner.substr(second);
}

std::string rewriteObj(std::string_view source, const std::vector<double>& uv,
                       const std::vector<std::uint32_t>& cornerUv) {
  std::string out;
  out.reserve(source.size() + 24 * uv.size() + 8 * cornerUv.size());
  const std::string_view eol = lineEnd(source);
  ObjLines lines(source);
  ObjLine line;
  std::size_t corner = 0;
  bool texcoordsWritten = false;
  while (lines.next(line)) {
    if (line.kind == ObjLine::Kind::Texcoord) continue;
    if (line.kind != ObjLine::Kind::Face) {
      out += line.text;
      continue;
    }
    if (!texcoordsWritten) {
      if (!out.empty() && out.back() != '\n') out += eol;
      appendTexcoords(out, uv, eol);
      texcoordsWritten = true;
    }
    out += 'f';
    std::string arguments(line.arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (arguments[i] == '\\' || arguments[i] == '\r' || arguments[i] == '\n') arguments[i] = ' ';
    std::string_view words = arguments;
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words))
      appendCorner(out, word, cornerUv[corner++]);
    out += eol;
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
      out += std::to_string(mesh.faceVertices[c] + 1);
      if (uv.empty()) continue;
      out += '/';
      out += std::to_string(cornerUv[c] + 1);
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
