#include "bounds_file.h"

#include <sstream>

#include "input_file.h"
#include "paths.h"

namespace abflat::cli {

Result<std::vector<VertexBound>> readBounds(const std::string& path) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status;
  std::istringstream in(text.value);
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
                    inputName(path) + ":" + std::to_string(number) +
                        ": expected a vertex number and its t, such as '17 1.5'"};
    bounds.push_back(bound);
  }
  return bounds;
}

}  // namespace abflat::cli
