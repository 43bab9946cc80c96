#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/gltf.h"
#include "gltf/container.h"
#include "gltf/field.h"

namespace abflat::gltf {

struct BufferView {
  std::size_t buffer = kNone, offset = 0, length = 0;
  std::size_t stride = 0;  ///< bytes from one element to the next; 0: tightly packed
};

/// The buffers of a file, from the .glb, from data URIs or from files beside it. Buffers whose
/// bytes nothing needs are left empty.
std::vector<std::string> loadBuffers(const Field& root, const Container& container,
                                     const std::string& fileName, const ReadResource& readResource,
                                     Complaints& complaints);

/// A bufferView, or the part of a buffer that an extension describes with the same keys; inside its
/// buffer unless there is a complaint.
BufferView readView(const Field& view, const std::vector<std::string>& buffers);

std::string_view bytesOf(const BufferView& view, const std::vector<std::string>& buffers);

}  // namespace abflat::gltf
