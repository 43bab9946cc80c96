#pragma once

#include <functional>

#include "base/parallel.h"
#include "solve/cholesky/tasks.h"

namespace abflat {

/// Runs each task after its children; without threads in postorder.
void runUpwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                const std::function<void(std::uint32_t)>& work);

/// Runs each task before its children.
void runDownwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                  const std::function<void(std::uint32_t)>& work);

}  // namespace abflat
