#include "solve/conjugate_gradients.h"

#include <cmath>

#include "base/portable_math.h"

namespace abflat {
namespace {

/// Before this many steps the speed says little.
constexpr int kFirstSteps = 3;

/// Always sums in the same order; Eigen's order depends on the machine's vector width.
double orderedDot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double sum[4] = {};
  Eigen::Index i = 0;
  for (; i + 4 <= a.size(); i += 4)
    for (Eigen::Index k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
  for (; i < a.size(); ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Expected further iterations until `tolerance`, from the mean reduction so far.
double expectedIterations(const ConjugateGradientsResult& now, double first, double tolerance) {
  const double reduction = portable::log(first / now.residual) / now.iterations;
  return reduction > 0 ? portable::log(now.residual / tolerance) / reduction
                       : std::numeric_limits<double>::infinity();
}

}  // namespace

ConjugateGradientsResult conjugateGradients(const Eigen::SparseMatrix<double>& lower,
                                            const Eigen::VectorXd& b,
                                            const Preconditioner& preconditioner,
                                            Eigen::VectorXd& x,
                                            const ConjugateGradientsOptions& options) {
  using Code = ConjugateGradientsResult::Code;
  const auto a = lower.selfadjointView<Eigen::Lower>();
  ConjugateGradientsResult result;
  Eigen::VectorXd r = b, p, q(b.size()), z(b.size());
  if (!x.isZero(0)) r.noalias() -= a * x;
  double before = 0, first = 0;
  for (;; ++result.iterations) {
    result.residual = r.size() > 0 ? r.lpNorm<Eigen::Infinity>() : 0;
    if (result.residual <= options.tolerance) return result;
    if (result.iterations == options.maxIterations)
      return result.code = Code::TooManyIterations, result;
    if (result.iterations == 0) first = result.residual;
    if (result.iterations >= kFirstSteps &&
        expectedIterations(result, first, options.tolerance) > options.worthwhile)
      return result.code = Code::TooSlow, result;
    preconditioner.apply(r.data(), z.data());
    const double now = orderedDot(r, z);
    if (!(now > 0)) return result.code = Code::NotPositive, result;
    if (result.iterations == 0)
      p = z;
    else
      p = z + (now / before) * p;
    before = now;
    q.setZero();
    q.noalias() += a * p;
    const double curvature = orderedDot(p, q);
    if (!(curvature > 0)) return result.code = Code::NotPositive, result;
    x.noalias() += (now / curvature) * p;
    r.noalias() -= (now / curvature) * q;
  }
}

}  // namespace abflat
