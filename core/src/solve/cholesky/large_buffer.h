#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace abflat {

struct LargeBufferDeleter {
  void* block = nullptr;  ///< that the buffer lies in
  void operator()(void*) const { ::operator delete(block); }
};

/// Uninitialised scalars.
template <typename Scalar>
using LargeBuffer = std::unique_ptr<Scalar[], LargeBufferDeleter>;

/// What largeBuffer() wants an address to be a multiple of.
std::size_t largeAlignment(std::size_t bytes);
/// The system may expect all of it to be used: touching a large buffer for the first time then
/// takes a fraction of the time (Linux, huge pages).
void adviseLarge(void* memory, std::size_t bytes);

/// Lack of memory ends as it does for every container. Aligned here: what glibc aligns leaves holes
/// that no other aligned block of that size fits, hundreds of megabytes over many small charts.
template <typename Scalar>
LargeBuffer<Scalar> largeBuffer(std::size_t count) {
  const std::size_t bytes = count * sizeof(Scalar), alignment = largeAlignment(bytes);
  std::size_t room = bytes + alignment;
  void* const block = ::operator new(room);
  void* memory = block;
  std::align(alignment, bytes, memory, room);
  adviseLarge(memory, bytes);
  return {static_cast<Scalar*>(memory), {block}};
}

}  // namespace abflat
