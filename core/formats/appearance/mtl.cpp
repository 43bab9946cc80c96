#include "appearance/mtl.h"

#include <algorithm>
#include <cmath>

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

/// Number of arguments that a map option takes; of those that take up to three numbers, only the
/// first is required.
std::size_t argumentsOf(std::string_view option) {
  for (const std::string_view numbers : {"-o", "-s", "-t"})
    if (option == numbers) return 3;
  return option == "-mm" ? 2 : 1;
}

/// "-s 1 1 1 -clamp on my wood.png": the name of the file, which may contain blanks.
std::string_view mapPath(std::string_view words) {
  while (true) {
    std::string_view rest = words;
    const std::string_view option = takeWord(rest);
    if (option.size() < 2 || option[0] != '-') return restOfLine(words);
    const std::size_t count = argumentsOf(option);
    for (std::size_t i = 0; i < count; ++i) {
      std::string_view next = rest;
      double value = 0;
      const std::string_view word = takeWord(next);
      if (i > 0 && !parseDouble(word, value)) break;
      rest = next;
    }
    words = rest;
  }
}

void readLine(std::string_view keyword, std::string_view words, MtlMaterial& out) {
  double value = 0;
  if (keyword == "Kd") readColor(words, out.diffuse);
  if (keyword == "Ke") readColor(words, out.emission);
  if (keyword == "map_Kd") out.diffuseMap = mapPath(words);
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
