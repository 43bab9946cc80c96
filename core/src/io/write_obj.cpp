#include "abflat/io.h"
#include "base/number_text.h"
#include "io/obj_lines.h"
#include "io/plain_obj_line.h"
#include "io/text_lines.h"
#include "io/text_writer.h"

namespace abflat {
namespace {

using CornerUv = std::vector<std::uint32_t>;

void putTexcoords(TextWriter& out, const std::vector<double>& uv, std::string_view eol) {
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) {
    out.put("vt ");
    out.put(uv[i]);
    out.put(' ');
    out.put(uv[i + 1]);
    out.put(eol);
  }
}

/// Writes `f` with its corners: vertices and normals as they were written, with new texcoords in
/// between, starting at `next`.
void putFace(TextWriter& out, std::string_view corners, const CornerUv& cornerUv,
             std::size_t& next) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  const char *from = corners.data(), *const last = from + corners.size();
  // A corner takes at least a letter and a blank.
  char* to = out.room(corners.size() + 1 + (2 + kMostIntegerChars) * (corners.size() / 2 + 1));
  *to++ = 'f';
  while (true) {
    while (from != last && isBlank(*from)) ++from;
    if (from == last) break;
    *to++ = ' ';
    while (from != last && !isBlank(*from) && *from != '/') *to++ = *from++;
    const std::uint32_t texcoord = cornerUv[next++];
    const bool exists = texcoord != kNoTexcoord;
    if (from != last && *from == '/') ++from;
    while (from != last && !isBlank(*from) && *from != '/') ++from;
    // A slash with nothing after it is dropped.
    if (from != last && *from == '/' && (from + 1 == last || isBlank(from[1]))) ++from;
    const bool hasNormal = from != last && *from == '/';
    if (exists || hasNormal) *to++ = '/';
    if (exists) to = writeInteger(to, texcoord + 1);
    while (from != last && !isBlank(*from)) *to++ = *from++;
  }
  out.endAt(to);
}

/// The same corners the other way round; the first stays first.
std::string turnedWords(std::string_view corners) {
  std::string out(takeWord(corners));
  std::vector<std::string_view> others;
  for (std::string_view word = takeWord(corners); !word.empty(); word = takeWord(corners))
    others.push_back(word);
  for (std::size_t i = others.size(); i-- > 0;) out.append(" ").append(others[i]);
  return out;
}

/// Writes `l` with its vertices only: the texcoords they referred to are gone. These words have not
/// been validated, so anything that is not v/vt stays as it is.
void putPolyline(TextWriter& out, std::string_view points) {
  out.put('l');
  for (std::string_view word = takeWord(points); !word.empty(); word = takeWord(points)) {
    const std::string_view vertex = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    out.put(' ');
    out.put(parseInteger(vertex, index) ? vertex : word);
  }
}

/// Rewrites a source text with new texcoords.
class ObjRewriter {
 public:
  ObjRewriter(const std::vector<double>& uv, const CornerUv& cornerUv,
              const std::vector<std::uint32_t>& turnedFaces, std::size_t sourceSize)
      : uv_(uv),
        cornerUv_(cornerUv),
        nextTurned_(turnedFaces.begin()),
        endTurned_(turnedFaces.end()),
        out_(sourceSize + 24 * uv.size() + 8 * cornerUv.size()) {}

  std::string run(std::string_view source) {
    const bool hasMark = hasByteOrderMark(source);
    if (hasMark) {
      out_.put(kByteOrderMark);
      source.remove_prefix(kByteOrderMark.size());
    }
    const std::string_view firstEnd = lineEnd(source.substr(0, lineSize(source)));
    eol_ = firstEnd.empty() ? "\n" : firstEnd;
    ObjLines lines(source);
    ObjLine line;
    while (!lines.rest().empty()) {
      const std::size_t size = plainLine(lines.rest());
      if (size > 0 && takePlain(lines.rest().substr(0, size)))
        lines.skipLine(size);
      else if (lines.next(line))
        take(line);
    }
    std::string text = out_.take();
    // The text may now begin with what looks like a mark, because the texcoord before it is gone.
    while (!hasMark && (hasByteOrderMark(text) || isUtf16(text))) text.insert(0, eol_);
    return text;
  }

 private:
  /// Handles the kinds of line that most of the file consists of; false for any other.
  bool takePlain(std::string_view line) {
    if (beginsWith(line, "f ")) {
      const std::string_view end = lineEnd(line);
      putFaceLine(line.substr(2, line.size() - 2 - end.size()), end);
      return true;
    }
    if (beginsWith(line, "vt ")) {
      drop();
      return true;
    }
    if (!beginsWith(line, "v ") && !beginsWith(line, "vn ")) return false;
    put(line);
    return true;
  }

  void put(std::string_view line) {
    out_.put(line);
    const std::size_t size = line.size() - lineEnd(line).size();
    isOpen_ = size > 0 && line[size - 1] == '\\' && line.find('#') == std::string_view::npos;
  }

  /// Drops a line, but keeps its end if its neighbours would otherwise be joined.
  void drop() {
    if (isOpen_) out_.put(eol_);
    isOpen_ = false;
  }

  void take(const ObjLine& line) {
    const bool isFace = line.kind == ObjLine::Kind::Face;
    const bool isMapped =
        line.kind == ObjLine::Kind::Polyline && line.arguments.find('/') != std::string_view::npos;
    if (line.kind == ObjLine::Kind::Texcoord) return drop();
    if (!isFace && !isMapped) return put(line.text);
    const std::string_view arguments = argumentsOf(line, storage_);
    const std::string_view end = lineEnd(line.text);
    if (isFace)
      putFaceLine(arguments, end, line.comment);
    else {
      putPolyline(out_, arguments);
      putEnd(end, line.comment);
    }
  }

  void putFaceLine(std::string_view corners, std::string_view end, std::string_view comment = {}) {
    if (corner_ == 0) putTexcoords(out_, uv_, end.empty() ? eol_ : end);
    const bool isTurned = nextTurned_ != endTurned_ && *nextTurned_ == face_;
    nextTurned_ += isTurned;
    ++face_;
    const std::string turned = isTurned ? turnedWords(corners) : std::string();
    putFace(out_, isTurned ? turned : corners, cornerUv_, corner_);
    putEnd(end, comment);
  }

  void putEnd(std::string_view end, std::string_view comment) {
    if (!comment.empty()) {
      out_.put(' ');
      out_.put(comment);
    }
    out_.put(end.empty() ? eol_ : end);
    isOpen_ = false;
  }

  const std::vector<double>& uv_;
  const CornerUv& cornerUv_;
  std::size_t corner_ = 0, face_ = 0;                                  ///< the next
  std::vector<std::uint32_t>::const_iterator nextTurned_, endTurned_;  ///< faces
  bool isOpen_ = false;  ///< the last line written ends in a backslash
  std::string_view eol_;
  std::string storage_;
  TextWriter out_;
};

std::string freshObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const CornerUv& cornerUv) {
  TextWriter out(21 * mesh.positions.size() + 24 * uv.size() + 16 * mesh.faceVertices.size());
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    out.put('v');
    for (std::size_t d = 0; d < 3; ++d) {
      out.put(' ');
      out.put(mesh.positions[3 * v + d]);
    }
    out.put('\n');
  }
  putTexcoords(out, uv, "\n");
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    out.put('f');
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      out.put(' ');
      out.put(mesh.faceVertices[c] + 1);
      if (uv.empty() || cornerUv[c] == kNoTexcoord) continue;
      out.put('/');
      out.put(cornerUv[c] + 1);
    }
    out.put('\n');
  }
  return out.take();
}

}  // namespace

std::string writeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const std::vector<std::uint32_t>& cornerUv, std::string_view sourceObj,
                     const std::vector<std::uint32_t>& turnedFaces) {
  return sourceObj.empty()
             ? freshObj(mesh, uv, cornerUv)
             : ObjRewriter(uv, cornerUv, turnedFaces, sourceObj.size()).run(sourceObj);
}

}  // namespace abflat
