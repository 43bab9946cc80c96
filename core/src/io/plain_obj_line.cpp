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

/// The numbers of a line that may not be finite, and maybe more; returns the size of the line.
std::size_t takeNumbers(std::string_view text, Cursor c, double* numbers, std::size_t count) {
  for (std::size_t d = 0; d < count; ++d) {
    const char* const end = scanDouble(c.at, c.end, numbers[d]);
    if (end == nullptr) return 0;
    c.at = end;
    if (!c.atWordEnd()) return 0;
    c.skipBlanks();
  }
  return skipPlain(c) ? sizeWithLineEnd(text, c) : 0;
}

/// v, v/vt, v//vn or v/vt/vn; a slash with nothing after it means no index.
bool takeCorner(Cursor& c, ObjCorner& corner) {
  if (!takeInteger(c, corner.vertex) || corner.vertex == 0) return false;
  for (std::int64_t* const index : {&corner.texcoord, &corner.normal}) {
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
  const std::size_t size = takeKeyword(c, 'v') ? takeNumbers(text, c, point.data(), 3) : 0;
  if (size == 0) return 0;
  for (const double coordinate : point)
    if (!std::isfinite(coordinate)) return 0;
  return size;
}

std::size_t plainTexcoordLine(std::string_view text, std::array<double, 2>& texcoord) {
  Cursor c{text.data(), text.data() + text.size()};
  return takeKeyword(c, 'v', 't') ? takeNumbers(text, c, texcoord.data(), 2) : 0;
}

std::size_t plainNormalLine(std::string_view text, std::array<double, 3>& normal) {
  Cursor c{text.data(), text.data() + text.size()};
  return takeKeyword(c, 'v', 'n') ? takeNumbers(text, c, normal.data(), 3) : 0;
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
