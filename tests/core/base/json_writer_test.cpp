#include "base/json_writer.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "abflat/flatten.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;
using Json = nlohmann::ordered_json;

namespace {

/// The text in the library's format.
std::string text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string written(std::string_view value) {
  JsonWriter json;
  json.field("value", value);
  return json.take();
}

/// Bytes, favouring those that begin, continue and break UTF-8 sequences.
std::string randomBytes(std::mt19937& random) {
  const std::string kBytes =
      "a\"\\\n\x01\x1F\x7F\x80\x8F\x90\x9F\xA0\xBF\xC0\xC2\xDF\xE0\xE1\xED\xEF\xF0\xF1\xF4\xF5\xFF";
  std::string out(random() % 12, ' ');
  for (char& c : out)
    c = random() % 4 ? kBytes[random() % kBytes.size()] : static_cast<char>(random());
  return out;
}

}  // namespace

TEST_CASE("fields, objects and arrays are written as a library of JSON writes them") {
  JsonWriter json;
  json.field("real", 0.1);
  json.field("whole", 3.0);
  json.field("tiny", -5e-324);
  json.field("infinite", std::numeric_limits<double>::infinity());
  json.field("count", std::size_t{7});
  json.field("negative", -2);
  json.field("yes", true);
  json.null("nothing");
  json.field("texts", std::vector<std::string>{"one", "two"});
  json.field("none", std::vector<std::string>{});
  json.object("inner");
  json.array("pairs");
  for (int i = 0; i < 2; ++i) {
    json.array();
    json.field(nullptr, i);
    json.end();
  }
  json.end();
  json.object("empty");
  json.end();
  json.end();
  json.field("last", "text");
  CHECK(json.take() == text({{"real", 0.1},
                             {"whole", 3.0},
                             {"tiny", -5e-324},
                             {"infinite", nullptr},
                             {"count", 7},
                             {"negative", -2},
                             {"yes", true},
                             {"nothing", nullptr},
                             {"texts", {"one", "two"}},
                             {"none", Json::array()},
                             {"inner", {{"pairs", {{0}, {1}}}, {"empty", Json::object()}}},
                             {"last", "text"}}));
  CHECK(JsonWriter().take() == text(Json::object()));
}

TEST_CASE(
    "texts are escaped, and bytes that are not UTF-8 replaced, as a library of JSON does it") {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::string value = randomBytes(random);
    INFO(i);
    REQUIRE(written(value) == text({{"value", value}}));
  }
}

TEST_CASE("reports come back from a library of JSON byte for byte") {
  const PolygonMesh mesh = bumpyGrid(6, 6, 0.3, 1);
  FlattenOptions options;
  options.balance = 1;
  const std::string flat = reportJson(flatten(mesh, options).value().report);
  CHECK(text(Json::parse(flat)) == flat);
  const std::string atlas = unwrapReportJson(unwrap(mesh, UnwrapOptions{}).value().report);
  CHECK(text(Json::parse(atlas)) == atlas);
}
