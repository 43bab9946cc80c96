#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace abflat {

struct LargeBufferDeleter {
  void* block = nullptr;  ///< the block that contains the buffer
  void operator()(void*) const { ::operator delete(block); }
};

/// Uninitialised scalars.
template <typename Scalar>
using LargeBuffer = std::unique_ptr<Scalar[], LargeBufferDeleter>;

/// The alignment that largeBuffer() wants for an address.
std::size_t largeAlignment(std::size_t bytes);
/// Tells the system that all of the memory will be used: touching a large buffer for the first time
/// then takes a fraction of the time (Linux, huge pages).
void adviseLarge(void* memory, std::size_t bytes);

/// Running out of memory ends as for any container. Aligned here because glibc's aligned blocks
/// leave holes that no other aligned block of that size fits: hundreds of megabytes over many small
/// charts.
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
