#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/number_text.h"

namespace abflat {

/// A text that grows at its end. Numbers are written in place, with one capacity check each.
class TextWriter {
 public:
  explicit TextWriter(std::size_t expectedSize) { text_.resize(expectedSize); }

  /// Room for this many characters at the end, valid until the next call of the writer; endAt tells
  /// how much of it was used.
  char* room(std::size_t chars) {
    if (text_.size() - size_ < chars) text_.resize(size_ + chars + text_.size() / 2);
    return &text_[size_];
  }
  void endAt(const char* end) { size_ = static_cast<std::size_t>(end - text_.data()); }

  void put(char c) { *room(1) = c, ++size_; }
  void put(std::string_view part) {
    if (part.empty()) return;
    std::memcpy(room(part.size()), part.data(), part.size());
    size_ += part.size();
  }
  /// Takes back the last character.
  void unput() { --size_; }
  void put(double value) { endAt(writeDouble(room(kMostDoubleChars), value)); }
  void put(std::uint32_t value) { endAt(writeInteger(room(kMostIntegerChars), value)); }

  /// Returns the text; the writer must not be used afterwards.
  std::string take() {
    text_.resize(size_);
    return std::move(text_);
  }

 private:
  std::string text_;
  std::size_t size_ = 0;
};

}  // namespace abflat
