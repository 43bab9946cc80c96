#pragma once

#include <string>
#include <string_view>

#include "abflat/obj_maps.h"

namespace abflat {

/// A line of a material that uses an image.
struct MtlMapLine {
  MtlMap map;
  std::string_view keyword;
  std::string path;     ///< of the image, as it is written
  std::string options;  ///< those that do not place the image, each with a blank behind it
};

/// The words behind the keyword of a map: "-s 1 1 1 -clamp on my wood.png". Names may have blanks.
MtlMapLine mapLine(std::string_view words);

/// Whether a line of a material uses an image, which then is in `out`.
bool readMapLine(std::string_view line, MtlMapLine& out);

}  // namespace abflat
