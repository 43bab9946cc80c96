#include "research/minres.h"

#include <limits>

#include "base/portable_math.h"
#include "research/lanczos.h"

namespace abflat {

LinearSolveResult minres(const LinearOperator& matrix, const Eigen::VectorXd& rhs,
                         const LinearSolveOptions& options, const LinearOperator& preconditioner) {
  LinearSolveResult out;
  out.x = Eigen::VectorXd::Zero(rhs.size());
  Lanczos lanczos(matrix, preconditioner, rhs);
  const double start = lanczos.beta();
  if (start == 0) {
    out.converged = true;
    return out;
  }
  double dbar = 0, epsilon = 0, phibar = start, cs = -1, sn = 0, scale = 0;
  Eigen::VectorXd w = out.x, w1 = out.x, w2 = out.x;
  while (out.iterations < options.maxIterations) {
    lanczos.advance();
    ++out.iterations;
    // The QR factors of the tridiagonal matrix, one plane rotation further.
    const double alpha = lanczos.alpha(), beta = lanczos.beta(), oldEpsilon = epsilon;
    scale = std::max({scale, std::abs(alpha), beta});
    const double delta = cs * dbar + sn * alpha, gbar = sn * dbar - cs * alpha;
    epsilon = sn * beta;
    dbar = -cs * beta;
    const double tiny = std::numeric_limits<double>::epsilon() * scale;
    const double gamma = portable::hypot(gbar, beta);
    if (!(gamma > tiny)) break;  // singular: x is the least squares solution already
    cs = gbar / gamma;
    sn = beta / gamma;
    w1.swap(w2);
    w2.swap(w);
    w = (lanczos.vector() - oldEpsilon * w1 - delta * w2) / gamma;
    out.x += cs * phibar * w;
    phibar *= sn;
    if (phibar <= options.tolerance * start || beta <= tiny) break;
  }
  out.residual = phibar / start;
  out.converged = out.residual <= options.tolerance;
  return out;
}

}  // namespace abflat
