#include "solve/cholesky/supernodes.h"

#include <algorithm>

namespace abflat {
namespace {

/// A supernode that may still be joined with its parent; sizes in matrix rows.
struct PanelDraft {
  double columns = 0, rows = 0;                ///< `rows` includes the columns
  std::uint32_t firstPlace = 0, endPlace = 0;  ///< own vertices, without those joined to it
  std::uint32_t parent = kNoParent;
  std::uint32_t joinedTo = kNoParent;
};

double panelTime(double rows, double columns, const PanelCost& cost) {
  const double below = rows - columns;
  // sum of (rows - j)^2 / 2 over the columns
  const double multiplies = columns * (rows * below + columns * columns / 3) / 2;
  return cost.perPanel + cost.perRow * rows + cost.perUpdateEntry * below * below / 2 + multiplies;
}

/// Largest chains of columns with the same structure.
std::vector<PanelDraft> fundamentalPanels(const WeightedGraph& g, const EliminationTree& t) {
  std::vector<PanelDraft> panels;
  std::vector<std::uint32_t> panelOf(g.size());
  for (std::uint32_t j = 0; j < g.size(); ++j) {
    const bool continues =
        j > 0 && t.parent[j - 1] == j && t.count[j - 1] == t.count[j] + g.weight[t.order[j - 1]];
    if (!continues) {
      panels.emplace_back();
      panels.back().firstPlace = j;
      panels.back().rows = static_cast<double>(t.count[j]);
    }
    panels.back().columns += g.weight[t.order[j]];
    panels.back().endPlace = j + 1;
    panelOf[j] = static_cast<std::uint32_t>(panels.size() - 1);
  }
  for (PanelDraft& p : panels)
    if (t.parent[p.endPlace - 1] != kNoParent) p.parent = panelOf[t.parent[p.endPlace - 1]];
  return panels;
}

void joinPanels(std::vector<PanelDraft>& panels, const PanelCost& cost) {
  std::vector<std::vector<std::uint32_t>> children(panels.size());
  for (std::uint32_t s = 0; s < panels.size(); ++s) {
    PanelDraft& p = panels[s];
    // The last child is the one with the most rows in common, as a rule.
    for (std::size_t i = children[s].size(); i-- > 0;) {
      PanelDraft& c = panels[children[s][i]];
      const double apart = panelTime(c.rows, c.columns, cost) + panelTime(p.rows, p.columns, cost);
      if (panelTime(c.columns + p.rows, c.columns + p.columns, cost) > apart) continue;
      p.rows += c.columns;
      p.columns += c.columns;
      c.joinedTo = s;
    }
    if (p.parent != kNoParent) children[p.parent].push_back(s);
  }
}

/// Numbers what is left of the panels in postorder and their columns accordingly.
void numberPanels(const std::vector<PanelDraft>& panels, const EliminationTree& t,
                  Supernodes& out) {
  const auto n = static_cast<std::uint32_t>(panels.size());
  std::vector<std::uint32_t> top(n);  // the panel it became a part of
  for (std::uint32_t s = n; s-- > 0;)
    top[s] = panels[s].joinedTo == kNoParent ? s : top[panels[s].joinedTo];
  std::vector<std::uint32_t> number(n, kNoParent), left, parent;
  for (std::uint32_t s = 0; s < n; ++s)
    if (top[s] == s) {
      number[s] = static_cast<std::uint32_t>(left.size());
      left.push_back(s);
    }
  for (const std::uint32_t s : left)
    parent.push_back(panels[s].parent == kNoParent ? kNoParent : number[top[panels[s].parent]]);
  const std::vector<std::uint32_t> post = postorder(parent);
  std::vector<std::uint32_t> place(left.size());
  for (std::uint32_t k = 0; k < post.size(); ++k) place[post[k]] = k;
  std::vector<std::uint32_t> vertices(left.size() + 1, 0);
  for (std::uint32_t s = 0; s < n; ++s)
    vertices[place[number[top[s]]] + 1] += panels[s].endPlace - panels[s].firstPlace;
  for (std::size_t k = 0; k < left.size(); ++k) vertices[k + 1] += vertices[k];
  out.first = vertices;
  out.order.resize(t.order.size());
  for (std::uint32_t s = 0; s < n; ++s)  // joined children come before the panel's own columns
    for (std::uint32_t j = panels[s].firstPlace; j < panels[s].endPlace; ++j)
      out.order[vertices[place[number[top[s]]]]++] = t.order[j];
  for (const std::uint32_t p : post)
    out.parent.push_back(parent[p] == kNoParent ? kNoParent : place[parent[p]]);
}

/// Rows of a supernode: those of its columns in the matrix and those of its children.
void findRows(const WeightedGraph& g, Supernodes& s) {
  const std::uint32_t n = g.size();
  std::vector<std::uint32_t> place(n), marked(n, kNoParent);
  for (std::uint32_t k = 0; k < n; ++k) place[s.order[k]] = k;
  std::vector<std::vector<std::uint32_t>> children(s.size());
  s.rowsBegin.assign(1, 0);
  for (std::uint32_t p = 0; p < s.size(); ++p) {
    const auto begin = static_cast<std::ptrdiff_t>(s.rows.size());
    const std::uint32_t end = s.first[p + 1];
    const auto add = [&](std::uint32_t row) {
      if (row < end || marked[row] == p) return;
      marked[row] = p;
      s.rows.push_back(row);
    };
    for (std::uint32_t k = s.first[p]; k < end; ++k)
      for (const std::uint32_t* u = g.begin(s.order[k]); u != g.end(s.order[k]); ++u)
        add(place[*u]);
    for (const std::uint32_t c : children[p])
      for (std::size_t i = s.rowsBegin[c]; i < s.rowsBegin[c + 1]; ++i) add(s.rows[i]);
    std::sort(s.rows.begin() + begin, s.rows.end());
    s.rowsBegin.push_back(s.rows.size());
    if (s.parent[p] != kNoParent) children[s.parent[p]].push_back(p);
  }
}

}  // namespace

Supernodes findSupernodes(const WeightedGraph& graph, const EliminationTree& tree,
                          const PanelCost& cost) {
  std::vector<PanelDraft> panels = fundamentalPanels(graph, tree);
  joinPanels(panels, cost);
  Supernodes s;
  numberPanels(panels, tree, s);
  findRows(graph, s);
  return s;
}

}  // namespace abflat
