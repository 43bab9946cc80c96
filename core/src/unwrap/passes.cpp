#include "unwrap/passes.h"

namespace abflat {
namespace {

constexpr double kShareOfSeams = 0.65;  ///< of a pass, by measurement

}  // namespace

void Passes::next(double more) {
  from_ = to_;
  between_ = from_ + (kTo - from_) * kShareOfSeams / (1 + more);
  expect(more);
}

void Passes::expect(double more) {
  constexpr double kLayouts = 1 - kShareOfSeams;
  to_ = between_ + (kTo - between_) * kLayouts / (kLayouts + more);
}

Listener Passes::seams() const {
  // How often a search reports until about half of it is done, by measurement.
  const double usual = 60 + 1e-3 * static_cast<double>(triangles_);
  return run_.part(from_, between_).approach(usual);
}

}  // namespace abflat
