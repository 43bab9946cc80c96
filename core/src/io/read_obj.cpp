#include "io/read_obj.h"

#include <cmath>
#include <istream>
#include <streambuf>
#include <vector>

#include "io/number_text.h"
#include "io/obj_lines.h"
#include "io/parse_error.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

namespace abflat {
namespace {

/// What tinyobjloader leaves unsaid: it reads a missing or malformed number as 0, does not join
/// lines and rounds decimals loosely. Each v and f line is checked here, so that what it parses
/// afterwards is known to be well formed, and coordinates are taken from here, correctly rounded.
struct StrictPass {
  std::string_view fileName;
  std::vector<double> positions;
  std::vector<std::size_t> faceLines;
  std::size_t corners = 0;
  std::int64_t largestIndex = 0;  ///< of all faces, counted from 1
  std::size_t largestIndexLine = 0;
  bool needsCleaning = false;  ///< a vertex or face line is continued or ends in a comment

  Status run(std::string_view text) {
    ObjLines lines(text);
    ObjLine line;
    while (lines.next(line)) {
      if (line.kind == ObjLine::Kind::Vertex || line.kind == ObjLine::Kind::Face)
        needsCleaning = needsCleaning || line.isJoined || !line.comment.empty();
      if (line.kind == ObjLine::Kind::Vertex) {
        if (Status s = vertex(line); !s.ok()) return s;
      } else if (line.kind == ObjLine::Kind::Face) {
        if (Status s = face(line); !s.ok()) return s;
      }
    }
    const auto vertices = static_cast<std::int64_t>(positions.size() / 3);
    if (largestIndex > vertices)
      return parseError(fileName, largestIndexLine,
                        "the face refers to vertex " + std::to_string(largestIndex) +
                            ", but the file has " + std::to_string(vertices) + " vertices");
    if (positions.empty() && faceLines.empty())
      return {StatusCode::ParseError, std::string(fileName) + ": holds no vertices and no faces" +
                                          (text.empty() ? "; the file is empty" : "")};
    return {};
  }

 private:
  Status vertex(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    for (int d = 0; d < 3; ++d) {
      const std::string_view word = takeWord(words);
      double value = 0;
      if (word.empty())
        return parseError(fileName, line.number,
                          "the vertex has " + std::to_string(d) +
                              " coordinates instead of 3; is the file cut off?");
      if (!parseDouble(word, value))
        return parseError(fileName, line.number, quoted(word) + " is not a number");
      if (!std::isfinite(value))
        return parseError(fileName, line.number,
                          "the coordinate " + quoted(word) + " is not finite");
      positions.push_back(value);
    }
    return {};
  }

  Status face(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    std::size_t count = 0;
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words), ++count)
      if (Status s = corner(line, word); !s.ok()) return s;
    if (count < 3)
      return parseError(
          fileName, line.number,
          "the face has " + std::to_string(count) + " corners; at least 3 are needed");
    corners += count;
    faceLines.push_back(line.number);
    return {};
  }

  /// v, v/vt, v//vn or v/vt/vn
  Status corner(const ObjLine& line, std::string_view word) {
    const auto malformed = [&] {
      return parseError(fileName, line.number,
                        quoted(word) + " is not a face corner (v, v/vt, v//vn or v/vt/vn)");
    };
    std::string_view rest = word;
    std::int64_t vertex = 0;
    for (int part = 0;; ++part) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view number = rest.substr(0, slash);
      std::int64_t value = 0;
      const bool mayBeEmpty = part == 1 && slash < rest.size();
      if (part > 2 || (!parseInteger(number, value) && !(number.empty() && mayBeEmpty)))
        return malformed();
      if (part == 0) vertex = value;
      if (slash == rest.size()) break;
      rest.remove_prefix(slash + 1);
    }
    if (vertex == 0) return parseError(fileName, line.number, "vertex index 0; OBJ counts from 1");
    const auto known = static_cast<std::int64_t>(positions.size() / 3);
    if (vertex < -known)
      return parseError(fileName, line.number,
                        "the face refers to vertex " + std::to_string(vertex) +
                            " (counted back), but only " + std::to_string(known) +
                            " vertices come before it");
    if (vertex > largestIndex) {
      largestIndex = vertex;
      largestIndexLine = line.number;
    }
    return {};
  }
};

/// The vertices and faces alone, each on one line without a comment: tinyobjloader knows neither
/// comments nor continuation inside of them.
std::string cleaned(std::string_view text) {
  std::string out, storage;
  out.reserve(text.size());
  ObjLines lines(text);
  ObjLine line;
  while (lines.next(line)) {
    if (line.kind != ObjLine::Kind::Vertex && line.kind != ObjLine::Kind::Face) continue;
    out += line.kind == ObjLine::Kind::Vertex ? "v " : "f ";
    out += argumentsOf(line, storage);
    out += '\n';
  }
  return out;
}

/// A stream over bytes that are not copied.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // only read from
    setg(begin, begin, begin + text.size());
  }
};

/// Receives tinyobjloader's records.
struct FaceCollector {
  PolygonMesh mesh;
  std::uint32_t verticesSoFar = 0;

  static void onVertex(void* self, double, double, double, double) {
    ++static_cast<FaceCollector*>(self)->verticesSoFar;
  }
  static void onFace(void* self, tinyobj::index_t* corners, int count) {
    auto& c = *static_cast<FaceCollector*>(self);
    for (int k = 0; k < count; ++k) {
      const int v = corners[k].vertex_index;
      c.mesh.faceVertices.push_back(v > 0 ? static_cast<std::uint32_t>(v - 1)
                                          : c.verticesSoFar - static_cast<std::uint32_t>(-v));
    }
    c.mesh.faceOffsets.push_back(static_cast<std::uint32_t>(c.mesh.faceVertices.size()));
  }
};

}  // namespace

Result<PolygonMesh> readObj(std::string_view bytes, std::string_view fileName) {
  StrictPass strict;
  strict.fileName = fileName;
  if (Status s = strict.run(bytes); !s.ok()) return s;

  const std::string copy = strict.needsCleaning ? cleaned(bytes) : std::string();
  ViewBuffer buffer(strict.needsCleaning ? std::string_view(copy) : bytes);
  std::istream stream(&buffer);
  FaceCollector collector;
  collector.mesh.faceOffsets.reserve(strict.faceLines.size() + 1);
  collector.mesh.faceOffsets.push_back(0);
  collector.mesh.faceVertices.reserve(strict.corners);
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = &FaceCollector::onVertex;
  callbacks.index_cb = &FaceCollector::onFace;
  std::string warning, error;
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &collector, nullptr, &warning, &error))
    return Status{StatusCode::ParseError, std::string(fileName) + ": " + error};
  // The two passes must have seen the same records.
  if (collector.verticesSoFar != strict.positions.size() / 3 ||
      collector.mesh.faceCount() != strict.faceLines.size() ||
      collector.mesh.faceVertices.size() != strict.corners)
    return Status{
        StatusCode::ParseError,
        std::string(fileName) +
            ": the lines of the file are ambiguous (unusual line ends or control characters)"};
  collector.mesh.positions = std::move(strict.positions);
  return std::move(collector.mesh);
}

}  // namespace abflat
