#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace abflat {

/// Writes a JSON object as text while it is being told the fields: one field per line, indented by
/// two spaces. Browsers download it, so it is a few small functions rather than a tree of values.
class JsonWriter {
 public:
  JsonWriter() { begin(nullptr, '{'); }

  /// Writes null if the value is not finite.
  void field(const char* name, double value);
  void field(const char* name, bool value);
  /// Whatever is not UTF-8 becomes U+FFFD, since paths and quoted input need not be UTF-8.
  void field(const char* name, std::string_view text);
  void field(const char* name, const char* text) { field(name, std::string_view(text)); }
  void field(const char* name, const std::string& text) { field(name, std::string_view(text)); }
  void field(const char* name, const std::vector<std::string>& texts);
  void field(const char* name, const std::vector<std::uint32_t>& values);
  void field(const char* name, const std::vector<std::array<std::uint32_t, 2>>& pairs);
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  void field(const char* name, Integer value) {
    integer(name, static_cast<std::int64_t>(value));
  }
  void null(const char* name) { put(name, "null"); }

  /// What follows goes inside, until end(). Elements of arrays have no name.
  void object(const char* name = nullptr) { begin(name, '{'); }
  void array(const char* name = nullptr) { begin(name, '['); }
  void end();

  /// Ends the object and its line.
  std::string take();

 private:
  void begin(const char* name, char bracket);
  void integer(const char* name, std::int64_t value);
  void put(const char* name, std::string_view value);
  void startLine();

  std::string text_;
  std::string open_;  ///< brackets still to be closed
  bool isEmpty_ = true;
};

}  // namespace abflat
