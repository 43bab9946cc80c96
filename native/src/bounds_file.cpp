#include "bounds_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace abflat::cli {

Result<std::vector<VertexBound>> readBounds(const std::string& path) {
  std::ifstream in(path);
  if (!in)
    return Status{StatusCode::UnreadableFile, "cannot read " + path + ": " + std::strerror(errno)};
  std::vector<VertexBound> bounds;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string first, rest;
    if (!(words >> first)) continue;
    VertexBound bound;
    std::istringstream vertex(first);
    const bool isVertex = first[0] != '-' && (vertex >> bound.vertex) && vertex.eof();
    if (!isVertex || !(words >> bound.t) || (words >> rest))
      return Status{StatusCode::ParseError,
                    path + ":" + std::to_string(number) +
                        ": expected a vertex number and its t, such as '17 1.5'"};
    bounds.push_back(bound);
  }
  return bounds;
}

}  // namespace abflat::cli
