#pragma once

#include <cstddef>

#include "io/ply_header.h"
#include "io/ply_value.h"

namespace abflat {

/// One property in a row of a binary file.
struct PlyField {
  const char* begin = nullptr;    ///< includes the count of a list
  const char* numbers = nullptr;  ///< the first of `count` numbers
  const char* end = nullptr;
  std::size_t count = 1;
};

enum class PlyScan { Ok, CutOff, BadCount };

/// The field that begins at `at`, in a file that ends at `end`. BadCount: the length of a list is
/// negative or not a whole number.
inline PlyScan scanField(const PlyProperty& property, const char* at, const char* end,
                         bool isBigEndian, PlyField& field) {
  const auto room = [&] { return static_cast<std::size_t>(end - at); };
  field.begin = at;
  field.count = 1;
  if (property.isList) {
    if (room() < sizeOf(property.countType)) return PlyScan::CutOff;
    const double count = loadNumber(at, property.countType, isBigEndian);
    if (!(count >= 0) || count > largestWhole(property.countType)) return PlyScan::BadCount;
    field.count = static_cast<std::size_t>(count);
    if (static_cast<double>(field.count) != count) return PlyScan::BadCount;
    at += sizeOf(property.countType);
  }
  if (room() / sizeOf(property.type) < field.count) return PlyScan::CutOff;
  field.numbers = at;
  field.end = at + field.count * sizeOf(property.type);
  return PlyScan::Ok;
}

}  // namespace abflat
