#pragma once

#include <string>

#include "io/ply_header.h"

namespace abflat {

inline std::string tooFewCorners(std::size_t corners) {
  return "the face has " + std::to_string(corners) + " corners; at least 3 are needed";
}

inline std::string noSuchVertex(const std::string& vertex, std::uint64_t vertices) {
  return "the face refers to vertex " + vertex + ", but the file has " + std::to_string(vertices) +
         " vertices (indices start at 0)";
}

/// For the entry of a triangle strip.
inline std::string noSuchEntry(std::size_t entry, const std::string& vertex,
                               std::uint64_t vertices) {
  return "entry " + std::to_string(entry) + " of the strip is " + vertex + ", but the file has " +
         std::to_string(vertices) + " vertices (indices start at 0, -1 ends a strip)";
}

constexpr const char* kTooManyCorners = "more than 4294967295 face corners are not supported";

/// "3 elements 'face'", "1 element 'vertex'".
inline std::string rowsOf(std::uint64_t rows, const PlyElement& element) {
  return std::to_string(rows) + (rows == 1 ? " element '" : " elements '") +
         std::string(element.name.substr(0, 40)) + "'";
}

}  // namespace abflat
