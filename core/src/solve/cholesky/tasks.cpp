#include "solve/cholesky/tasks.h"

#include <algorithm>

#include "solve/cholesky/elimination_tree.h"

namespace abflat {
namespace {

/// Subtrees with at most this share of all work are not divided ...
constexpr double kSmallShare = 1.0 / 48;
/// ... nor those with less than these multiplications and additions: about 0.2 ms.
constexpr double kSmallWork = 1e6;
/// What a supernode costs beyond its multiplications and additions, in their time.
constexpr double kPerSupernode = 1000;

/// Work of each supernode's subtree.
std::vector<double> subtreeWork(const std::vector<std::uint32_t>& parent,
                                const SupernodeSizes& sizes) {
  std::vector<double> work(parent.size(), 0);
  for (std::size_t s = 0; s < parent.size(); ++s) {
    work[s] += sizes.flops[s] + kPerSupernode;
    if (parent[s] != kNoParent) work[parent[s]] += work[s];
  }
  return work;
}

void linkChildren(std::vector<CholeskyTask>& tasks) {
  for (auto t = static_cast<std::uint32_t>(tasks.size()); t-- > 0;) {
    const std::uint32_t p = tasks[t].parent;
    if (p == kNoParent) continue;
    tasks[t].nextSibling = tasks[p].firstChild;
    tasks[p].firstChild = t;
  }
}

/// Room that the stacks need, and results that wait at once when tasks run in order.
void measureMemory(const std::vector<std::uint32_t>& parent, const std::vector<std::uint8_t>& stack,
                   const SupernodeSizes& sizes, CholeskyTasks& out) {
  std::vector<std::size_t> ofChildren(parent.size(), 0), resultOfChildren(out.all.size(), 0);
  std::size_t waiting = 0;
  for (std::size_t t = 0; t < out.all.size(); ++t) {
    CholeskyTask& task = out.all[t];
    std::array<std::size_t, 2> used{};
    for (std::uint32_t s = task.begin; s < task.end; ++s) {
      if (parent[s] == kNoParent || parent[s] >= task.end) {
        task.result += sizes.update[s];
      } else {
        used[stack[s]] += sizes.update[s];
        ofChildren[parent[s]] += sizes.update[s];
        out.stackSize[stack[s]] = std::max(out.stackSize[stack[s]], used[stack[s]]);
      }
      used[!stack[s]] -= ofChildren[s];
    }
    waiting += task.result;
    out.maxResults = std::max(out.maxResults, waiting);
    waiting -= resultOfChildren[t];
    if (task.parent != kNoParent) resultOfChildren[task.parent] += task.result;
  }
}

}  // namespace

CholeskyTasks divideIntoTasks(const std::vector<std::uint32_t>& parent,
                              const std::vector<std::uint8_t>& stack, const SupernodeSizes& sizes) {
  const auto n = static_cast<std::uint32_t>(parent.size());
  const std::vector<double> work = subtreeWork(parent, sizes);
  double total = 0;
  for (std::uint32_t s = 0; s < n; ++s)
    if (parent[s] == kNoParent) total += work[s];
  const double small = std::max(kSmallWork, kSmallShare * total);

  CholeskyTasks out;
  std::vector<std::uint32_t> taskOf(n);
  double workOfLast = 0;
  std::uint32_t parentOfLast = kNoParent;  // supernode; only of small subtrees
  bool isLastSmall = false;
  std::uint32_t begin = 0;  // of the subtree being looked for
  for (std::uint32_t s = 0; s < n; ++s) {
    const bool isSmall = work[s] <= small;
    if (isSmall && parent[s] != kNoParent && work[parent[s]] <= small) continue;  // not its root
    if (isSmall && isLastSmall && parentOfLast == parent[s] && workOfLast + work[s] <= small) {
      out.all.back().end = s + 1;
      workOfLast += work[s];
    } else {
      out.all.push_back({begin, s + 1, kNoParent, kNoParent, kNoParent, 0});
      workOfLast = work[s];
    }
    isLastSmall = isSmall;
    parentOfLast = parent[s];
    begin = s + 1;
  }
  for (std::uint32_t t = 0; t < out.all.size(); ++t)
    std::fill(taskOf.begin() + out.all[t].begin, taskOf.begin() + out.all[t].end, t);
  for (CholeskyTask& task : out.all)
    if (parent[task.end - 1] != kNoParent) task.parent = taskOf[parent[task.end - 1]];
  linkChildren(out.all);
  measureMemory(parent, stack, sizes, out);
  return out;
}

}  // namespace abflat
