#include "io/read_obj.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "io/obj_lines.h"
#include "io/parse_error.h"
#include "io/plain_obj_line.h"
#include "io/settle_normals.h"
#include "io/settle_texcoords.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// What 1.#QNAN, -1.#IND and the like leave after the point, which reads as a comment.
bool isMicrosoftNan(std::string_view comment) {
  return beginsWith(comment, "#QNAN") || beginsWith(comment, "#SNAN") ||
         beginsWith(comment, "#IND") || beginsWith(comment, "#INF");
}

/// Takes vertices, faces, texcoords, normals, smoothing groups and materials from an OBJ text.
/// Rejects malformed input, except that a malformed texcoord or normal counts as none.
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
      return Status{
          StatusCode::ParseError,
          std::string(fileName_) +
              (text.empty() ? ": the file is empty" : " contains no mesh (no v or f lines)")};
    settleTexcoords(mesh_);
    if (hasSmoothing_) mesh_.faceSmoothing.resize(mesh_.faceCount(), smoothing_);
    settleNormals(mesh_);
    if (!materials_.empty()) mesh_.faceMaterials.resize(mesh_.faceCount(), material_);
    return std::move(mesh_);
  }

 private:
  /// Assumes two triangles per vertex and the file size of a mesh without normals and texcoords.
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
      for (const ObjCorner& corner : corners_)
        if (Status s = inFile(corner.vertex, lines.number()); !s.ok()) return s;
      appendFace();
      lines.skipLine(size);
      return {};
    }
    std::array<double, 2> uv;
    if (const std::size_t size = plainTexcoordLine(lines.rest(), uv); size > 0) {
      if (mesh_.texcoords.empty()) mesh_.texcoords.reserve(mesh_.positions.size() / 3 * 2);
      mesh_.texcoords.insert(mesh_.texcoords.end(), uv.begin(), uv.end());
      lines.skipLine(size);
      return {};
    }
    std::array<double, 3> normal;
    if (const std::size_t size = plainNormalLine(lines.rest(), normal); size > 0) {
      if (mesh_.normals.empty()) mesh_.normals.reserve(mesh_.positions.size());
      mesh_.normals.insert(mesh_.normals.end(), normal.begin(), normal.end());
      lines.skipLine(size);
      return {};
    }
    ObjLine line;
    lines.next(line);
    if (line.kind == ObjLine::Kind::Vertex) return vertex(line);
    if (line.kind == ObjLine::Kind::Face) return face(line);
    if (line.kind == ObjLine::Kind::Texcoord) texcoord(line);
    if (line.kind == ObjLine::Kind::Other) other(line);
    return {};
  }

  void other(const ObjLine& line) {
    std::string_view rest = line.text;
    const std::string_view keyword = takeWord(rest);
    if (keyword == "vn") normal(line.arguments);
    if (keyword == "s") smoothing(line.arguments);
    if (keyword == "usemtl") material(restOfLine(rest));
  }

  void normal(std::string_view words) {
    for (int d = 0; d < 3; ++d) {
      double value = 0;
      if (!parseDouble(takeWord(words), value)) value = std::numeric_limits<double>::quiet_NaN();
      mesh_.normals.push_back(value);
    }
  }

  /// Faces before the first `s` are in no group, which is also called 0 or off.
  void smoothing(std::string_view words) {
    mesh_.faceSmoothing.resize(mesh_.faceCount(), smoothing_);
    hasSmoothing_ = true;
    std::int64_t number = 0;
    const bool isGroup = parseInteger(takeWord(words), number) && number > 0 && number < 0xffffffff;
    smoothing_ = isGroup ? static_cast<std::uint32_t>(number) : 0;
  }

  /// The second coordinate may be omitted.
  void texcoord(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    for (int d = 0; d < 2; ++d) {
      const std::string_view word = takeWord(words);
      double value = 0;
      if ((d == 0 || !word.empty()) && !parseDouble(word, value))
        value = std::numeric_limits<double>::quiet_NaN();
      mesh_.texcoords.push_back(value);
    }
  }

  /// Names may contain blanks and #. Faces before the first `usemtl` have a material of their own.
  void material(std::string_view name) {
    if (materials_.empty() && mesh_.faceCount() > 0) {
      mesh_.faceMaterials.assign(mesh_.faceCount(), 0);
      materials_.emplace("", 0);
      mesh_.materialNames.emplace_back();
    }
    mesh_.faceMaterials.resize(mesh_.faceCount(), material_);
    const auto [known, isNew] =
        materials_.emplace(name, static_cast<std::uint32_t>(materials_.size()));
    material_ = known->second;
    if (isNew) mesh_.materialNames.emplace_back(name);
  }

  Status vertex(const ObjLine& line) {
    std::string storage;
    std::string_view words = argumentsOf(line, storage);
    for (int d = 0; d < 3; ++d) {
      const std::string_view word = takeWord(words);
      double value = 0;
      if (isMicrosoftNan(line.comment))
        return parseError(fileName_, line.number,
                          "a coordinate is not finite: " + quoted(line.comment));
      if (word.empty())
        return parseError(fileName_, line.number,
                          "the vertex has " + std::to_string(d) +
                              (d == 1 ? " coordinate" : " coordinates") +
                              " instead of 3. Is the file truncated?");
      if (!parseDouble(word, value)) return parseError(fileName_, line.number, notANumber(word));
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
      ObjCorner corner;
      if (Status s = parseCorner(line, word, corner); !s.ok()) return s;
      if (Status s = inFile(corner.vertex, line.number); !s.ok()) return s;
      corners_.push_back(corner);
    }
    if (corners_.size() < 3)
      return parseError(
          fileName_, line.number,
          "the face has " + std::to_string(corners_.size()) + " corners; at least 3 are needed");
    appendFace();
    return {};
  }

  /// Takes the corners of one face, whose vertices are in the file already or may follow.
  void appendFace() {
    const std::int64_t known = knownVertices();
    bool hasTexcoords = false, hasNormals = false;
    for (const auto& [v, vt, vn] : corners_) {
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(v > 0 ? v - 1 : known + v));
      hasTexcoords = hasTexcoords || vt != 0;
      hasNormals = hasNormals || vn != 0;
    }
    if (hasTexcoords)
      appendIndices(&ObjCorner::texcoord, mesh_.texcoords.size() / 2, mesh_.faceTexcoords);
    if (hasNormals) appendIndices(&ObjCorner::normal, mesh_.normals.size() / 3, mesh_.faceNormals);
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
  }

  /// Appends texcoords or normals of the corners of a face, of which `known` are in the file so
  /// far.
  void appendIndices(std::int64_t ObjCorner::*index, std::size_t known,
                     std::vector<std::uint32_t>& out) const {
    static_assert(kNoTexcoord == kNoNormal, "both mean none");
    if (out.empty()) out.reserve(mesh_.faceVertices.capacity());
    // Earlier faces may have had none.
    out.resize(mesh_.faceVertices.size() - corners_.size(), kNoTexcoord);
    for (const ObjCorner& corner : corners_) {
      const std::int64_t given = corner.*index;
      const std::int64_t i = given > 0 ? given - 1 : static_cast<std::int64_t>(known) + given;
      const bool isIndex = given != 0 && i >= 0 && i < kNoTexcoord;
      out.push_back(isIndex ? static_cast<std::uint32_t>(i) : kNoTexcoord);
    }
  }

  /// v, v/vt, v//vn or v/vt/vn; a slash with nothing after it means no index.
  Status parseCorner(const ObjLine& line, std::string_view word, ObjCorner& corner) const {
    const auto malformed = [&] {
      return parseError(fileName_, line.number,
                        quoted(word) + " is not a face corner (v, v/vt, v//vn or v/vt/vn)");
    };
    std::string_view rest = word;
    for (int part = 0;; ++part) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view number = rest.substr(0, slash);
      std::int64_t value = 0;
      if (part > 2 || (!parseInteger(number, value) && (part == 0 || !number.empty())))
        return malformed();
      if (part == 0) corner.vertex = value;
      if (part == 1) corner.texcoord = value;
      if (part == 2) corner.normal = value;
      if (slash == rest.size()) break;
      rest.remove_prefix(slash + 1);
    }
    if (corner.vertex == 0)
      return parseError(fileName_, line.number, "vertex index 0. OBJ indices start at 1");
    return {};
  }

  /// Checks an index against the lines read so far; the upper bound is checked at the end of the
  /// file.
  Status inFile(std::int64_t vertex, std::size_t line) {
    const std::int64_t known = knownVertices();
    if (vertex < -known)
      return parseError(fileName_, line,
                        "the face refers to vertex " + std::to_string(vertex) + ", but only " +
                            std::to_string(known) + " vertices come before it");
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
  std::vector<ObjCorner> corners_;                               ///< of one face
  std::map<std::string, std::uint32_t, std::less<>> materials_;  ///< numbers by name
  std::uint32_t material_ = 0;                                   ///< of the faces to come
  std::uint32_t smoothing_ = 0;                                  ///< likewise
  bool hasSmoothing_ = false;
  std::int64_t largestIndex_ = 0;  ///< of all faces, counted from 1
  std::size_t largestIndexLine_ = 0;
};

}  // namespace

Result<PolygonMesh> readObj(std::string_view bytes, std::string_view fileName) {
  return ObjReader(fileName).run(bytes);
}

bool looksLikeObj(std::string_view bytes) {
  ObjLines lines(bytes.substr(0, 1 << 16));
  ObjLine line;
  while (lines.next(line))
    if (line.kind != ObjLine::Kind::Other && !line.arguments.empty()) return true;
  return false;
}

}  // namespace abflat
