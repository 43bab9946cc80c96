#include <algorithm>

#include "solve/cholesky/cholesky.h"
#include "solve/cholesky/run_tasks.h"

namespace abflat {
namespace {

/// Right-hand sides that pass through the factor together. The entries of a row lie side by side.
constexpr std::size_t kTogether = 4;
/// Rows that are copied as one piece of work.
constexpr std::size_t kGrain = 1 << 15;

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

/// Substitution with R right-hand sides, whose entries of a row lie side by side in x. What a
/// subtree takes from the rows above it is passed on from child to parent: tasks share no numbers,
/// and the order of additions is that of the tree.
template <std::size_t R>
class Substitution {
 public:
  Substitution(const CholeskySymbolic& s, const double* factor, const double* sign,
               ThreadPool* pool)
      : s_(s),
        factor_(factor),
        sign_(sign),
        pool_(pool),
        x_(std::size_t{s.size} * R),
        result_(s.tasks.all.size()) {}

  void run(double* b) {
    parallelRanges(pool_, s_.size, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t r = 0; r < R; ++r) x_[s_.place[i] * R + r] = b[r * s_.size + i];
    });
    runUpwards(pool_, s_.tasks.all, [this](std::uint32_t t) { forwardTask(t); });
    runDownwards(pool_, s_.tasks.all, [this](std::uint32_t t) { backwardTask(t); });
    parallelRanges(pool_, s_.size, kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t r = 0; r < R; ++r) b[r * s_.size + i] = x_[s_.place[i] * R + r];
    });
  }

 private:
  using Numbers = std::vector<double>;

  /// Adds to the parent p of c what c and its subtree take from p's front.
  void passOn(std::uint32_t c, std::uint32_t p, const double* from, double* below) {
    double* const own = &x_[s_.firstColumn[p] * R];
    const std::uint32_t* row = s_.inParent.data() + s_.rowsBegin[c];
    const std::size_t columns = s_.columns(p), size = s_.rowsBelow(c);
    std::size_t i = 0;
    for (; i < size && row[i] < columns; ++i)
      for (std::size_t r = 0; r < R; ++r) own[row[i] * R + r] += from[i * R + r];
    for (; i < size; ++i)
      for (std::size_t r = 0; r < R; ++r) below[(row[i] - columns) * R + r] += from[i * R + r];
  }

  void forwardTask(std::uint32_t t) {
    const CholeskyTask& task = s_.tasks.all[t];
    Numbers waiting;  // a stack of what finished supernodes pass on
    std::vector<std::uint32_t> children;
    if (task.firstChild != kNoParent) {
      for (std::uint32_t c = task.firstChild; c != kNoParent; c = s_.tasks.all[c].nextSibling) {
        const CholeskyTask& child = s_.tasks.all[c];
        for (std::uint32_t q = child.begin; q < child.end; ++q)
          if (s_.parent[q] == task.begin) children.push_back(q);
        waiting.insert(waiting.end(), result_[c].begin(), result_[c].end());
        Numbers().swap(result_[c]);
      }
    }
    Numbers below(std::size_t{s_.maxFrontRows} * R);
    for (std::uint32_t p = task.begin; p < task.end; ++p) {
      const std::size_t columns = s_.columns(p), size = s_.rowsBelow(p);
      std::fill_n(below.begin(), size * R, 0.0);
      std::size_t first = children.size(), length = 0;
      while (first > 0 && s_.parent[children[first - 1]] == p)
        length += std::size_t{s_.rowsBelow(children[--first])} * R;
      const double* from = waiting.data() + waiting.size() - length;
      for (std::size_t i = first; i < children.size(); ++i) {
        passOn(children[i], p, from, below.data());
        from += std::size_t{s_.rowsBelow(children[i])} * R;
      }
      children.resize(first);
      waiting.resize(waiting.size() - length);
      forward<R>(factor_ + s_.panelBegin[p], columns + size, columns, &x_[s_.firstColumn[p] * R],
                 below.data());
      if (s_.parent[p] == kNoParent) continue;
      children.push_back(p);
      waiting.insert(waiting.end(), below.begin(),
                     below.begin() + static_cast<std::ptrdiff_t>(size * R));
    }
    result_[t] = std::move(waiting);
  }

  void backwardTask(std::uint32_t t) {
    const CholeskyTask& task = s_.tasks.all[t];
    Numbers below(std::size_t{s_.maxFrontRows} * R);
    for (std::uint32_t p = task.end; p-- > task.begin;) {
      const std::uint32_t* row = s_.rows.data() + s_.rowsBegin[p];
      const std::size_t columns = s_.columns(p), size = s_.rowsBelow(p);
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t r = 0; r < R; ++r) below[i * R + r] = x_[row[i] * R + r];
      backward<R>(factor_ + s_.panelBegin[p], columns + size, columns, sign_ + s_.firstColumn[p],
                  &x_[s_.firstColumn[p] * R], below.data());
    }
  }

  const CholeskySymbolic& s_;
  const double* factor_;
  const double* sign_;
  ThreadPool* pool_;
  Numbers x_;
  std::vector<Numbers> result_;  ///< per task: what its roots pass on
};

}  // namespace

void Cholesky::solve(double* b, std::size_t columns) const {
  const CholeskySymbolic& s = *symbolic_;
  for (; columns >= kTogether; columns -= kTogether, b += kTogether * s.size)
    Substitution<kTogether>(s, factor_.get(), sign_.get(), options_.pool).run(b);
  for (; columns >= 2; columns -= 2, b += std::size_t{2} * s.size)
    Substitution<2>(s, factor_.get(), sign_.get(), options_.pool).run(b);
  if (columns == 1) Substitution<1>(s, factor_.get(), sign_.get(), options_.pool).run(b);
}

}  // namespace abflat
