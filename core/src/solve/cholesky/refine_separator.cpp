#include <algorithm>
#include <queue>

#include "solve/cholesky/separator.h"

namespace abflat {
namespace {

constexpr int kPasses = 8;
/// A part may weigh this share of both parts.
constexpr double kLargestPart = 0.6;

/// Moving a separator vertex to a part pulls its neighbours in the other part into the separator.
class Refinement {
 public:
  Refinement(const WeightedGraph& graph, Separation& separation)
      : g_(graph), s_(separation), version_(graph.size(), 0), locked_(graph.size(), 0) {}

  /// True when the separator became lighter or the parts better balanced.
  bool pass() {
    heap_ = {};
    log_.clear();
    touched_.clear();
    for (std::uint32_t v = 0; v < g_.size(); ++v)
      if (s_.set[v] == 2) push(v);
    const Score before = score();
    Score best = before;
    std::size_t bestLength = 0;
    const std::size_t patience = 40 + heap_.size() / 8;
    int fruitless = 0;
    while (!heap_.empty() && static_cast<std::size_t>(fruitless) < patience) {
      const Move m = heap_.top();
      heap_.pop();
      if (m.version != version_[m.vertex] || s_.set[m.vertex] != 2) continue;
      if (locked_[m.vertex] || !fits(m)) continue;
      apply(m);
      ++fruitless;
      if (score() < best) {
        best = score();
        bestLength = log_.size();
        fruitless = 0;
      }
    }
    while (log_.size() > bestLength) undo();
    for (const std::uint32_t v : touched_) locked_[v] = 0;
    return best < before;
  }

 private:
  struct Move {
    std::int64_t gain;
    std::uint32_t vertex, version;
    std::uint8_t part;
    bool operator<(const Move& o) const {
      if (gain != o.gain) return gain < o.gain;
      if (vertex != o.vertex) return vertex > o.vertex;
      return part > o.part;
    }
  };
  struct Score {
    std::uint64_t separator, imbalance;
    bool operator<(const Score& o) const {
      return separator != o.separator ? separator < o.separator : imbalance < o.imbalance;
    }
  };
  struct Change {
    std::uint32_t vertex;
    std::uint8_t from;
    bool isMove;  ///< the changes before it, back to the previous move, were pulled by it
  };

  Score score() const {
    const std::uint64_t a = s_.weight[0], b = s_.weight[1];
    const std::uint64_t worst = std::max(a, b);
    const bool unbalanced = static_cast<double>(worst) > kLargestPart * static_cast<double>(a + b);
    // An unbalanced cut is worse than any balanced one.
    return {s_.weight[2] + (unbalanced ? worst : 0), worst - std::min(a, b)};
  }

  std::int64_t gain(std::uint32_t v, std::uint8_t part) const {
    std::int64_t sum = g_.weight[v];
    for (const std::uint32_t* u = g_.begin(v); u != g_.end(v); ++u)
      if (s_.set[*u] == 1 - part) sum -= g_.weight[*u];
    return sum;
  }

  bool fits(const Move& m) const {
    const double here = static_cast<double>(s_.weight[m.part] + g_.weight[m.vertex]);
    const double other = static_cast<double>(s_.weight[1 - m.part]);
    return s_.weight[m.part] < s_.weight[1 - m.part] || here <= kLargestPart * (here + other);
  }

  void push(std::uint32_t v) {
    ++version_[v];
    if (locked_[v]) return;
    for (const std::uint8_t part : {std::uint8_t{0}, std::uint8_t{1}})
      heap_.push({gain(v, part), v, version_[v], part});
  }

  void set(std::uint32_t v, std::uint8_t to) {
    s_.weight[s_.set[v]] -= g_.weight[v];
    s_.weight[to] += g_.weight[v];
    s_.set[v] = to;
  }

  void apply(const Move& m) {
    const std::uint32_t v = m.vertex;
    stale_.clear();
    for (const std::uint32_t* u = g_.begin(v); u != g_.end(v); ++u) {
      if (s_.set[*u] == 2) stale_.push_back(*u);
      if (s_.set[*u] != 1 - m.part) continue;
      log_.push_back({*u, s_.set[*u], false});
      set(*u, 2);
      stale_.push_back(*u);
      for (const std::uint32_t* x = g_.begin(*u); x != g_.end(*u); ++x)
        if (s_.set[*x] == 2 && *x != v) stale_.push_back(*x);
    }
    log_.push_back({v, 2, true});
    set(v, m.part);
    locked_[v] = 1;
    touched_.push_back(v);
    std::sort(stale_.begin(), stale_.end());
    stale_.erase(std::unique(stale_.begin(), stale_.end()), stale_.end());
    for (const std::uint32_t u : stale_) push(u);
  }

  void undo() {
    set(log_.back().vertex, 2);
    log_.pop_back();
    for (; !log_.empty() && !log_.back().isMove; log_.pop_back())
      set(log_.back().vertex, log_.back().from);
  }

  const WeightedGraph& g_;
  Separation& s_;
  std::vector<std::uint32_t> version_;
  std::vector<std::uint8_t> locked_;
  std::priority_queue<Move> heap_;
  std::vector<Change> log_;
  std::vector<std::uint32_t> touched_, stale_;
};

}  // namespace

void refineSeparator(const WeightedGraph& graph, Separation& separation) {
  Refinement refinement(graph, separation);
  for (int pass = 0; pass < kPasses && refinement.pass(); ++pass) {
  }
}

}  // namespace abflat
