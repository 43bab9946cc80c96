#include "abflat/io.h"
#include "base/guarded.h"
#include "io/format_functions.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

bool endsWith(std::string_view name, std::string_view ending) {
  if (name.size() < ending.size()) return false;
  for (std::size_t i = 0; i < ending.size(); ++i) {
    const char c = name[name.size() - ending.size() + i];
    if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != ending[i]) return false;
  }
  return true;
}

/// Releases the spare capacity that the arrays grew while their sizes were unknown: they stay in
/// memory for the whole run.
void dropSpare(PolygonMesh& mesh) {
  mesh.positions.shrink_to_fit();
  mesh.faceVertices.shrink_to_fit();
  mesh.faceOffsets.shrink_to_fit();
  mesh.normals.shrink_to_fit();
  mesh.faceNormals.shrink_to_fit();
}

/// Without the mark that texts may begin with.
std::string_view textOf(std::string_view bytes) {
  if (hasByteOrderMark(bytes)) bytes.remove_prefix(kByteOrderMark.size());
  return bytes;
}

Result<MeshFormat> formatOf(std::string_view fileName, std::string_view bytes) {
  for (const MeshEnding& known : kMeshEndings)
    if (endsWith(fileName, known.ending)) return known.format;
  for (const FormatFunctions& known : kFormatFunctions)
    if (known.looksLike(known.beginsFreely ? bytes : textOf(bytes))) return known.format;
  return Status{
      StatusCode::UnreadableFile,
      std::string(fileName) +
          (bytes.empty() ? ": the file is empty" : " is not supported. Use " ABFLAT_MESH_FORMATS)};
}

Result<PolygonMesh> readAs(MeshFormat format, std::string_view bytes, std::string_view fileName) {
  const FormatFunctions& known = functionsOf(format);
  if (isUtf16(bytes) && !(known.beginsFreely && known.looksLike(bytes)))
    return Status{StatusCode::ParseError,
                  std::string(fileName) + ": the text is UTF-16. Save it as UTF-8"};
  Result<PolygonMesh> mesh = known.read(known.beginsFreely ? bytes : textOf(bytes), fileName);
  if (mesh.ok()) dropSpare(mesh.value());
  return mesh;
}

}  // namespace

Result<MeshFormat> detectFormat(std::string_view fileName, std::string_view bytes) {
  return guarded([&] { return formatOf(fileName, bytes); });
}

Result<PolygonMesh> readMesh(std::string_view bytes, MeshFormat format, std::string_view fileName) {
  return guarded([&] { return readAs(format, bytes, fileName); });
}

}  // namespace abflat
