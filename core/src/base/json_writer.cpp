#include "base/json_writer.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "base/number_text.h"

namespace abflat {
namespace {

struct Sequence {
  std::size_t length;
  bool isValid;
};

/// The UTF-8 sequence at the beginning of `text`. For an invalid one, as many bytes as a valid one
/// might begin with, but at least one.
Sequence sequenceOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {1, true};
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (lead < 0xC2 || lead > 0xF4) return {1, false};
  // Not longer than needed, not half of a surrogate pair, and not beyond U+10FFFF.
  unsigned low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  unsigned high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  for (std::size_t i = 1; i < length; ++i) {
    if (i == text.size() || byte(i) < low || byte(i) > high) return {i, false};
    low = 0x80;
    high = 0xBF;
  }
  return {length, true};
}

void appendEscaped(char c, std::string& out) {
  constexpr std::string_view kPlain = "\"\\\b\f\n\r\t", kNames = "\"\\bfnrt",
                             kHex = "0123456789abcdef";
  const std::size_t at = kPlain.find(c);
  out += '\\';
  if (at != std::string_view::npos) {
    out += kNames[at];
    return;
  }
  out += "u00";
  out += kHex[static_cast<unsigned char>(c) >> 4];
  out += kHex[c & 15];
}

void appendText(std::string_view text, std::string& out) {
  out += '"';
  while (!text.empty()) {
    const char c = text[0];
    const auto [length, isValid] = sequenceOf(text);
    if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\')
      appendEscaped(c, out);
    else
      out += isValid ? text.substr(0, length) : "\xEF\xBF\xBD";
    text.remove_prefix(length);
  }
  out += '"';
}

}  // namespace

void JsonWriter::startLine() {
  text_ += '\n';
  text_.append(2 * open_.size(), ' ');
}

void JsonWriter::put(const char* name, std::string_view value) {
  if (!open_.empty()) {
    if (!isEmpty_) text_ += ',';
    startLine();
  }
  isEmpty_ = false;
  if (name) {
    text_ += '"';
    text_ += name;
    text_ += "\": ";
  }
  text_ += value;
}

void JsonWriter::begin(const char* name, char bracket) {
  put(name, std::string_view(&bracket, 1));
  open_ += bracket;
  isEmpty_ = true;
}

void JsonWriter::end() {
  const char bracket = open_.back();
  open_.pop_back();
  if (!isEmpty_) startLine();
  text_ += bracket == '{' ? '}' : ']';
  isEmpty_ = false;
}

void JsonWriter::field(const char* name, double value) {
  if (!std::isfinite(value)) return null(name);
  char out[kMostDoubleChars];
  put(name, {out, static_cast<std::size_t>(writeReal(out, value) - out)});
}

void JsonWriter::field(const char* name, bool value) { put(name, value ? "true" : "false"); }

void JsonWriter::integer(const char* name, std::int64_t value) {
  char out[20];
  put(name, {out, static_cast<std::size_t>(std::to_chars(out, out + sizeof out, value).ptr - out)});
}

void JsonWriter::field(const char* name, std::string_view text) {
  put(name, {});
  appendText(text, text_);
}

void JsonWriter::field(const char* name, const std::vector<std::string>& texts) {
  array(name);
  for (const std::string& text : texts) field(nullptr, text);
  end();
}

void JsonWriter::field(const char* name, const std::vector<std::uint32_t>& values) {
  array(name);
  for (const std::uint32_t value : values) integer(nullptr, value);
  end();
}

void JsonWriter::field(const char* name, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  array(name);
  for (const auto& pair : pairs) {
    array();
    for (const std::uint32_t value : pair) integer(nullptr, value);
    end();
  }
  end();
}

std::string JsonWriter::take() {
  while (!open_.empty()) end();
  return std::move(text_) + '\n';
}

}  // namespace abflat
