#include "gltf/edit.h"

#include "gltf/merged_buffer.h"

namespace abflat::gltf {

Edit::Edit(const Document& document, Usage usage)
    : document_(document),
      usage_(std::move(usage)),
      json_(document.json),
      isNew_(document.views.size(), false) {}

void Edit::release(std::size_t accessor) {
  const Accessor& a = document_.accessors[accessor];
  usage_.release(a);
  std::vector<std::size_t> views = {a.view};
  if (a.sparse) views.insert(views.end(), {a.sparse->indexView, a.sparse->valueView});
  for (const std::size_t view : views)
    if (view != kNone && usage_.ofView(view) == 0) freeViews_.insert(view);
}

std::size_t Edit::addView(std::string bytes, std::size_t stride, Target target) {
  Json::Items& views = json_["bufferViews"].items();
  std::size_t view = views.size();
  if (freeViews_.empty()) {
    views.push_back(Json::object());
  } else {
    view = *freeViews_.begin();
    freeViews_.erase(freeViews_.begin());
    isNew_[view] = true;
  }
  Json& json = views[view];
  for (const char* key : {"byteStride", "target"}) json.erase(key);
  json["buffer"] = 0;
  json["byteOffset"] = 0;
  json["byteLength"] = bytes.size();
  if (stride != 0) json["byteStride"] = stride;
  if (target != Target::Other) json["target"] = static_cast<int>(target);
  added_.push_back({view, std::move(bytes)});
  return view;
}

std::size_t Edit::putAccessor(std::size_t slot, Json accessor) {
  Json::Items& accessors = json_["accessors"].items();
  if (slot == kNone) {
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }
  accessors[slot] = std::move(accessor);
  return slot;
}

std::pair<Json, std::string> Edit::finish() {
  MergedBuffer merged(document_, isNew_);
  Json::Items& views = json_["bufferViews"].items();
  for (std::size_t view = 0; view < document_.views.size(); ++view) {
    if (isNew_[view]) continue;
    const std::size_t offset = merged.offsetOf(document_.views[view]);
    views[view]["buffer"] = 0;
    if (offset != document_.views[view].offset) views[view]["byteOffset"] = offset;
  }
  for (const NewView& view : added_) views[view.view]["byteOffset"] = merged.append(view.bytes);
  Json buffer = Json::object();
  Json::Items& buffers = json_["buffers"].items();
  if (!buffers.empty()) buffer = std::move(buffers[0]);
  buffer.erase("uri");
  buffer["byteLength"] = merged.bytes().size();
  buffers.assign(1, buffer);
  return {std::move(json_), merged.take()};
}

}  // namespace abflat::gltf
