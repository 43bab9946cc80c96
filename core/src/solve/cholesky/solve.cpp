#include <algorithm>

#include "solve/cholesky/cholesky.h"

namespace abflat {
namespace {

/// Right-hand sides that pass through the factor together. The entries of a row lie side by side.
constexpr std::size_t kTogether = 4;

/// b -= L x for the rows below, where x are the solved columns; `below` is `size` x R.
template <std::size_t R>
void forward(const double* panel, std::size_t rows, std::size_t columns, double* x, double* below) {
  for (std::size_t j = 0; j < columns; ++j) {
    const double* l = panel + j * rows;
    double value[R];
    for (std::size_t r = 0; r < R; ++r) value[r] = x[j * R + r] /= l[j];
    for (std::size_t i = j + 1; i < columns; ++i)
      for (std::size_t r = 0; r < R; ++r) x[i * R + r] -= l[i] * value[r];
    l += columns;
    for (std::size_t i = 0; i < rows - columns; ++i)
      for (std::size_t r = 0; r < R; ++r) below[i * R + r] -= l[i] * value[r];
  }
}

template <std::size_t R>
void backward(const double* panel, std::size_t rows, std::size_t columns, const double* sign,
              double* x, const double* below) {
  for (std::size_t j = columns; j-- > 0;) {
    const double* l = panel + j * rows;
    // Two sums each, so that additions need not wait for one another.
    double even[R] = {}, odd[R] = {};
    const std::size_t size = rows - columns;
    std::size_t i = 0;
    for (; i + 1 < size; i += 2)
      for (std::size_t r = 0; r < R; ++r) {
        even[r] += l[columns + i] * below[i * R + r];
        odd[r] += l[columns + i + 1] * below[(i + 1) * R + r];
      }
    for (; i < size; ++i)
      for (std::size_t r = 0; r < R; ++r) even[r] += l[columns + i] * below[i * R + r];
    for (i = j + 1; i < columns; ++i)
      for (std::size_t r = 0; r < R; ++r) odd[r] += l[i] * x[i * R + r];
    for (std::size_t r = 0; r < R; ++r)
      x[j * R + r] = (x[j * R + r] * sign[j] - (even[r] + odd[r])) / l[j];
  }
}

template <std::size_t R>
void solveTogether(const CholeskySymbolic& s, const double* factor, const double* sign, double* b) {
  std::vector<double> x(std::size_t{s.size} * R), below(std::size_t{s.maxFrontRows} * R);
  for (std::size_t i = 0; i < s.size; ++i)
    for (std::size_t r = 0; r < R; ++r) x[s.place[i] * R + r] = b[r * s.size + i];
  for (std::uint32_t p = 0; p < s.supernodes(); ++p) {
    const std::uint32_t* row = s.rows.data() + s.rowsBegin[p];
    const std::size_t columns = s.columns(p), size = s.rowsBelow(p);
    std::fill(below.begin(), below.begin() + static_cast<std::ptrdiff_t>(size * R), 0.0);
    forward<R>(factor + s.panelBegin[p], columns + size, columns, &x[s.firstColumn[p] * R],
               below.data());
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t r = 0; r < R; ++r) x[row[i] * R + r] += below[i * R + r];
  }
  for (std::uint32_t p = s.supernodes(); p-- > 0;) {
    const std::uint32_t* row = s.rows.data() + s.rowsBegin[p];
    const std::size_t columns = s.columns(p), size = s.rowsBelow(p);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t r = 0; r < R; ++r) below[i * R + r] = x[row[i] * R + r];
    backward<R>(factor + s.panelBegin[p], columns + size, columns, sign + s.firstColumn[p],
                &x[s.firstColumn[p] * R], below.data());
  }
  for (std::size_t i = 0; i < s.size; ++i)
    for (std::size_t r = 0; r < R; ++r) b[r * s.size + i] = x[s.place[i] * R + r];
}

}  // namespace

void Cholesky::solve(double* b, std::size_t columns) const {
  const CholeskySymbolic& s = *symbolic_;
  for (; columns >= kTogether; columns -= kTogether, b += kTogether * s.size)
    solveTogether<kTogether>(s, factor_.get(), sign_.get(), b);
  for (; columns >= 2; columns -= 2, b += std::size_t{2} * s.size)
    solveTogether<2>(s, factor_.get(), sign_.get(), b);
  if (columns == 1) solveTogether<1>(s, factor_.get(), sign_.get(), b);
}

}  // namespace abflat
