#pragma once

#include <cstddef>

#include "base/listener.h"

namespace abflat {

/// The parts of the progress bar that cutting and flattening take, when a surface is cut in several
/// ways one after the other. How many there will be is only expected, so each takes a share of what
/// is left of the bar.
class Passes {
 public:
  /// What all of them take of the bar.
  static constexpr double kFrom = 0.03, kTo = 0.9;

  /// `run`: of the whole bar; `triangles`: of the surface.
  Passes(const Listener& run, std::size_t triangles) : run_(run), triangles_(triangles) {}

  /// Begins another with the search for its seams. `more`: how many are expected to follow.
  void next(double more);
  /// The same once its seams are known, for what is left.
  void expect(double more);

  /// For the seams of the present one, and for the layouts of its charts.
  Listener seams() const;
  Listener layouts() const { return run_.part(between_, to_); }

 private:
  Listener run_;
  std::size_t triangles_;
  double from_ = kFrom, between_ = kFrom, to_ = kFrom;
};

}  // namespace abflat
