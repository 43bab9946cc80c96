#include <algorithm>
#include <cmath>

#include "solve/cholesky/cholesky.h"

namespace abflat {
namespace {

/// Adds the columns [begin, end) of a child's update matrix to the parent. `target(j)` is the
/// column of the parent's front, shifted so that it can be indexed by rows of the front.
template <typename Scalar, typename Target>
void extendAdd(const Scalar* update, std::size_t size, const std::uint32_t* row, std::size_t begin,
               std::size_t end, Target&& target) {
  for (std::size_t j = begin; j < end; ++j) {
    Scalar* const to = target(row[j]);
    const Scalar* const from = update + j * size;
    for (std::size_t i = j; i < size; ++i) to[row[i]] += from[i];
  }
}

/// The two stacks of update matrices, and what a thread needs besides.
template <typename Scalar>
struct Workspace {
  LargeBuffer<Scalar> stack[2], front;
  std::size_t used[2] = {0, 0};

  explicit Workspace(const CholeskySymbolic& s)
      : stack{largeBuffer<Scalar>(s.stackSize[0]), largeBuffer<Scalar>(s.stackSize[1])},
        front(largeBuffer<Scalar>(frontWorkspace(s.maxFrontRows))) {}
};

}  // namespace

template <typename Scalar>
void BasicCholesky<Scalar>::allocate() {
  const CholeskySymbolic& s = *symbolic_;
  if (factor_) return;
  sign_ = largeBuffer<Scalar>(s.size);
  leastPivot_ = largeBuffer<Scalar>(s.size);
  factor_ = largeBuffer<Scalar>(s.panelBegin.back());
}

template <typename Scalar>
void BasicCholesky<Scalar>::assemble(std::uint32_t p, const double* values) {
  const CholeskySymbolic& s = *symbolic_;
  Scalar* const panel = factor_.get() + s.panelBegin[p];
  std::fill(panel, factor_.get() + s.panelBegin[p + 1], Scalar{0});
  for (std::size_t i = s.entriesBegin[p]; i < s.entriesBegin[p + 1]; ++i)
    panel[s.entries[i].target] += static_cast<Scalar>(values[s.entries[i].source]);
  const std::size_t rows = s.columns(p) + s.rowsBelow(p);
  for (std::uint32_t j = 0; j < s.columns(p); ++j)
    leastPivot_[s.firstColumn[p] + j] =
        static_cast<Scalar>(options_.pivotTolerance) * std::abs(panel[j * (rows + 1)]);
}

template <typename Scalar>
CholeskyStatus BasicCholesky<Scalar>::failure(std::uint32_t p, const PivotFailure& f) const {
  const auto column = static_cast<std::uint32_t>(symbolic_->firstColumn[p] + f.column);
  const std::vector<std::uint32_t>& place = symbolic_->place;
  CholeskyStatus status;
  status.column =
      static_cast<std::uint32_t>(std::find(place.begin(), place.end(), column) - place.begin());
  status.pivot = f.value;
  status.code = !std::isfinite(f.value) ? CholeskyStatus::Code::NotFinite
                : f.value < 0 && -f.value > leastPivot_[column]
                    ? CholeskyStatus::Code::NegativePivot
                    : CholeskyStatus::Code::ZeroPivot;
  return status;
}

template <typename Scalar>
CholeskyStatus BasicCholesky<Scalar>::factorize(const double* values) {
  const CholeskySymbolic& s = *symbolic_;
  allocate();
  Workspace<Scalar> work(s);
  std::vector<std::uint32_t> children;  // finished supernodes without parent yet; a stack
  for (std::uint32_t p = 0; p < s.supernodes(); ++p) {
    assemble(p, values);
    const std::size_t columns = s.columns(p), below = s.rowsBelow(p), rows = columns + below;
    Scalar* const panel = factor_.get() + s.panelBegin[p];
    const unsigned own = s.stack[p], theirs = !own;
    Scalar* const update = work.stack[own].get() + work.used[own];
    work.used[own] += below * below;

    std::size_t first = children.size();
    std::size_t childrenSize = 0;
    while (first > 0 && s.parent[children[first - 1]] == p)
      childrenSize +=
          std::size_t{s.rowsBelow(children[first - 1])} * s.rowsBelow(children[first - 1]),
          --first;
    const Scalar* const begin = work.stack[theirs].get() + work.used[theirs] - childrenSize;
    const auto addChildren = [&](bool toPanel) {
      const Scalar* from = begin;
      for (std::size_t i = first; i < children.size(); ++i) {
        const std::uint32_t c = children[i];
        const std::size_t size = s.rowsBelow(c);
        const std::uint32_t* row = s.inParent.data() + s.rowsBegin[c];
        const auto split =
            static_cast<std::size_t>(std::lower_bound(row, row + size, columns) - row);
        if (toPanel)
          extendAdd(from, size, row, 0, split, [&](std::uint32_t j) { return panel + j * rows; });
        else
          extendAdd(from, size, row, split, size, [&](std::uint32_t j) {
            return update + static_cast<std::ptrdiff_t>((j - columns) * below) -
                   static_cast<std::ptrdiff_t>(columns);
          });
        from += size * size;
      }
    };
    addChildren(true);
    const Front<Scalar> front{rows,
                              columns,
                              panel,
                              update,
                              sign_.get() + s.firstColumn[p],
                              leastPivot_.get() + s.firstColumn[p],
                              options_.allowNegative,
                              work.front.get()};
    const PivotFailure failed = factorFront(front, options_.simd);
    if (failed.column < columns) return failure(p, failed);
    addChildren(false);
    work.used[theirs] -= childrenSize;
    children.resize(first);
    if (s.parent[p] != kNoParent) children.push_back(p);
  }
  negativePivots_ = static_cast<std::uint32_t>(
      std::count_if(sign_.get(), sign_.get() + s.size, [](Scalar x) { return x < 0; }));
  return {};
}

template class BasicCholesky<float>;
template class BasicCholesky<double>;

}  // namespace abflat
