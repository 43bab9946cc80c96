#include "base/listener.h"

#include <algorithm>
#include <utility>

namespace abflat {
namespace {

/// The share that `reports` make where half of them is usual: even at first, and never all.
double approached(double reports, double usual) {
  constexpr double kEven = 0.8, kRest = 1 - kEven;
  const double even = reports / (2 * usual);
  return even < kEven ? even : 1 - kRest * kRest / (even - kEven + kRest);
}

}  // namespace

Listener::Listener(ProgressCallback callback) {
  if (!callback) return;
  run_ = std::make_shared<Run>();
  run_->callback = std::move(callback);
}

Listener Listener::part(double from, double to) const {
  Listener out = *this;
  out.from_ = from_ + from * (to_ - from_);
  out.to_ = from_ + to * (to_ - from_);
  out.unknown_ = nullptr;
  return out;
}

Listener Listener::at(Stage stage) const {
  Listener out = *this;
  if (!stage_) out.stage_ = stage;
  return out;
}

Listener Listener::approach(double usual) const {
  Listener out = *this;
  out.unknown_ = std::make_shared<Unknown>(Unknown{usual});
  return out;
}

bool Listener::tell(double share) const {
  if (!isHeard()) return !isStopped();
  Progress& last = run_->last;
  if (stage_) last.stage = *stage_;
  last.fraction = std::max(last.fraction, from_ + share * (to_ - from_));
  run_->isStopped = !run_->callback(last);
  return !isStopped();
}

bool Listener::tell() const {
  if (!unknown_ || !isHeard()) return tell(0);
  ++unknown_->reports;
  return tell(approached(unknown_->reports, unknown_->usual));
}

bool Listener::tellStep(int newtonStep, double constraintResidual) const {
  if (stage_ || !isHeard()) return tell();
  run_->last.newtonStep = newtonStep;
  run_->last.constraintResidual = constraintResidual;
  return at(Stage::Solve).tell();
}

/// Whether a report reaches the caller.
bool Listener::isHeard() const {
  if (!run_ || isStopped()) return false;
#if ABFLAT_THREADS
  return std::this_thread::get_id() == run_->owner;
#else
  return true;
#endif
}

}  // namespace abflat
