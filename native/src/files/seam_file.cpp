#include "files/seam_file.h"

#include "files/rows_file.h"

namespace abflat::cli {

Result<std::vector<EdgeVertices>> readSeams(const std::string& path) {
  const auto read = [](std::istream& in, EdgeVertices& edge) {
    return readIndex(in, edge[0]) && readIndex(in, edge[1]);
  };
  return readRows<EdgeVertices>(path, "two vertex numbers, such as '17 42'", read);
}

std::string seamsText(const std::vector<EdgeVertices>& seams) {
  std::string out;
  for (const EdgeVertices& e : seams)
    out += std::to_string(e[0]) + " " + std::to_string(e[1]) + "\n";
  return out;
}

}  // namespace abflat::cli
