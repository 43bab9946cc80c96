#include "io/read_ply.h"

#include "io/text_lines.h"

namespace abflat {

Result<PolygonMesh> readPly(std::string_view bytes, std::string_view fileName) {
  const Result<PlyHeader> header = readPlyHeader(bytes, fileName);
  if (!header.ok()) return header.status();
  return header.value().encoding == PlyEncoding::Text
             ? readPlyText(header.value(), bytes, fileName)
             : readPlyBinary(header.value(), bytes, fileName);
}

bool looksLikePly(std::string_view bytes) {
  return beginsWith(bytes, "ply") && bytes.size() > 3 && (bytes[3] == '\n' || bytes[3] == '\r');
}

}  // namespace abflat
