#include <Eigen/Core>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "catch.h"
#include "solve/cholesky/cholesky.h"
#include "solve/cholesky/matrices.h"
#include "support/instrumented.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kThreadCounts[] = {1, 2, 3, 8};

struct NamedMatrix {
  std::string name;
  SparseMatrix lower;
};

/// Small ones, and some that are large enough for several tasks and for fronts in parts.
std::vector<NamedMatrix> matrices() {
  std::vector<NamedMatrix> all;
  for (const NamedGraph& g : awkwardGraphs())
    all.push_back({g.name, graphLaplacian(g.size, g.edges, 0.5, 9)});
  const SparseMatrix mesh = withTwoRowsEach(meshLaplacian(bumpyGrid(130, 120, 0.4, 3)));
  all.push_back({"mesh", mesh});
  SparseMatrix indefinite = mesh;
  for (int c = 0; c < mesh.cols(); c += 3) indefinite.coeffRef(c, c) -= 5;
  all.push_back({"indefinite", indefinite});
  all.push_back({"two meshes", [&] {
                   std::vector<Eigen::Triplet<double>> t;
                   for (int c = 0; c < mesh.outerSize(); ++c)
                     for (SparseMatrix::InnerIterator it(mesh, c); it; ++it)
                       for (int k = 0; k < 2; ++k)
                         t.emplace_back(it.row() + k * mesh.rows(), c + k * mesh.rows(),
                                        it.value());
                   SparseMatrix m(2 * mesh.rows(), 2 * mesh.cols());
                   m.setFromTriplets(t.begin(), t.end());
                   return m;
                 }()});
  Edges clique;
  for (int i = 0; i < 1100; ++i)
    for (int j = 0; j < i; ++j) clique.emplace_back(i, j);
  all.push_back({"dense", graphLaplacian(1100, clique, 0.5, 2)});
  return all;
}

Eigen::VectorXd waves(Eigen::Index n) {
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) b[i] = std::sin(static_cast<double>(i + 1));
  return b;
}

bool isSame(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(),
                                       sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
}

}  // namespace

TEST_CASE("a solution is the same to the last bit for any number of threads",
          "[cholesky][threads]") {
  for (const NamedMatrix& m : matrices()) {
    INFO(m.name);
    const auto symbolic = analyzed(m.lower);
    Eigen::VectorXd wanted;
    for (const unsigned threads : kThreadCounts) {
      INFO(threads << " threads");
      ThreadPool pool(threads);
      CholeskyOptions options;
      options.pool = &pool;
      Cholesky factor(symbolic, options);
      for (int again = 0; again < cases(3, 1); ++again) {
        REQUIRE(factor.factorize(m.lower.valuePtr()).isOk());
        Eigen::VectorXd x = waves(m.lower.rows());
        factor.solve(x.data());
        if (threads == 1) wanted = x;
        CHECK(isSame(x, wanted));
      }
    }
  }
}

TEST_CASE("an analysis is the same for any number of threads", "[cholesky][threads]") {
  for (const NamedMatrix& m : matrices()) {
    INFO(m.name);
    const auto wanted = analyzed(m.lower);
    for (const unsigned threads : kThreadCounts) {
      ThreadPool pool(threads);
      CholeskyAnalysisOptions options;
      options.pool = &pool;
      const auto s = analyzed(m.lower, options);
      CHECK(s->eliminationRank == wanted->eliminationRank);
      CHECK(s->firstColumn == wanted->firstColumn);
      CHECK(s->rows == wanted->rows);
      CHECK(std::equal(s->entries.begin(), s->entries.end(), wanted->entries.begin(),
                       wanted->entries.end(), [](const auto& a, const auto& b) {
                         return a.source == b.source && a.target == b.target;
                       }));
    }
  }
}

TEST_CASE("the first pivot that fails is reported for any number of threads",
          "[cholesky][threads]") {
  const SparseMatrix mesh = withTwoRowsEach(meshLaplacian(bumpyGrid(130, 120, 0.4, 3)));
  const auto symbolic = analyzed(mesh);
  for (const std::vector<int>& bad :
       {std::vector<int>{17}, {31000, 300}, {5, 9000, 20000, 31199}}) {
    SparseMatrix m = mesh;
    for (const int c : bad) m.coeffRef(c, c) = -1;
    CholeskyOptions options;
    options.allowNegative = false;
    CholeskyStatus wanted;
    for (const unsigned threads : kThreadCounts) {
      ThreadPool pool(threads);
      options.pool = &pool;
      Cholesky factor(symbolic, options);
      for (int again = 0; again < cases(5, 1); ++again) {
        const CholeskyStatus status = factor.factorize(m.valuePtr());
        if (threads == 1) wanted = status;
        CHECK(status.code == CholeskyStatus::Code::NegativePivot);
        CHECK(status.column == wanted.column);
        CHECK(status.pivot == wanted.pivot);
      }
      CHECK(factor.factorize(mesh.valuePtr()).isOk());
    }
  }
}

TEST_CASE("tasks are all supernodes, each once, and children come before parents",
          "[cholesky][threads]") {
  for (const NamedMatrix& m : matrices()) {
    INFO(m.name);
    const auto s = analyzed(m.lower);
    std::uint32_t next = 0;
    for (std::uint32_t t = 0; t < s->tasks.all.size(); ++t) {
      const CholeskyTask& task = s->tasks.all[t];
      CHECK(task.begin == next);
      REQUIRE(task.end > task.begin);
      next = task.end;
      if (task.firstChild != kNoParent) CHECK(task.end == task.begin + 1);
      for (std::uint32_t p = task.begin; p < task.end; ++p) {
        const std::uint32_t parent = s->parent[p];
        if (parent < task.end) continue;
        CHECK((task.parent == kNoParent) == (parent == kNoParent));
        if (parent != kNoParent) CHECK(s->tasks.all[task.parent].begin == parent);
      }
    }
    CHECK(next == s->supernodes());
    if (m.name == "mesh") CHECK(s->tasks.all.size() > 8);
  }
}
