#include "io/read_stl.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "io/parse_error.h"
#include "io/ply_value.h"
#include "io/text_lines.h"
#include "mesh/vertex_table.h"

namespace abflat {
namespace {

constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50, kNormalBytes = 12;

/// The facet count of a binary file; 0 if it is too short to have one.
std::uint64_t promisedFacets(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return 0;
  return loadedFrom<std::uint32_t, std::uint32_t>(bytes.data() + 80, false);
}

std::uint64_t promisedBytes(std::string_view bytes) {
  return kHeaderBytes + kFacetBytes * promisedFacets(bytes);
}

PolygonMesh meshOf(VertexTable& table, std::vector<std::uint32_t> corners) {
  PolygonMesh mesh;
  mesh.positions = table.takePositions();
  mesh.faceVertices = std::move(corners);
  mesh.faceOffsets.reserve(mesh.faceVertices.size() / 3 + 1);
  for (std::size_t c = 0; c <= mesh.faceVertices.size(); c += 3)
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(c));
  mesh.isZUp = true;  // as in CAD programs and printers, which use STL
  return mesh;
}

Result<PolygonMesh> readBinary(std::string_view bytes, std::string_view fileName) {
  const auto wrong = [&](const std::string& sentence) {
    return Status{StatusCode::ParseError, std::string(fileName) + ": " + sentence};
  };
  if (bytes.size() < kHeaderBytes)
    return wrong("not an STL file: it has " + std::to_string(bytes.size()) +
                 " bytes and does not begin with 'solid'");
  const std::uint64_t promised = promisedFacets(bytes);
  if (bytes.size() != promisedBytes(bytes))
    return wrong("the header declares " + std::to_string(promised) + " facets, or " +
                 std::to_string(promisedBytes(bytes)) + " bytes, but the file has " +
                 std::to_string(bytes.size()) +
                 (bytes.size() < promisedBytes(bytes) ? ". Is it truncated?" : ""));
  if (promised > 0xffffffff / 3) return wrong("more than 1431655765 facets are not supported");
  const auto facets = static_cast<std::size_t>(promised);
  VertexTable table(facets / 2);
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const char* at = bytes.data() + kHeaderBytes + f * kFacetBytes + kNormalBytes;
    for (std::size_t k = 0; k < 3; ++k) {
      double xyz[3];
      for (double& x : xyz) {
        x = static_cast<double>(loadedFrom<float, std::uint32_t>(at, false));
        if (!std::isfinite(x))
          return wrong("facet " + std::to_string(f) + " (byte " +
                       std::to_string(at - bytes.data()) + "): vertex " + std::to_string(k) +
                       " has a coordinate that is not finite");
        at += sizeof(float);
      }
      corners.push_back(table.vertexAt(xyz[0], xyz[1], xyz[2]));
    }
  }
  return meshOf(table, std::move(corners));
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Words of an STL text; line ends separate words just as blanks do.
class StlReader {
 public:
  StlReader(std::string_view text, std::string_view fileName)
      : text_(text), fileName_(fileName), table_(text.size() / kBytesPerFacet / 2) {
    corners_.reserve(3 * (text.size() / kBytesPerFacet));
  }

  Result<PolygonMesh> run() {
    bool isInSolid = false;
    for (std::string_view word = nextWord(); !word.empty(); word = nextWord()) {
      if (is(word, "solid") && !isInSolid) {
        isInSolid = true;
        skipLine();
      } else if (is(word, "endsolid") && isInSolid) {
        isInSolid = false;
        skipLine();
      } else if (is(word, "facet") && isInSolid) {
        if (Status s = facet(); !s.ok()) return s;
      } else {
        return here(isInSolid ? "expected 'facet' or 'endsolid', not " + quoted(word)
                              : "expected 'solid', not " + quoted(word));
      }
    }
    if (isInSolid) return here("the file ends before 'endsolid'. Is it truncated?");
    return meshOf(table_, std::move(corners_));
  }

 private:
  static constexpr std::size_t kBytesPerFacet = 200;

  /// Keywords may be upper or lower case.
  static bool is(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(),
                      [](char a, char b) { return (a | 0x20) == b; });
  }

  std::string_view nextWord() {
    skipBlanks();
    if (at_ == text_.size()) return {};
    word_ = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return text_.substr(word_, at_ - word_);
  }

  void skipLine() {
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  }

  /// An error at the word last read.
  Status here(const std::string& sentence) const {
    std::size_t line = 1;
    for (std::size_t i = 0; i < word_; ++line) {
      i += lineSize(text_.substr(i));
      if (i > word_) break;
    }
    return parseError(fileName_, line, sentence);
  }

  Status expect(std::string_view keyword) {
    if (takePlain(keyword)) return {};
    const std::string_view word = nextWord();
    if (is(word, keyword)) return {};
    return here("expected '" + std::string(keyword) + "', not " +
                (word.empty() ? "the end of the file. Is it truncated?" : quoted(word)));
  }

  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  }

  bool atWordEnd(std::size_t at) const { return at == text_.size() || isBlank(text_[at]); }

  /// Takes the keyword if it comes next and is written as usual.
  bool takePlain(std::string_view keyword) {
    skipBlanks();
    const std::size_t end = at_ + keyword.size();
    if (end > text_.size() || text_.compare(at_, keyword.size(), keyword) != 0 || !atWordEnd(end))
      return false;
    word_ = std::exchange(at_, end);
    return true;
  }

  /// As above, for a number.
  bool takePlain(double& value) {
    skipBlanks();
    const char* const begin = text_.data() + at_;
    const char* const end = scanDouble(begin, text_.data() + text_.size(), value);
    if (end == nullptr || !std::isfinite(value)) return false;
    const std::size_t next = at_ + static_cast<std::size_t>(end - begin);
    if (!atWordEnd(next)) return false;
    word_ = std::exchange(at_, next);
    return true;
  }

  /// Reads what follows 'facet'. The normal is ignored: many programs write one that is not a
  /// number.
  Status facet() {
    skipLine();
    for (const char* keyword : {"outer", "loop"})
      if (Status s = expect(keyword); !s.ok()) return s;
    for (int k = 0; k < 3; ++k)
      if (Status s = vertex(); !s.ok()) return s;
    for (const char* keyword : {"endloop", "endfacet"})
      if (Status s = expect(keyword); !s.ok()) return s;
    return {};
  }

  Status vertex() {
    if (Status s = expect("vertex"); !s.ok()) return s;
    double xyz[3];
    for (double& x : xyz) {
      if (takePlain(x)) continue;
      const std::string_view word = nextWord();
      if (!parseDouble(word, x))
        return here(word.empty() ? "the file ends within a vertex. Is it truncated?"
                                 : notANumber(word));
      if (!std::isfinite(x))
        return here("facet " + std::to_string(corners_.size() / 3) + ", vertex " +
                    std::to_string(corners_.size() % 3) + ": the coordinate " + quoted(word) +
                    " is not finite");
    }
    corners_.push_back(table_.vertexAt(xyz[0], xyz[1], xyz[2]));
    return {};
  }

  std::string_view text_;
  std::string_view fileName_;
  VertexTable table_;
  std::vector<std::uint32_t> corners_;
  std::size_t at_ = 0, word_ = 0;
};

/// Takes the first word off `text` and returns it in lower case.
std::string takeLowerWord(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && isBlank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !isBlank(text[end]) && end - begin < 16) ++end;
  std::string word(text.substr(begin, end - begin));
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  text.remove_prefix(end);
  return word;
}

/// Binary files may begin with "solid" too; what follows decides.
bool isText(std::string_view bytes) {
  constexpr std::size_t kEnough = 1024;
  if (hasByteOrderMark(bytes)) bytes.remove_prefix(kByteOrderMark.size());
  std::string_view rest = bytes;
  if (takeLowerWord(rest) != "solid") return false;
  if (bytes.substr(0, kEnough).find('\0') == std::string_view::npos) return true;
  rest.remove_prefix(lineSize(rest));
  const std::string word = takeLowerWord(rest);
  return word == "facet" || word == "endsolid";
}

bool hasBinarySize(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes && bytes.size() == promisedBytes(bytes);
}

}  // namespace

Result<PolygonMesh> readStl(std::string_view bytes, std::string_view fileName) {
  if (bytes.empty())
    return Status{StatusCode::ParseError, std::string(fileName) + ": the file is empty"};
  if (hasBinarySize(bytes)) return readBinary(bytes, fileName);
  if (!isText(bytes)) return readBinary(bytes, fileName);
  if (hasByteOrderMark(bytes)) bytes.remove_prefix(kByteOrderMark.size());
  return StlReader(bytes, fileName).run();
}

bool looksLikeStl(std::string_view bytes) { return hasBinarySize(bytes) || isText(bytes); }

}  // namespace abflat
