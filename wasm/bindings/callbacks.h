#pragma once

#include "abflat/progress.h"

// What every module calls in JavaScript.

namespace abflat::bindings {

/// As a ProgressCallback; a run is cancelled by ending its worker, so this always goes on.
bool tellProgress(const Progress& progress);

/// For std::set_new_handler. The JavaScript callback throws, in the thread that JavaScript called;
/// nothing of the module may run afterwards. That thread listens whenever it waits for others.
void outOfMemory();

}  // namespace abflat::bindings
