#include "solve/multigrid/galerkin.h"

#include <algorithm>

namespace abflat {
namespace {

/// One row of a product, gathered entry by entry.
class SparseRow {
 public:
  explicit SparseRow(std::uint32_t size) : value_(size, 0), isThere_(size, 0) {}

  void add(std::uint32_t j, double value) {
    if (!isThere_[j]) {
      isThere_[j] = 1;
      columns_.push_back(j);
    }
    value_[j] += value;
  }

  /// visit(j, value) in the order of the first additions; the row is empty afterwards.
  template <typename Visit>
  void drain(Visit&& visit) {
    for (const std::uint32_t j : columns_) {
      visit(j, value_[j]);
      value_[j] = 0;
      isThere_[j] = 0;
    }
    columns_.clear();
  }

  void sort() { std::sort(columns_.begin(), columns_.end()); }

 private:
  std::vector<double> value_;
  std::vector<std::uint8_t> isThere_;
  std::vector<std::uint32_t> columns_;
};

/// C = P' H P, where A = H + H'.
CompressedRows halfProduct(const HalfMatrix& a, const CompressedRows& p, std::uint32_t columns) {
  const CompressedRows restriction = transposed(p, columns);
  SparseRow inner(a.rows), outer(columns);
  CompressedRows c;
  c.start.reserve(columns + 1);
  for (std::uint32_t row = 0; row < columns; ++row) {
    restriction.forEach(row, [&](std::uint32_t i, double weight) {
      inner.add(i, 0.5 * weight * a.diagonal(i));
      a.forEachRight(i, [&](std::uint32_t j, double value) { inner.add(j, weight * value); });
    });
    inner.drain([&](std::uint32_t j, double value) {
      p.forEach(j, [&](std::uint32_t coarse, double weight) { outer.add(coarse, value * weight); });
    });
    outer.drain([&](std::uint32_t coarse, double value) { c.push(coarse, value); });
    c.endRow();
  }
  return c;
}

}  // namespace

CompressedRows transposed(const CompressedRows& m, std::uint32_t columns) {
  CompressedRows t;
  t.start.assign(columns + 1, 0);
  for (const int j : m.column) ++t.start[static_cast<std::size_t>(j) + 1];
  for (std::uint32_t j = 0; j < columns; ++j) t.start[j + 1] += t.start[j];
  t.column.resize(m.column.size());
  t.value.resize(m.value.size());
  std::vector<int> next(t.start.begin(), t.start.end() - 1);
  for (std::uint32_t i = 0; i < m.rows(); ++i)
    m.forEach(i, [&](std::uint32_t j, double value) {
      t.column[next[j]] = static_cast<int>(i);
      t.value[next[j]++] = value;
    });
  return t;
}

CompressedRows galerkinProduct(const HalfMatrix& a, const CompressedRows& p,
                               std::uint32_t columns) {
  const CompressedRows c = halfProduct(a, p, columns), ct = transposed(c, columns);
  SparseRow sum(columns);
  CompressedRows out;
  out.start.reserve(columns + 1);
  out.column.reserve(c.column.size());
  out.value.reserve(c.column.size());
  for (std::uint32_t row = 0; row < columns; ++row) {
    sum.add(row, 0);
    const auto add = [&](std::uint32_t j, double value) {
      if (j >= row) sum.add(j, value);
    };
    c.forEach(row, add);
    ct.forEach(row, add);
    sum.sort();
    sum.drain([&](std::uint32_t j, double value) { out.push(j, value); });
    out.endRow();
  }
  return out;
}

}  // namespace abflat
