#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number_text.h"
#include "io/parse_error.h"
#include "io/ply_messages.h"
#include "io/ply_texcoords.h"
#include "io/ply_value.h"
#include "io/read_ply.h"
#include "io/settle_normals.h"
#include "io/text_cursor.h"
#include "io/text_lines.h"
#include "io/triangle_strip.h"

namespace abflat {
namespace {

constexpr std::uint64_t kMostCorners = 0xffffffff;

/// Each row is a line; blank lines are skipped.
class TextReader {
 public:
  TextReader(const PlyHeader& header, std::string_view bytes, std::string_view fileName)
      : header_(header),
        rest_(bytes.substr(header.text.size())),
        line_(header.lines),
        fileName_(fileName) {}

  Result<PolygonMesh> run() {
    mesh_.faceOffsets.push_back(0);
    std::string_view words;
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      element_ = &header_.elements[i];
      if (element_->properties.empty()) continue;
      reserve(i);
      for (std::uint64_t row = 0; row < element_->count; ++row) {
        const bool isPlain = i == header_.vertex
                                 ? takePlainVertex()
                                 : i == header_.face && !header_.hasStrips && takePlainFace();
        if (isPlain) continue;
        if (!nextRow(words))
          return here("the header declares " + rowsOf(element_->count, *element_) +
                      ", but the file ends after " + std::to_string(row));
        const Status s = i == header_.vertex ? vertex(words) : skippedOrFace(words, i);
        if (!s.ok()) return s;
      }
    }
    if (nextRow(words)) return here("the file goes on after the last row that its header declares");
    finishTexcoords(header_, mesh_);
    takeVertexNormals(mesh_);
    return std::move(mesh_);
  }

 private:
  Status here(const std::string& sentence) const { return parseError(fileName_, line_, sentence); }

  /// A number takes at least 2 bytes, so a false count cannot make the reader reserve more memory
  /// than the file size warrants.
  void reserve(std::size_t element) {
    const auto rows =
        static_cast<std::size_t>(std::min<std::uint64_t>(element_->count, rest_.size() / 2 + 1));
    if (element == header_.vertex)
      mesh_.positions.reserve(std::min(3 * rows, rest_.size() / 2 + 3));
    if (element != header_.face) return;
    mesh_.faceOffsets.reserve(rows + 1);
    mesh_.faceVertices.reserve(std::min(3 * rows, rest_.size() / 2 + 3));
  }

  bool nextRow(std::string_view& words) {
    while (!rest_.empty()) {
      const std::string_view line = rest_.substr(0, lineSize(rest_));
      rest_.remove_prefix(line.size());
      ++line_;
      const std::size_t first = line.find_first_not_of(" \t\r\n");
      if (first == std::string_view::npos) continue;
      words = line.substr(first, line.find_last_not_of(" \t\r\n") + 1 - first);
      return true;
    }
    return false;
  }

  /// Nearly all rows are numbers and single separators, which need no closer look: they are parsed
  /// in a single pass. Any other row, valid or not, is left unread.
  bool takePlainVertex() {
    if (element_->hasLists) return false;
    TextCursor c{rest_.data(), rest_.data() + rest_.size()};
    double xyz[3], uv[2], normal[3];
    for (std::size_t p = 0; p < element_->properties.size(); ++p) {
      c.skipBlanks();
      if (c.atLineEnd()) return false;
      const std::size_t d = p == header_.x ? 0 : p == header_.y ? 1 : p == header_.z ? 2 : 3;
      if (d < 3) {
        const char* const end = scanDouble(c.at, c.end, xyz[d]);
        if (end == nullptr || !std::isfinite(xyz[d])) return false;
        c.at = end;
        if (!c.atWordEnd()) return false;
      } else if (const std::size_t n = normalAxis(p); n < 3 || p == header_.u || p == header_.v) {
        double& number = n < 3 ? normal[n] : uv[p == header_.u ? 0 : 1];
        const char* const end = scanDouble(c.at, c.end, number);
        if (end == nullptr) return false;
        c.at = end;
        if (!c.atWordEnd()) return false;
      } else {
        c.skipWord();
      }
    }
    if (!takeRowEnd(c)) return false;
    mesh_.positions.insert(mesh_.positions.end(), xyz, xyz + 3);
    if (readsUv()) mesh_.texcoords.insert(mesh_.texcoords.end(), uv, uv + 2);
    if (readsNormal()) mesh_.normals.insert(mesh_.normals.end(), normal, normal + 3);
    return true;
  }

  bool takePlainFace() {
    TextCursor c{rest_.data(), rest_.data() + rest_.size()};
    const std::size_t before = mesh_.faceVertices.size();
    bool isPlain = true;
    for (std::size_t p = 0; p < element_->properties.size() && isPlain; ++p) {
      c.skipBlanks();
      if (p == header_.corners) {
        isPlain = takePlainCorners(c);
      } else {
        isPlain = !element_->properties[p].isList && !c.atLineEnd();
        c.skipWord();
      }
    }
    if (!isPlain || mesh_.faceVertices.size() > kMostCorners || !takeRowEnd(c)) {
      mesh_.faceVertices.resize(before);
      return false;
    }
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    return true;
  }

  bool takePlainCorners(TextCursor& c) {
    const std::uint64_t vertices = header_.elements[header_.vertex].count;
    std::int64_t size = 0, vertex = 0;
    if (!takeInteger(c, size) || !c.atWordEnd() || size < 3) return false;
    for (; size > 0; --size) {
      c.skipBlanks();
      if (!takeInteger(c, vertex) || !c.atWordEnd() || vertex < 0 ||
          static_cast<std::uint64_t>(vertex) >= vertices)
        return false;
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(vertex));
    }
    return true;
  }

  /// Moves past the row if nothing else follows on its line.
  bool takeRowEnd(TextCursor c) {
    c.skipBlanks();
    if (!c.atLineEnd()) return false;
    c.takeLineEnd();
    rest_.remove_prefix(static_cast<std::size_t>(c.at - rest_.data()));
    ++line_;
    return true;
  }

  Status missing(const PlyProperty& property) const {
    return here("the row ends before " + quoted(property.name) + ". Is the file truncated?");
  }

  Status ended(std::string_view words) const {
    const std::string_view word = takeWord(words);
    if (word.empty()) return {};
    return here("the row has more values than its element has properties: " + quoted(word));
  }

  Status vertex(std::string_view words) {
    const std::size_t at = mesh_.positions.size(), uvAt = mesh_.texcoords.size();
    mesh_.positions.resize(at + 3);
    if (readsUv()) mesh_.texcoords.resize(uvAt + 2);
    if (readsNormal()) mesh_.normals.resize(at + 3);
    for (std::size_t p = 0; p < element_->properties.size(); ++p) {
      const bool isWanted = p == header_.x || p == header_.y || p == header_.z;
      if (const std::size_t n = normalAxis(p); n < 3 || p == header_.u || p == header_.v) {
        const std::string_view word = takeWord(words);
        if (word.empty()) return missing(element_->properties[p]);
        double& number =
            n < 3 ? mesh_.normals[at + n] : mesh_.texcoords[uvAt + (p == header_.u ? 0 : 1)];
        number = numberOrNone(word);
        continue;
      }
      if (!isWanted) {
        if (Status s = skip(element_->properties[p], words); !s.ok()) return s;
        continue;
      }
      const std::string_view word = takeWord(words);
      double value = 0;
      if (word.empty()) return missing(element_->properties[p]);
      if (!parseDouble(word, value)) return here(notANumber(word));
      if (!std::isfinite(value))
        return here("vertex " + std::to_string(at / 3) + " has the coordinate " + quoted(word) +
                    ", which is not finite");
      mesh_.positions[at + (p == header_.x ? 0 : p == header_.y ? 1 : 2)] = value;
    }
    return ended(words);
  }

  bool readsUv() const { return header_.u != kNoIndex; }
  bool readsNormal() const { return header_.normal[0] != kNoIndex; }

  /// 0 to 2 if the property is nx, ny or nz, otherwise 3.
  std::size_t normalAxis(std::size_t property) const {
    std::size_t axis = 0;
    while (axis < 3 && header_.normal[axis] != property) ++axis;
    return axis;
  }

  /// A number of a texcoord or normal; NaN if the word is not a number.
  static double numberOrNone(std::string_view word) {
    double value = 0;
    return parseDouble(word, value) ? value : std::numeric_limits<double>::quiet_NaN();
  }

  Status skippedOrFace(std::string_view words, std::size_t element) {
    const bool isFace = element == header_.face;
    uv_.clear();
    for (std::size_t p = 0; p < element_->properties.size(); ++p) {
      const PlyProperty& property = element_->properties[p];
      if (Status s = isFace && p == header_.corners           ? corners(property, words)
                     : isFace && p == header_.cornerTexcoords ? cornerTexcoords(property, words)
                                                              : skip(property, words);
          !s.ok())
        return s;
    }
    if (isFace && header_.cornerTexcoords != kNoIndex) appendTexcoords(uv_, mesh_);
    return ended(words);
  }

  Status cornerTexcoords(const PlyProperty& property, std::string_view& words) {
    std::int64_t size = 0;
    if (Status s = listSize(property, words, size); !s.ok()) return s;
    for (std::int64_t k = 0; k < size; ++k) {
      const std::string_view word = takeWord(words);
      if (word.empty()) return missing(property);
      uv_.push_back(numberOrNone(word));
    }
    return {};
  }

  /// Whole numbers may be written as "3.0" if their type is float.
  static bool parseWhole(std::string_view word, std::int64_t& whole) {
    if (parseInteger(word, whole)) return true;
    double value = 0;
    if (!parseDouble(word, value) || !(std::abs(value) < 1e15) || value != std::floor(value))
      return false;
    whole = static_cast<std::int64_t>(value);
    return true;
  }

  Status listSize(const PlyProperty& property, std::string_view& words, std::int64_t& size) {
    const std::string_view word = takeWord(words);
    if (word.empty()) return missing(property);
    if (!parseWhole(word, size) || size < 0)
      return here(quoted(word) + " is not the length of list " + quoted(property.name));
    return {};
  }

  Status skip(const PlyProperty& property, std::string_view& words) {
    std::int64_t size = 1;
    if (property.isList)
      if (Status s = listSize(property, words, size); !s.ok()) return s;
    for (std::int64_t k = 0; k < size; ++k)
      if (takeWord(words).empty()) return missing(property);
    return {};
  }

  Status corners(const PlyProperty& property, std::string_view& words) {
    if (Status s = header_.hasStrips ? strips(property, words) : face(property, words); !s.ok())
      return s;
    return mesh_.faceVertices.size() > kMostCorners ? here(kTooManyCorners) : Status();
  }

  Status strips(const PlyProperty& property, std::string_view& words) {
    const std::uint64_t vertices = header_.elements[header_.vertex].count;
    std::int64_t size = 0;
    if (Status s = listSize(property, words, size); !s.ok()) return s;
    TriangleStrip strip(mesh_);
    for (std::int64_t k = 0; k < size; ++k) {
      const std::string_view word = takeWord(words);
      std::int64_t vertex = 0;
      if (word.empty())
        return here("the strip has only " + std::to_string(k) + " of its " + std::to_string(size) +
                    " entries. Is the file truncated?");
      if (!parseWhole(word, vertex)) return here(quoted(word) + " is not a vertex number");
      if (vertex < -1 || (vertex >= 0 && static_cast<std::uint64_t>(vertex) >= vertices))
        return here(noSuchEntry(static_cast<std::size_t>(k), std::to_string(vertex), vertices));
      if (vertex < 0)
        strip.end();
      else
        strip.add(static_cast<std::uint32_t>(vertex));
    }
    return {};
  }

  Status face(const PlyProperty& property, std::string_view& words) {
    const std::uint64_t vertices = header_.elements[header_.vertex].count;
    std::int64_t size = 0;
    if (Status s = listSize(property, words, size); !s.ok()) return s;
    if (size < 3) return here(tooFewCorners(static_cast<std::size_t>(size)));
    for (std::int64_t k = 0; k < size; ++k) {
      const std::string_view word = takeWord(words);
      std::int64_t vertex = 0;
      if (word.empty())
        return here("the face has only " + std::to_string(k) + " of its " + std::to_string(size) +
                    " corners. Is the file truncated?");
      if (!parseWhole(word, vertex)) return here(quoted(word) + " is not a vertex number");
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices)
        return here(noSuchVertex(std::to_string(vertex), vertices));
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(vertex));
    }
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    return {};
  }

  const PlyHeader& header_;
  std::string_view rest_;
  std::size_t line_;
  std::string_view fileName_;
  const PlyElement* element_ = nullptr;
  std::vector<double> uv_;  ///< of the corners of one face
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> readPlyText(const PlyHeader& header, std::string_view bytes,
                                std::string_view fileName) {
  return TextReader(header, bytes, fileName).run();
}

}  // namespace abflat
