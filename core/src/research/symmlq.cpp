#include "research/symmlq.h"

#include <limits>

#include "base/portable_math.h"
#include "research/lanczos.h"

namespace abflat {

LinearSolveResult symmlq(const LinearOperator& matrix, const Eigen::VectorXd& rhs,
                         const LinearSolveOptions& options, const LinearOperator& preconditioner) {
  LinearSolveResult out;
  out.x = Eigen::VectorXd::Zero(rhs.size());
  Lanczos lanczos(matrix, preconditioner, rhs);
  const double start = lanczos.beta();
  if (start == 0) {
    out.converged = true;
    return out;
  }
  lanczos.advance();
  out.iterations = 1;
  double gbar = lanczos.alpha(), dbar = lanczos.beta(), rhs1 = start, rhs2 = 0, sines = 1;
  double scale = std::max(std::abs(gbar), dbar);
  Eigen::VectorXd w = lanczos.vector();
  while (true) {
    const double lq = portable::hypot(rhs1, rhs2);
    const double cg = gbar != 0 ? start * sines * lanczos.beta() / std::abs(gbar)
                                : std::numeric_limits<double>::infinity();
    out.residual = std::min(lq, cg) / start;
    const bool ended = lanczos.beta() <= std::numeric_limits<double>::epsilon() * scale;
    if (out.residual <= options.tolerance || ended || out.iterations >= options.maxIterations) {
      if (cg < lq) out.x += (rhs1 / gbar) * w;
      break;
    }
    lanczos.advance();
    ++out.iterations;
    scale = std::max({scale, std::abs(lanczos.alpha()), lanczos.beta()});
    // The LQ factors of the tridiagonal matrix, one plane rotation further.
    const double gamma = portable::hypot(gbar, lanczos.previousBeta());
    const double cs = gbar / gamma, sn = lanczos.previousBeta() / gamma;
    const double delta = cs * dbar + sn * lanczos.alpha();
    gbar = sn * dbar - cs * lanczos.alpha();
    const double epsilon = sn * lanczos.beta();
    dbar = -cs * lanczos.beta();
    const double z = rhs1 / gamma;
    out.x += z * cs * w + z * sn * lanczos.vector();
    w = sn * w - cs * lanczos.vector();
    sines *= sn;
    rhs1 = rhs2 - delta * z;
    rhs2 = -epsilon * z;
  }
  out.converged = out.residual <= options.tolerance;
  return out;
}

}  // namespace abflat
