#pragma once

#include <string>

#include "gltf/budget.h"
#include "gltf/document.h"

namespace abflat::gltf {

/// Views whose bytes have been decoded, each in a buffer of its own.
class DecodedViews {
 public:
  explicit DecodedViews(Document& document);

  /// To be asked before bytes are decoded.
  Budget& budget() { return budget_; }

  /// Makes these the bytes of view `slot`, or of a new view if that is kNone; everything else in
  /// its JSON stays. Returns its index.
  std::size_t put(std::size_t slot, std::string bytes);

  /// Lets the decoded bytes count towards what the file may ask for.
  void finish();

 private:
  Document& document_;
  Budget budget_;
  std::size_t decoded_ = 0;
};

}  // namespace abflat::gltf
