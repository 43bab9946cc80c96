#include "support/little_memory.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include "catch.h"
#include "support/instrumented.h"

namespace {

/// Allocations that still succeed; negative: all.
std::atomic<long> allocationsLeft{-1};
std::atomic<long> allocationsMade{0}, blocksLiving{0};
std::atomic<std::size_t> bytesLiving{0}, mostBytes{0};

/// In front of each block is its size.
constexpr std::size_t kHead = alignof(std::max_align_t);

void noteBytes(std::size_t size) {
  const std::size_t now = bytesLiving += size;
  std::size_t most = mostBytes;
  while (now > most && !mostBytes.compare_exchange_weak(most, now)) {
  }
}

}  // namespace

// Every allocation of the test program goes through here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocationsMade;
  if (allocationsLeft.load() >= 0 && allocationsLeft.fetch_sub(1) <= 0) {
    allocationsLeft = 0;
    return nullptr;
  }
  void* const block = std::malloc(kHead + size);
  if (!block) return nullptr;
  std::memcpy(block, &size, sizeof size);
  ++blocksLiving;
  noteBytes(size);
  return static_cast<char*>(block) + kHead;
}
void* operator new(std::size_t size) {
  void* const memory = ::operator new(size, std::nothrow);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  if (!memory) return;
  void* const block = static_cast<char*>(memory) - kHead;
  std::size_t size = 0;
  std::memcpy(&size, block, sizeof size);
  bytesLiving -= size;
  --blocksLiving;
  std::free(block);
}
void operator delete(void* memory, std::size_t) noexcept { ::operator delete(memory); }

namespace abflat::test {

Ended ended(const Status& status, const std::vector<double>& numbers) {
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()),
                               numbers.size() * sizeof(double));
  return {status.code, std::hash<std::string_view>()(bytes)};
}

Ended ended(const Status& status, std::string_view bytes) {
  return {status.code, std::hash<std::string_view>()(bytes)};
}
Ended ended(const Result<std::string>& bytes) {
  return bytes.ok() ? ended({}, bytes.value()) : ended(bytes.status(), "");
}

std::size_t mostBytesOf(const std::function<void()>& call) {
  const std::size_t before = bytesLiving;
  mostBytes = before;
  call();
  return mostBytes - before;
}

void checkWithLittleMemory(const std::function<Ended()>& call) {
  const Ended wanted = call();  // also fills what lives as long as the program
  const long before = allocationsMade;
  call();
  const long count = allocationsMade - before;
  const long tries = cases(150, 30);
  long failures = 0;
  for (long k = 0; k < tries; ++k) {
    const long n = k < 20 ? k : count * k / tries;
    const long lived = blocksLiving;
    allocationsLeft = n;
    Ended now{StatusCode::Internal, 0};
    bool hasThrown = false;
    try {
      now = call();
    } catch (const std::bad_alloc&) {
      hasThrown = true;
    }
    allocationsLeft = -1;
    const long kept = blocksLiving - lived;  // before the checks allocate
    const bool isRefused = now.code == StatusCode::OutOfMemory;
    const bool isRight = now.code == wanted.code && now.result == wanted.result;
    CAPTURE(n, count, now.code);
    CHECK_FALSE(hasThrown);
    CHECK((isRefused || isRight));
    CHECK(kept == 0);
    failures += isRefused;
  }
  CHECK(failures > 0);
  const Ended again = call();
  CHECK(again.code == wanted.code);
  CHECK(again.result == wanted.result);
}

}  // namespace abflat::test
