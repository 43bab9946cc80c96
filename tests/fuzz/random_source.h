#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace abflat::fuzz {

/// Choices taken from the bytes that a fuzzer makes up; all are 0 once these have run out.
class RandomSource {
 public:
  RandomSource(const std::uint8_t* bytes, std::size_t size) : next_(bytes), end_(bytes + size) {}

  bool isEmpty() const { return next_ == end_; }

  std::uint8_t byte() { return isEmpty() ? std::uint8_t{0} : *next_++; }

  /// Below `count`, which is at most 65536 and not 0.
  std::uint32_t below(std::size_t count) {
    const std::uint32_t high = count > 256 ? byte() : 0;
    return (high * 256u + byte()) % static_cast<std::uint32_t>(count);
  }

  std::uint32_t between(std::uint32_t least, std::uint32_t most) {
    return least + below(most - least + 1);
  }

  bool isOneOf(std::uint32_t count) { return below(count) == 1 % count; }
  bool flag() { return below(2) == 1; }

  /// In [-1, 1].
  double signedUnit() { return (static_cast<double>(below(65536)) - 32768) / 32768; }

  template <class T>
  T pick(std::initializer_list<T> values) {
    return *(values.begin() + below(values.size()));
  }

 private:
  const std::uint8_t *next_, *end_;
};

}  // namespace abflat::fuzz
