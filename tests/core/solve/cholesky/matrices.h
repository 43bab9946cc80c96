#pragma once

#include <Eigen/SparseCore>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "abflat/mesh.h"
#include "solve/cholesky/cholesky.h"

namespace abflat::test {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Edges = std::vector<std::pair<int, int>>;

inline LowerPattern patternOf(const SparseMatrix& lower) {
  return {static_cast<std::uint32_t>(lower.rows()), lower.outerIndexPtr(), lower.innerIndexPtr()};
}

inline std::shared_ptr<const CholeskySymbolic> analyzed(
    const SparseMatrix& lower, const CholeskyAnalysisOptions& options = {}) {
  return std::make_shared<const CholeskySymbolic>(analyzePattern(patternOf(lower), options));
}

/// Lower triangle of a graph Laplacian with random weights plus `shift` on the diagonal.
inline SparseMatrix graphLaplacian(int n, const Edges& edges, double shift, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> weight(0.2, 2);
  std::vector<Eigen::Triplet<double>> t;
  for (int i = 0; i < n; ++i) t.emplace_back(i, i, shift);
  for (const auto& [a, b] : edges) {
    const double w = weight(random);
    t.emplace_back(a, a, w);
    t.emplace_back(b, b, w);
    t.emplace_back(std::max(a, b), std::min(a, b), -w);
  }
  SparseMatrix m(n, n);
  m.setFromTriplets(t.begin(), t.end());
  return m;
}

inline SparseMatrix meshLaplacian(const PolygonMesh& mesh, double shift = 1e-3) {
  Edges edges;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::size_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    for (std::size_t c = begin; c < end; ++c)
      edges.emplace_back(static_cast<int>(mesh.faceVertices[c]),
                         static_cast<int>(mesh.faceVertices[c + 1 < end ? c + 1 : begin]));
  }
  return graphLaplacian(static_cast<int>(mesh.vertexCount()), edges, shift, 5);
}

/// Two rows per row of `lower`, coupled by positive definite 2x2 blocks.
inline SparseMatrix withTwoRowsEach(const SparseMatrix& lower) {
  const double block[2][2] = {{2, 0.5}, {0.5, 1}};
  std::vector<Eigen::Triplet<double>> t;
  for (int c = 0; c < lower.outerSize(); ++c)
    for (SparseMatrix::InnerIterator it(lower, c); it; ++it)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
          if (2 * it.row() + a >= 2 * c + b)
            t.emplace_back(2 * static_cast<int>(it.row()) + a, 2 * c + b, it.value() * block[a][b]);
  SparseMatrix m(2 * lower.rows(), 2 * lower.cols());
  m.setFromTriplets(t.begin(), t.end());
  return m;
}

struct NamedGraph {
  std::string name;
  int size;
  Edges edges;
};

/// Graphs that are hard for orderings: empty, one vertex, no edges, stars, paths, cliques, trees,
/// several components, hubs, random ones.
inline std::vector<NamedGraph> awkwardGraphs() {
  std::vector<NamedGraph> graphs;
  const auto add = [&](std::string name, int n, auto&& connect) {
    Edges edges;
    connect(edges);
    graphs.push_back({std::move(name), n, std::move(edges)});
  };
  const auto path = [](int from, int to) {
    return [=](Edges& e) {
      for (int i = from; i + 1 < to; ++i) e.emplace_back(i, i + 1);
    };
  };
  const auto star = [](int hub, int from, int to) {
    return [=](Edges& e) {
      for (int i = from; i < to; ++i)
        if (i != hub) e.emplace_back(hub, i);
    };
  };
  const auto clique = [](int from, int to) {
    return [=](Edges& e) {
      for (int i = from; i < to; ++i)
        for (int j = from; j < i; ++j) e.emplace_back(i, j);
    };
  };
  const auto random = [](int n, int edges, unsigned seed) {
    return [=](Edges& e) {
      std::mt19937 generator(seed);
      std::uniform_int_distribution<int> vertex(0, n - 1);
      for (int i = 0; i < edges; ++i) {
        const int a = vertex(generator), b = vertex(generator);
        if (a != b) e.emplace_back(a, b);
      }
    };
  };
  add("empty", 0, [](Edges&) {});
  add("one vertex", 1, [](Edges&) {});
  add("two vertices", 2, path(0, 2));
  add("no edges", 1500, [](Edges&) {});
  add("path", 2000, path(0, 2000));
  add("star, hub first", 1500, star(0, 0, 1500));
  add("star, hub last", 1500, star(1499, 0, 1500));
  add("clique", 150, clique(0, 150));
  add("large clique", 300, clique(0, 300));
  add("components", 900, [&](Edges& e) {
    path(0, 300)(e);
    star(300, 300, 600)(e);
    clique(600, 640)(e);
  });
  add("mesh-like with hubs", 1200, [&](Edges& e) {
    path(0, 1200)(e);
    for (int i = 0; i + 40 < 1200; ++i) e.emplace_back(i, i + 40);
    star(7, 0, 1200)(e);
    star(600, 0, 900)(e);
  });
  add("random, sparse", 1200, random(1200, 1500, 3));
  add("random, denser", 400, random(400, 4000, 4));
  add("binary tree", 1023, [](Edges& e) {
    for (int i = 1; i < 1023; ++i) e.emplace_back(i, (i - 1) / 2);
  });
  return graphs;
}

}  // namespace abflat::test
