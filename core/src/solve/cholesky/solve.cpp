#include <algorithm>

#include "solve/cholesky/cholesky.h"
#include "solve/cholesky/run_tasks.h"

namespace abflat {
namespace {

/// Columns of the factor that are read together, so that the right-hand side is read once for them.
constexpr std::size_t kTogether = 4;
/// Right-hand sides that pass through the factor together.
constexpr std::size_t kMaxSides = 8;

/// Always sixteen bytes, so that sums are the same on every machine.
template <typename Scalar>
struct Lanes {
  static constexpr std::size_t kCount = 16 / sizeof(Scalar);
  // NOLINTNEXTLINE(modernize-use-using): the attributes need a typedef
  typedef Scalar Vector __attribute__((vector_size(16), aligned(sizeof(Scalar)), may_alias));
};

/// x[i] -= sum over the N columns l of l[i] value
template <std::size_t N, typename Scalar>
void subtractColumns(const Scalar* l, std::size_t stride, const Scalar* value, std::size_t begin,
                     std::size_t end, Scalar* __restrict x) {
  for (std::size_t i = begin; i < end; ++i) {
    Scalar sum = l[i] * value[0];
    for (std::size_t k = 1; k < N; ++k) sum += l[k * stride + i] * value[k];
    x[i] -= sum;
  }
}

/// sum[k] = sum over i of l[i] x[i] for each of N columns l
template <std::size_t N, typename Scalar>
void multiplyColumns(const Scalar* l, std::size_t stride, std::size_t begin, std::size_t end,
                     const Scalar* x, Scalar* sum) {
  using Vector = typename Lanes<Scalar>::Vector;
  constexpr std::size_t kCount = Lanes<Scalar>::kCount;
  Vector lanes[N] = {};
  std::size_t i = begin;
  for (; i + kCount <= end; i += kCount)
    for (std::size_t k = 0; k < N; ++k)
      lanes[k] += *reinterpret_cast<const Vector*>(l + k * stride + i) *
                  *reinterpret_cast<const Vector*>(x + i);
  for (std::size_t k = 0; k < N; ++k) {
    sum[k] = 0;
    for (std::size_t n = 0; n < kCount; ++n) sum[k] += lanes[k][n];
    for (std::size_t rest = i; rest < end; ++rest) sum[k] += l[k * stride + rest] * x[rest];
  }
}

/// One supernode: its panel and the part of the right-hand sides that it sees, `rows` for each.
template <typename Scalar>
struct Panel {
  const Scalar* at;
  std::size_t rows, columns;
  const Scalar* sign;

  const Scalar* column(std::size_t j) const { return at + j * rows; }

  /// Columns j to j + N.
  template <std::size_t N>
  void forward(std::size_t j, Scalar* x) const {
    const Scalar* l = column(j);
    Scalar value[N];
    for (std::size_t k = 0; k < N; ++k) {
      value[k] = x[j + k] /= l[k * rows + j + k];
      for (std::size_t i = k + 1; i < N; ++i) x[j + i] -= l[k * rows + j + i] * value[k];
    }
    subtractColumns<N>(l, rows, value, j + N, rows, x);
  }

  template <std::size_t N>
  void backward(std::size_t j, Scalar* x) const {
    const Scalar* l = column(j);
    Scalar sum[N];
    multiplyColumns<N>(l, rows, j + N, rows, x, sum);
    for (std::size_t k = N; k-- > 0;) {
      for (std::size_t i = k + 1; i < N; ++i) sum[k] += l[k * rows + j + i] * x[j + i];
      x[j + k] = (x[j + k] * sign[j + k] - sum[k]) / l[k * rows + j + k];
    }
  }

  void forward(Scalar* x) const {
    std::size_t j = 0;
    for (; j + kTogether <= columns; j += kTogether) forward<kTogether>(j, x);
    for (; j < columns; ++j) forward<1>(j, x);
  }

  void backward(Scalar* x) const {
    std::size_t j = columns;
    for (; j % kTogether != 0; --j) backward<1>(j - 1, x);
    for (; j > 0; j -= kTogether) backward<kTogether>(j - kTogether, x);
  }
};

/// Right-hand sides in the order of the factor. What a subtree subtracts from the rows above it is
/// passed on from child to parent: tasks share no numbers, and the order of additions is that of
/// the tree.
template <typename Scalar>
class Substitution {
 public:
  Substitution(const CholeskySymbolic& s, const Scalar* factor, const Scalar* sign,
               std::size_t sides, ThreadPool* pool)
      : s_(s),
        factor_(factor),
        sign_(sign),
        sides_(sides),
        pool_(pool),
        x_(std::size_t{s.size} * sides),
        result_(s.tasks.all.size()) {}

  void run(double* b) {
    parallelRanges(pool_, x_.size(), kNumbersPerPiece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        x_[i / s_.size * s_.size + s_.eliminationRank[i % s_.size]] = static_cast<Scalar>(b[i]);
    });
    runUpwards(pool_, s_.tasks.all, [this](std::uint32_t t) { forwardTask(t); });
    runDownwards(pool_, s_.tasks.all, [this](std::uint32_t t) { backwardTask(t); });
    parallelRanges(pool_, x_.size(), kNumbersPerPiece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        b[i] = x_[i / s_.size * s_.size + s_.eliminationRank[i % s_.size]];
    });
  }

 private:
  using Numbers = std::vector<Scalar>;

  /// Finished supernodes and what they pass on, for each of them `sides_` times its rows: a stack.
  struct Waiting {
    std::vector<std::uint32_t> supernodes;
    Numbers numbers;
  };

  Panel<Scalar> panel(std::uint32_t p) const {
    return {factor_ + s_.panelBegin[p], std::size_t{s_.columns(p)} + s_.rowsBelow(p), s_.columns(p),
            sign_ + s_.firstColumn[p]};
  }

  void endStep(std::uint32_t p) const {
    constexpr std::size_t kPerStep = 256;  // multiplications
    beat(pool_, std::size_t{s_.columns(p)} * (s_.columns(p) + s_.rowsBelow(p)) / kPerStep + 1);
  }

  Waiting resultsOfChildren(const CholeskyTask& task) {
    Waiting waiting;
    for (std::uint32_t c = task.firstChild; c != kNoParent; c = s_.tasks.all[c].nextSibling) {
      const CholeskyTask& child = s_.tasks.all[c];
      for (std::uint32_t q = child.begin; q < child.end; ++q)
        if (s_.parent[q] == task.begin) waiting.supernodes.push_back(q);
      waiting.numbers.insert(waiting.numbers.end(), result_[c].begin(), result_[c].end());
      Numbers().swap(result_[c]);
    }
    return waiting;
  }

  void forwardTask(std::uint32_t t) {
    const CholeskyTask& task = s_.tasks.all[t];
    Waiting waiting = resultsOfChildren(task);
    Numbers local(s_.maxFrontRows * sides_);
    for (std::uint32_t p = task.begin; p < task.end; ++p) {
      forward(p, waiting, local);
      endStep(p);
    }
    result_[t] = std::move(waiting.numbers);
  }

  void forward(std::uint32_t p, Waiting& waiting, Numbers& local) {
    const Panel<Scalar> at = panel(p);
    std::vector<std::uint32_t>& children = waiting.supernodes;
    std::size_t first = children.size(), length = 0;
    while (first > 0 && s_.parent[children[first - 1]] == p)
      length += s_.rowsBelow(children[--first]) * sides_;
    for (std::size_t r = 0; r < sides_; ++r) {
      Scalar* const front = &local[r * at.rows];
      std::copy_n(&x_[r * s_.size + s_.firstColumn[p]], at.columns, front);
      std::fill(front + at.columns, front + at.rows, Scalar{0});
    }
    const Scalar* from = waiting.numbers.data() + waiting.numbers.size() - length;
    for (std::size_t i = first; i < children.size(); ++i) {
      const std::uint32_t* row = s_.inParent.data() + s_.rowsBegin[children[i]];
      const std::size_t size = s_.rowsBelow(children[i]);
      for (std::size_t r = 0; r < sides_; ++r, from += size)
        for (std::size_t k = 0; k < size; ++k) local[r * at.rows + row[k]] += from[k];
    }
    children.resize(first);
    waiting.numbers.resize(waiting.numbers.size() - length);
    const bool isRoot = s_.parent[p] == kNoParent;
    for (std::size_t r = 0; r < sides_; ++r) {
      const Scalar* const front = &local[r * at.rows];
      at.forward(&local[r * at.rows]);
      std::copy_n(front, at.columns, &x_[r * s_.size + s_.firstColumn[p]]);
      if (!isRoot)
        waiting.numbers.insert(waiting.numbers.end(), front + at.columns, front + at.rows);
    }
    if (!isRoot) children.push_back(p);
  }

  void backwardTask(std::uint32_t t) {
    const CholeskyTask& task = s_.tasks.all[t];
    Numbers local(s_.maxFrontRows);
    for (std::uint32_t p = task.end; p-- > task.begin;) {
      const Panel<Scalar> at = panel(p);
      const std::uint32_t* row = s_.rows.data() + s_.rowsBegin[p];
      for (std::size_t r = 0; r < sides_; ++r) {
        Scalar* const x = &x_[r * s_.size];
        std::copy_n(x + s_.firstColumn[p], at.columns, local.data());
        for (std::size_t i = at.columns; i < at.rows; ++i) local[i] = x[row[i - at.columns]];
        at.backward(local.data());
        std::copy_n(local.data(), at.columns, x + s_.firstColumn[p]);
      }
      endStep(p);
    }
  }

  const CholeskySymbolic& s_;
  const Scalar* factor_;
  const Scalar* sign_;
  std::size_t sides_;
  ThreadPool* pool_;
  Numbers x_;
  std::vector<Numbers> result_;  ///< per task: what its roots pass on
};

}  // namespace

template <typename Scalar>
void BasicCholesky<Scalar>::solve(double* b, std::size_t columns) const {
  for (std::size_t done = 0; done < columns; done += kMaxSides)
    Substitution<Scalar>(*symbolic_, factor_.get(), sign_.get(),
                         std::min(kMaxSides, columns - done), options_.pool)
        .run(b + done * symbolic_->size);
}

template void BasicCholesky<float>::solve(double* b, std::size_t columns) const;
template void BasicCholesky<double>::solve(double* b, std::size_t columns) const;

}  // namespace abflat
