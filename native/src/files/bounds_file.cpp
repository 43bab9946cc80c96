#include "files/bounds_file.h"

#include "files/rows_file.h"

namespace abflat::cli {

Result<std::vector<VertexBound>> readBounds(const std::string& path) {
  const auto read = [](std::istream& in, VertexBound& bound) {
    return readIndex(in, bound.vertex) && in >> bound.t;
  };
  return readRows<VertexBound>(path, "a vertex number and its t, such as '17 1.5'", read);
}

}  // namespace abflat::cli
