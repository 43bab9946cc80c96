#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace abflat {

struct LargeBufferDeleter {
  std::align_val_t alignment{};
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};

/// Uninitialised scalars.
template <typename Scalar>
using LargeBuffer = std::unique_ptr<Scalar[], LargeBufferDeleter>;

/// What largeBuffer() wants an address to be a multiple of.
std::align_val_t largeAlignment(std::size_t bytes);
/// The system may expect all of it to be used: touching a large buffer for the first time then
/// takes a fraction of the time (Linux, huge pages).
void adviseLarge(void* memory, std::size_t bytes);

/// Lack of memory ends as it does for every container.
template <typename Scalar>
LargeBuffer<Scalar> largeBuffer(std::size_t count) {
  const std::size_t bytes = count * sizeof(Scalar);
  const std::align_val_t alignment = largeAlignment(bytes);
  void* const memory = ::operator new(bytes, alignment);
  adviseLarge(memory, bytes);
  return {static_cast<Scalar*>(memory), {alignment}};
}

}  // namespace abflat
