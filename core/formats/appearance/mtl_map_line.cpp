#include "appearance/mtl_map_line.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "io/text_lines.h"

namespace abflat {
namespace {

struct MapWord {
  std::string_view keyword;  ///< in lower case
  const char* name;
  MtlMeaning meaning;
};

constexpr MapWord kMapWords[] = {
    {"map_ka", "ambient", MtlMeaning::Colour},
    {"map_kd", "diffuse", MtlMeaning::Colour},
    {"map_ks", "specular", MtlMeaning::Colour},
    {"map_ke", "emissive", MtlMeaning::Colour},
    {"map_ns", "shininess", MtlMeaning::Number},
    {"map_d", "opacity", MtlMeaning::Number},
    {"map_tr", "transparency", MtlMeaning::Number},
    {"map_pr", "roughness", MtlMeaning::Number},
    {"map_pm", "metallic", MtlMeaning::Number},
    {"map_ps", "sheen", MtlMeaning::Number},
    {"map_pc", "clearcoat", MtlMeaning::Number},
    {"map_pcr", "clearcoatRoughness", MtlMeaning::Number},
    {"norm", "normal", MtlMeaning::Normal},
    {"map_kn", "normal", MtlMeaning::Normal},
    {"bump", "bump", MtlMeaning::Relief},
    {"map_bump", "bump", MtlMeaning::Relief},
    {"disp", "displacement", MtlMeaning::Number},
    {"map_disp", "displacement", MtlMeaning::Number},
    {"decal", "decal", MtlMeaning::Unknown},
    {"refl", "refl", MtlMeaning::Unknown},
};

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// Number of arguments that an option takes; of those that take up to three numbers, only the
/// first is required.
std::size_t argumentsOf(std::string_view option) {
  for (const std::string_view numbers : {"-o", "-s", "-t"})
    if (option == numbers) return 3;
  return option == "-mm" ? 2 : 1;
}

std::vector<std::string_view> takeArguments(std::string_view option, std::string_view& words) {
  std::vector<std::string_view> out;
  for (std::size_t i = 0; i < argumentsOf(option); ++i) {
    std::string_view rest = words;
    double value = 0;
    const std::string_view word = takeWord(rest);
    if (i > 0 && !parseDouble(word, value)) break;
    out.push_back(word);
    words = rest;
  }
  return out;
}

void place(const std::vector<std::string_view>& arguments, std::array<double, 2>& out) {
  for (std::size_t d = 0; d < std::min<std::size_t>(2, arguments.size()); ++d) {
    double value = 0;
    if (parseDouble(arguments[d], value) && std::isfinite(value)) out[d] = value;
  }
}

/// Takes an option that places the image; false for any other.
bool takePlacing(std::string_view option, const std::vector<std::string_view>& arguments,
                 MtlMap& out) {
  if (option == "-s") place(arguments, out.scale);
  if (option == "-o") place(arguments, out.offset);
  if (option == "-clamp") out.isClamped = !arguments.empty() && arguments[0] == "on";
  return option == "-s" || option == "-o" || option == "-t" || option == "-clamp";
}

void takeStrength(const std::vector<std::string_view>& arguments, MtlMap& out) {
  double value = 0;
  if (!arguments.empty() && parseDouble(arguments[0], value) && std::isfinite(value))
    out.strength = value;
}

}  // namespace

MtlMapLine mapLine(std::string_view words) {
  MtlMapLine out;
  while (true) {
    std::string_view rest = words;
    const std::string_view option = takeWord(rest);
    if (option.size() < 2 || option[0] != '-') break;
    const std::vector<std::string_view> arguments = takeArguments(option, rest);
    words = rest;
    if (takePlacing(option, arguments, out.map)) continue;
    if (option == "-bm") takeStrength(arguments, out.map);
    out.options.append(option).append(" ");
    for (const std::string_view argument : arguments) out.options.append(argument).append(" ");
  }
  out.path = restOfLine(words);
  return out;
}

bool readMapLine(std::string_view line, MtlMapLine& out) {
  std::string_view words = line;
  const std::string_view keyword = takeWord(words);
  const std::string lower = lowerCase(keyword);
  const auto* const word = std::find_if(std::begin(kMapWords), std::end(kMapWords),
                                        [&](const MapWord& each) { return each.keyword == lower; });
  const bool isKnown = word != std::end(kMapWords);
  if (!isKnown && lower.rfind("map_", 0) != 0) return false;
  // Not an image, but whether textures are smoothed.
  if (lower == "map_aat") return false;
  out = mapLine(words);
  out.keyword = keyword;
  out.map.name = isKnown ? word->name : std::string(keyword);
  out.map.meaning = isKnown ? word->meaning : MtlMeaning::Unknown;
  return true;
}

}  // namespace abflat
