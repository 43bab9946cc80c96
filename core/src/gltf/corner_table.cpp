#include "gltf/corner_table.h"

namespace abflat::gltf {

void CornerTable::add(const Corner& corner, std::uint32_t primitive) {
  const auto isWanted = [&](const Entry& entry) {
    return entry.primitive == primitive && entry.corner == corner;
  };
  PrimitiveVertices& out = primitives_[primitive];
  std::uint32_t at = newest_[corner.vertex];
  while (at != kNoNumber && !isWanted(entries_[at])) at = entries_[at].older;
  if (at == kNoNumber) {
    at = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({corner, primitive, static_cast<std::uint32_t>(out.corners.size()),
                        newest_[corner.vertex]});
    newest_[corner.vertex] = at;
    out.corners.push_back(corner);
  }
  out.indices.push_back(entries_[at].number);
}

}  // namespace abflat::gltf
