#include <memory>
#include <optional>
#include <string>

#include "abflat/status.h"
#include "catch.h"

namespace abflat {
namespace {

Result<std::string> half(int n) {
  if (n % 2 != 0) return Status{StatusCode::InvalidOption, "odd"};
  return std::to_string(n / 2);
}

TEST_CASE("a value that is not there cannot be taken") {
  const Result<std::string> none = half(3);
  CHECK_FALSE(none.ok());
  CHECK(none.status().code == StatusCode::InvalidOption);
  CHECK_THROWS_AS(none.value(), std::bad_optional_access);
  CHECK_THROWS_AS(half(5).value(), std::bad_optional_access);
  CHECK(half(5).status().message == "odd");
  const Result<std::string> four = half(8);
  CHECK(four.ok());
  CHECK(four.status().ok());
  CHECK(four.value() == "4");
}

TEST_CASE("a value can be moved out of a result") {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(7);
  const std::unique_ptr<int> taken = std::move(made).value();
  REQUIRE(taken);
  CHECK(*taken == 7);
}

}  // namespace
}  // namespace abflat
