#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>

#include "abflat/progress.h"

#if ABFLAT_THREADS
#include <thread>
#endif

namespace abflat {

/// Hears how far a run has got, and may stop it. A run makes one from the caller's callback and
/// hands parts of it to its stages. Whichever of them hears that the run is to stop, all know.
///
/// Only the thread that made it calls the callback. On other threads it just says whether to go on.
class Listener {
 public:
  /// Nobody listens, so nothing stops.
  Listener() = default;
  explicit Listener(ProgressCallback callback);

  /// For what is done from one share of this one's work to another.
  Listener part(double from, double to) const;
  /// For work that belongs to a stage. Where a stage is named already, this one is a detail of it,
  /// and is not reported.
  Listener at(Stage stage) const;
  Listener part(Stage stage, double from, double to) const { return at(stage).part(from, to); }
  /// For work of unknown amount: each report without a share comes closer to the end, and passes
  /// one half after `usual` of them. The first four fifths pass evenly.
  Listener approach(double usual) const;

  /// Reports that this share of the work is done, or as much as before if that is more. Returns
  /// whether to go on, as the next three do. What ends early may be incomplete, but is consistent.
  bool tell(double share) const;
  /// Reports that work goes on.
  bool tell() const;
  /// The same after a step of Newton's method, which is reported unless a stage is named.
  bool tellStep(int newtonStep, double constraintResidual) const;
  /// To be called, by one thread, after `steps` small steps of a long loop. Now and then it tells
  /// that work goes on.
  bool beat(std::size_t steps = 1) const {
    done_ += steps;
    if (done_ < kSteps) return !isStopped();
    done_ = 0;
    return tell();
  }
  bool isStopped() const { return run_ && run_->isStopped.load(std::memory_order_relaxed); }

  /// It tells after this many steps, which is some milliseconds.
  static constexpr std::size_t kSteps = 1 << 15;

 private:
  struct Run {
    ProgressCallback callback;
    Progress last;
    std::atomic<bool> isStopped{false};
#if ABFLAT_THREADS
    const std::thread::id owner = std::this_thread::get_id();
#endif
  };
  struct Unknown {
    double usual, reports = 0;
  };

  bool isHeard() const;

  std::shared_ptr<Run> run_;          ///< null: nobody listens
  std::shared_ptr<Unknown> unknown_;  ///< null: the amount of work is known
  std::optional<Stage> stage_;
  double from_ = 0, to_ = 1;      ///< of the whole run
  mutable std::size_t done_ = 0;  ///< small steps since it last told
};

}  // namespace abflat
