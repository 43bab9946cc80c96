#include "io/read_obj.h"

#include <array>
#include <cmath>
#include <vector>

#include "io/number_text.h"
#include "io/obj_lines.h"
#include "io/parse_error.h"
#include "io/plain_obj_line.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// Takes vertices and faces from an OBJ text and rejects what is not well formed.
class ObjReader {
 public:
  explicit ObjReader(std::string_view fileName) : fileName_(fileName) {}

  Result<PolygonMesh> run(std::string_view text) {
    reserve(text.size());
    mesh_.faceOffsets.push_back(0);
    ObjLines lines(text);
    while (!lines.rest().empty())
      if (Status s = nextLine(lines); !s.ok()) return s;
    if (largestIndex_ > knownVertices())
      return parseError(fileName_, largestIndexLine_,
                        "the face refers to vertex " + std::to_string(largestIndex_) +
                            ", but the file has " + std::to_string(knownVertices()) + " vertices");
    if (mesh_.positions.empty() && mesh_.faceVertices.empty())
      return Status{StatusCode::ParseError, std::string(fileName_) +
                                                ": holds no vertices and no faces" +
                                                (text.empty() ? "; the file is empty" : "")};
    return std::move(mesh_);
  }

 private:
  /// Two triangles a vertex, in bytes as a file without normals and texcoords has them.
  void reserve(std::size_t bytes) {
    constexpr std::size_t kBytesPerVertex = 96;
    const std::size_t vertices = bytes / kBytesPerVertex;
    mesh_.positions.reserve(3 * vertices);
    mesh_.faceOffsets.reserve(2 * vertices + 1);
    mesh_.faceVertices.reserve(6 * vertices);
  }

  Status nextLine(ObjLines& lines) {
    std::array<double, 3> point;
    if (const std::size_t size = plainVertexLine(lines.rest(), point); size > 0) {
      mesh_.positions.insert(mesh_.positions.end(), point.begin(), point.end());
      lines.skipLine(size);
      return {};
    }
    corners_.clear();
    if (const std::size_t size = plainFaceLine(lines.rest(), corners_); size > 0) {
      for (const std::int64_t vertex : corners_)
        if (Status s = inFile(vertex, lines.number()); !s.ok()) return s;
      appendFace();
      lines.skipLine(size);
      return {};
    }
    if (beginsWith(lines.rest(), "vn ") || beginsWith(lines.rest(), "vt "))
      if (const std::size_t size = plainLine(lines.rest()); size > 0) {
        lines.skipLine(size);
        return {};
      }
    ObjLine line;
    lines.next(line);
    if (line.kind == ObjLine::Kind::Vertex) return vertex(line);
    if (line.kind == ObjLine::Kind::Face) return face(line);
    return {};
  }

  Status vertex(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    for (int d = 0; d < 3; ++d) {
      const std::string_view word = takeWord(words);
      double value = 0;
      if (word.empty())
        return parseError(fileName_, line.number,
                          "the vertex has " + std::to_string(d) +
                              " coordinates instead of 3; is the file cut off?");
      if (!parseDouble(word, value))
        return parseError(fileName_, line.number, quoted(word) + " is not a number");
      if (!std::isfinite(value))
        return parseError(fileName_, line.number,
                          "the coordinate " + quoted(word) + " is not finite");
      mesh_.positions.push_back(value);
    }
    return {};
  }

  Status face(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    corners_.clear();
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words)) {
      std::int64_t vertex = 0;
      if (Status s = corner(line, word, vertex); !s.ok()) return s;
      if (Status s = inFile(vertex, line.number); !s.ok()) return s;
      corners_.push_back(vertex);
    }
    if (corners_.size() < 3)
      return parseError(
          fileName_, line.number,
          "the face has " + std::to_string(corners_.size()) + " corners; at least 3 are needed");
    appendFace();
    return {};
  }

  /// Takes the corners of one face, whose vertices are known to be in the file or may yet come.
  void appendFace() {
    const std::int64_t known = knownVertices();
    for (const std::int64_t v : corners_)
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(v > 0 ? v - 1 : known + v));
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
  }

  /// v, v/vt, v//vn or v/vt/vn
  Status corner(const ObjLine& line, std::string_view word, std::int64_t& vertex) const {
    const auto malformed = [&] {
      return parseError(fileName_, line.number,
                        quoted(word) + " is not a face corner (v, v/vt, v//vn or v/vt/vn)");
    };
    std::string_view rest = word;
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
    if (vertex == 0) return parseError(fileName_, line.number, "vertex index 0; OBJ counts from 1");
    return {};
  }

  /// Checks an index as far as the lines read so far tell; the rest is for the end of the file.
  Status inFile(std::int64_t vertex, std::size_t line) {
    const std::int64_t known = knownVertices();
    if (vertex < -known)
      return parseError(fileName_, line,
                        "the face refers to vertex " + std::to_string(vertex) +
                            " (counted back), but only " + std::to_string(known) +
                            " vertices come before it");
    if (vertex > largestIndex_) {
      largestIndex_ = vertex;
      largestIndexLine_ = line;
    }
    return {};
  }

  std::int64_t knownVertices() const {
    return static_cast<std::int64_t>(mesh_.positions.size() / 3);
  }

  std::string_view fileName_;
  PolygonMesh mesh_;
  std::vector<std::int64_t> corners_;  ///< of one face, as written
  std::int64_t largestIndex_ = 0;      ///< of all faces, counted from 1
  std::size_t largestIndexLine_ = 0;
};

}  // namespace

Result<PolygonMesh> readObj(std::string_view bytes, std::string_view fileName) {
  return ObjReader(fileName).run(bytes);
}

}  // namespace abflat
