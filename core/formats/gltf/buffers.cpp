#include "gltf/buffers.h"

#include <algorithm>
#include <utility>

#include "gltf/meshopt_extension.h"
#include "gltf/uri.h"

namespace abflat::gltf {
namespace {

constexpr std::size_t kMostStride = 252;

/// Buffers that some view needs. A compressed view needs the buffer of its compressed bytes, not
/// the fallback for programs without a decoder.
std::vector<bool> usedBuffers(const Field& root, std::size_t buffers) {
  std::vector<bool> out(buffers);
  for (const Field& view : root["bufferViews"].items()) {
    const Field compressed = meshoptExtension(view);
    const Field& user = compressed.isPresent() ? compressed : view;
    const std::size_t buffer = user["buffer"].requiredIndex(buffers, "buffers");
    if (buffer != kNone) out[buffer] = true;
  }
  return out;
}

class BufferLoader {
 public:
  BufferLoader(const Container& container, const std::string& fileName,
               const ReadResource& readResource, Complaints& complaints)
      : container_(container),
        fileName_(fileName),
        readResource_(readResource),
        complaints_(complaints) {}

  std::string load(const Field& buffer, bool isFirst) const {
    const std::size_t length = buffer["byteLength"].count();
    std::string bytes;
    if (buffer["uri"].isPresent())
      bytes = resource(buffer["uri"]);
    else if (container_.hasBuffer && isFirst)
      bytes = std::string(container_.buffer);
    else
      buffer.complain("has no uri, and the file has no binary chunk for it");
    if (length > bytes.size())
      buffer.complain("declares " + std::to_string(length) + " bytes, but has only " +
                      std::to_string(bytes.size()) + ": it is truncated");
    bytes.resize(std::min(length, bytes.size()));
    return bytes;
  }

 private:
  std::string resource(const Field& place) const {
    const std::string uri = place.text();
    if (isDataUri(uri)) {
      Result<std::string> data = dataOf(uri);
      if (data.ok()) return std::move(data).value();
      place.complain(data.status().message);
      return {};
    }
    if (hasScheme(uri)) {
      place.complain("is " + uri + ", which is not a local file. Download it first");
      return {};
    }
    Result<std::string> bytes = readResource_(pathOfUri(uri));
    if (bytes.ok()) return std::move(bytes).value();
    complaints_.fail(
        {bytes.status().code, fileName_ + ": " + place.place() + ": " + bytes.status().message});
    return {};
  }

  const Container& container_;
  const std::string& fileName_;
  const ReadResource& readResource_;
  Complaints& complaints_;
};

}  // namespace

std::vector<std::string> loadBuffers(const Field& root, const Container& container,
                                     const std::string& fileName, const ReadResource& readResource,
                                     Complaints& complaints) {
  const BufferLoader loader(container, fileName, readResource, complaints);
  const std::vector<Field> buffers = root["buffers"].items();
  const std::vector<bool> isUsed = usedBuffers(root, buffers.size());
  std::vector<std::string> out(buffers.size());
  for (std::size_t b = 0; b < buffers.size() && complaints.none(); ++b)
    if (isUsed[b]) out[b] = loader.load(buffers[b], b == 0);
  return out;
}

BufferView readView(const Field& view, const std::vector<std::string>& buffers) {
  BufferView out;
  out.buffer = view["buffer"].requiredIndex(buffers.size(), "buffers");
  out.offset = view["byteOffset"].count(0);
  out.length = view["byteLength"].count();
  out.stride = view["byteStride"].count(0);
  if (out.stride > kMostStride) view["byteStride"].complain("exceeds 252");
  if (out.buffer == kNone) return out;
  const std::size_t size = buffers[out.buffer].size();
  if (out.offset > size || out.length > size - out.offset)
    view.complain("ends at byte " + std::to_string(out.offset + out.length) + " of buffer " +
                  std::to_string(out.buffer) + ", which has " + std::to_string(size));
  return out;
}

std::string_view bytesOf(const BufferView& view, const std::vector<std::string>& buffers) {
  return std::string_view(buffers[view.buffer]).substr(view.offset, view.length);
}

}  // namespace abflat::gltf
