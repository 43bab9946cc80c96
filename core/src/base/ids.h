#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace abflat {

/// Stands for "no number".
constexpr std::uint32_t kNone = 0xffffffffu;

/// A number typed by what it counts, so that a corner is never taken for a vertex, nor a vertex of
/// a chart for one of the surface. Converts to a plain number implicitly, but from one only
/// explicitly.
template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  template <class Number, std::enable_if_t<std::is_integral_v<Number>, int> = 0>
  explicit constexpr Id(Number number) : number_(static_cast<std::uint32_t>(number)) {}

  constexpr operator std::uint32_t() const { return number_; }
  constexpr bool exists() const { return number_ != kNone; }
  constexpr Id& operator++() {
    ++number_;
    return *this;
  }

  friend constexpr bool operator==(Id a, Id b) { return a.number_ == b.number_; }
  friend constexpr bool operator!=(Id a, Id b) { return a.number_ != b.number_; }
  friend constexpr bool operator<(Id a, Id b) { return a.number_ < b.number_; }
  template <class Other>
  friend constexpr bool operator==(Id, Id<Other>) = delete;
  template <class Other>
  friend constexpr bool operator!=(Id, Id<Other>) = delete;
  template <class Other>
  friend constexpr bool operator<(Id, Id<Other>) = delete;

 private:
  std::uint32_t number_ = kNone;
};

/// The ids from `begin` up to `end`.
template <class I>
class IdRange {
 public:
  class Iterator {
   public:
    explicit constexpr Iterator(I at) : at_(at) {}
    constexpr I operator*() const { return at_; }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr bool operator!=(Iterator other) const { return at_ != other.at_; }

   private:
    I at_;
  };

  constexpr IdRange(I begin, I end) : begin_(begin), end_(end) {}
  explicit constexpr IdRange(std::size_t size) : begin_(std::size_t{0}), end_(size) {}
  constexpr Iterator begin() const { return Iterator(begin_); }
  constexpr Iterator end() const { return Iterator(end_); }
  constexpr std::size_t size() const { return end_ - begin_; }

 private:
  I begin_, end_;
};

/// A view of values in someone else's array, indexed by one kind of id.
template <class I, class T>
class IdSpan {
 public:
  IdSpan() = default;
  IdSpan(const T* first, std::size_t size) : first_(first), size_(size) {}

  const T& operator[](I i) const { return first_[i]; }
  template <class Other>
  const T& operator[](Other) const = delete;

  const T* begin() const { return first_; }
  const T* end() const { return first_ + size_; }
  const T& front() const { return *first_; }
  const T& back() const { return first_[size_ - 1]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  IdRange<I> ids() const { return IdRange<I>(size_); }

 private:
  const T* first_ = nullptr;
  std::size_t size_ = 0;
};

/// A vector indexed by one kind of id.
template <class I, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t size) : values_(size) {}
  IdVector(std::size_t size, const T& value) : values_(size, value) {}
  explicit IdVector(std::vector<T> values) : values_(std::move(values)) {}
  IdVector(std::initializer_list<T> values) : values_(values) {}

  T& operator[](I i) { return values_[i]; }
  const T& operator[](I i) const { return values_[i]; }
  template <class Other>
  T& operator[](Other) const = delete;

  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  T& front() { return values_.front(); }
  T& back() { return values_.back(); }
  const T& front() const { return values_.front(); }
  const T& back() const { return values_.back(); }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  void resize(std::size_t size) { values_.resize(size); }
  void resize(std::size_t size, const T& value) { values_.resize(size, value); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void clear() { values_.clear(); }
  void pop_back() { values_.pop_back(); }

  /// Returns the id of the new value.
  I push_back(T value) {
    values_.push_back(std::move(value));
    return I(values_.size() - 1);
  }

  IdRange<I> ids() const { return IdRange<I>(values_.size()); }
  IdSpan<I, T> span() const { return {values_.data(), values_.size()}; }

  /// For code that uses plain numbers: callers' arrays, linear systems.
  std::vector<T>& raw() { return values_; }
  const std::vector<T>& raw() const { return values_; }

  friend bool operator==(const IdVector& a, const IdVector& b) { return a.values_ == b.values_; }
  friend bool operator!=(const IdVector& a, const IdVector& b) { return a.values_ != b.values_; }

 private:
  std::vector<T> values_;
};

}  // namespace abflat
