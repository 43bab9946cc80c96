#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abflat {

/// What triangles cover of rows that are evenly spread over a range of v. What is covered more than
/// once counts once, so that areas are right wherever islands overlap themselves.
class RowSpans {
 public:
  RowSpans(double low, double high);

  /// `triangles` has 6 coordinates for each of `count` triangles, either way round.
  void cover(const double* triangles, std::size_t count);

  double low() const { return low_; }
  double high() const { return low_ + height_ * kRows; }
  double area() const;
  /// Both have the same rows.
  friend double commonArea(const RowSpans& a, const RowSpans& b);

 private:
  static constexpr int kRows = 64;

  struct Span {
    int row;
    double from, to;
  };

  void add(const double* triangle);
  void merge();

  double low_, height_;
  std::vector<Span> spans_;  ///< by row, then from left to right, disjoint
};

double commonArea(const RowSpans& a, const RowSpans& b);

}  // namespace abflat
