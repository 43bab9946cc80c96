#include "support/ply_files.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace abflat::test {
namespace {

template <class T>
std::string bytesOf(double number, bool isBig) {
  const T value = static_cast<T>(number);
  std::string out(sizeof value, '\0');
  std::memcpy(out.data(), &value, sizeof value);
  const std::uint16_t probe = 1;
  const bool isBigHere = *reinterpret_cast<const char*>(&probe) == 0;
  if (isBig != isBigHere) std::reverse(out.begin(), out.end());
  return out;
}

std::string encoded(const std::string& type, double number, const std::string& format) {
  if (format == "ascii") {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
  }
  const bool isBig = format == "binary_big_endian";
  if (type == "char" || type == "int8") return bytesOf<std::int8_t>(number, isBig);
  if (type == "uchar" || type == "uint8") return bytesOf<std::uint8_t>(number, isBig);
  if (type == "short" || type == "int16") return bytesOf<std::int16_t>(number, isBig);
  if (type == "ushort" || type == "uint16") return bytesOf<std::uint16_t>(number, isBig);
  if (type == "int" || type == "int32") return bytesOf<std::int32_t>(number, isBig);
  if (type == "uint" || type == "uint32") return bytesOf<std::uint32_t>(number, isBig);
  if (type == "float" || type == "float32") return bytesOf<float>(number, isBig);
  return bytesOf<double>(number, isBig);
}

std::string encodedRow(const PlyTestElement& element, const std::vector<double>& row,
                       const std::string& format, const std::string& lineEnd) {
  std::string out;
  std::size_t at = 0;
  const auto put = [&](const std::string& type) {
    if (format == "ascii" && at > 0) out += ' ';
    out += encoded(type, row.at(at++), format);
  };
  for (const std::string& property : element.properties) {
    std::istringstream words(property);
    std::string type, countType;
    words >> type;
    double count = 1;
    if (type == "list") {
      words >> countType >> type;
      count = row.at(at);
      put(countType);
    }
    for (double k = 0; k < count; ++k) put(type);
  }
  return format == "ascii" ? out + lineEnd : out;
}

}  // namespace

const std::vector<std::string> kPlyFormats = {"ascii", "binary_little_endian", "binary_big_endian"};

std::string plyFile(const std::string& format, const std::vector<PlyTestElement>& elements,
                    const std::string& lineEnd) {
  std::string out = "ply" + lineEnd + "format " + format + " 1.0" + lineEnd +
                    "comment made by a test" + lineEnd + "obj_info none" + lineEnd;
  for (const PlyTestElement& element : elements) {
    out += "element " + element.name + " " + std::to_string(element.rows.size()) + lineEnd;
    for (const std::string& property : element.properties) out += "property " + property + lineEnd;
  }
  out += "end_header" + lineEnd;
  for (const PlyTestElement& element : elements)
    for (const std::vector<double>& row : element.rows)
      out += encodedRow(element, row, format, lineEnd);
  return out;
}

}  // namespace abflat::test
