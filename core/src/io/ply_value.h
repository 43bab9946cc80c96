#pragma once

#include <cstdint>
#include <cstring>

#include "io/ply_header.h"

namespace abflat {

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
constexpr bool kIsBigEndianHere = true;
#else
constexpr bool kIsBigEndianHere = false;
#endif

inline std::uint8_t byteSwapped(std::uint8_t bits) { return bits; }
inline std::uint16_t byteSwapped(std::uint16_t bits) { return __builtin_bswap16(bits); }
inline std::uint32_t byteSwapped(std::uint32_t bits) { return __builtin_bswap32(bits); }
inline std::uint64_t byteSwapped(std::uint64_t bits) { return __builtin_bswap64(bits); }

/// A number at any position in a file, in either byte order. `Bits` is the unsigned type of the
/// same size.
template <class T, class Bits>
T loadedFrom(const char* at, bool isBigEndian) {
  Bits bits;
  T value;
  std::memcpy(&bits, at, sizeof bits);
  if (isBigEndian != kIsBigEndianHere) bits = byteSwapped(bits);
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <class Bits, class T>
char* storedTo(char* to, T value, bool isBigEndian) {
  Bits bits;
  std::memcpy(&bits, &value, sizeof bits);
  if (isBigEndian != kIsBigEndianHere) bits = byteSwapped(bits);
  std::memcpy(to, &bits, sizeof bits);
  return to + sizeof bits;
}

/// A double holds every number that PLY can express.
inline double loadNumber(const char* at, PlyType type, bool isBigEndian) {
  switch (type) {
    case PlyType::Int8:
      return static_cast<std::int8_t>(*at);
    case PlyType::Uint8:
      return static_cast<std::uint8_t>(*at);
    case PlyType::Int16:
      return loadedFrom<std::int16_t, std::uint16_t>(at, isBigEndian);
    case PlyType::Uint16:
      return loadedFrom<std::uint16_t, std::uint16_t>(at, isBigEndian);
    case PlyType::Int32:
      return loadedFrom<std::int32_t, std::uint32_t>(at, isBigEndian);
    case PlyType::Uint32:
      return loadedFrom<std::uint32_t, std::uint32_t>(at, isBigEndian);
    case PlyType::Float32:
      return static_cast<double>(loadedFrom<float, std::uint32_t>(at, isBigEndian));
    case PlyType::Float64:
      return loadedFrom<double, std::uint64_t>(at, isBigEndian);
  }
  return 0;
}

/// `value` must be in the range of the type, and whole if the type is integral. Returns the end.
inline char* storeNumber(char* to, double value, PlyType type, bool isBigEndian) {
  switch (type) {
    case PlyType::Int8:
      return storedTo<std::uint8_t>(to, static_cast<std::int8_t>(value), isBigEndian);
    case PlyType::Uint8:
      return storedTo<std::uint8_t>(to, static_cast<std::uint8_t>(value), isBigEndian);
    case PlyType::Int16:
      return storedTo<std::uint16_t>(to, static_cast<std::int16_t>(value), isBigEndian);
    case PlyType::Uint16:
      return storedTo<std::uint16_t>(to, static_cast<std::uint16_t>(value), isBigEndian);
    case PlyType::Int32:
      return storedTo<std::uint32_t>(to, static_cast<std::int32_t>(value), isBigEndian);
    case PlyType::Uint32:
      return storedTo<std::uint32_t>(to, static_cast<std::uint32_t>(value), isBigEndian);
    case PlyType::Float32:
      return storedTo<std::uint32_t>(to, static_cast<float>(value), isBigEndian);
    case PlyType::Float64:
      return storedTo<std::uint64_t>(to, value, isBigEndian);
  }
  return to;
}

/// The largest n such that the type holds every whole number from 0 to n.
constexpr double largestWhole(PlyType type) {
  constexpr double kLargest[] = {127,        255,        32767,    65535,
                                 2147483647, 4294967295, 16777216, 4294967295};
  return kLargest[static_cast<std::size_t>(type)];
}

}  // namespace abflat
