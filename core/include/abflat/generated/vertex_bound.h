// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstdint>

namespace abflat {

/// A bound of t pi for one boundary vertex, in place of the common t; if a vertex has several, the
/// last one counts.
struct VertexBound {
  /// Vertex of the input.
  std::uint32_t vertex = 0;
  /// Its boundary control coefficient.
  double t = 0;
};

template <class Visitor>
void visitFields(const VertexBound& r, Visitor& v) {
  v.field("vertex", r.vertex);
  v.field("t", r.t);
}

}  // namespace abflat
