// Cholesky beside Eigen's SimplicialLDLT and, where it is installed, CHOLMOD: medians of repeated
// runs on one thread, one row per solver and matrix.
//
//   abflat_cholesky_bench [--repeat N] [--no-eigen] WHAT...
//   WHAT: a number of faces of a generated mesh, or FILE or FILE+N, subdivided N times
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "abflat/io.h"
#include "bench_matrices.h"
#include "solve/cholesky/cholesky.h"
#ifdef ABFLAT_BENCH_CHOLMOD
#include <cholmod.h>
#endif

using namespace abflat;
using SparseMatrix = Eigen::SparseMatrix<double>;

namespace {

struct Row {
  double analyze = 0, numeric = 0, solve = 0;  ///< seconds
  double entries = 0, flops = 0, residual = 0;
};

template <typename Work>
double seconds(int repeat, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

double residual(const SparseMatrix& m, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (m.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
}

void print(const char* solver, const Row& r, const Row& reference) {
  std::printf("  %-12s %9.4f %9.4f %9.4f %8.2f %8.2f %9.1e %7.2f %7.2f\n", solver, r.analyze,
              r.numeric, r.solve, r.entries / 1e6, r.flops / 1e9, r.residual,
              r.numeric / reference.numeric,
              (r.analyze + r.numeric + r.solve) /
                  (reference.analyze + reference.numeric + reference.solve));
}

Row runOwn(const SparseMatrix& m, const Eigen::VectorXd& b, SimdWidth width, int repeat) {
  Row row;
  std::shared_ptr<const CholeskySymbolic> symbolic;
  row.analyze = seconds(repeat, [&] {
    symbolic = std::make_shared<const CholeskySymbolic>(analyzePattern(
        {static_cast<std::uint32_t>(m.rows()), m.outerIndexPtr(), m.innerIndexPtr()}));
  });
  CholeskyOptions options;
  options.simd = width;
  Cholesky factor(symbolic, options);
  CholeskyStatus status;
  row.numeric = seconds(repeat, [&] { status = factor.factorize(m.valuePtr()); });
  if (!status.isOk()) std::printf("  failed at column %u\n", status.column);
  Eigen::VectorXd x;
  row.solve = seconds(repeat, [&] {
    x = b;
    factor.solve(x.data());
  });
  row.entries = static_cast<double>(symbolic->factorEntries);
  row.flops = symbolic->flops;
  row.residual = residual(m, x, b);
  return row;
}

Row runEigen(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat) {
  Row row;
  Eigen::SimplicialLDLT<SparseMatrix> factor;
  Eigen::VectorXd x;
  row.analyze = seconds(1, [&] { factor.analyzePattern(m); });
  row.numeric = seconds(repeat, [&] { factor.factorize(m); });
  row.solve = seconds(repeat, [&] { x = factor.solve(b); });
  const SparseMatrix& l = factor.matrixL().nestedExpression();
  row.entries = static_cast<double>(l.nonZeros() + l.rows());
  for (int c = 0; c < l.outerSize(); ++c) {
    const double count = l.outerIndexPtr()[c + 1] - l.outerIndexPtr()[c] + 1;
    row.flops += count * count;
  }
  row.residual = residual(m, x, b);
  return row;
}

#ifdef ABFLAT_BENCH_CHOLMOD
Row runCholmod(SparseMatrix m, Eigen::VectorXd b, int repeat) {
  Row row;
  cholmod_common common;
  cholmod_start(&common);
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(m.rows());
  a.nzmax = static_cast<std::size_t>(m.nonZeros());
  a.p = m.outerIndexPtr();
  a.i = m.innerIndexPtr();
  a.x = m.valuePtr();
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.sorted = a.packed = 1;
  cholmod_dense rhs{};
  rhs.nrow = rhs.nzmax = rhs.d = a.nrow;
  rhs.ncol = 1;
  rhs.x = b.data();
  rhs.xtype = CHOLMOD_REAL;
  cholmod_factor* factor = nullptr;
  row.analyze = seconds(1, [&] { factor = cholmod_analyze(&a, &common); });
  row.entries = common.lnz;
  row.flops = common.fl;
  row.numeric = seconds(repeat, [&] { cholmod_factorize(&a, factor, &common); });
  Eigen::VectorXd x(m.rows());
  row.solve = seconds(repeat, [&] {
    cholmod_dense* solved = cholmod_solve(CHOLMOD_A, factor, &rhs, &common);
    std::copy_n(static_cast<double*>(solved->x), m.rows(), x.data());
    cholmod_free_dense(&solved, &common);
  });
  row.residual = residual(m, x, b);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return row;
}
#endif

void compare(const SparseMatrix& m, const char* kind, int repeat, bool withEigen) {
  std::printf(" %s, %ld rows\n", kind, static_cast<long>(m.rows()));
  std::srand(1);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(m.rows());
  const Row own = runOwn(m, b, widestSimd(), repeat);
  print("own", own, own);
  if (widestSimd() != SimdWidth::Two)
    print("own, 2 lanes", runOwn(m, b, SimdWidth::Two, repeat), own);
#ifdef ABFLAT_BENCH_CHOLMOD
  print("CHOLMOD", runCholmod(m, b, repeat), own);
#endif
  if (withEigen) print("Eigen", runEigen(m, b, repeat), own);
  std::fflush(stdout);
}

bool makeMesh(const std::string& what, PolygonMesh& mesh) {
  if (what.find_first_not_of("0123456789") == std::string::npos) {
    mesh = bench::noisyCap(static_cast<unsigned>(std::stoul(what)));
    return true;
  }
  const std::size_t plus = what.find('+');
  const std::string path = what.substr(0, plus);
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const Result<MeshFormat> format = detectFormat(path, bytes);
  Result<PolygonMesh> read = readMesh(bytes, format.value, path);
  if (!in || !format.ok() || !read.ok()) {
    std::fprintf(stderr, "%s cannot be read\n", path.c_str());
    return false;
  }
  mesh = std::move(read.value);
  for (int i = plus == std::string::npos ? 0 : std::atoi(what.c_str() + plus + 1); i > 0; --i)
    mesh = bench::subdivided(mesh);
  return true;
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
      if (!makeMesh(argv[i], mesh)) return 1;
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
