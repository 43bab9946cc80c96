#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abflat {

/// Supernodes that one thread handles, one after another: a large one alone, or whole subtrees of
/// the elimination tree that hang from the same supernode. Tasks are in postorder, as supernodes
/// are.
struct CholeskyTask {
  std::uint32_t begin = 0, end = 0;  ///< supernodes
  std::uint32_t parent = 0;          ///< task, kNoParent at a root
  std::uint32_t firstChild = 0;   ///< the children are this task and its siblings; kNoParent: none
  std::uint32_t nextSibling = 0;  ///< kNoParent at the last
  std::size_t result = 0;         ///< doubles in the update matrices that it leaves to its parent
};

/// How the work on a factor is divided. Depends on the matrix alone, and so does every result.
struct CholeskyTasks {
  std::vector<CholeskyTask> all;
  std::array<std::size_t, 2> stackSize{};  ///< doubles that one thread needs
  std::size_t maxResults = 0;              ///< doubles that wait for parents at once, on one thread
};

struct SupernodeSizes {
  std::vector<std::size_t> update;  ///< doubles in the update matrix
  std::vector<double> flops;
};

/// `stack`: per supernode, which of the two stacks holds its update matrix within a task.
CholeskyTasks divideIntoTasks(const std::vector<std::uint32_t>& parent,
                              const std::vector<std::uint8_t>& stack, const SupernodeSizes& sizes);

}  // namespace abflat
