#include "solve/cholesky/cholesky.h"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>

#include "catch.h"
#include "solve/cholesky/matrices.h"
#include "support/dense_algebra.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Eigen::VectorXd randomVector(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  Eigen::VectorXd x(n);
  for (double& entry : x) entry = value(random);
  return x;
}

/// Symmetric with random entries; `dominance` 1: positive definite, 0: usually indefinite.
SparseMatrix randomMatrix(int n, double density, double dominance, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1), share(0, 1);
  std::vector<Eigen::Triplet<double>> t;
  std::vector<double> sum(static_cast<std::size_t>(n), 0.1);
  for (int c = 0; c < n; ++c)
    for (int r = c + 1; r < n; ++r)
      if (share(random) < density) {
        const double x = value(random);
        t.emplace_back(r, c, x);
        sum[static_cast<std::size_t>(r)] += std::abs(x);
        sum[static_cast<std::size_t>(c)] += std::abs(x);
      }
  for (int i = 0; i < n; ++i)
    t.emplace_back(i, i,
                   dominance * sum[static_cast<std::size_t>(i)] + (1 - dominance) * value(random));
  SparseMatrix m(n, n);
  m.setFromTriplets(t.begin(), t.end());
  return m;
}

double residual(const SparseMatrix& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (lower.selfadjointView<Eigen::Lower>() * x - b).norm() / std::max(b.norm(), 1e-300);
}

template <typename Scalar>
Eigen::VectorXd solved(const BasicCholesky<Scalar>& factor, Eigen::VectorXd b) {
  factor.solve(b.data());
  return b;
}

}  // namespace

TEST_CASE("random positive definite systems are solved like a dense solver does", "[cholesky]") {
  for (const int n : {1, 2, 3, 4, 5, 7, 16, 17, 40, 131, 260})
    for (const double density : {0.02, 0.2, 1.0}) {
      INFO("n = " << n << ", density " << density);
      const SparseMatrix m = randomMatrix(n, density, 1, static_cast<unsigned>(n));
      Cholesky factor(analyzed(m), {/*allowNegative=*/false});
      REQUIRE(factor.factorize(m.valuePtr()).isOk());
      const Eigen::VectorXd b = randomVector(n, 3), x = solved(factor, b);
      const Eigen::MatrixXd dense = Eigen::MatrixXd(m).selfadjointView<Eigen::Lower>();
      const Eigen::VectorXd wanted = denseSolve(dense, b);
      CHECK((x - wanted).norm() <= 1e-11 * wanted.norm());
      CHECK(factor.negativePivots() == 0);
    }
}

TEST_CASE("the negative pivots are as many as the negative eigenvalues", "[cholesky]") {
  for (const int n : {1, 6, 30, 150}) {
    const SparseMatrix m = randomMatrix(n, 0.2, 0.4, static_cast<unsigned>(n));
    const Eigen::MatrixXd dense = Eigen::MatrixXd(m).selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd values = symmetricEigen(dense).values;
    Cholesky factor(analyzed(m));
    REQUIRE(factor.factorize(m.valuePtr()).isOk());
    CHECK(factor.negativePivots() == (values.array() < 0).count());
    const Eigen::VectorXd b = randomVector(n, 5);
    CHECK(residual(m, solved(factor, b), b) < 1e-8);
  }
}

TEST_CASE("mesh Laplacians are solved like by Eigen", "[cholesky]") {
  for (const PolygonMesh& mesh : {bumpyGrid(3, 3, 0.2, 1), bumpyGrid(40, 25, 0.4, 2),
                                  bumpyGrid(150, 90, 0.4, 3), torus(60, 40), cone(500, 1)})
    for (const bool twice : {false, true}) {
      const SparseMatrix one = meshLaplacian(mesh);
      const SparseMatrix m = twice ? withTwoRowsEach(one) : one;
      const Eigen::SimplicialLDLT<SparseMatrix> eigen(m);
      Cholesky factor(analyzed(m));
      REQUIRE(factor.factorize(m.valuePtr()).isOk());
      const Eigen::VectorXd b = randomVector(m.rows(), 8), wanted = eigen.solve(b);
      CHECK((solved(factor, b) - wanted).norm() <= 1e-10 * wanted.norm());
    }
}

TEST_CASE("awkward graphs are solved", "[cholesky]") {
  for (const NamedGraph& named : awkwardGraphs()) {
    INFO(named.name);
    const SparseMatrix m = graphLaplacian(named.size, named.edges, 0.5, 9);
    for (const std::uint32_t leaf : {1u, 100u}) {
      CholeskyAnalysisOptions options;
      options.dissection.leafVertices = leaf;
      Cholesky factor(analyzed(m, options));
      REQUIRE(factor.factorize(m.valuePtr()).isOk());
      const Eigen::VectorXd b = randomVector(m.rows(), 8);
      CHECK(residual(m, solved(factor, b), b) < 1e-12);
    }
  }
}

TEST_CASE("hubs do not fill the factor", "[cholesky]") {
  for (const NamedGraph& named : awkwardGraphs()) {
    if (named.name.find("star") == std::string::npos && named.name != "path") continue;
    INFO(named.name);
    const SparseMatrix m = graphLaplacian(named.size, named.edges, 1, 1);
    CHECK(analyzed(m)->factorEntries < 120 * static_cast<std::uint64_t>(named.size));
  }
}

TEST_CASE("the order of a surface serves the surface and its parts", "[cholesky]") {
  const PolygonMesh grid = bumpyGrid(80, 60, 0.4, 3);
  for (const bool twice : {false, true}) {
    const SparseMatrix one = meshLaplacian(grid), m = twice ? withTwoRowsEach(one) : one;
    const auto own = analyzed(m);
    CholeskyAnalysisOptions known;
    known.eliminationRank = own->eliminationRank;
    CHECK(analyzed(m, known)->factorEntries == own->factorEntries);

    const int rows = static_cast<int>(m.rows()) / 2;
    const SparseMatrix part = m.topLeftCorner(rows, rows);
    known.eliminationRank.resize(static_cast<std::size_t>(rows));
    const auto symbolic = analyzed(part, known);
    CHECK(10 * symbolic->factorEntries < 13 * analyzed(part)->factorEntries);
    Cholesky factor(symbolic);
    REQUIRE(factor.factorize(part.valuePtr()).isOk());
    const Eigen::VectorXd b = randomVector(rows, 8);
    CHECK(residual(part, solved(factor, b), b) < 1e-12);
  }
}

TEST_CASE("one analysis serves many factorisations", "[cholesky]") {
  SparseMatrix m = withTwoRowsEach(meshLaplacian(bumpyGrid(50, 50, 0.4, 3)));
  const auto symbolic = analyzed(m);
  Cholesky first(symbolic), second(symbolic);
  const Eigen::VectorXd b = randomVector(m.rows(), 2);
  REQUIRE(first.factorize(m.valuePtr()).isOk());
  const Eigen::VectorXd x = solved(first, b);
  SparseMatrix scaled = m;
  for (Eigen::Index i = 0; i < m.nonZeros(); ++i) scaled.valuePtr()[i] *= 4;
  REQUIRE(second.factorize(scaled.valuePtr()).isOk());
  CHECK(solved(second, b) == x / 4);
  CHECK(solved(first, b) == x);
  REQUIRE(second.factorize(m.valuePtr()).isOk());
  CHECK(solved(second, b) == x);
}

TEST_CASE("several right-hand sides give what each of them gives", "[cholesky]") {
  const SparseMatrix m = withTwoRowsEach(meshLaplacian(bumpyGrid(30, 40, 0.4, 3)));
  Cholesky factor(analyzed(m));
  REQUIRE(factor.factorize(m.valuePtr()).isOk());
  for (const Eigen::Index columns : {0, 1, 2, 3, 4, 5, 7, 9}) {
    Eigen::MatrixXd b(m.rows(), columns);
    for (Eigen::Index c = 0; c < columns; ++c)
      b.col(c) = randomVector(m.rows(), 10 + static_cast<unsigned>(c));
    Eigen::MatrixXd x = b;
    factor.solve(x.data(), static_cast<std::size_t>(columns));
    for (Eigen::Index c = 0; c < columns; ++c) CHECK(x.col(c) == solved(factor, b.col(c)));
  }
}

TEMPLATE_TEST_CASE("all vector widths give the same bits", "[cholesky]", float, double) {
  const SparseMatrix mesh = withTwoRowsEach(meshLaplacian(bumpyGrid(70, 60, 0.4, 3)));
  const SparseMatrix dense = randomMatrix(333, 1, 0.5, 7);
  for (const SparseMatrix* m : {&mesh, &dense}) {
    const auto symbolic = analyzed(*m);
    const Eigen::VectorXd b = randomVector(m->rows(), 4);
    Eigen::VectorXd wanted;
    for (const SimdWidth width : {SimdWidth::Two, SimdWidth::Four, SimdWidth::Eight}) {
      if (width > widestSimd()) continue;
      CholeskyOptions options;
      options.simd = width;
      BasicCholesky<TestType> factor(symbolic, options);
      REQUIRE(factor.factorize(m->valuePtr()).isOk());
      const Eigen::VectorXd x = solved(factor, b);
      if (wanted.size() == 0) wanted = x;
      CHECK(x == wanted);
    }
  }
}

TEST_CASE("a factor of floats solves as far as floats reach", "[cholesky]") {
  for (const NamedGraph& named : awkwardGraphs()) {
    INFO(named.name);
    const SparseMatrix m = graphLaplacian(named.size, named.edges, 0.5, 9);
    FloatCholesky factor(analyzed(m));
    REQUIRE(factor.factorize(m.valuePtr()).isOk());
    const Eigen::VectorXd b = randomVector(m.rows(), 8);
    CHECK(residual(m, solved(factor, b), b) < 1e-4);
  }
  for (const int n : {1, 2, 3, 5, 17, 64, 200}) {
    const SparseMatrix m = randomMatrix(n, 1, 1, static_cast<unsigned>(n));
    FloatCholesky factor(analyzed(m), {/*allowNegative=*/false});
    REQUIRE(factor.factorize(m.valuePtr()).isOk());
    const Eigen::VectorXd b = randomVector(n, 8);
    CHECK(residual(m, solved(factor, b), b) < 1e-4);
  }
}

TEST_CASE("a singular matrix is reported with a column and the pivot", "[cholesky]") {
  using Code = CholeskyStatus::Code;
  {  // the vertex without edges has a zero row
    const SparseMatrix m = graphLaplacian(4, {{0, 1}, {1, 2}}, 0, 1);
    Cholesky factor(analyzed(m));
    SparseMatrix shifted = m;
    for (int i = 0; i < 3; ++i) shifted.coeffRef(i, i) += 1;
    const CholeskyStatus status = factor.factorize(shifted.valuePtr());
    CHECK(status.code == Code::ZeroPivot);
    CHECK(status.column == 3);
    CHECK(status.pivot == 0);
  }
  {  // constants are in the null space: only rounding is left of the last pivot
    const SparseMatrix m = meshLaplacian(bumpyGrid(20, 20, 0.2, 1), 0);
    CholeskyOptions options;
    options.pivotTolerance = 1e-12;
    const CholeskyStatus status = Cholesky(analyzed(m), options).factorize(m.valuePtr());
    CHECK(status.code == Code::ZeroPivot);
    CHECK(std::abs(status.pivot) < 1e-12 * 20);
    CHECK(status.column < static_cast<std::uint32_t>(m.rows()));
  }
}

TEST_CASE("negative pivots and values that are not finite are reported", "[cholesky]") {
  using Code = CholeskyStatus::Code;
  SparseMatrix m = meshLaplacian(bumpyGrid(30, 30, 0.2, 1));
  const double good = m.coeff(123, 123);
  CholeskyOptions options;
  options.allowNegative = false;
  Cholesky factor(analyzed(m), options);
  m.coeffRef(123, 123) = -5;
  CholeskyStatus status = factor.factorize(m.valuePtr());
  CHECK(status.code == Code::NegativePivot);
  CHECK(status.pivot < 0);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    m.coeffRef(123, 123) = bad;
    status = factor.factorize(m.valuePtr());
    CHECK(status.code == Code::NotFinite);
  }
  m.coeffRef(123, 123) = good;
  CHECK(factor.factorize(m.valuePtr()).isOk());
}

TEST_CASE("the analysis reports what the factor takes", "[cholesky]") {
  const SparseMatrix m = randomMatrix(200, 1, 1, 1);
  const auto symbolic = analyzed(m);
  CHECK(symbolic->supernodes() == 1);
  CHECK(symbolic->factorEntries == 200 * 201 / 2);
  CHECK(symbolic->factorBytes() == 8 * 200 * 200);
  CHECK(symbolic->flops == Approx(200.0 * 201 * 401 / 6));
}
