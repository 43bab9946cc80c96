// Cholesky beside Eigen's SimplicialLDLT and, where it is installed, CHOLMOD: medians of repeated
// runs on one thread, one row per solver and matrix.
//
//   abflat_cholesky_bench [--repeat N] [--no-eigen] WHAT...
//   WHAT: see bench::makeMesh
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bench_matrices.h"
#include "factor_rows.h"

using namespace abflat;
using bench::FactorRow, bench::SparseMatrix;

namespace {

void print(const char* solver, const FactorRow& r, const FactorRow& reference) {
  std::printf("  %-12s %9.4f %9.4f %9.4f %8.2f %8.2f %9.1e %7.2f %7.2f\n", solver, r.analyze,
              r.numeric, r.solve, r.entries / 1e6, r.flops / 1e9, r.residual,
              r.numeric / reference.numeric, r.all() / reference.all());
}

/// Two threads beside the one that was measured just before.
void compareThreads(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat,
                    const FactorRow& one, const Eigen::VectorXd& solution) {
  ThreadPool pool(2);
  if (pool.threads() < 2) return;
  Eigen::VectorXd x;
  const FactorRow two = bench::runOwn(m, b, repeat, {widestSimd(), &pool, &x});
  print("own, 2 thr.", two, one);
  const bool isSame = std::equal(x.begin(), x.end(), solution.begin(), solution.end());
  std::printf("  two threads faster by: analysis %.2f, numeric %.2f, solution %.2f, all %.2f; %s\n",
              one.analyze / two.analyze, one.numeric / two.numeric, one.solve / two.solve,
              one.all() / two.all(), isSame ? "identical" : "NOT IDENTICAL");
}

void compare(const SparseMatrix& m, const char* kind, int repeat, bool withEigen) {
  std::printf(" %s, %ld rows\n", kind, static_cast<long>(m.rows()));
  std::srand(1);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(m.rows());
  Eigen::VectorXd x;
  const FactorRow own = bench::runOwn(m, b, repeat, {widestSimd(), nullptr, &x});
  print("own", own, own);
  if (widestSimd() != SimdWidth::Two)
    print("own, 2 lanes", bench::runOwn(m, b, repeat, {SimdWidth::Two}), own);
  compareThreads(m, b, repeat, own, x);
#ifdef ABFLAT_BENCH_CHOLMOD
  print("CHOLMOD", bench::runCholmod(m, b, repeat), own);
#endif
  if (withEigen) print("Eigen", bench::runEigenLdlt(m, b, repeat), own);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int repeat = 5;
  bool withEigen = true;
  std::printf("%-14s %9s %9s %9s %8s %8s %9s %7s %7s\n", "", "analyze/s", "numeric/s", "solve/s",
              "M entr.", "GFlop", "residual", "numeric", "all");
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--no-eigen")) {
      withEigen = false;
    } else if (!std::strcmp(argv[i], "--repeat") && i + 1 < argc) {
      repeat = std::max(1, std::atoi(argv[++i]));
    } else {
      PolygonMesh mesh;
      if (!bench::makeMesh(argv[i], mesh)) return 1;
      std::printf("%s: %zu faces\n", argv[i], mesh.faceCount());
      compare(bench::cotangentLaplacian(mesh), "cotangent Laplacian", repeat, withEigen);
      std::string message;
      const SparseMatrix schur = bench::schurMatrix(mesh, message);
      if (schur.rows() == 0)
        std::printf(" no Newton matrix: %s\n", message.c_str());
      else
        compare(schur, "Newton matrix", repeat, withEigen);
    }
  }
  return 0;
}
