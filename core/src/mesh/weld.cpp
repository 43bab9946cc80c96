#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/corner_table.h"

namespace abflat {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Cells are so much larger than the tolerance that nearly every vertex needs to look in its own
/// only.
constexpr double kCellPerTolerance = 64;

/// First vertices of places, by the cell they are in: an open hash table whose order of lookups
/// depends on the input alone.
class Places {
 public:
  Places(const std::vector<double>& positions, double cellSize)
      : positions_(positions), cellSize_(cellSize), next_(positions.size() / 3, kNone) {
    std::size_t size = 16;
    while (size < positions.size() / 3 * 2) size *= 2;
    slots_.assign(size, {{0, 0, 0}, kNone});
    for (std::size_t d = 0; d < 3; ++d) low_[d] = positions.empty() ? 0 : positions[d];
    for (std::size_t i = 0; i < positions.size(); ++i)
      low_[i % 3] = std::min(low_[i % 3], positions[i]);
  }

  /// A vertex within `reach` of v that has been added, or kNone; the first such one of the first
  /// cell.
  std::uint32_t find(std::uint32_t v, double reach) const {
    Cell from, to;
    for (std::size_t d = 0; d < 3; ++d) {
      from[d] = cellOf(v, d, -reach);
      to[d] = cellOf(v, d, reach);
    }
    Cell c;
    for (c[0] = from[0]; c[0] <= to[0]; ++c[0])
      for (c[1] = from[1]; c[1] <= to[1]; ++c[1])
        for (c[2] = from[2]; c[2] <= to[2]; ++c[2])
          for (std::uint32_t u = slots_[slotOf(c)].first; u != kNone; u = next_[u])
            if (isWithin(u, v, reach)) return u;
    return kNone;
  }

  void add(std::uint32_t v) {
    const Cell cell{cellOf(v, 0, 0), cellOf(v, 1, 0), cellOf(v, 2, 0)};
    Slot& slot = slots_[slotOf(cell)];
    slot.cell = cell;
    next_[v] = slot.first;
    slot.first = v;
  }

  bool isWithin(std::uint32_t u, std::uint32_t v, double reach) const {
    double square = 0;
    if (reach == 0) return at(u, 0) == at(v, 0) && at(u, 1) == at(v, 1) && at(u, 2) == at(v, 2);
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = (at(u, d) - at(v, d)) / reach;
      square += x * x;
    }
    return square <= 1;
  }

 private:
  struct Slot {
    Cell cell;
    std::uint32_t first;  ///< kNone: empty
  };

  double at(std::uint32_t v, std::size_t d) const {
    return positions_[3 * static_cast<std::size_t>(v) + d];
  }
  /// Extents may be as large as doubles get: halves of them do not overflow.
  std::int64_t cellOf(std::uint32_t v, std::size_t d, double shift) const {
    const double from = at(v, d) / 2 - low_[d] / 2 + shift / 2;
    return cellSize_ > 0 ? static_cast<std::int64_t>(std::floor(from / (cellSize_ / 2))) : 0;
  }
  std::size_t slotOf(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell)
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
    std::size_t i = (hash ^ hash >> 32) & (slots_.size() - 1);
    while (slots_[i].first != kNone && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
    return i;
  }

  const std::vector<double>& positions_;
  double cellSize_;
  std::array<double, 3> low_{};
  std::vector<std::uint32_t> next_;  ///< in the same cell
  std::vector<Slot> slots_;
};

/// Halved, so that it never overflows.
double halfDiagonal(const std::vector<double>& positions) {
  if (positions.empty()) return 0;
  double square = 0, largest = 0;
  std::array<double, 3> extent{};
  for (std::size_t d = 0; d < 3; ++d) {
    double low = positions[d], high = positions[d];
    for (std::size_t i = d; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    extent[d] = high / 2 - low / 2;
    largest = std::max(largest, extent[d]);
  }
  if (largest == 0) return 0;
  for (const double x : extent) square += x / largest * (x / largest);
  return largest * std::sqrt(square);
}

}  // namespace

namespace {

Welding weldWithin(const std::vector<double>& positions, double reach, double cellSize) {
  const auto n = static_cast<std::uint32_t>(positions.size() / 3);
  Welding out;
  out.reach = reach;
  out.ofVertex.resize(n);
  Places places(positions, cellSize);
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t found = places.find(v, reach);
    out.ofVertex[v] = found == kNone ? v : found;
    if (found == kNone) {
      places.add(v);
      continue;
    }
    ++out.merged;
    out.isExact = out.isExact && places.isWithin(found, v, 0);
  }
  return out;
}

}  // namespace

Welding weldVertices(const std::vector<double>& positions, double tolerance) {
  const double reach = 2 * tolerance * halfDiagonal(positions);
  return weldWithin(positions, reach, kCellPerTolerance * reach);
}

Welding weldEqualVertices(const std::vector<double>& positions) {
  return weldWithin(positions, 0, 2 * kCellPerTolerance * kWeldTolerance * halfDiagonal(positions));
}

}  // namespace abflat
