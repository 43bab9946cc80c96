#include "gltf/merged_buffer.h"

#include <algorithm>
#include <utility>

namespace abflat::gltf {
namespace {

constexpr std::size_t kRangeAlignment = 8;  // of the largest type in any extension

using Interval = std::pair<std::size_t, std::size_t>;

/// Sorted and without overlaps.
std::vector<Interval> united(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::vector<Interval> out;
  for (const Interval& i : intervals) {
    if (!out.empty() && i.first <= out.back().second)
      out.back().second = std::max(out.back().second, i.second);
    else
      out.push_back(i);
  }
  return out;
}

}  // namespace

MergedBuffer::MergedBuffer(const Document& document, const std::vector<bool>& isLeft) {
  const std::size_t buffers = document.buffers.size();
  std::vector<std::vector<Interval>> used(buffers);
  for (std::size_t v = 0; v < document.views.size(); ++v) {
    const BufferView& view = document.views[v];
    if (!isLeft[v]) used[view.buffer].emplace_back(view.offset, view.offset + view.length);
  }
  kept_.resize(buffers);
  for (std::size_t b = 0; b < buffers; ++b)
    for (const Interval& range : united(std::move(used[b]))) {
      align(kRangeAlignment, range.first % kRangeAlignment);
      kept_[b].push_back({range.first, range.second, bytes_.size()});
      bytes_.append(document.buffers[b], range.first, range.second - range.first);
    }
}

std::size_t MergedBuffer::offsetOf(const BufferView& view) const {
  const std::vector<Range>& ranges = kept_[view.buffer];
  const auto next =
      std::upper_bound(ranges.begin(), ranges.end(), view.offset,
                       [](std::size_t offset, const Range& range) { return offset < range.begin; });
  if (next == ranges.begin()) return 0;  // an empty view of an empty buffer
  return std::prev(next)->newBegin + (view.offset - std::prev(next)->begin);
}

std::size_t MergedBuffer::append(const std::string& bytes) {
  align(4, 0);
  const std::size_t out = bytes_.size();
  bytes_ += bytes;
  return out;
}

void MergedBuffer::align(std::size_t alignment, std::size_t remainder) {
  while (bytes_.size() % alignment != remainder) bytes_.push_back('\0');
}

}  // namespace abflat::gltf
