#include "solve/cholesky/nested_dissection.h"

#include <algorithm>

#include "base/stable_order.h"
#include "solve/cholesky/minimum_degree.h"
#include "solve/cholesky/separator.h"

namespace abflat {
namespace {

/// Larger parts that cannot be separated are ordered by degree alone.
constexpr std::uint32_t kMaxLeaf = 2000;
/// A separator that weighs more than this share of the whole does not help.
constexpr double kUselessSeparator = 0.5;
/// Parts of at most this size are ordered by one task: about 5 ms.
constexpr std::uint32_t kSmallPart = 4000;

struct Part {
  WeightedGraph graph;
  std::vector<std::uint32_t> vertex;  ///< of the whole graph
  std::size_t end;                    ///< of its places in the order
};

/// The subgraph of the vertices in one of the sets.
Part extract(const Part& whole, const std::vector<std::uint8_t>& set, std::uint8_t wanted,
             std::vector<std::uint32_t>& number) {
  Part part;
  const WeightedGraph& g = whole.graph;
  number.resize(g.size());
  std::size_t edges = 0;
  for (std::uint32_t v = 0; v < g.size(); ++v)
    if (set[v] == wanted) {
      number[v] = static_cast<std::uint32_t>(part.vertex.size());
      part.vertex.push_back(whole.vertex[v]);
      part.graph.weight.push_back(g.weight[v]);
      edges += g.degree(v);
    }
  part.graph.offset.reserve(part.vertex.size() + 1);
  part.graph.neighbour.reserve(edges);
  part.graph.offset.push_back(0);
  for (std::uint32_t v = 0; v < g.size(); ++v) {
    if (set[v] != wanted) continue;
    for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
      if (set[*u] == wanted) part.graph.neighbour.push_back(number[*u]);
    part.graph.offset.push_back(part.graph.neighbour.size());
  }
  return part;
}

/// Numbers a separator along itself: neighbours in the mesh get neighbouring places, so that
/// the rows that a descendant shares with it come in runs.
void orderAlong(const Part& p, std::vector<std::uint32_t>& result) {
  const WeightedGraph& g = p.graph;
  const std::vector<std::uint32_t> byDegree = stableOrder(
      g.size(), [&](std::uint32_t a, std::uint32_t b) { return g.degree(a) < g.degree(b); });
  std::vector<std::uint32_t> stack;
  std::vector<std::uint8_t> seen(g.size(), 0);
  for (const std::uint32_t start : byDegree) {
    if (seen[start]) continue;
    stack.assign(1, start);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (seen[v]) continue;
      seen[v] = 1;
      result.push_back(p.vertex[v]);
      for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
        if (!seen[*u]) stack.push_back(*u);
    }
  }
}

/// Work space of one thread.
struct Scratch {
  std::vector<std::uint32_t> number, placed;
  LocalMinimumDegree minimumDegree;

  explicit Scratch(const WeightedGraph& graph) : minimumDegree(graph) {}
};

/// Orders parts, each independently of all others, into places of its own.
class Dissection {
 public:
  Dissection(const WeightedGraph& graph, const DissectionOptions& options, ThreadPool* pool)
      : graph_(graph), options_(options), pool_(pool), order_(graph.size()), group_(pool) {}

  std::vector<std::uint32_t> run() {
    Part all;
    all.graph = graph_;
    all.vertex.resize(graph_.size());
    all.end = graph_.size();
    for (std::uint32_t v = 0; v < graph_.size(); ++v) all.vertex[v] = v;
    addTask(std::move(all));
    group_.wait();
    return std::move(order_);
  }

 private:
  void addTask(Part part) {
    group_.add([this, shared = std::make_shared<Part>(std::move(part))] {
      std::unique_ptr<Scratch> scratch = spares_.take();
      if (!scratch) scratch = std::make_unique<Scratch>(graph_);
      orderPart(std::move(*shared), *scratch);
      spares_.give(std::move(scratch));
    });
  }

  /// A large part leaves its halves to other tasks.
  void orderPart(Part part, Scratch& scratch) {
    std::vector<Part> todo;
    todo.push_back(std::move(part));
    while (!todo.empty()) {
      const Part whole = std::move(todo.back());
      todo.pop_back();
      beat(pool_, whole.graph.size());
      Part first, second;
      if (whole.graph.size() <= options_.leafVertices || !divide(whole, scratch, first, second)) {
        orderLeaf(whole, scratch);
        continue;
      }
      for (Part* half : {&second, &first})
        if (whole.graph.size() > kSmallPart)
          addTask(std::move(*half));
        else
          todo.push_back(std::move(*half));
    }
  }

  /// Orders the separator. False when the part cannot be separated.
  bool divide(const Part& whole, Scratch& scratch, Part& first, Part& second) {
    ThreadPool* const pool = whole.graph.size() > kSmallPart ? pool_ : nullptr;
    const Separation s = separate(whole.graph, pool);
    const auto total = static_cast<double>(s.weight[0] + s.weight[1] + s.weight[2]);
    if (s.weight[0] == 0 || s.weight[1] == 0 ||
        static_cast<double>(s.weight[2]) > kUselessSeparator * total)
      return false;
    const Part separator = extract(whole, s.set, 2, scratch.number);
    scratch.placed.clear();
    orderAlong(separator, scratch.placed);
    place(scratch.placed, whole.end);
    std::vector<std::uint32_t> otherNumber;
    parallelFor(pool, 2, [&](std::size_t i) {
      if (i == 0)
        second = extract(whole, s.set, 1, scratch.number);
      else
        first = extract(whole, s.set, 0, otherNumber);
    });
    second.end = whole.end - scratch.placed.size();
    first.end = second.end - second.vertex.size();
    return true;
  }

  void orderLeaf(const Part& part, Scratch& scratch) {
    std::vector<std::uint32_t>& placed = scratch.placed;
    placed = part.vertex;
    if (part.vertex.size() <= kMaxLeaf)
      scratch.minimumDegree.order(placed);
    else
      sortStably(
          placed.data(), placed.data() + placed.size(),
          [&](std::uint32_t a, std::uint32_t b) { return graph_.degree(a) < graph_.degree(b); });
    place(placed, part.end);
  }

  void place(const std::vector<std::uint32_t>& placed, std::size_t end) {
    std::copy(placed.begin(), placed.end(),
              order_.begin() + static_cast<std::ptrdiff_t>(end - placed.size()));
  }

  const WeightedGraph& graph_;
  const DissectionOptions& options_;
  ThreadPool* pool_;
  std::vector<std::uint32_t> order_;
  Spares<Scratch> spares_;
  TaskGroup group_;
};

}  // namespace

std::vector<std::uint32_t> nestedDissection(const WeightedGraph& graph,
                                            const DissectionOptions& options, ThreadPool* pool) {
  return Dissection(graph, options, pool).run();
}

}  // namespace abflat
