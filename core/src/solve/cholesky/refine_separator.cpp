#include <algorithm>
#include <queue>

#include "solve/cholesky/separator.h"

namespace abflat {
namespace {

constexpr int kPasses = 10;
/// Moves without success before a pass ends: at most this number and one per separator vertex.
constexpr std::size_t kPatience = 200;
/// A part may weigh this share of both parts.
constexpr double kLargestPart = 0.6;

/// Moving a separator vertex to a part pulls its neighbours in the other part into the separator.
/// All moves of a pass go the same way: the separator sweeps over the other part, past obstacles,
/// and the best position on its way is kept.
class Refinement {
 public:
  Refinement(const WeightedGraph& graph, Separation& separation)
      : g_(graph),
        s_(separation),
        version_(graph.size(), 0),
        to_(separation.weight[0] < separation.weight[1] ? 0 : 1) {
    for (std::uint32_t v = 0; v < g_.size(); ++v)
      if (s_.set[v] == 2) separator_.push_back(v);
  }

  /// True if the separator became lighter or the parts better balanced.
  bool pass() {
    heap_ = {};
    log_.clear();
    for (const std::uint32_t v : separator_) push(v);
    const Score before = score();
    Score best = before;
    std::size_t bestLength = 0;
    const std::size_t sweep = heap_.size();
    const std::size_t patience = std::min(kPatience + sweep, 20 + 2 * sweep);
    int fruitless = 0;
    while (!heap_.empty() && static_cast<std::size_t>(fruitless) < patience) {
      const Move m = heap_.top();
      heap_.pop();
      if (m.version != version_[m.vertex] || s_.set[m.vertex] != 2) continue;
      if (!fits(m.vertex)) continue;
      apply(m.vertex);
      ++fruitless;
      if (score() < best) {
        best = score();
        bestLength = log_.size();
        fruitless = 0;
      }
    }
    while (log_.size() > bestLength) undo();
    for (const Change& c : log_) separator_.push_back(c.vertex);
    std::sort(separator_.begin(), separator_.end());
    separator_.erase(std::unique(separator_.begin(), separator_.end()), separator_.end());
    separator_.erase(std::remove_if(separator_.begin(), separator_.end(),
                                    [&](std::uint32_t v) { return s_.set[v] != 2; }),
                     separator_.end());
    to_ = to_ == 0;
    return best < before;
  }

 private:
  struct Move {
    std::int64_t gain;
    std::uint32_t vertex, version;
    bool operator<(const Move& o) const {
      if (gain != o.gain) return gain < o.gain;
      return vertex > o.vertex;
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

  std::int64_t gain(std::uint32_t v) const {
    std::int64_t sum = g_.weight[v];
    for (const std::uint32_t* u = g_.begin(v); u != g_.end(v); ++u)
      if (s_.set[*u] == 1 - to_) sum -= g_.weight[*u];
    return sum;
  }

  bool fits(std::uint32_t v) const {
    const auto here = static_cast<double>(s_.weight[to_] + g_.weight[v]);
    const auto other = static_cast<double>(s_.weight[1 - to_]);
    return s_.weight[to_] < s_.weight[1 - to_] || here <= kLargestPart * (here + other);
  }

  void push(std::uint32_t v) { heap_.push({gain(v), v, ++version_[v]}); }

  void set(std::uint32_t v, std::uint8_t to) {
    s_.weight[s_.set[v]] -= g_.weight[v];
    s_.weight[to] += g_.weight[v];
    s_.set[v] = to;
  }

  void apply(std::uint32_t v) {
    stale_.clear();
    for (const std::uint32_t* u = g_.begin(v); u != g_.end(v); ++u) {
      if (s_.set[*u] != 1 - to_) continue;
      log_.push_back({*u, s_.set[*u], false});
      set(*u, 2);
      stale_.push_back(*u);
      for (const std::uint32_t* x = g_.begin(*u); x != g_.end(*u); ++x)
        if (s_.set[*x] == 2 && *x != v) stale_.push_back(*x);
    }
    log_.push_back({v, 2, true});
    set(v, to_);
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
  std::uint8_t to_;  ///< the part that grows
  std::priority_queue<Move> heap_;
  std::vector<Change> log_;
  std::vector<std::uint32_t> separator_, stale_;
};

}  // namespace

void refineSeparator(const WeightedGraph& graph, Separation& separation) {
  Refinement refinement(graph, separation);
  int fruitless = 0;
  for (int pass = 0; pass < kPasses && fruitless < 2; ++pass)
    fruitless = refinement.pass() ? 0 : fruitless + 1;
}

}  // namespace abflat
