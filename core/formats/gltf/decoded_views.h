#pragma once

#include <string>

#include "gltf/budget.h"
#include "gltf/document.h"

namespace abflat::gltf {

/// Views whose bytes have been decoded, each in a buffer of its own.
class DecodedViews {
 public:
  explicit DecodedViews(Document& document);

  /// Asked before bytes are decoded.
  Budget& budget() { return budget_; }

  /// View `slot`, or a new one where that is kNone, has these bytes from now on; what else its JSON
  /// says stays. Returns its number.
  std::size_t put(std::size_t slot, std::string bytes);

  /// What remains of the file counts towards what it may ask for.
  void finish();

 private:
  Document& document_;
  Budget budget_;
  std::size_t decoded_ = 0;
};

}  // namespace abflat::gltf
