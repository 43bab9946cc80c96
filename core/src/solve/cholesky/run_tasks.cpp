#include "solve/cholesky/run_tasks.h"

#include <atomic>

#include "solve/cholesky/elimination_tree.h"

namespace abflat {

void runUpwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                const std::function<void(std::uint32_t)>& work) {
  const auto count = static_cast<std::uint32_t>(tasks.size());
  if (!isParallel(pool) || count < 2) {
    for (std::uint32_t t = 0; t < count; ++t) work(t);
    return;
  }
  std::vector<std::atomic<std::uint32_t>> unfinishedChildren(count);
  for (const CholeskyTask& task : tasks)
    if (task.parent != kNoParent) ++unfinishedChildren[task.parent];
  std::function<void(std::uint32_t)> run;
  TaskGroup group(pool);
  run = [&](std::uint32_t t) {
    work(t);
    const std::uint32_t p = tasks[t].parent;
    if (p != kNoParent && --unfinishedChildren[p] == 0) group.add([&run, p] { run(p); });
  };
  // The last one added runs first: nearly postorder, so that few results wait.
  for (std::uint32_t t = count; t-- > 0;)
    if (tasks[t].firstChild == kNoParent) group.add([&run, t] { run(t); });
  group.wait();
}

void runDownwards(ThreadPool* pool, const std::vector<CholeskyTask>& tasks,
                  const std::function<void(std::uint32_t)>& work) {
  const auto count = static_cast<std::uint32_t>(tasks.size());
  if (!isParallel(pool) || count < 2) {
    for (std::uint32_t t = count; t-- > 0;) work(t);
    return;
  }
  std::function<void(std::uint32_t)> run;
  TaskGroup group(pool);
  run = [&](std::uint32_t t) {
    work(t);
    for (std::uint32_t c = tasks[t].firstChild; c != kNoParent; c = tasks[c].nextSibling)
      group.add([&run, c] { run(c); });
  };
  for (std::uint32_t t = 0; t < count; ++t)
    if (tasks[t].parent == kNoParent) group.add([&run, t] { run(t); });
  group.wait();
}

}  // namespace abflat
