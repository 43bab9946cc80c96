#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gltf/document.h"
#include "gltf/target.h"
#include "gltf/usage.h"

namespace abflat::gltf {

/// New content for a file: accessors are added or replaced, and their bytes are added to the
/// file's. No index of an accessor or view changes. Views that nothing uses any more are reused,
/// and bytes that only they hold are dropped from the file.
class Edit {
 public:
  Edit(const Document& document, Usage usage);

  /// Announces that `accessor` will be replaced. To be called for all such accessors before
  /// anything is added.
  void release(std::size_t accessor);

  /// Index of a view of these bytes. `stride` is 0 if elements are tightly packed.
  std::size_t addView(std::string bytes, std::size_t stride, Target target);

  /// Replaces accessor `slot`, or adds one if that is kNone. Returns its index.
  std::size_t putAccessor(std::size_t slot, Json accessor);

  /// The file's JSON with its own changes and these, and the bytes of its only buffer.
  std::pair<Json, std::string> finish();

  Json& json() { return json_; }

 private:
  struct NewView {
    std::size_t view;
    std::string bytes;
  };

  const Document& document_;
  Usage usage_;
  Json json_;
  std::set<std::size_t> freeViews_;
  std::vector<bool> isNew_;  ///< by view of the document: whether it has new bytes
  std::vector<NewView> added_;
};

}  // namespace abflat::gltf
