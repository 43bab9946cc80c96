#pragma once

#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// How many places of a file refer to each accessor and view. Any number within extensions and
/// extras may be a reference, except in those for materials, textures and lights.
class Usage {
 public:
  explicit Usage(const Document& document);

  std::size_t ofAccessor(std::size_t accessor) const { return accessors_[accessor]; }
  std::size_t ofView(std::size_t view) const { return views_[view]; }

  /// Discounts an accessor's references to its views.
  void release(const Accessor& accessor);

 private:
  void countAccessors(const Json& json);
  void countUnknown(const Json& json, bool isUnknown);

  std::vector<std::size_t> accessors_, views_;
};

}  // namespace abflat::gltf
