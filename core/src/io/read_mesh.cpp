#include "abflat/io.h"
#include "base/guarded.h"
#include "io/obj_lines.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"
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

/// Whether the first line that is not empty or a comment belongs to an OFF header.
bool looksLikeOff(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, lineSize(bytes));
    const std::size_t begin = line.find_first_not_of(" \t\r\n");
    if (begin != std::string_view::npos && line[begin] != '#') {
      const std::size_t end = line.find_first_of(" \t\r\n", begin);
      const std::string_view word = line.substr(begin, end - begin);
      return word.size() >= 3 && word.substr(word.size() - 3) == "OFF";
    }
    bytes.remove_prefix(line.size());
  }
  return false;
}

bool looksLikePly(std::string_view bytes) {
  return beginsWith(bytes, "ply") && bytes.size() > 3 && (bytes[3] == '\n' || bytes[3] == '\r');
}

bool looksLikeObj(std::string_view bytes) {
  ObjLines lines(bytes.substr(0, 1 << 16));
  ObjLine line;
  while (lines.next(line))
    if (line.kind != ObjLine::Kind::Other && !line.arguments.empty()) return true;
  return false;
}

/// STL is what CAD programs and printers use, where z points up.
Result<PolygonMesh> withZUp(Result<PolygonMesh> mesh) {
  mesh.value.isZUp = true;
  return mesh;
}

/// Releases the spare capacity that the arrays grew while their sizes were unknown: they stay in
/// memory for the whole run.
Result<PolygonMesh> withoutSpare(Result<PolygonMesh> mesh) {
  mesh.value.positions.shrink_to_fit();
  mesh.value.faceVertices.shrink_to_fit();
  mesh.value.faceOffsets.shrink_to_fit();
  mesh.value.normals.shrink_to_fit();
  mesh.value.faceNormals.shrink_to_fit();
  return mesh;
}

Result<MeshFormat> formatOf(std::string_view fileName, std::string_view bytes) {
  if (endsWith(fileName, ".obj")) return MeshFormat::Obj;
  if (endsWith(fileName, ".off")) return MeshFormat::Off;
  if (endsWith(fileName, ".ply")) return MeshFormat::Ply;
  if (endsWith(fileName, ".stl")) return MeshFormat::Stl;
  if (looksLikeStl(bytes)) return MeshFormat::Stl;
  if (hasByteOrderMark(bytes)) bytes.remove_prefix(kByteOrderMark.size());
  if (looksLikePly(bytes)) return MeshFormat::Ply;
  if (looksLikeOff(bytes)) return MeshFormat::Off;
  if (looksLikeObj(bytes)) return MeshFormat::Obj;
  return Status{
      StatusCode::UnreadableFile,
      std::string(fileName) +
          (bytes.empty() ? ": the file is empty" : " is not supported. Use OBJ, PLY, STL or OFF")};
}

Result<PolygonMesh> readAs(MeshFormat format, std::string_view bytes, std::string_view fileName) {
  std::string_view text = bytes;
  if (isUtf16(bytes) && !(format == MeshFormat::Stl && looksLikeStl(bytes)))
    return Status{StatusCode::ParseError,
                  std::string(fileName) + ": the text is UTF-16. Save it as UTF-8"};
  if (hasByteOrderMark(text)) text.remove_prefix(kByteOrderMark.size());
  switch (format) {
    case MeshFormat::Obj:
      return withoutSpare(readObj(text, fileName));
    case MeshFormat::Off:
      return withoutSpare(readOff(text, fileName));
    case MeshFormat::Ply:
      return withoutSpare(readPly(text, fileName));
    case MeshFormat::Stl:
      return withoutSpare(withZUp(readStl(bytes, fileName)));  // binary STL may begin with anything
  }
  return Status{StatusCode::Internal, "no reader for this format"};
}

}  // namespace

Result<MeshFormat> detectFormat(std::string_view fileName, std::string_view bytes) {
  return guarded([&] { return formatOf(fileName, bytes); });
}

Result<PolygonMesh> readMesh(std::string_view bytes, MeshFormat format, std::string_view fileName) {
  return guarded([&] { return readAs(format, bytes, fileName); });
}

}  // namespace abflat
