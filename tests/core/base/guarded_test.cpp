#include "base/guarded.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/abflat.h"
#include "abflat/compare.h"
#include "abflat/draw.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/io.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/instrumented.h"

namespace {

/// Allocations that still succeed; negative: all.
std::atomic<long> left{-1};
std::atomic<long> made{0}, living{0};

}  // namespace

// Every allocation of the test program goes through here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++made;
  if (left.load() >= 0 && left.fetch_sub(1) <= 0) {
    left = 0;
    return nullptr;
  }
  void* const memory = std::malloc(std::max<std::size_t>(size, 1));
  if (memory) ++living;
  return memory;
}
void* operator new(std::size_t size) {
  void* const memory = ::operator new(size, std::nothrow);
  if (!memory) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  if (!memory) return;
  --living;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { ::operator delete(memory); }

namespace abflat {
namespace {

/// A bent grid of n x n squares, cut in two triangles each.
PolygonMesh bentGrid(unsigned n) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i)
      mesh.positions.insert(mesh.positions.end(),
                            {1.0 * i, 1.0 * j, 0.5 * std::sin(1.3 * i) * std::cos(0.9 * j)});
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      for (const auto& t : {std::array{a, b, c}, std::array{a, c, d}}) {
        mesh.faceVertices.insert(mesh.faceVertices.end(), t.begin(), t.end());
        mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
      }
    }
  return mesh;
}

struct Ended {
  StatusCode code;
  std::size_t result;  ///< a hash, which needs no memory
};
using Call = std::function<Ended()>;

Ended ended(const Status& status, std::string_view bytes) {
  return {status.code, std::hash<std::string_view>()(bytes)};
}
template <class T>
Ended ended(const Result<T>& result, std::vector<double> T::*numbers) {
  if (!result.ok()) return ended(result.status(), "");
  const std::vector<double>& all = result.value().*numbers;
  return ended(result.status(),
               {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(double)});
}

/// Calls with memory for ever more allocations, some of them as in a program whose memory is full.
void checkWithLittleMemory(const Call& call) {
  const Ended wanted = call();  // also fills what lives as long as the program
  const long before = made;
  call();
  const long count = made - before;
  const long tries = test::cases(150, 30);
  long failures = 0;
  for (long k = 0; k < tries; ++k) {
    const long n = k < 20 ? k : count * k / tries;
    const long lived = living;
    left = n;
    Ended now{StatusCode::Internal, 0};
    bool hasThrown = false;
    try {
      now = call();
    } catch (const std::bad_alloc&) {
      hasThrown = true;
    }
    left = -1;
    const long kept = living - lived;  // before the checks allocate
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

}  // namespace

TEST_CASE("public functions report lack of memory, leak nothing and work again") {
  const PolygonMesh mesh = bentGrid(6);
  const std::string name = "a mesh with a name that is too long for the string itself.obj";
  Result<UnwrapResult> atlas = unwrap(mesh, UnwrapOptions());
  REQUIRE(atlas.ok());
  const std::string obj = writeObj(mesh, atlas.value().uv, atlas.value().cornerUv, {});
  SECTION("readMesh") {
    for (const std::string& text : {obj, std::string("v 1\n")})
      checkWithLittleMemory(
          [&] { return ended(readMesh(text, MeshFormat::Obj, name), &PolygonMesh::positions); });
  }
  SECTION("inspect") {
    checkWithLittleMemory([&] { return ended(inspect(mesh).disk, ""); });
  }
  for (const int threads : {1, 3}) {
    DYNAMIC_SECTION("unwrap with " << threads << " threads") {
      UnwrapOptions options;
      options.threads = threads;
      checkWithLittleMemory([&] { return ended(unwrap(mesh, options), &UnwrapResult::uv); });
    }
    DYNAMIC_SECTION("flatten with " << threads << " threads") {
      FlattenOptions options;
      options.threads = threads;
      checkWithLittleMemory([&] { return ended(flatten(mesh, options), &FlattenResult::uv); });
    }
  }
  SECTION("compare") {
    checkWithLittleMemory([&] { return ended(compare(mesh, {}).status(), ""); });
  }
  SECTION("for C") {
    const abflat_mesh triangles = {
        mesh.positions.data(),       0, 0, mesh.vertexCount(), mesh.faceVertices.data(),
        mesh.faceVertices.size() / 3};
    checkWithLittleMemory([&] {
      abflat_result* result = nullptr;
      const int status = abflat_unwrap(&triangles, nullptr, nullptr, nullptr, &result);
      std::size_t count = 0;
      const double* const uv = result ? abflat_uv(result, &count) : nullptr;
      const auto* const bytes = reinterpret_cast<const char*>(uv);
      const Ended out = ended({static_cast<StatusCode>(status), {}},
                              std::string_view(bytes, 2 * count * sizeof(double)));
      abflat_free_result(result);
      return out;
    });
  }
#if ABFLAT_DRAWING
  SECTION("pictures") {
    checkWithLittleMemory([&] {
      const Result<std::string> png = atlasPng(mesh, atlas.value());
      return ended(png.status(), png.ok() ? std::string_view(png.value()) : std::string_view());
    });
  }
#endif
}

}  // namespace abflat
