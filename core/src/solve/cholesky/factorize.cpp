#include <algorithm>
#include <atomic>
#include <cmath>

#include "solve/cholesky/cholesky.h"
#include "solve/cholesky/front_kernel.h"
#include "solve/cholesky/run_tasks.h"

namespace abflat {
namespace {

/// A finished supernode and its update matrix.
template <typename Scalar>
struct Child {
  std::uint32_t supernode;
  const Scalar* update;
};

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

/// Work space of a thread for one task: the two stacks of update matrices within it.
template <typename Scalar>
struct Workspace {
  LargeBuffer<Scalar> stack[2], front;

  explicit Workspace(const CholeskySymbolic& s)
      : stack{largeBuffer<Scalar>(s.tasks.stackSize[0]), largeBuffer<Scalar>(s.tasks.stackSize[1])},
        front(largeBuffer<Scalar>(frontWorkspace(s.maxFrontRows))) {}
};

}  // namespace

/// One factorisation in progress.
template <typename Scalar>
class BasicCholesky<Scalar>::Factorization {
 public:
  Factorization(BasicCholesky& owner, const double* values)
      : owner_(owner),
        s_(*owner.symbolic_),
        values_(values),
        result_(s_.tasks.all.size()),
        failedAt_(s_.supernodes()) {}

  CholeskyStatus run() {
    runUpwards(owner_.options_.pool, s_.tasks.all, [this](std::uint32_t t) { runTask(t); });
    const std::uint32_t p = failedAt_;
    return p == s_.supernodes() ? CholeskyStatus{} : owner_.failure(p, failure_);
  }

 private:
  void runTask(std::uint32_t t) {
    const CholeskyTask& task = s_.tasks.all[t];
    // Tasks before a failure go on, because the first failure counts.
    if (failedAt_ < task.begin) return;
    std::unique_ptr<Workspace<Scalar>> work = spares_.take();
    if (!work) work = std::make_unique<Workspace<Scalar>>(s_);
    result_[t] = largeBuffer<Scalar>(task.result);
    if (task.firstChild != kNoParent)
      eliminateLarge(t, *work);
    else
      eliminateSubtrees(task, result_[t].get(), *work);
    spares_.give(std::move(work));
  }

  /// A supernode whose children are tasks of their own.
  void eliminateLarge(std::uint32_t t, Workspace<Scalar>& work) {
    const CholeskyTask& task = s_.tasks.all[t];
    const std::uint32_t p = task.begin;
    std::vector<Child<Scalar>> children;
    for (std::uint32_t c = task.firstChild; c != kNoParent; c = s_.tasks.all[c].nextSibling) {
      const Scalar* update = result_[c].get();
      for (std::uint32_t s = s_.tasks.all[c].begin; s < s_.tasks.all[c].end; ++s) {
        if (s_.parent[s] != p) continue;
        children.push_back({s, update});
        update += updateSize(s);
      }
    }
    eliminate(p, children.data(), children.size(), result_[t].get(), work, owner_.options_.pool);
    for (std::uint32_t c = task.firstChild; c != kNoParent; c = s_.tasks.all[c].nextSibling)
      result_[c].reset();
  }

  void eliminateSubtrees(const CholeskyTask& task, Scalar* result, Workspace<Scalar>& work) {
    std::size_t used[2] = {0, 0};
    std::vector<Child<Scalar>> children;  // finished supernodes without parent yet; a stack
    for (std::uint32_t p = task.begin; p < task.end; ++p) {
      std::size_t first = children.size(), childrenSize = 0;
      while (first > 0 && s_.parent[children[first - 1].supernode] == p)
        childrenSize += updateSize(children[--first].supernode);
      const bool isRoot = s_.parent[p] >= task.end;
      const unsigned own = s_.stack[p];
      Scalar* const update = isRoot ? result : work.stack[own].get() + used[own];
      if (isRoot)
        result += updateSize(p);
      else
        used[own] += updateSize(p);
      if (!eliminate(p, children.data() + first, children.size() - first, update, work, nullptr))
        return;
      used[!own] -= childrenSize;
      children.resize(first);
      if (!isRoot) children.push_back({p, update});
    }
  }

  std::size_t updateSize(std::uint32_t p) const {
    return std::size_t{s_.rowsBelow(p)} * s_.rowsBelow(p);
  }

  /// Eliminates one front. False if a pivot fails.
  bool eliminate(std::uint32_t p, const Child<Scalar>* children, std::size_t childCount,
                 Scalar* update, Workspace<Scalar>& work, ThreadPool* pool) {
    const std::size_t columns = s_.columns(p), below = s_.rowsBelow(p), rows = columns + below;
    Scalar* const panel = owner_.factor_.get() + s_.panelBegin[p];
    owner_.assemble(p, values_, pool);
    // Shifted, so that it can be indexed by rows of the front.
    Scalar* const shifted = update - static_cast<std::ptrdiff_t>(columns);
    const auto addChildren = [&](bool toPanel) {
      for (std::size_t i = 0; i < childCount; ++i) {
        const std::uint32_t c = children[i].supernode;
        const std::size_t size = s_.rowsBelow(c);
        const std::uint32_t* row = s_.inParent.data() + s_.rowsBegin[c];
        const auto split =
            static_cast<std::size_t>(std::lower_bound(row, row + size, columns) - row);
        const std::size_t first = toPanel ? 0 : split, count = toPanel ? split : size - split;
        parallelRanges(
            pool, count, kNumbersPerPiece / (size + 1) + 1, [&](std::size_t a, std::size_t b) {
              if (toPanel)
                extendAdd(children[i].update, size, row, first + a, first + b,
                          [&](std::uint32_t j) { return panel + j * rows; });
              else
                extendAdd(children[i].update, size, row, first + a, first + b,
                          [&](std::uint32_t j) { return shifted + (j - columns) * below; });
            });
      }
    };
    addChildren(true);
    const Front<Scalar> front{rows,
                              columns,
                              panel,
                              update,
                              owner_.sign_.get() + s_.firstColumn[p],
                              owner_.leastPivot_.get() + s_.firstColumn[p],
                              owner_.options_.allowNegative,
                              work.front.get(),
                              pool};
    const PivotFailure failed = factorFront(front, owner_.options_.simd);
    if (failed.column < columns) {
      reportFailure(p, failed);
      return false;
    }
    addChildren(false);
    beat(owner_.options_.pool, rows * rows * columns / kMultipliesPerStep + rows);
    return true;
  }

  void reportFailure(std::uint32_t p, const PivotFailure& failure) {
    const SharedLock lock(mutex_);
    if (p >= failedAt_) return;
    failedAt_ = p;
    failure_ = failure;
  }

  BasicCholesky& owner_;
  const CholeskySymbolic& s_;
  const double* values_;
  std::vector<LargeBuffer<Scalar>> result_;  ///< per task: its roots' update matrices
  Spares<Workspace<Scalar>> spares_;
  SharedMutex mutex_;
  std::atomic<std::uint32_t> failedAt_;  ///< the first supernode that failed
  PivotFailure failure_{};
};

template <typename Scalar>
void BasicCholesky<Scalar>::allocate() {
  const CholeskySymbolic& s = *symbolic_;
  if (factor_) return;
  sign_ = largeBuffer<Scalar>(s.size);
  leastPivot_ = largeBuffer<Scalar>(s.size);
  factor_ = largeBuffer<Scalar>(s.panelBegin.back());
}

template <typename Scalar>
void BasicCholesky<Scalar>::assemble(std::uint32_t p, const double* values, ThreadPool* pool) {
  const CholeskySymbolic& s = *symbolic_;
  Scalar* const panel = factor_.get() + s.panelBegin[p];
  parallelRanges(pool, s.panelBegin[p + 1] - s.panelBegin[p], kNumbersPerPiece,
                 [&](std::size_t a, std::size_t b) { std::fill(panel + a, panel + b, Scalar{0}); });
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
  const std::vector<std::uint32_t>& place = symbolic_->eliminationRank;
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
  allocate();
  const CholeskyStatus status = Factorization(*this, values).run();
  if (!status.isOk()) return status;
  Scalar* const end = sign_.get() + symbolic_->size;
  negativePivots_ =
      static_cast<std::uint32_t>(std::count_if(sign_.get(), end, [](Scalar x) { return x < 0; }));
  return status;
}

template class BasicCholesky<float>;
template class BasicCholesky<double>;

}  // namespace abflat
