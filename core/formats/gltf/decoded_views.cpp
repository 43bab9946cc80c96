#include "gltf/decoded_views.h"

#include <utility>

namespace abflat::gltf {
namespace {

/// Bytes that decoding a file may take. Meshopt turns one byte into 64 at most. Draco turns one
/// into 110, counted twice as here, if the surface is a regular grid.
constexpr std::size_t kLeastDecoded = std::size_t{1} << 25, kDecodedPerByte = 256;
/// A byte of the file may ask for eight elements, a decoded byte for one.
constexpr std::size_t kDecodedWorth = 8;

}  // namespace

DecodedViews::DecodedViews(Document& document)
    : document_(document), budget_(document.size, kLeastDecoded, kDecodedPerByte) {}

std::size_t DecodedViews::put(std::size_t slot, std::string bytes) {
  Json::Items& views = document_.json["bufferViews"].items();
  if (slot == kNone) {
    slot = views.size();
    views.push_back(Json::object());
  }
  Json& view = views[slot];
  view["buffer"] = document_.buffers.size();
  view["byteOffset"] = 0;
  view["byteLength"] = bytes.size();
  decoded_ += bytes.size();
  document_.json["buffers"].items().emplace_back()["byteLength"] = bytes.size();
  document_.buffers.push_back(std::move(bytes));
  document_.decodedViews.push_back(slot);
  return slot;
}

void DecodedViews::finish() { document_.size += decoded_ / kDecodedWorth; }

}  // namespace abflat::gltf
