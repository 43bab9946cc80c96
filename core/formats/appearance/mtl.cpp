#include "appearance/mtl.h"

#include <algorithm>
#include <cmath>

#include "appearance/mtl_map_line.h"
#include "base/number_text.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

/// Takes up to `size` numbers from 0 to 1; returns how many there were.
std::size_t takeNumbers(std::string_view words, double* out, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    double value = 0;
    if (!parseDouble(takeWord(words), value) || !std::isfinite(value)) return i;
    out[i] = std::clamp(value, 0.0, 1.0);
  }
  return size;
}

/// A single number is a grey.
void readColor(std::string_view words, std::array<double, 3>& color) {
  std::array<double, 3> value{};
  const std::size_t count = takeNumbers(words, value.data(), 3);
  if (count == 1) value[1] = value[2] = value[0];
  if (count == 1 || count == 3) color = value;
}

void readLine(std::string_view keyword, std::string_view words, MtlMaterial& out) {
  double value = 0;
  if (keyword == "Kd") readColor(words, out.diffuse);
  if (keyword == "Ke") readColor(words, out.emission);
  if (keyword == "map_Kd") out.diffuseMap = mapLine(words).path;
  if (keyword == "d" && takeNumbers(words, &value, 1) == 1) {
    out.opacity = value;
    out.hasOpacity = true;
  }
  // Some programs mean opacity by it, so it only counts if no opacity is given.
  if (keyword == "Tr" && !out.hasOpacity && takeNumbers(words, &value, 1) == 1)
    out.opacity = 1 - value;
  if (keyword == "Pm" && takeNumbers(words, &value, 1) == 1) out.metallic = value;
  if (keyword == "Pr" && takeNumbers(words, &value, 1) == 1) out.roughness = value;
}

}  // namespace

void readMtl(std::string_view text, MtlMaterials& out) {
  if (hasByteOrderMark(text)) text.remove_prefix(kByteOrderMark.size());
  MtlMaterial repeated;  // for a name that exists already
  MtlMaterial* material = nullptr;
  while (!text.empty()) {
    const std::size_t size = lineSize(text);
    std::string_view words = restOfLine(text.substr(0, size));
    text.remove_prefix(size);
    const std::string_view keyword = takeWord(words);
    if (keyword == "newmtl") {
      const auto [place, isNew] = out.emplace(restOfLine(words), MtlMaterial());
      material = isNew ? &place->second : &repeated;
    } else if (material != nullptr) {
      readLine(keyword, words, *material);
    }
  }
}

}  // namespace abflat
