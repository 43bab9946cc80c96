#include "io/plain_obj_line.h"

#include <cmath>
#include <cstring>

#include "base/number_text.h"
#include "io/text_cursor.h"

namespace abflat {
namespace {

using Cursor = TextCursor;

template <class... Letters>
bool takeKeyword(Cursor& c, Letters... letters) {
  if (!(c.take(letters) && ...) || c.done() || !Cursor::isBlank(*c.at)) return false;
  c.skipBlanks();
  return true;
}

bool hasByte(std::uint64_t eight, char c) {
  constexpr std::uint64_t kOnes = 0x0101010101010101, kHighBits = 0x8080808080808080;
  const std::uint64_t zeroThere = eight ^ (kOnes * static_cast<unsigned char>(c));
  return ((zeroThere - kOnes) & ~zeroThere & kHighBits) != 0;
}

/// Advances to the first character that ends the line or makes it special; false if it is the
/// latter.
bool skipPlain(Cursor& c) {
  for (std::uint64_t eight = 0; c.end - c.at >= 8; c.at += 8) {
    std::memcpy(&eight, c.at, 8);
    if (hasByte(eight, '\n') || hasByte(eight, '\r') || hasByte(eight, '\\') || hasByte(eight, '#'))
      break;
  }
  for (; !c.atLineEnd(); ++c.at)
    if (*c.at == '\\' || *c.at == '#') return false;
  return true;
}

std::size_t sizeWithLineEnd(std::string_view text, Cursor c) {
  c.takeLineEnd();
  return static_cast<std::size_t>(c.at - text.data());
}

/// v, v/vt, v//vn or v/vt/vn; a slash with nothing after it means no index.
bool takeCorner(Cursor& c, ObjCorner& corner) {
  std::int64_t normal = 0;
  if (!takeInteger(c, corner.vertex) || corner.vertex == 0) return false;
  for (std::int64_t* const index : {&corner.texcoord, &normal}) {
    if (!c.take('/')) break;
    if (!c.atWordEnd() && *c.at != '/' && !takeInteger(c, *index)) return false;
  }
  return c.atWordEnd();
}

}  // namespace

std::size_t plainLine(std::string_view text) {
  Cursor c{text.data(), text.data() + text.size()};
  return skipPlain(c) ? sizeWithLineEnd(text, c) : 0;
}

std::size_t plainVertexLine(std::string_view text, std::array<double, 3>& point) {
  Cursor c{text.data(), text.data() + text.size()};
  if (!takeKeyword(c, 'v')) return 0;
  for (double& coordinate : point) {
    const char* const end = scanDouble(c.at, c.end, coordinate);
    if (end == nullptr || !std::isfinite(coordinate)) return 0;
    c.at = end;
    if (!c.atWordEnd()) return 0;
    c.skipBlanks();
  }
  return skipPlain(c) ? sizeWithLineEnd(text, c) : 0;
}

std::size_t plainTexcoordLine(std::string_view text, std::array<double, 2>& texcoord) {
  Cursor c{text.data(), text.data() + text.size()};
  if (!takeKeyword(c, 'v', 't')) return 0;
  for (double& coordinate : texcoord) {
    const char* const end = scanDouble(c.at, c.end, coordinate);
    if (end == nullptr) return 0;
    c.at = end;
    if (!c.atWordEnd()) return 0;
    c.skipBlanks();
  }
  return skipPlain(c) ? sizeWithLineEnd(text, c) : 0;
}

std::size_t plainFaceLine(std::string_view text, std::vector<ObjCorner>& corners) {
  Cursor c{text.data(), text.data() + text.size()};
  if (!takeKeyword(c, 'f')) return 0;
  const std::size_t before = corners.size();
  while (!c.atLineEnd()) {
    ObjCorner corner;
    if (!takeCorner(c, corner)) return corners.resize(before), 0;
    corners.push_back(corner);
    c.skipBlanks();
  }
  if (corners.size() < before + 3) return corners.resize(before), 0;
  return sizeWithLineEnd(text, c);
}

}  // namespace abflat
