#include "islands/row_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// Where an edge crosses a row; the same in both directions.
double crossingOf(const double* a, const double* b, double v) {
  if (a[1] > b[1]) std::swap(a, b);
  return a[0] + (b[0] - a[0]) * ((v - a[1]) / (b[1] - a[1]));
}

}  // namespace

RowSpans::RowSpans(double low, double high) : low_(low), height_((high - low) / kRows) {}

void RowSpans::cover(const double* triangles, std::size_t count) {
  if (!(height_ > 0)) return;
  for (std::size_t i = 0; i < count; ++i) add(triangles + 6 * i);
  merge();
}

void RowSpans::add(const double* t) {
  const auto [least, most] = std::minmax({t[1], t[3], t[5]});
  const auto rowAbove = [&](double v) {  // the first whose middle is not below
    return static_cast<int>(std::clamp(std::ceil((v - low_) / height_ - 0.5), 0.0, kRows * 1.0));
  };
  for (int row = rowAbove(least), end = rowAbove(most); row < end; ++row) {
    const double v = low_ + (row + 0.5) * height_;
    Span span{row, HUGE_VAL, -HUGE_VAL};
    for (std::size_t k = 0; k < 3; ++k) {
      const double *a = t + 2 * k, *b = t + 2 * ((k + 1) % 3);
      if ((a[1] <= v) == (b[1] <= v)) continue;
      const double u = crossingOf(a, b, v);
      span.from = std::min(span.from, u);
      span.to = std::max(span.to, u);
    }
    if (span.from < span.to) spans_.push_back(span);
  }
}

void RowSpans::merge() {
  sortStably(spans_, [](const Span& a, const Span& b) {
    return std::tie(a.row, a.from, a.to) < std::tie(b.row, b.from, b.to);
  });
  std::size_t kept = 0;
  for (const Span& span : spans_) {
    if (kept > 0 && spans_[kept - 1].row == span.row && span.from <= spans_[kept - 1].to)
      spans_[kept - 1].to = std::max(spans_[kept - 1].to, span.to);
    else
      spans_[kept++] = span;
  }
  spans_.resize(kept);
}

double RowSpans::area() const {
  double sum = 0;
  for (const Span& span : spans_) sum += span.to - span.from;
  return sum * height_;
}

double commonArea(const RowSpans& a, const RowSpans& b) {
  double sum = 0;
  for (auto i = a.spans_.begin(), j = b.spans_.begin();
       i != a.spans_.end() && j != b.spans_.end();) {
    if (i->row == j->row) sum += std::max(std::min(i->to, j->to) - std::max(i->from, j->from), 0.0);
    ++(std::tie(i->row, i->to) < std::tie(j->row, j->to) ? i : j);
  }
  return sum * a.height_;
}

}  // namespace abflat
