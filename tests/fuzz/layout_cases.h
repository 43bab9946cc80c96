#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "abflat/pack_layout.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"

namespace abflat::fuzz {

struct UnwrapCase {
  PolygonMesh mesh;
  UnwrapOptions options;
  bool isPlain = false;  ///< the usual options
};
UnwrapCase unwrapCase(const std::uint8_t* bytes, std::size_t size);

struct FlattenCase {
  PolygonMesh mesh;
  FlattenOptions options;
  Precision precision = Precision::Double;
};
FlattenCase flattenCase(const std::uint8_t* bytes, std::size_t size);

struct PackCase {
  PolygonMesh mesh;
  PackLayoutOptions options;
};
PackCase packCase(const std::uint8_t* bytes, std::size_t size);

struct VerifyCase {
  PolygonMesh mesh;
  VerifyOptions options;
};
/// A random mesh with a random layout, or a file: the first byte says which.
VerifyCase verifyCase(const std::uint8_t* bytes, std::size_t size);

/// A case for people: the mesh as an OBJ, options and seams as comments.
std::string shown(const UnwrapCase& c);
std::string shown(const FlattenCase& c);
std::string shown(const PackCase& c);
std::string shown(const VerifyCase& c);

}  // namespace abflat::fuzz
