#include <array>
#include <cstring>

#include "abflat/io.h"
#include "catch.h"

using namespace abflat;

// What exporters write beyond what the formats allow. It is either accepted the way other readers
// accept it, or rejected with a reason.

namespace {

struct Habit {
  const char* name;
  std::string text;
  const char* complaint = "";  ///< part of the message; empty: one triangle is read
};

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", kFace = "f 1 2 3\n";
const std::string kThreePoints = "0 0 0\n1 0 0\n0 1 0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string utf16(const std::string& text, bool isBig, bool hasMark) {
  std::string out = !hasMark ? "" : isBig ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) out += isBig ? std::string{'\0', c} : std::string{c, '\0'};
  return out;
}

void check(const std::vector<Habit>& habits, MeshFormat format, const std::string& ending) {
  for (const Habit& habit : habits) {
    INFO(habit.name);
    const Result<PolygonMesh> r = readMesh(habit.text, format, "a." + ending);
    INFO(r.status().message);
    CHECK(r.ok() == (*habit.complaint == 0));
    if (*habit.complaint != 0) {
      CHECK(r.status().code == StatusCode::ParseError);
      CHECK(r.status().message.find(habit.complaint) != std::string::npos);
      continue;
    }
    REQUIRE(r.value().faceCount() == 1);
    CHECK(validateArrays(r.value()).ok());
    const std::array<double, 9> wanted{0, 0, 0, 1, 0, 0, 0, 1, 0};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        CHECK(r.value().positions[3 * r.value().faceVertices[c] + d] == wanted[3 * c + d]);
  }
}

std::string binaryFacet(const std::string& header, const std::string& behind = "") {
  std::string out = header;
  out.resize(80, ' ');
  const float facet[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  out += std::string("\1\0\0\0", 4);
  out.append(reinterpret_cast<const char*>(facet), sizeof facet);
  return out + std::string(2, '\0') + behind;
}

std::string plyText(const std::string& list, const std::string& name = "vertex_indices") {
  return "ply\nformat ascii 1.0\ncomment c\nobj_info i\nelement vertex 3\nproperty float x\n"
         "property float y\nproperty float z\nelement face 1\nproperty list " +
         list + " " + name + "\nend_header\n" + kThreePoints + "3 0 1 2\n";
}

}  // namespace

TEST_CASE("OBJ: habits of exporters", "[habits]") {
  const std::string plain = kVertices + kFace, uv = kVertices + "vt 0.5 0.5 0\nvn 0 0 1\n";
  check(
      {
          {"v//", kVertices + "f 1// 2// 3//\n"},
          {"v/", kVertices + "f 1/ 2/ 3/\n"},
          {"v/vt/", uv + "f 1/1/ 2/1/ 3/1/\n"},
          {"mixed corners", uv + "f 1/1/1 2// 3//1 # c\n"},
          {"counted back", kVertices + "f -3 -2 -1\n"},
          {"faces before vertices", kFace + kVertices},
          {"tabs", replaced(plain, " ", "\t")},
          {"blanks everywhere", replaced(replaced(plain, "\n", "   \n  "), " ", "  ")},
          {"CR", replaced(plain, "\n", "\r")},
          {"CR CR LF", replaced(plain, "\n", "\r\r\n")},
          {"LF CR", replaced(plain, "\n", "\n\r")},
          {"no last line end", kVertices + "f 1 2 3"},
          {"NUL, ^Z or a form feed on a line of its own",
           plain + std::string("\0\0\n\x1a\n\f\n", 7)},
          {"mark of UTF-8", "\xEF\xBB\xBF" + plain},
          {"weights", replaced(kVertices, "0\n", "0 1.0\n") + kFace},
          {"colours", replaced(kVertices, "\n", " .1 .2 .3 1\n") + kFace},
          {"one texcoord coordinate", kVertices + "vt 0.5\nf 1/1 2/1 3/1\n"},
          {"three texcoord coordinates", kVertices + "vt 0 0 0\nf 1/1 2/1 3/1\n"},
          {"lines and points", kVertices + "l 1 2 3\np 1 2\n" + kFace + "l 1/1 2/2\n"},
          {"curves and surfaces", kVertices +
                                      "cstype bspline\ndeg 3\ncurv 0 1 1 2 3\nparm u 0 1\nend\n"
                                      "surf 0 1 0 1 1 2 3\ncall x.obj\ncsh -ls\nctech cparm 1\n" +
                                      kFace},
          {"joined lines", replaced(kVertices, "0 0\n", "0 \\\n0\n") + "f 1 \\\r\n 2 \\\n 3\n"},
          {"signs and points", "v +0 -0 .0\nv 1. 0e0 0E+5\nv 0 +1.0e-0 0.\nf +1 2 3\n"},
          {"comments", "// x\n#\n" + kVertices + "f 1 2 3#c\n"},
          {"not a number of Microsoft", "v 1.#QNAN 0 0\n" + plain, "a.obj:1: a coordinate is not"},
          {"another", "v 0 -1.#IND00 0\n" + plain, "not finite: '#IND00"},
          {"nan", "v nan 0 0\n" + plain, "'nan' is not finite"},
          {"too large", "v 1e400 0 0\n" + plain, "'1e400' is not finite"},
          {"decimal comma", "v 1,5 0 0\n" + plain, "'1,5' is not a number. Use a decimal point"},
          {"Fortran", "v 1.5D0 0 0\n" + plain, "'1.5D0' is not a number"},
          {"two coordinates", "v 0 0\n" + plain, "has 2 coordinates instead of 3"},
          {"one coordinate", "v 0\n" + plain, "has 1 coordinate instead of 3"},
          {"two corners", kVertices + "f 1 2\n" + kFace, "a.obj:4: the face has 2 corners"},
          {"too many slashes", kVertices + "f 1/// 2 3\n", "is not a face corner"},
          {"semicolon", kVertices + "f 1 2 3;\n", "'3;' is not a face corner"},
          {"counted from 0", kVertices + "f 0 1 2\n", "indices start at 1"},
          {"UTF-16", utf16(plain, false, true), "UTF-16. Save it as UTF-8"},
          {"UTF-16, big", utf16(plain, true, true), "UTF-16. Save it as UTF-8"},
          {"UTF-16 without a mark", utf16(plain, false, false), "UTF-16. Save it as UTF-8"},
          {"nothing", "mtllib a.mtl\n", "contains no mesh (no v or f lines)"},
      },
      MeshFormat::Obj, "obj");
}

TEST_CASE("OBJ: slashes with nothing behind them are not written again", "[habits]") {
  const std::string source =
      kVertices + "vn 0 0 1\nf 1// 2/ 3/4/\nf 1/2/1 2//1 3 # c\nf 3/4/ 2// 1/ # c\n";
  const Result<PolygonMesh> mesh = readMesh(source, MeshFormat::Obj, "a.obj");
  REQUIRE(mesh.ok());
  const std::string text =
      writeObj(mesh.value(), {0, 0, 1, 0, 0, 1}, {0, 1, 2, 0, 1, 2, 2, 1, 0}, source);
  CHECK(text.find("f 1/1 2/2 3/3\nf 1/1/1 2/2/1 3/3 # c\nf 3/3 2/2 1/1 # c\n") !=
        std::string::npos);
}

TEST_CASE("OFF: habits of exporters", "[habits]") {
  const std::string body = kThreePoints + "3 0 1 2\n";
  check(
      {
          {"name and counts in one word", "OFF3 1 0\n" + body},
          {"name left out", "3 1 0\n" + body},
          {"two counts", "OFF\n3 1\n" + body},
          {"comments", "# a\nOFF # b\n# c\n3 1 0 # d\n\n" + body + "# e\n"},
          {"normals", "NOFF\n3 1 0\n" + replaced(kThreePoints, "\n", " 0 0 1\n") + "3 0 1 2\n"},
          {"colours",
           "COFF\n3 1 0\n" + replaced(kThreePoints, "\n", " 9 9 9 9\n") + "3 0 1 2 9 9 9\n"},
          {"CR", replaced("OFF\n3 1 0\n" + body, "\n", "\r")},
          {"NUL at the end", "OFF\n3 1 0\n" + body + std::string(2, '\0')},
          {"mark of UTF-8", "\xEF\xBB\xBFOFF\n3 1 0\n" + body},
          {"binary without anything", "OFF BINARY\n", "ends before the vertex and face counts"},
          {"four coordinates", "4OFF\n3 1 0\n" + body, "not an OFF file: it begins with '4OFF'"},
          {"two corners", "OFF\n3 2 0\n" + kThreePoints + "2 0 1\n3 0 1 2\n", "2 corners"},
          {"UTF-16", utf16("OFF\n3 1 0\n" + body, false, true), "UTF-16. Save it as UTF-8"},
      },
      MeshFormat::Off, "off");
}

TEST_CASE("STL: habits of exporters", "[habits]") {
  const std::string facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
      " endloop\nendfacet\n";
  const std::string text = "solid a\n" + facet + "endsolid a\n";
  std::string upper = text;
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  check(
      {
          {"binary that begins with solid", binaryFacet("solid made of bits")},
          {"binary that begins with a mark of UTF-16", binaryFacet("\xFF\xFE")},
          {"binary whose header is full of NUL", binaryFacet(std::string(80, '\0'))},
          {"upper case", upper},
          {"mixed case", replaced(replaced(text, "solid", "Solid"), "vertex", "Vertex")},
          {"several solids", "solid b\nendsolid b\n" + text},
          {"CR", replaced(text, "\n", "\r")},
          {"no normal", replaced(text, "facet normal 0 0 1", "facet")},
          {"normal that is no number", replaced(text, "0 0 1\n o", "nan nan nan\n o")},
          {"mark of UTF-8", "\xEF\xBB\xBF" + text},
          {"bytes behind the last facet", binaryFacet("", "ab"), "but the file has 136"},
          {"cut off", "solid a\n" + facet, "ends before 'endsolid'"},
          {"quads", replaced(text, " endloop", "  vertex 1 1 0\n endloop"), "expected 'endloop'"},
          {"UTF-16", utf16(text, false, true), "UTF-16. Save it as UTF-8"},
      },
      MeshFormat::Stl, "stl");
}

TEST_CASE("PLY: habits of exporters", "[habits]") {
  check(
      {
          {"vertex_index", plyText("uchar int", "vertex_index")},
          {"CR LF", replaced(plyText("uchar int"), "\n", "\r\n")},
          {"CR", replaced(plyText("uchar int"), "\n", "\r")},
          {"sized types", replaced(plyText("uint8 int32"), "float", "float32")},
          {"numbers of other types", replaced(plyText("int float"), "float", "double")},
          {"mark of UTF-8", "\xEF\xBB\xBF" + plyText("uchar int")},
          {"blank lines", replaced(plyText("uchar int"), "comment c", "\ncomment c")},
          {"long integers", plyText("uchar uint64"), "'uint64' is not a PLY type"},
          {"another name", plyText("uchar int", "corners"), "no list property 'vertex_indices'"},
          {"UTF-16", utf16(plyText("uchar int"), true, true), "UTF-16. Save it as UTF-8"},
      },
      MeshFormat::Ply, "ply");
}
