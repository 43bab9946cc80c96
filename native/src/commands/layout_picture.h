#pragma once

#include <string>

#include "abflat/draw.h"
#include "files/paths.h"

namespace abflat::cli {

/// The picture of an atlas, as the ending of its name says. `scale`: see UnwrapCommand.
inline Result<std::string> layoutPicture(const std::string& path, double scale,
                                         const PolygonMesh& mesh, const UnwrapResult& result) {
  if (endingOf(path) == ".svg") return atlasSvg(mesh, result, scale);
  return atlasPng(mesh, result);
}

}  // namespace abflat::cli
