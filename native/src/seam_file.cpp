#include "seam_file.h"

#include <sstream>

#include "input_file.h"
#include "paths.h"

namespace abflat::cli {

Result<std::vector<EdgeVertices>> readSeams(const std::string& path) {
  const Result<std::string> text = readBytes(path);
  if (!text.ok()) return text.status;
  std::istringstream in(text.value);
  std::vector<EdgeVertices> edges;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string content = line.substr(0, line.find('#'));
    std::istringstream words(content);
    std::string rest;
    EdgeVertices edge;
    if (!(words >> rest)) continue;
    std::istringstream numbers(content);
    const bool isEdge = content.find('-') == std::string::npos && (numbers >> edge[0] >> edge[1]) &&
                        !(numbers >> rest);
    if (!isEdge)
      return Status{StatusCode::ParseError, inputName(path) + ":" + std::to_string(number) +
                                                ": expected two vertex numbers, such as '17 42'"};
    edges.push_back(edge);
  }
  return edges;
}

std::string seamsText(const std::vector<EdgeVertices>& seams) {
  std::string out;
  for (const EdgeVertices& e : seams)
    out += std::to_string(e[0]) + " " + std::to_string(e[1]) + "\n";
  return out;
}

}  // namespace abflat::cli
