#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace abflat {

/// Two triangles that have more than boundary in common, decided exactly. `uv` has 6 coordinates
/// per triangle; triangles that are not counter-clockwise are ignored.
std::optional<std::array<std::uint32_t, 2>> findOverlap(const std::vector<double>& uv);

/// The same for two triangles of different groups, whichever way round they are. `group` has one
/// per triangle.
std::optional<std::array<std::uint32_t, 2>> findOverlapBetween(
    std::vector<double> uv, const std::vector<std::uint32_t>& group);

/// Per triangle, whether it has more than boundary in common with another one, whichever way round
/// they are. One without area has not.
std::vector<std::uint8_t> overlappingTriangles(std::vector<double> uv);

/// Calls `found` with pairs of triangles as above, the smaller number first, but for those that
/// `isKnown` says yes to. Of triangles in the same place, the others are only paired with the
/// first.
void forOverlaps(std::vector<double> uv,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& isKnown,
                 const std::function<void(std::uint32_t, std::uint32_t)>& found);

/// Leaves out groups of triangles until nothing that is left overlaps as above: those that overlap
/// themselves or a group that stays, of a smaller number. `group` has one per triangle, below
/// `groups`. Returns, per group, the one that it overlaps, or kNoOverlap where it stays.
std::vector<std::uint32_t> leaveOutOverlaps(const std::vector<double>& uv,
                                            const std::vector<std::uint32_t>& group,
                                            std::size_t groups);
constexpr std::uint32_t kNoOverlap = 0xffffffff;

}  // namespace abflat
