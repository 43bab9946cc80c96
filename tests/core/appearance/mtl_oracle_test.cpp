// Compares MTL files, damaged ones included, with what tinyobjloader reads. Where the two readers
// differ, the text must show one of the reasons listed here: what we would have to correct in its
// result.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "appearance/mtl.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/mutated_text.h"
#include "support/tinyobj.h"

using namespace abflat;

namespace {

/// Bit flags.
enum Field {
  kNames = 1,
  kDiffuse = 2,
  kEmission = 4,
  kOpacity = 8,
  kMetal = 16,
  kRough = 32,
  kMap = 64
};

struct Line {
  std::string all, keyword;
  std::vector<std::string> words;

  bool is(const char* name) const { return keyword == name; }
};

std::vector<Line> linesOf(const std::string& text) {
  std::vector<Line> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    Line line;
    line.all = text.substr(at, end - at);
    for (const std::string& piece : test::piecesOf(line.all))
      if (piece[0] != ' ' && piece[0] != '\t') line.words.push_back(piece);
    if (!line.words.empty()) {
      line.keyword = line.words.front();
      line.words.erase(line.words.begin());
    }
    out.push_back(line);
    at = end + 1;
  }
  return out;
}

bool isNumber(const std::string& word) {
  static const std::regex kNumber(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
  return std::regex_match(word, kNumber) && std::isfinite(std::strtod(word.c_str(), nullptr));
}

bool isShare(const std::string& word) {
  const double value = std::strtod(word.c_str(), nullptr);
  return isNumber(word) && value >= 0 && value <= 1;
}

/// How many of the first words, at most `most`, satisfy isSo.
std::size_t leading(const Line& line, bool (*isSo)(const std::string&), std::size_t most) {
  std::size_t n = 0;
  while (n < std::min(most, line.words.size()) && isSo(line.words[n])) ++n;
  return n;
}

int colourOf(const Line& line) { return line.is("Kd") ? kDiffuse : line.is("Ke") ? kEmission : 0; }

int shareOf(const Line& line) {
  if (line.is("d") || line.is("Tr")) return kOpacity;
  return line.is("Pm") ? kMetal : line.is("Pr") ? kRough : 0;
}

/// The fields in which such a line makes the two readers differ.
struct Reason {
  const char* name;
  int (*fields)(const Line& line);
};

const Reason kReasons[] = {
    {"one number of a colour is a grey to us, red to tinyobj",
     [](const Line& l) { return leading(l, isNumber, 3) == 1 ? colourOf(l) : 0; }},
    {"a colour or share that is damaged is left out by us, 0 to tinyobj",
     [](const Line& l) {
       if (leading(l, isNumber, 3) < 3 && colourOf(l) != 0) return colourOf(l);
       return leading(l, isNumber, 1) < 1 ? shareOf(l) : 0;
     }},
    {"we keep values within 0 and 1",
     [](const Line& l) {
       const bool isInside = leading(l, isShare, 3) == leading(l, isNumber, 3);
       return isInside ? 0 : colourOf(l) | shareOf(l);
     }},
    {"tinyobj takes an option that it does not know for the name of the image, and the name for a "
     "number of an option",
     [](const Line& l) {
       return l.is("map_Kd") && (l.words.empty() || l.words[0][0] == '-') ? +kMap : 0;
     }},
    {"blanks around a name are part of it to tinyobj, and a name may not be missing",
     [](const Line& l) {
       const bool isPlain = l.words.size() > 0 && l.all.rfind("newmtl " + l.words[0], 0) == 0;
       return l.is("newmtl") && !isPlain ? ~0 : 0;
     }},
    {"tinyobj does not know the mark of UTF-8",
     [](const Line& l) { return l.all.rfind("\xEF\xBB\xBF", 0) == 0 ? ~0 : 0; }},
};

/// The fields that differ between one of our materials and one of tinyobj's.
int differences(const MtlMaterial& ours, const test::TinyMaterial& theirs) {
  const auto differs = [](double a, double b) { return !(std::abs(a - b) <= 1e-12); };
  int out = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (differs(ours.diffuse[d], theirs.diffuse[d])) out |= kDiffuse;
    if (differs(ours.emission[d], theirs.emission[d])) out |= kEmission;
  }
  if (differs(ours.opacity, theirs.opacity)) out |= kOpacity;
  if (differs(ours.metallic, theirs.metallic)) out |= kMetal;
  if (differs(ours.roughness, theirs.roughness)) out |= kRough;
  if (ours.diffuseMap != theirs.diffuseMap) out |= kMap;
  return out;
}

/// The fields in which the readers differ in any material.
int differencesOf(const std::string& text) {
  MtlMaterials ours;
  readMtl(text, ours);
  std::vector<test::TinyMaterial> theirs = test::materialsByTinyobj(text);
  // Without any material it makes one that is empty.
  if (ours.empty() && theirs.size() == 1 && theirs[0].name.empty()) return 0;
  int out = ours.size() == theirs.size() ? 0 : +kNames;
  for (const test::TinyMaterial& material : theirs) {
    const auto found = ours.find(material.name);
    out |= found == ours.end() ? +kNames : differences(found->second, material);
  }
  return out;
}

using Tally = std::map<std::string, int>;

/// Gives each block these lines, so that the different defaults of the two readers (white and
/// rough, black and smooth) do not count: they are the first thing that would have to be corrected.
std::string withDefaults(const std::string& text) {
  std::string out;
  for (const Line& line : linesOf(text)) {
    out += line.all + "\n";
    if (line.is("newmtl")) out += "Kd 1 1 1\nPr 1\n";
  }
  return out;
}

void compare(const std::string& mutated, Tally& tally) {
  const std::string text = withDefaults(mutated);
  int left = differencesOf(text);
  if (left == 0) {
    ++tally["same"];
    return;
  }
  for (const Reason& reason : kReasons)
    for (const Line& line : linesOf(text))
      if (const int fields = reason.fields(line); (fields & left) != 0) {
        ++tally[reason.name];
        left &= ~fields;
      }
  INFO(text);
  CHECK(left == 0);
}

const std::vector<std::string> kSmall = {
    "newmtl red\nKa 0 0 0\nKd 0.8 0.1 0\nKs 1 1 1\nNs 250\nd 1\nillum 2\n",
    "# Blender\nnewmtl my wood\r\nKd 0.64 0.640000 .5\r\nKe 0.1 0 0\r\nTr 0.25\r\nmap_Kd the oak "
    "2.png\r\n"
    "newmtl glass\r\nd 0.5\r\nTr 0.1\r\nPm 0.3\r\nPr 0.6\r\nmap_Kd -s 1 1 1 -clamp on b.png\r\n",
    "newmtl a\nKd 0.5 0.25 0.125\nnewmtl b\nd 0.75\nnewmtl a\nKd 0 0 1\nPr 0.5\n",
};

const std::vector<std::string> kWords = {
    "newmtl",   "Kd", "Ke", "d",    "Tr", "Pm",  "Pr", "map_Kd", "-s",  "-o",    "-mm",
    "-clamp",   "on", "-",  "0",    "1",  "0.5", "2",  "-1",     "nan", "1e400", "0x1",
    "spectral", "#",  "\n", "\r\n", "\r", " ",   "\t", "a.png",  "xyz", "1,5",   "1e-3"};

}  // namespace

TEST_CASE("MTL: damaged files are read as tinyobjloader reads them, or for a reason not",
          "[appearance]") {
  test::Mutator mutate(2, kWords);
  Tally tally;
  for (const std::string& text : kSmall) compare(text, tally);
  for (int i = 0; i < test::cases(5000, 500); ++i)
    compare(mutate(kSmall[mutate.below(kSmall.size())]), tally);
  CHECK(tally.size() > 4);
  CHECK(tally["same"] > test::cases(1000, 100));
}
