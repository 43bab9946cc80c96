#pragma once

#include <cstddef>
#include <functional>

#include "base/parallel.h"
#include "solve/cholesky/tasks.h"

namespace abflat {

/// Numbers set, copied or added up per piece of work.
constexpr std::size_t kNumbersPerPiece = 1 << 15;

/// Runs each task after its children; without threads in postorder.
void runUpwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                const std::function<void(std::uint32_t)>& work);

/// Runs each task before its children.
void runDownwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                  const std::function<void(std::uint32_t)>& work);

}  // namespace abflat
