#include "gltf/boxes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gltf/budget.h"
#include "gltf/elements.h"

namespace abflat::gltf {
namespace {

struct Box {
  std::vector<double> low, high;
};

/// Box of the values as they are stored.
Box boxOf(const Document& document, Accessor accessor) {
  accessor.isNormalized = false;
  const std::vector<double> values = numbersOf(document, accessor);
  const std::size_t n = accessor.shape.components();
  if (n == 0 || values.size() < n) return {};
  Box out{{values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
  out.high = out.low;
  for (std::size_t i = n; i < values.size(); ++i) {
    out.low[i % n] = std::min(out.low[i % n], values[i]);
    out.high[i % n] = std::max(out.high[i % n], values[i]);
  }
  return out;
}

Json numbersAsJson(const std::vector<double>& values, bool isFloat) {
  Json out = Json::array();
  for (const double x : values) {
    if (isFloat || !std::isfinite(x))
      out.items().emplace_back(x);
    else
      out.items().emplace_back(static_cast<std::int64_t>(x));
  }
  return out;
}

}  // namespace

void refreshBoxes(Document& document, Complaints& complaints) {
  std::vector<bool> isDecoded(document.views.size());
  for (const std::size_t view : document.decodedViews) isDecoded[view] = true;
  Budget budget(document.size);
  for (std::size_t a = 0; a < document.accessors.size(); ++a) {
    const Accessor& accessor = document.accessors[a];
    Json& json = document.json["accessors"][a];
    const bool hasBox = json.has("min") && json.has("max");
    if (!hasBox || accessor.view == kNone || !isDecoded[accessor.view] || accessor.count == 0)
      continue;
    const std::size_t elements = accessor.count + (accessor.sparse ? accessor.sparse->count : 0);
    if (!budget.take(elements))
      return complaints.add("too many accessors use the same compressed bytes");
    if (!hasSparseOrder(document, accessor)) continue;  // rejected when a mesh uses it
    const Box box = boxOf(document, accessor);
    const bool isFloat = accessor.shape.type == ComponentType::Float;
    json["min"] = numbersAsJson(box.low, isFloat);
    json["max"] = numbersAsJson(box.high, isFloat);
  }
}

}  // namespace abflat::gltf
