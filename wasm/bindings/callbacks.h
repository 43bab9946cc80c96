#pragma once

#include <new>

#include "abflat/progress.h"

// What every module calls in JavaScript.

namespace abflat::bindings {

/// As a ProgressCallback: JavaScript says whether to go on.
bool tellProgress(const Progress& progress);

/// For std::set_new_handler. The JavaScript callback throws, in the thread that JavaScript called;
/// nothing of the module may run afterwards. That thread listens whenever it waits for others.
void outOfMemory();

/// The first thing that a call from JavaScript makes.
template <class Job>
Job* newJob() {
  // Without exceptions a failed allocation would just abort the module.
  std::set_new_handler(outOfMemory);
  return new Job;
}

}  // namespace abflat::bindings
