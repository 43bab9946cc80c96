#include "abflat/seam_sources.h"
#include "base/number_text.h"

namespace abflat {
namespace {

Status wrong(std::string_view word) {
  return {StatusCode::InvalidOption, "'" + std::string(word) +
                                         "' is not auto, hard, uv, material, none or sharp=DEGREES "
                                         "with degrees above 0 and at most 180"};
}

}  // namespace

Result<SeamSources> parseSeams(std::string_view text) {
  constexpr std::string_view kSharp = "sharp=";
  SeamSources out;
  out.isAuto = false;
  bool isNone = false;
  std::size_t words = 0;
  for (bool isLast = false; !isLast; ++words) {
    const std::size_t comma = text.find(',');
    isLast = comma == std::string_view::npos;
    const std::string_view word = text.substr(0, comma);
    if (!isLast) text.remove_prefix(comma + 1);
    if (word == "auto")
      out.isAuto = true;
    else if (word == "hard")
      out.followsHardEdges = true;
    else if (word == "uv")
      out.followsTexcoords = true;
    else if (word == "material")
      out.followsMaterials = true;
    else if (word == "none")
      isNone = true;
    else if (word.substr(0, kSharp.size()) != kSharp ||
             !parseDouble(word.substr(kSharp.size()), out.sharpDegrees) ||
             !(out.sharpDegrees > 0 && out.sharpDegrees <= 180))
      return wrong(word);
  }
  if (isNone && words > 1)
    return Status{StatusCode::InvalidOption, "none cannot be combined with other seams"};
  return out;
}

}  // namespace abflat
