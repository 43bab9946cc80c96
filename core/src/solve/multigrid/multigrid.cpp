#include "solve/multigrid/multigrid.h"

#include <algorithm>

#include "solve/multigrid/aggregation.h"
#include "solve/multigrid/galerkin.h"

namespace abflat {
namespace {

/// Coarse levels with more than this share of the rows are not worth it.
constexpr double kSlowCoarsening = 0.9;

/// (D + L) x = b. `work` is overwritten.
void sweepFromZero(const HalfMatrix& a, const std::vector<double>& inverse, const double* b,
                   double* x, std::vector<double>& work) {
  std::copy_n(b, a.rows, work.begin());
  for (std::uint32_t i = 0; i < a.rows; ++i) {
    const double xi = x[i] = work[i] * inverse[i];
    a.forEachRight(i, [&](std::uint32_t j, double value) { work[j] -= value * xi; });
  }
}

/// coarse = P' (b - A x) after sweepFromZero, which leaves the residual -U x.
void restrictResidual(const HalfMatrix& a, const CompressedRows& p, const double* x,
                      std::vector<double>& coarse) {
  std::fill(coarse.begin(), coarse.end(), 0.0);
  for (std::uint32_t i = 0; i < a.rows; ++i) {
    double residual = 0;
    a.forEachRight(i, [&](std::uint32_t j, double value) { residual -= value * x[j]; });
    p.forEach(i, [&](std::uint32_t j, double weight) { coarse[j] += weight * residual; });
  }
}

/// x += P coarse, work = b - L x.
void prolongate(const HalfMatrix& a, const CompressedRows& p, const std::vector<double>& coarse,
                const double* b, double* x, std::vector<double>& work) {
  std::copy_n(b, a.rows, work.begin());
  for (std::uint32_t i = 0; i < a.rows; ++i) {
    double xi = x[i];
    p.forEach(i, [&](std::uint32_t j, double weight) { xi += weight * coarse[j]; });
    x[i] = xi;
    a.forEachRight(i, [&](std::uint32_t j, double value) { work[j] -= value * xi; });
  }
}

/// (D + U) x = work, the backward sweep.
void sweepBack(const HalfMatrix& a, const std::vector<double>& inverse,
               const std::vector<double>& work, double* x) {
  for (std::uint32_t i = a.rows; i-- > 0;) {
    double sum = work[i];
    a.forEachRight(i, [&](std::uint32_t j, double value) { sum -= value * x[j]; });
    x[i] = sum * inverse[i];
  }
}

template <typename T>
std::uint64_t bytesOf(const std::vector<T>& v) {
  return sizeof(T) * v.capacity();
}

}  // namespace

Multigrid::Multigrid(std::vector<std::uint8_t> kind, MultigridOptions options)
    : kind_(std::move(kind)), options_(options) {}

bool Multigrid::prepareLevel(Level& level) const {
  const HalfMatrix& a = level.matrix;
  level.inverse.resize(a.rows);
  level.work.resize(a.rows);
  for (std::uint32_t i = 0; i < a.rows; ++i) {
    if (!(a.diagonal(i) > 0)) return false;
    level.inverse[i] = 1 / a.diagonal(i);
  }
  return true;
}

bool Multigrid::factorCoarsest(const HalfMatrix& matrix) {
  if (matrix.rows > options_.coarsestRows) return true;
  CholeskyOptions options;
  options.allowNegative = false;
  coarsest_ = std::make_unique<Cholesky>(std::make_shared<const CholeskySymbolic>(analyzePattern(
                                             {matrix.rows, matrix.start, matrix.column})),
                                         options);
  return coarsest_->factorize(matrix.value).isOk();
}

bool Multigrid::setup(const HalfMatrix& matrix) {
  levels_.clear();
  coarsest_.reset();
  levels_.emplace_back().matrix = matrix;
  std::vector<std::uint8_t> kind = kind_;
  for (;;) {
    Level& fine = levels_.back();
    if (!prepareLevel(fine)) return false;
    const HalfMatrix a = fine.matrix;
    if (a.rows <= options_.coarsestRows) return factorCoarsest(a);
    const StrongGraph graph = strongGraph(a, kind, options_.strongShare);
    const Aggregates aggregates = aggregate(graph, kind);
    if (aggregates.count() == 0 || aggregates.count() > kSlowCoarsening * a.rows) return true;
    fine.prolongation = smoothedProlongation(graph, aggregates);
    Level coarse;
    coarse.owned = galerkinProduct(a, fine.prolongation, aggregates.count());
    coarse.matrix = coarse.owned.asHalf();
    coarse.x.resize(aggregates.count());
    coarse.b.resize(aggregates.count());
    kind = aggregates.kind;
    levels_.push_back(std::move(coarse));
  }
}

void Multigrid::cycle(std::size_t l, const double* b, double* x) const {
  const Level& level = levels_[l];
  const HalfMatrix& a = level.matrix;
  if (l + 1 == levels_.size() && coarsest_) {
    std::copy_n(b, a.rows, x);
    coarsest_->solve(x);
    return;
  }
  sweepFromZero(a, level.inverse, b, x, level.work);
  if (l + 1 == levels_.size()) {
    prolongate(a, {std::vector<int>(a.rows + 1, 0), {}, {}}, {}, b, x, level.work);
  } else {
    const Level& coarse = levels_[l + 1];
    restrictResidual(a, level.prolongation, x, coarse.b);
    cycle(l + 1, coarse.b.data(), coarse.x.data());
    prolongate(a, level.prolongation, coarse.x, b, x, level.work);
  }
  sweepBack(a, level.inverse, level.work, x);
}

void Multigrid::apply(const double* r, double* z) const { cycle(0, r, z); }

double Multigrid::complexity() const {
  double entries = 0;
  for (const Level& l : levels_) entries += l.matrix.start[l.matrix.rows];
  const HalfMatrix& finest = levels_.front().matrix;
  return entries / std::max(1, finest.start[finest.rows]);
}

std::uint64_t Multigrid::bytes() const {
  std::uint64_t sum = bytesOf(kind_);
  for (const Level& l : levels_)
    sum += l.owned.bytes() + l.prolongation.bytes() + bytesOf(l.inverse) + bytesOf(l.work) +
           bytesOf(l.x) + bytesOf(l.b);
  if (coarsest_) sum += coarsest_->symbolic().factorBytes();
  return sum;
}

}  // namespace abflat
