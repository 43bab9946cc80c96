#include "draw/svg_writer.h"

#include <cmath>
#include <cstdint>

namespace abflat {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Bytes of the UTF-8 character at the front if XML may hold it; 0 if there is none.
std::size_t xmlCharacterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const std::uint8_t next = byte(1);
  const bool isOverlong = (lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90);
  const bool isSurrogate = lead == 0xED && next >= 0xA0;
  const bool isTooLarge = lead == 0xF4 && next >= 0x90;
  const bool isNoncharacter = lead == 0xEF && next == 0xBF && byte(2) >= 0xBE;
  return isOverlong || isSurrogate || isTooLarge || isNoncharacter ? 0 : length;
}

/// 0 for values that no picture can show.
long long rounded(double value) { return std::abs(value) < 1e12 ? std::llround(value) : 0; }

}  // namespace

std::string svgNumber(double value) {
  if (!std::isfinite(value) || std::abs(value) > 1e12) return "0";
  const long long hundredths = std::llround(value * 100);
  std::string digits = std::to_string(std::llabs(hundredths));
  while (digits.size() < 3) digits.insert(digits.begin(), '0');
  std::string fraction = digits.substr(digits.size() - 2);
  while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
  const std::string whole = digits.substr(0, digits.size() - 2);
  return (hundredths < 0 ? "-" : "") + whole + (fraction.empty() ? "" : "." + fraction);
}

std::string xmlText(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = xmlCharacterLength(text);
    if (length == 0)
      out += kReplacement;
    else if (text[0] == '&')
      out += "&amp;";
    else if (text[0] == '<')
      out += "&lt;";
    else if (text[0] == '>')
      out += "&gt;";
    else if (text[0] == '"')
      out += "&quot;";
    else
      out += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

void SvgWriter::start(std::string_view element, SvgAttributes attributes) {
  out_ += '<';
  out_ += element;
  for (const SvgAttribute& a : attributes) {
    out_ += ' ';
    out_ += a.name;
    out_ += "=\"" + xmlText(a.value) + '"';
  }
}

void SvgWriter::open(std::string_view element, SvgAttributes attributes) {
  start(element, attributes);
  out_ += ">\n";
}

void SvgWriter::close(std::string_view element) {
  out_ += "</";
  out_ += element;
  out_ += ">\n";
}

void SvgWriter::add(std::string_view element, SvgAttributes attributes) {
  start(element, attributes);
  out_ += "/>\n";
}

void SvgWriter::text(double x, double y, std::string_view content, SvgAttributes attributes) {
  start("text", attributes);
  out_ +=
      " x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\">" + xmlText(content) + "</text>\n";
}

void SvgPath::go(char command, double x, double y) {
  const long long toX = rounded(x), toY = rounded(y);
  const long long dx = toX - x_, dy = toY - y_;
  if (command == 'l' && dx == 0 && dy == 0) return;
  const bool isRepeated = command == last_;
  if (!isRepeated) data_ += command;
  if (isRepeated && dx >= 0) data_ += ' ';
  data_ += std::to_string(dx);
  if (dy >= 0) data_ += ' ';
  data_ += std::to_string(dy);
  x_ = toX;
  y_ = toY;
  last_ = command;
}

void SvgPath::moveTo(double x, double y) {
  last_ = 0;  // coordinates after a move would be read as lines
  go('m', x, y);
  startX_ = x_;
  startY_ = y_;
}

void SvgPath::lineTo(double x, double y) { go('l', x, y); }

void SvgPath::close() {
  data_ += 'z';
  last_ = 'z';
  x_ = startX_;
  y_ = startY_;
}

}  // namespace abflat
