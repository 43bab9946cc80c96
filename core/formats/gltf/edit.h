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

/// New content for a file: accessors are added or replaced, and their bytes added to the file's. No
/// number of an accessor or view changes. Views that nothing uses any more are used again, and what
/// only they hold leaves the file.
class Edit {
 public:
  Edit(const Document& document, Usage usage);

  /// `accessor` is about to be replaced. To be called for all of them before anything is added.
  void release(std::size_t accessor);

  /// Number of a view of these bytes. `stride` is 0 where elements follow each other.
  std::size_t addView(std::string bytes, std::size_t stride, Target target);

  /// Replaces accessor `slot`, or adds one when that is kNone. Returns its number.
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
  std::vector<bool> isNew_;  ///< by view of the document: it has new bytes
  std::vector<NewView> added_;
};

}  // namespace abflat::gltf
