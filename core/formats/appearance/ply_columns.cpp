#include "appearance/ply_columns.h"

#include <algorithm>
#include <limits>

#include "base/number_text.h"
#include "io/ply_row.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// For each property of the element, its index in `properties`, or their number if it is not among
/// them.
std::vector<std::size_t> placesOf(const PlyElement& element,
                                  const std::vector<std::size_t>& properties) {
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    out.push_back(static_cast<std::size_t>(std::find(properties.begin(), properties.end(), p) -
                                           properties.begin()));
  return out;
}

/// The next line that is not blank.
std::string_view nextRow(std::string_view& rest) {
  while (!rest.empty()) {
    const std::size_t size = lineSize(rest);
    const std::string_view words = restOfLine(rest.substr(0, size));
    rest.remove_prefix(size);
    if (!words.empty()) return words;
  }
  return {};
}

std::vector<double> textColumns(const PlyHeader& header, std::string_view rest,
                                const std::vector<std::size_t>& properties) {
  const PlyElement& vertex = header.elements[header.vertex];
  const std::vector<std::size_t> places = placesOf(vertex, properties);
  std::vector<double> out;
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      std::string_view words = nextRow(rest);
      if (&element != &vertex) continue;
      const std::size_t begin = out.size();
      out.resize(begin + properties.size(), kNoNumber);
      for (std::size_t p = 0; p < places.size(); ++p) {
        std::int64_t count = 1;  // words in this property
        if (vertex.properties[p].isList && !parseInteger(takeWord(words), count)) break;
        for (std::int64_t k = 0; k < count; ++k) {
          double value = 0;
          const bool isNumber = parseDouble(takeWord(words), value);
          if (places[p] < properties.size() && isNumber) out[begin + places[p]] = value;
        }
      }
    }
    if (&element == &vertex) return out;
  }
  return out;
}

std::vector<double> binaryColumns(const PlyHeader& header, std::string_view body,
                                  const std::vector<std::size_t>& properties) {
  const PlyElement& vertex = header.elements[header.vertex];
  const std::vector<std::size_t> places = placesOf(vertex, properties);
  const bool isBigEndian = header.encoding == PlyEncoding::BigEndian;
  const char *at = body.data(), *const end = at + body.size();
  std::vector<double> out;
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      const std::size_t begin = out.size();
      if (&element == &vertex) out.resize(begin + properties.size());
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        PlyField field;
        if (scanField(property, at, end, isBigEndian, field) != PlyScan::Ok) return out;
        at = field.end;
        if (&element == &vertex && places[p] < properties.size())
          out[begin + places[p]] = loadNumber(field.numbers, property.type, isBigEndian);
      }
    }
    if (&element == &vertex) return out;
  }
  return out;
}

}  // namespace

std::vector<double> plyColumns(const PlyHeader& header, std::string_view bytes,
                               const std::vector<std::size_t>& properties) {
  const std::string_view body = bytes.substr(header.text.size());
  return header.encoding == PlyEncoding::Text ? textColumns(header, body, properties)
                                              : binaryColumns(header, body, properties);
}

}  // namespace abflat
