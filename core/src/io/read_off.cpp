#include "io/read_off.h"

#include <cmath>
#include <utility>

#include "base/counted.h"
#include "base/number_text.h"
#include "io/parse_error.h"
#include "io/read_off_binary.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// Lines that are not empty, without comments and line ends.
class OffLines {
 public:
  explicit OffLines(std::string_view text) : rest_(text) {}

  /// What follows the line last returned.
  std::string_view rest() const { return rest_; }

  bool next(std::string_view& line) {
    while (!rest_.empty()) {
      line = rest_.substr(0, lineSize(rest_));
      rest_.remove_prefix(line.size());
      ++number_;
      line = line.substr(0, line.find('#'));
      const std::size_t begin = line.find_first_not_of(kBlank);
      if (begin == std::string_view::npos) continue;
      line = line.substr(begin, line.find_last_not_of(kBlank) + 1 - begin);
      return true;
    }
    return false;
  }
  /// Number of the line last returned, counted from 1.
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// `numbers`: how many a vertex has in a binary file.
bool isHeader(std::string_view word, std::size_t& numbers) {
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return false;
  numbers = 3;
  for (const auto& [prefix, more] :
       {std::pair<std::string_view, std::size_t>{"ST", 2}, {"C", 4}, {"N", 3}}) {
    if (word.substr(0, prefix.size()) != prefix) continue;
    word.remove_prefix(prefix.size());
    numbers += more;
  }
  return word == "OFF";
}

class OffReader {
 public:
  OffReader(std::string_view bytes, std::string_view fileName)
      : lines_(bytes), bytes_(bytes), fileName_(fileName) {}

  Result<PolygonMesh> run() {
    if (Status s = readHeader(); !s.ok()) return s;
    if (binary_.size > 0) return readOffBinary(binary_, bytes_, fileName_);
    // A vertex takes at least 6 bytes and a face 8, so a false count cannot make the reader reserve
    // much more memory than the file size warrants.
    mesh_.positions.reserve(3 * std::min<std::size_t>(vertices_, bytes_.size() / 6));
    mesh_.faceOffsets.reserve(std::min<std::size_t>(faces_, bytes_.size() / 8) + 1);
    mesh_.faceVertices.reserve(3 * (mesh_.faceOffsets.capacity() - 1));
    mesh_.faceOffsets.push_back(0);
    std::string_view line;
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!lines_.next(line)) return cutOff(v, "vertex", "vertices");
      if (Status s = readVertex(line); !s.ok()) return s;
    }
    for (std::size_t f = 0; f < faces_; ++f) {
      if (!lines_.next(line)) return cutOff(f, "face", "faces");
      if (Status s = readFace(line); !s.ok()) return s;
    }
    // Exporters leave all sorts of things at the end, but another face would be part of the mesh.
    if (lines_.next(line) && readFace(line).ok())
      return here("the header declares " + promised() + ", but there is another face");
    mesh_.faceVertices.resize(mesh_.faceOffsets.back());  // drops what began like a face
    return std::move(mesh_);
  }

 private:
  Status here(const std::string& sentence) const {
    return parseError(fileName_, lines_.number(), sentence);
  }

  std::string promised() const {
    return counted(vertices_, "vertex", "vertices") + " and " + counted(faces_, "face", "faces");
  }

  Status cutOff(std::size_t read, const char* one, const char* many) const {
    return here("the header declares " + promised() + ", but the file ends after " +
                counted(read, one, many));
  }

  Status readHeader() {
    std::string_view line;
    if (!lines_.next(line))
      return {StatusCode::ParseError, std::string(fileName_) + ": the file is empty"};
    std::string_view words = line;
    std::string_view name = takeWord(words);
    // A well-known collection has "OFF490 518 0"; and the name may be omitted.
    constexpr std::string_view kDigits = "0123456789";
    const std::size_t glued = std::min(name.find_first_of(kDigits), name.size());
    const bool isCount = name.find_first_not_of(kDigits) == std::string_view::npos;
    if (isCount || isHeader(name.substr(0, glued), binary_.vertexNumbers)) {
      name = name.substr(0, glued);
      words = line.substr(glued);
    }
    if (!name.empty() && !isHeader(name, binary_.vertexNumbers))
      return here("not an OFF file: it begins with " + quoted(name));
    std::string_view counts = words;
    std::string_view first = takeWord(counts);
    if (first == "BINARY") {
      binary_.size = bytes_.size() - lines_.rest().size();
      return {};
    }
    if (first.empty()) {
      if (!lines_.next(line)) return here("the file ends before the vertex and face counts");
      words = line;
    }
    std::int64_t v = 0, f = 0;
    if (!parseInteger(takeWord(words), v) || !parseInteger(takeWord(words), f) || v < 0 || f < 0)
      return here("expected the vertex and face counts");
    vertices_ = static_cast<std::size_t>(v);
    faces_ = static_cast<std::size_t>(f);
    return {};
  }

  Status readVertex(std::string_view line) {
    std::string_view words = line;
    for (int d = 0; d < 3; ++d) {
      const std::string_view word = takeWord(words);
      double value = 0;
      if (word.empty())
        return here("the vertex has " + std::to_string(d) +
                    " coordinates instead of 3. Is the file truncated?");
      if (!parseDouble(word, value)) return here(notANumber(word));
      if (!std::isfinite(value)) return here("the coordinate " + quoted(word) + " is not finite");
      mesh_.positions.push_back(value);
    }
    return {};
  }

  Status readFace(std::string_view line) {
    std::string_view words = line;
    std::int64_t count = 0;
    const std::string_view first = takeWord(words);
    if (!parseInteger(first, count)) return here(quoted(first) + " is not a corner count");
    if (count < 3)
      return here("the face has " + std::to_string(count) + " corners; at least 3 are needed");
    for (std::int64_t k = 0; k < count; ++k) {
      const std::string_view word = takeWord(words);
      std::int64_t vertex = 0;
      if (word.empty())
        return here("the face has only " + std::to_string(k) + " of its " + std::to_string(count) +
                    " corners. Is the file truncated?");
      if (!parseInteger(word, vertex)) return here(quoted(word) + " is not a vertex number");
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices_)
        return here("the face refers to vertex " + std::to_string(vertex) + ", but the file has " +
                    std::to_string(vertices_) + " vertices (indices start at 0)");
      mesh_.faceVertices.push_back(static_cast<std::uint32_t>(vertex));
    }
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    return {};
  }

  OffLines lines_;
  std::string_view bytes_, fileName_;
  OffBinaryHeader binary_;  ///< if its size is not 0
  std::size_t vertices_ = 0, faces_ = 0;
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> readOff(std::string_view bytes, std::string_view fileName) {
  return OffReader(bytes, fileName).run();
}

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

}  // namespace abflat
