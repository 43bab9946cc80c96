#pragma once

#include <string>
#include <vector>

namespace abflat::test {

/// An element of a PLY file. A row has all numbers in file order, including the counts of lists.
struct PlyTestElement {
  std::string name;
  std::vector<std::string> properties;  ///< "float x", "list uchar int vertex_indices"
  std::vector<std::vector<double>> rows;
};

extern const std::vector<std::string> kPlyFormats;  ///< "ascii", "binary_little_endian", ...

/// A whole file in one of the formats, written without any of the library's code.
std::string plyFile(const std::string& format, const std::vector<PlyTestElement>& elements,
                    const std::string& lineEnd = "\n");

}  // namespace abflat::test
