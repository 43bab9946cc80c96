#include "refine/extended_matrix.h"

#include <algorithm>
#include <utility>

namespace abflat {
namespace {

/// -1 if the pattern has no such entry.
int placeOf(const Eigen::SparseMatrix<double>& matrix, int row, int column) {
  const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  const int* at = std::lower_bound(begin, end, row);
  return at != end && *at == row ? static_cast<int>(at - matrix.innerIndexPtr()) : -1;
}

}  // namespace

ExtendedMatrix::ExtendedMatrix(const Eigen::SparseMatrix<double>& own, SparseEntries more)
    : own_(own), more_(std::move(more)) {
  if (!more_.empty()) buildPattern();
}

void ExtendedMatrix::buildPattern() {
  isOwn_ = false;
  SparseEntries all;
  all.reserve(static_cast<std::size_t>(own_.nonZeros()) + more_.size());
  for (int c = 0; c < own_.outerSize(); ++c)
    for (int i = own_.outerIndexPtr()[c]; i < own_.outerIndexPtr()[c + 1]; ++i)
      all.emplace_back(own_.innerIndexPtr()[i], c, 0);
  for (const auto& e : more_) all.emplace_back(e.row(), e.col(), 0);
  sum_ = assembled(own_.rows(), all);
  place_.resize(static_cast<std::size_t>(own_.nonZeros()));
  for (int c = 0; c < own_.outerSize(); ++c) {
    int at = sum_.outerIndexPtr()[c];
    for (int i = own_.outerIndexPtr()[c]; i < own_.outerIndexPtr()[c + 1]; ++i) {
      while (sum_.innerIndexPtr()[at] != own_.innerIndexPtr()[i]) ++at;
      place_[static_cast<std::size_t>(i)] = at;
    }
  }
}

bool ExtendedMatrix::add(const SparseEntries& entries) {
  const std::size_t held = more_.size();
  for (const auto& e : entries)
    if (placeOf(sum(), e.row(), e.col()) < 0) more_.emplace_back(e.row(), e.col(), 0);
  const bool isNew = more_.size() > held;
  if (isNew || (isOwn_ && !entries.empty())) buildPattern();
  if (isOwn_) return false;
  std::fill_n(sum_.valuePtr(), sum_.nonZeros(), 0.0);
  for (std::size_t i = 0; i < place_.size(); ++i) sum_.valuePtr()[place_[i]] = own_.valuePtr()[i];
  for (const auto& e : entries) sum_.valuePtr()[placeOf(sum_, e.row(), e.col())] += e.value();
  return isNew;
}

}  // namespace abflat
