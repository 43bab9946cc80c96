#include "refine/extended_matrix.h"

#include "catch.h"

using namespace abflat;

namespace {

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& matrix) { return Eigen::MatrixXd(matrix); }

Eigen::SparseMatrix<double> chain(int n) {
  SparseEntries entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 2 + i);
    if (i > 0) entries.emplace_back(i, i - 1, -1);
  }
  return assembled(n, entries);
}

}  // namespace

TEST_CASE("a matrix and what is added to it, in a pattern that grows where it must", "[refine]") {
  Eigen::SparseMatrix<double> own = chain(6);
  ExtendedMatrix extended(own, {});
  CHECK(!extended.add({}));
  CHECK(&extended.sum() == &own);

  const SparseEntries some{{4, 1, 0.5}, {4, 1, 0.25}, {3, 3, 7}};
  CHECK(extended.add(some));
  CHECK(dense(extended.sum()) == dense(own) + dense(assembled(6, some)));
  // The same places with other numbers, also in the matrix, and fewer of them.
  own.coeffRef(2, 1) = 9;
  const SparseEntries fewer{{4, 1, -3}};
  CHECK(!extended.add(fewer));
  CHECK(dense(extended.sum()) == dense(own) + dense(assembled(6, fewer)));
  CHECK(!extended.add({}));
  CHECK(dense(extended.sum()) == dense(own));
  const SparseEntries other{{5, 0, 1}};
  CHECK(extended.add(other));
  CHECK(dense(extended.sum()) == dense(own) + dense(assembled(6, other)));
  // Entries that come back still have their place.
  CHECK(!extended.add(some));
  CHECK(dense(extended.sum()) == dense(own) + dense(assembled(6, some)));
}

TEST_CASE("a pattern that is known from the start stays", "[refine]") {
  const Eigen::SparseMatrix<double> own = chain(5);
  const SparseEntries always{{3, 0, 0}, {4, 2, 0}};
  ExtendedMatrix extended(own, always);
  CHECK(extended.sum().nonZeros() == own.nonZeros() + 2);
  CHECK(!extended.add({{4, 2, 5}, {3, 0, 1}}));
  CHECK(extended.sum().coeff(4, 2) == 5);
  CHECK(extended.add({{4, 0, 1}}));
  CHECK(extended.sum().nonZeros() == own.nonZeros() + 3);
  CHECK(!extended.add({{4, 2, 1}}));
  CHECK(extended.sum().coeff(4, 0) == 0);
}
