#include "gltf/uri.h"

#include <array>
#include <cstdint>

namespace abflat::gltf {
namespace {

constexpr std::string_view kData = "data:", kBase64 = ";base64";
constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view kHexDigits = "0123456789ABCDEF";
constexpr int kNoDigit = -1;

/// Value of each character as a base 64 digit.
std::array<int, 256> digitValues() {
  std::array<int, 256> out{};
  out.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    out[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  return out;
}

int hexValue(char c) {
  const char upper = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  const std::size_t at = kHexDigits.find(upper);
  return at == std::string_view::npos ? kNoDigit : static_cast<int>(at);
}

Result<std::string> decodeBase64(std::string_view text) {
  const std::array<int, 256> values = digitValues();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string out;
  out.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int value = values[static_cast<unsigned char>(text[i])];
    if (value == kNoDigit)
      return Status{StatusCode::ParseError,
                    "has a non-base64 character at position " + std::to_string(i) + " of its data"};
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out.push_back(static_cast<char>(bits >> held & 0xff));
  }
  return out;
}

}  // namespace

bool isDataUri(std::string_view uri) { return uri.substr(0, kData.size()) == kData; }

bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && uri.find('/') > colon;
}

Result<std::string> dataOf(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos)
    return Status{StatusCode::ParseError, "is a data URI without a comma"};
  const std::string_view type = uri.substr(0, comma), data = uri.substr(comma + 1);
  const bool isBase64 =
      type.size() >= kBase64.size() && type.substr(type.size() - kBase64.size()) == kBase64;
  if (isBase64) return decodeBase64(data);
  return pathOfUri(data);
}

std::string dataUri(std::string_view bytes) {
  std::string out = "data:application/octet-stream;base64,";
  out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63]);
  }
  return out;
}

std::string pathOfUri(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool isCode = uri[i] == '%' && i + 2 < uri.size() && hexValue(uri[i + 1]) != kNoDigit &&
                        hexValue(uri[i + 2]) != kNoDigit;
    out.push_back(isCode ? static_cast<char>(16 * hexValue(uri[i + 1]) + hexValue(uri[i + 2]))
                         : uri[i]);
    if (isCode) i += 2;
  }
  return out;
}

std::string uriOfPath(std::string_view path) {
  constexpr std::string_view kPlain = "-_.~/()!$&'*+,;=@";
  std::string out;
  for (const char c : path) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || kPlain.find(c) != std::string_view::npos;
    if (isPlain) {
      out.push_back(c);
      continue;
    }
    const unsigned byte = static_cast<unsigned char>(c);
    out.push_back('%');
    out.push_back(kHexDigits[byte >> 4]);
    out.push_back(kHexDigits[byte & 15]);
  }
  return out;
}

}  // namespace abflat::gltf
