#pragma once

#include <memory>

#include "seam/find_seams.h"

namespace abflat {

/// A search for the seams of a mesh that can be given up half way. It cuts in rounds. A chart that
/// a round leaves unchanged is done; the rounds continue with only the others as soon as they make
/// up much less than the whole.
class SeamSearch {
 public:
  /// `given` seams are marked on both sides. What is passed by reference has to outlive the search.
  SeamSearch(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport& report);
  ~SeamSearch();

  /// Cuts until no chart needs it, then joins charts.
  void join();
  const Seams& joined() const;     ///< the seams so far
  const LogScales& scale() const;  ///< expected so far
  /// Redraws seams and shortens them. They are marked on both sides.
  Seams finish();

 private:
  class Finder;
  std::unique_ptr<Finder> finder_;
};

/// Both steps of a search.
Seams findInRounds(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                   SeamReport& report);

}  // namespace abflat
