// Compares OBJ files, damaged ones included, with what tinyobjloader reads. Where the two readers
// differ, the text must show one of the reasons listed here.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "abflat/io.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/mutated_text.h"
#include "support/tinyobj.h"

using namespace abflat;

namespace {

/// A line of a text as either reader may see it, independent of their code.
struct Line {
  std::string all, keyword;
  std::vector<std::string> words;           ///< between the keyword and a comment
  std::size_t vertices = 0, texcoords = 0;  ///< number of such lines before it
  std::size_t allVertices = 0, allTexcoords = 0;

  bool is(const char* name) const { return keyword == name; }
  bool isData() const { return is("v") || is("vt") || is("f"); }
};

std::vector<Line> linesOf(const std::string& text) {
  std::vector<Line> out;
  std::size_t vertices = 0, texcoords = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    Line line;
    line.all = text.substr(at, end - at);
    for (const std::string& piece : test::piecesOf(line.all.substr(0, line.all.find('#'))))
      if (piece[0] != ' ' && piece[0] != '\t') line.words.push_back(piece);
    if (!line.words.empty()) {
      line.keyword = line.words.front();
      line.words.erase(line.words.begin());
    }
    line.vertices = vertices;
    line.texcoords = texcoords;
    vertices += line.is("v");
    texcoords += line.is("vt");
    out.push_back(line);
    at = end + 1;
  }
  for (Line& line : out) {
    line.allVertices = vertices;
    line.allTexcoords = texcoords;
  }
  return out;
}

bool isNumber(const std::string& word) {
  static const std::regex kNumber(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
  return std::regex_match(word, kNumber);
}

/// Out of reach of powers of five and two computed in double precision.
bool isFar(const std::string& word) {
  constexpr double kFar = 280;
  if (!isNumber(word)) return false;
  const double value = std::abs(std::strtod(word.c_str(), nullptr));
  const std::size_t e = word.find_first_of("eE");
  const double exponent = e == std::string::npos ? 0 : std::strtod(&word[e + 1], nullptr);
  return !std::isfinite(value) || std::abs(exponent) > kFar || word.size() > 40;
}

/// The numbers between slashes; empty if one of them is not a number.
std::vector<std::string> partsOf(const std::string& corner) {
  std::vector<std::string> out(1);
  for (const char c : corner) {
    if (c == '/')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

bool isInteger(const std::string& word) {
  static const std::regex kInteger(R"([+-]?\d+)");
  return std::regex_match(word, kInteger);
}

double numberIn(const std::string& word) { return std::strtod(word.c_str(), nullptr); }

bool isCorner(const std::string& word) {
  const std::vector<std::string> parts = partsOf(word);
  if (parts.size() > 3 || !isInteger(parts[0])) return false;
  return std::all_of(parts.begin() + 1, parts.end(),
                     [](const std::string& p) { return p.empty() || isInteger(p); });
}

bool anyWord(const Line& line, bool (*isSo)(const std::string&)) {
  return std::any_of(line.words.begin(), line.words.end(), isSo);
}

bool isOutside(double index, std::size_t before, std::size_t all) {
  return index == 0 || index > static_cast<double>(all) || index < -static_cast<double>(before);
}

bool anyPart(const Line& line, std::size_t part, std::size_t before, std::size_t all) {
  return std::any_of(line.words.begin(), line.words.end(), [&](const std::string& word) {
    const std::vector<std::string> parts = partsOf(word);
    return part < parts.size() && isOutside(numberIn(parts[part]), before, all);
  });
}

enum Kind { kWeRefuse = 1, kTheyRefuse = 2, kOther = 4 };

struct Reason {
  const char* name;
  int kinds;
  bool (*holds)(const Line& line);
};

const Reason kReasons[] = {
    {"we refuse a coordinate that is no number, tinyobj makes it 0", kWeRefuse,
     [](const Line& l) {
       const auto end = l.words.begin() +
                        std::min<std::ptrdiff_t>(3, std::distance(l.words.begin(), l.words.end()));
       return l.is("v") && !std::all_of(l.words.begin(), end, isNumber);
     }},
    {"we refuse a vertex of fewer than 3 coordinates, tinyobj makes them 0", kWeRefuse,
     [](const Line& l) { return l.is("v") && l.words.size() < 3; }},
    {"tinyobj multiplies powers, which overflow", kWeRefuse | kOther,
     [](const Line& l) { return l.isData() && anyWord(l, isFar); }},
    {"tinyobj makes a texcoord that is no number 0, to us it is none", kOther,
     [](const Line& l) {
       return l.is("vt") && (l.words.empty() || !isNumber(l.words[0]) ||
                             (l.words.size() > 1 && !isNumber(l.words[1])));
     }},
    {"a # within a word begins a comment to us", kWeRefuse | kTheyRefuse | kOther,
     [](const Line& l) {
       const std::size_t at = l.all.find('#');
       return at != std::string::npos && at > 0 && l.all[at - 1] != ' ' && l.all[at - 1] != '\t';
     }},
    {"we join lines that end in a backslash", kWeRefuse | kTheyRefuse | kOther,
     [](const Line& l) { return l.all.find('\\') != std::string::npos; }},
    {"we refuse a face corner with anything but whole numbers", kWeRefuse,
     [](const Line& l) {
       return l.is("f") && !std::all_of(l.words.begin(), l.words.end(), isCorner);
     }},
    {"tinyobj refuses an empty or zero texcoord or normal of a corner", kTheyRefuse,
     [](const Line& l) {
       return l.is("f") && std::any_of(l.words.begin(), l.words.end(), [](const std::string& word) {
                const std::vector<std::string> parts = partsOf(word);
                const bool hasNormal = parts.size() > 2;
                const bool isSkipped = hasNormal && parts[1].empty();
                return (parts.size() > 1 && !isSkipped && numberIn(parts[1]) == 0) ||
                       (hasNormal && numberIn(parts[2]) == 0);
              });
     }},
    {"tinyobj takes a comment behind corners for a corner", kTheyRefuse,
     [](const Line& l) {
       return (l.is("f") || l.is("l") || l.is("p")) && l.all.find('#') != std::string::npos;
     }},
    {"we refuse a vertex that is not in the file", kWeRefuse,
     [](const Line& l) { return l.is("f") && anyPart(l, 0, l.vertices, l.allVertices); }},
    {"a texcoord that is not in the file is none to us", kOther,
     [](const Line& l) { return l.is("f") && anyPart(l, 1, l.texcoords, l.allTexcoords); }},
    {"we refuse a face of fewer than 3 corners, tinyobj leaves it out", kWeRefuse,
     [](const Line& l) { return l.is("f") && l.words.size() < 3; }},
    {"tinyobj counts up to 255 corners of a face", kOther,
     [](const Line& l) { return l.is("f") && l.words.size() > 255; }},
    {"tinyobj checks lines and points, which we skip", kTheyRefuse,
     [](const Line& l) { return l.is("l") || l.is("p"); }},
    {"we refuse what Microsoft's library writes for a number that is none", kWeRefuse,
     [](const Line& l) {
       return l.is("v") &&
              (l.all.find("#QNAN") != std::string::npos ||
               l.all.find("#IND") != std::string::npos || l.all.find("#INF") != std::string::npos);
     }},
    {"tinyobj does not know the mark of UTF-8", kTheyRefuse | kOther | kWeRefuse,
     [](const Line& l) { return l.all.substr(0, 3) == "\xEF\xBB\xBF"; }},
};

/// Texts that are not given to tinyobj: they have records of its own, whose numbers it converts
/// unchecked.
bool isOfTinyobjAlone(const std::vector<Line>& lines) {
  return std::any_of(lines.begin(), lines.end(),
                     [](const Line& l) { return l.is("vw") || l.is("t"); });
}

bool isClose(double a, double b) { return std::abs(a - b) <= 1e-13 * std::abs(a) + 1e-300; }

bool hasSameTexcoord(const PolygonMesh& ours, const test::TinyMesh& theirs, std::size_t corner) {
  const std::uint32_t t = ours.faceTexcoords.empty() ? kNoTexcoord : ours.faceTexcoords[corner];
  const int u = theirs.faceTexcoords[corner];
  if (t == kNoTexcoord || u < 0) return t == kNoTexcoord && u < 0;
  const std::size_t at = 2 * static_cast<std::size_t>(u);
  return at + 1 < theirs.texcoords.size() &&
         isClose(ours.texcoords[2 * std::size_t{t}], theirs.texcoords[at]) &&
         isClose(ours.texcoords[2 * std::size_t{t} + 1], theirs.texcoords[at + 1]);
}

bool isSame(const PolygonMesh& ours, const test::TinyMesh& theirs) {
  if (!std::equal(ours.positions.begin(), ours.positions.end(), theirs.positions.begin(),
                  theirs.positions.end(), isClose))
    return false;
  if (ours.faceCount() != theirs.faceSizes.size() ||
      ours.faceVertices.size() != theirs.faceVertices.size())
    return false;
  for (std::size_t f = 0; f < ours.faceCount(); ++f)
    if (ours.faceOffsets[f + 1] - ours.faceOffsets[f] != theirs.faceSizes[f]) return false;
  for (std::size_t c = 0; c < ours.faceVertices.size(); ++c)
    if (theirs.faceVertices[c] < 0 ||
        ours.faceVertices[c] != static_cast<std::uint32_t>(theirs.faceVertices[c]) ||
        !hasSameTexcoord(ours, theirs, c))
      return false;
  return true;
}

/// The kind of difference; 0: none.
int differenceOf(const Result<PolygonMesh>& ours, const test::TinyMesh& theirs) {
  if (!ours.ok() && !theirs.isRead) return 0;
  if (!ours.ok()) return kWeRefuse;
  if (!theirs.isRead) return kTheyRefuse;
  return isSame(ours.value(), theirs) ? 0 : kOther;
}

using Tally = std::map<std::string, int>;

/// Compares both readers on a text, and counts a reason for each difference.
void compare(const std::string& text, Tally& tally) {
  const std::vector<Line> lines = linesOf(text);
  if (isOfTinyobjAlone(lines)) {
    ++tally["not compared: records of tinyobj alone"];
    return;
  }
  const Result<PolygonMesh> ours = readMesh(text, MeshFormat::Obj, "a.obj");
  const int kind = differenceOf(ours, test::readByTinyobj(text));
  if (kind == 0) {
    ++tally["same"];
    return;
  }
  const bool isEmpty = std::none_of(lines.begin(), lines.end(),
                                    [](const Line& l) { return l.is("v") || l.is("f"); });
  if (kind == kWeRefuse && isEmpty) {
    ++tally["we refuse a file without a mesh"];
    return;
  }
  for (const Reason& reason : kReasons)
    if ((reason.kinds & kind) != 0 && std::any_of(lines.begin(), lines.end(), reason.holds)) {
      ++tally[reason.name];
      return;
    }
  INFO(ours.status().message << "\n" << text.substr(0, 2000));
  FAIL("a difference of kind " << kind << " without a reason");
}

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::vector<std::string> kSmall = {
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "# cube\r\no a b\r\nv -1 -1 -1\r\nv 1 -1 -1\r\nv 1 1 -1\r\nv -1 1 -1\r\nvt 0 0\r\nvt 1 0\r\nvt "
    "1 1\r\n"
    "usemtl red\r\nf 1/1 2/2 3/3\r\ns 1\r\nf -4/-3 -2/-1 -1/-2\r\n",
    "mtllib a.mtl\nv 1e-3 .5 +2. 1 0 0\nv 1.5E2 -0.25 7\nv 0.1 0.2 0.3\nv 3 4 5\nvn 0 0 1\nvt 0.25 "
    "0.75\n"
    "vt 0.5\ng x y\nf 1/1/1 2/2/1 3//1 4//1\nf 1//1 2//1 3//1\nl 1 2\np 3\n",
    "v 0 0 0 # first\n\n  v\t1 0 0\nv 0 1 0\nv 1 1 0\nvt 1 0 0\nf 1/1 2/1 4/1 3/1\nf 4 2 1\n",
    "f 1 2 3\nv 0.123456789012345 123456.789 -9.87654e-05\nv 2 2 2\nv 3 1 4\n",
};

const std::vector<std::string> kWords = {"v",           "vt",
                                         "vn",          "f",
                                         "l",           "p",
                                         "g",           "o",
                                         "usemtl",      "\\",
                                         "\\\n",        "#",
                                         "0",           "-1",
                                         "1",           "7",
                                         "99999999999", "1//",
                                         "1/",          "//",
                                         "1/2/3/4",     "1e400",
                                         "1e-400",      "1e",
                                         "nan",         "inf",
                                         "1.#QNAN",     "1,5",
                                         "0x10",        "+",
                                         "-",           ".",
                                         "abc",         "\n",
                                         "\r\n",        "\r",
                                         "\t",          " ",
                                         "vw",          "t",
                                         "1.5x",        "-0",
                                         "00012",       "3.14159265358979312",
                                         "1E5",         "\xEF\xBB\xBF",
                                         "\v"};

}  // namespace

TEST_CASE("OBJ: the files of the corpus are read as tinyobjloader reads them") {
  Tally tally;
  std::size_t files = 0;
  for (const char* folder : {"meshes", "meshes2", "findings"}) {
    const std::filesystem::path path = std::filesystem::path(ABFLAT_SHARED_DIR) / folder;
    if (!std::filesystem::exists(path)) {
      WARN("skipped: " << folder << " is not there");
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (entry.path().extension() != ".obj" ||
          entry.file_size() > test::cases(16u << 20, 1u << 18))
        continue;
      INFO(entry.path().filename().string());
      compare(contentOf(entry.path()), tally);
      ++files;
    }
  }
  INFO(files << " files, " << tally["same"] << " alike");
  for (const auto& [reason, count] : tally)
    if (reason != "same") WARN(count << " times: " << reason);
}

TEST_CASE("OBJ: the comparison with tinyobjloader sees what differs") {
  const test::TinyMesh right = test::readByTinyobj(kSmall[1]);
  const Result<PolygonMesh> mesh = readMesh(kSmall[1], MeshFormat::Obj, "a.obj");
  CHECK(differenceOf(mesh, right) == 0);
  for (int i = 0; i < 4; ++i) {
    test::TinyMesh wrong = right;
    if (i == 0) wrong.positions[4] += 1e-9;
    if (i == 1) std::swap(wrong.faceVertices[0], wrong.faceVertices[1]);
    if (i == 2) wrong.faceTexcoords[2] = -1;
    if (i == 3) wrong.isRead = false;
    CHECK(differenceOf(mesh, wrong) != 0);
  }
}

TEST_CASE("OBJ: damaged files are read as tinyobjloader reads them, or for a reason not") {
  test::Mutator mutate(1, kWords);
  Tally tally;
  for (const std::string& text : kSmall) compare(text, tally);
  CHECK(tally["same"] >= 3);
  for (int i = 0; i < test::cases(10000, 1000); ++i)
    compare(mutate(kSmall[mutate.below(kSmall.size())]), tally);
  // Enough of both outcomes to make the comparison meaningful.
  CHECK(tally["same"] > test::cases(1500, 150));
  CHECK(tally.size() > 8);
}
