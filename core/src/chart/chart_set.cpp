#include "chart/chart_set.h"

#include <algorithm>
#include <utility>

#include "mesh/topology.h"

namespace abflat {
namespace {

/// Vertices of one chart: fans in their order, which is that of the input's vertices.
class VertexNumbers {
 public:
  explicit VertexNumbers(std::size_t fans) : number_(fans, kNone) {}

  const std::vector<std::uint32_t>& sorted(const std::uint32_t* fans, std::size_t count) {
    sorted_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      if (number_[fans[i]] != kNone) continue;
      number_[fans[i]] = 0;
      sorted_.push_back(fans[i]);
    }
    std::sort(sorted_.begin(), sorted_.end());
    for (std::uint32_t i = 0; i < sorted_.size(); ++i) number_[sorted_[i]] = i;
    return sorted_;
  }
  std::uint32_t operator[](std::uint32_t fan) const { return number_[fan]; }

 private:
  std::vector<std::uint32_t> number_;  ///< fans belong to one chart each
  std::vector<std::uint32_t> sorted_;
};

std::vector<std::uint32_t> copyOf(Indices numbers) { return {numbers.begin(), numbers.end()}; }

}  // namespace

class ChartSetMaker {
 public:
  ChartSetMaker(const PolygonMesh& mesh, const FilledTable& filled)
      : filled_(filled), cut_(filled.table), fans_(findFans(cut_, mesh.vertexCount())) {
    Components parts = findComponents(cut_);
    out_.mesh_ = &mesh;
    out_.parts_.resize(parts.firstTriangle.size() + 1);
    out_.ofTriangle = std::move(parts.ofTriangle);
  }

  ChartSet run() {
    listTriangles();
    connect();
    listBoundaries();
    countHoles();
    out_.ofTriangle.resize(filled_.surfaceTriangles);
    return std::move(out_);
  }

 private:
  using Part = ChartSet::Part;

  /// Turns numbers of the charts, each with the one before, into where they begin.
  void addUp(std::uint32_t Part::*number) {
    for (std::size_t i = 1; i < out_.parts_.size(); ++i)
      out_.parts_[i].*number += out_.parts_[i - 1].*number;
  }

  void listTriangles() {
    for (const std::uint32_t chart : out_.ofTriangle) ++out_.parts_[chart + 1].triangle;
    addUp(&Part::triangle);
    std::vector<std::uint32_t> next(out_.size(), 0);
    local_.resize(cut_.triangleCount());
    out_.triangles_.resize(cut_.triangleCount());
    for (std::uint32_t f = 0; f < cut_.triangleCount(); ++f) {
      const std::uint32_t chart = out_.ofTriangle[f];
      local_[f] = next[chart]++;
      out_.triangles_[out_.parts_[chart].triangle + local_[f]] = f;
    }
  }

  void connect() {
    VertexNumbers numbers(fans_.inputVertex.size());
    out_.vertexOfCorner_.reserve(cut_.twin.size());
    out_.twin_.reserve(cut_.twin.size());
    out_.inputVertex_.reserve(fans_.inputVertex.size());
    for (const std::uint32_t f : out_.triangles_)
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::uint32_t twin = cut_.twin[h];
        out_.vertexOfCorner_.push_back(fans_.ofCorner[h]);
        out_.twin_.push_back(twin == kNone ? kNone : localCorner(twin));
      }
    for (std::size_t i = 0; i < out_.size(); ++i) {
      const std::size_t begin = 3 * std::size_t{out_.parts_[i].triangle},
                        end = 3 * std::size_t{out_.parts_[i + 1].triangle};
      for (const std::uint32_t fan : numbers.sorted(&out_.vertexOfCorner_[begin], end - begin))
        out_.inputVertex_.push_back(fans_.inputVertex[fan]);
      out_.parts_[i + 1].vertex = static_cast<std::uint32_t>(out_.inputVertex_.size());
    }
    for (std::uint32_t& v : out_.vertexOfCorner_) v = numbers[v];
  }

  void listBoundaries() {
    const std::vector<std::vector<std::uint32_t>> loops = findBoundaryLoops(cut_);
    const auto chartOf = [&](const std::vector<std::uint32_t>& loop) {
      return out_.ofTriangle[loop.front() / 3];
    };
    for (const std::vector<std::uint32_t>& loop : loops)
      out_.parts_[chartOf(loop) + 1].boundary += static_cast<std::uint32_t>(loop.size());
    addUp(&Part::boundary);
    out_.boundary_.resize(out_.parts_.back().boundary);
    std::vector<std::uint32_t> written(out_.size(), 0);  // islands that are given may have holes
    for (const std::vector<std::uint32_t>& loop : loops) {
      const std::uint32_t chart = chartOf(loop), begin = out_.parts_[chart].boundary;
      for (const std::uint32_t h : loop) out_.boundary_[begin + written[chart]++] = localCorner(h);
    }
  }

  void countHoles() {
    std::uint32_t last = kNone;  // triangles that fill a hole follow each other
    for (std::uint32_t i = 0; i < filled_.hole.size(); ++i) {
      Part& part = out_.parts_[out_.ofTriangle[filled_.surfaceTriangles + i]];
      ++part.fillingTriangles;
      part.filledHoles += filled_.hole[i] != last;
      last = filled_.hole[i];
    }
  }

  std::uint32_t localCorner(std::uint32_t h) const { return 3 * local_[h / 3] + h % 3; }

  const FilledTable& filled_;
  const CornerTable& cut_;
  const Fans fans_;
  std::vector<std::uint32_t> local_;  ///< per triangle, its number within its chart
  ChartSet out_;
};

ChartTopology ChartSet::topology(std::size_t i) const {
  const Part &from = parts_[i], &to = parts_[i + 1];
  const auto part = [](const std::vector<std::uint32_t>& all, std::size_t begin, std::size_t end) {
    return Indices{all.data() + begin, end - begin};
  };
  const std::size_t begin = 3 * std::size_t{from.triangle}, end = 3 * std::size_t{to.triangle};
  return {part(vertexOfCorner_, begin, end),
          part(twin_, begin, end),
          part(boundary_, from.boundary, to.boundary),
          part(inputVertex_, from.vertex, to.vertex),
          from.fillingTriangles,
          from.filledHoles};
}

Indices ChartSet::triangles(std::size_t i) const {
  return {triangles_.data() + parts_[i].triangle,
          parts_[i + 1].triangle - parts_[i].triangle - parts_[i].fillingTriangles};
}

DiskChart ChartSet::chart(std::size_t i) const {
  const ChartTopology own = topology(i);
  DiskChart out;
  out.vertexOfCorner = copyOf(own.vertexOfCorner);
  out.twin = copyOf(own.twin);
  out.boundary = copyOf(own.boundary);
  out.inputVertex = copyOf(own.inputVertex);
  out.fillingTriangles = own.fillingTriangles;
  out.filledHoles = own.filledHoles;
  if (!place.empty())
    for (const std::uint32_t v : out.inputVertex) out.place.push_back(place[v]);
  placeChart(*mesh_, out);
  return out;
}

ChartSet makeCharts(const PolygonMesh& mesh, const FilledTable& filled) {
  return ChartSetMaker(mesh, filled).run();
}

}  // namespace abflat
