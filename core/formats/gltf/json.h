#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace abflat::gltf {

/// A value of a JSON text; members of an object keep their order. nlohmann/json reads and writes
/// the text, but its own values need memory in order to be freed, and end the program if there is
/// none.
class Json {
 public:
  struct Member;
  using Items = std::vector<Json>;
  using Members = std::vector<Member>;

  Json();  ///< null
  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();
  Json(const char* text);
  Json(std::string text);
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  Json(T value);
  template <std::size_t N>
  Json(const std::array<double, N>& numbers);

  static Json array();
  static Json object();

  bool isObject() const { return std::holds_alternative<Members>(value_); }
  bool isArray() const { return std::holds_alternative<Items>(value_); }
  bool isInteger() const {
    return std::holds_alternative<std::uint64_t>(value_) ||
           std::holds_alternative<std::int64_t>(value_);
  }
  bool isNumber() const { return isInteger() || std::holds_alternative<double>(value_); }

  /// What the value is, or nothing if it is something else.
  const bool* flag() const { return std::get_if<bool>(&value_); }
  const std::string* text() const { return std::get_if<std::string>(&value_); }
  std::optional<double> number() const;
  /// A number that is written without sign, point or exponent.
  std::optional<std::uint64_t> wholeNumber() const;

  /// Of an array; empty for other values.
  const Items& items() const;
  /// Makes the value an array if it is none.
  Items& items();
  /// Of an object; empty for other values.
  const Members& members() const;

  /// A member, or null.
  const Json* find(std::string_view key) const;
  Json* find(std::string_view key);
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// A member that exists.
  const Json& operator[](std::string_view key) const { return *find(key); }
  /// A member, which is added if there is none; makes null an object.
  Json& operator[](std::string_view key);
  void erase(std::string_view key);

  const Json& operator[](std::size_t i) const { return items()[i]; }
  Json& operator[](std::size_t i) { return items()[i]; }

  /// A number as it is written.
  std::string numberText() const;
  /// Lines indented by two spaces, or all in one line. What is not UTF-8 is replaced.
  std::string dump(bool isIndented) const;

 private:
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string,
                             Items, Members>;

  Value value_;
};

struct Json::Member {
  std::string key;
  Json value;
};

template <class T, class>
Json::Json(T value) {
  if constexpr (std::is_same_v<T, bool>)
    value_ = value;
  else if constexpr (std::is_floating_point_v<T>)
    value_ = double{value};
  else if constexpr (std::is_signed_v<T>)
    value_ = std::int64_t{value};
  else
    value_ = std::uint64_t{value};
}

template <std::size_t N>
Json::Json(const std::array<double, N>& numbers) : value_(Items(numbers.begin(), numbers.end())) {}

/// Nothing if the text is not JSON.
std::optional<Json> parsedJson(std::string_view text);

}  // namespace abflat::gltf
