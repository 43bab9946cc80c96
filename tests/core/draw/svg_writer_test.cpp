#include "draw/svg_writer.h"

#include <cmath>

#include "catch.h"

using namespace abflat;

TEST_CASE("SVG numbers have no locale, no exponent and no needless digits", "[draw]") {
  CHECK(svgNumber(0) == "0");
  CHECK(svgNumber(-0.001) == "0");
  CHECK(svgNumber(0.5) == "0.5");
  CHECK(svgNumber(-0.05) == "-0.05");
  CHECK(svgNumber(12.345) == "12.35");
  CHECK(svgNumber(1200000) == "1200000");
  CHECK(svgNumber(NAN) == "0");
  CHECK(svgNumber(INFINITY) == "0");
}

TEST_CASE("XML text holds neither markup nor what XML forbids", "[draw]") {
  CHECK(xmlText("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
  CHECK(xmlText("α² ≤ 𝛼") == "α² ≤ 𝛼");
  const std::string replacement = "\xEF\xBF\xBD";
  for (const std::string& bad : {std::string("\x01"), std::string("\0", 1), std::string("\xFF"),
                                 std::string("\xC3"), std::string("\xC0\xAF").substr(0, 1)})
    CHECK(xmlText("a" + bad + "b") == "a" + replacement + "b");
  // A surrogate: three bytes, none of which represents a character.
  CHECK(xmlText("\xED\xA0\x80") == replacement + replacement + replacement);
}

TEST_CASE("elements are nested and escaped", "[draw]") {
  SvgWriter out;
  out.open("g", {{"id", "a\"b"}});
  out.add("line", {{"x1", 1}, {"x2", 2.5}});
  out.text(1, 2, "x < y", {{"fill", "red"}});
  out.close("g");
  CHECK(out.take() ==
        "<g id=\"a&quot;b\">\n<line x1=\"1\" x2=\"2.5\"/>\n"
        "<text fill=\"red\" x=\"1\" y=\"2\">x &lt; y</text>\n</g>\n");
}

namespace {

/// The points on the path, as absolute coordinates.
std::vector<std::pair<long long, long long>> pointsOf(const std::string& data) {
  std::vector<std::pair<long long, long long>> out;
  long long x = 0, y = 0, startX = 0, startY = 0;
  char command = 0;
  for (const char* at = data.c_str(); *at != '\0';) {
    if (*at == 'z') {
      x = startX, y = startY, ++at;
      continue;
    }
    const bool isMove = *at == 'm';
    if (*at == 'm' || *at == 'l') command = *at++;
    REQUIRE((command == 'm' || command == 'l'));
    char* end = nullptr;
    x += std::strtoll(at, &end, 10);
    y += std::strtoll(end, &end, 10);
    if (isMove) startX = x, startY = y;
    at = end;
    out.emplace_back(x, y);
  }
  return out;
}

}  // namespace

TEST_CASE("relative path data leads to the rounded points without drift", "[draw]") {
  SvgPath path;
  std::vector<std::pair<long long, long long>> wanted;
  for (int i = 0; i < 1000; ++i) {
    const double x = 1000 * std::sin(0.7 * i), y = 1000 * std::cos(1.3 * i);
    if (i % 7 == 6) path.close();
    path.add(i % 7 == 0, x, y);
    wanted.emplace_back(std::llround(x), std::llround(y));
  }
  CHECK(pointsOf(path.data()) == wanted);
}
