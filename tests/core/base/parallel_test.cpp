#include "base/parallel.h"

#include <atomic>
#include <new>
#include <numeric>

#include "catch.h"

using namespace abflat;

namespace {

constexpr unsigned kThreadCounts[] = {1, 2, 3, 8};

}  // namespace

TEST_CASE("parallel loops visit each index once", "[threads]") {
  for (const unsigned threads : kThreadCounts) {
    ThreadPool pool(threads);
    CHECK(pool.threads() <= threads);
    for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<int> visits(count, 0), inRanges(count, 0);
      parallelFor(&pool, count, [&](std::size_t i) { ++visits[i]; });
      parallelRanges(&pool, count, 3, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++inRanges[i];
      });
      CHECK(visits == std::vector<int>(count, 1));
      CHECK(inRanges == visits);
    }
  }
  std::vector<int> visits(5, 0);
  parallelFor(nullptr, 5, [&](std::size_t i) { ++visits[i]; });
  CHECK(visits == std::vector<int>(5, 1));
}

TEST_CASE("tasks may add tasks and run loops of their own", "[threads]") {
  for (const unsigned threads : kThreadCounts) {
    ThreadPool pool(threads);
    std::atomic<int> leaves{0};
    std::function<void(int)> divide;
    TaskGroup group(&pool);
    divide = [&](int depth) {
      if (depth > 0)
        for (int i = 0; i < 2; ++i) group.add([&, depth] { divide(depth - 1); });
      else
        parallelFor(&pool, 5, [&](std::size_t) { ++leaves; });
    };
    group.add([&] { divide(8); });
    group.wait();
    CHECK(leaves == 5 * 256);
  }
}

TEST_CASE("lack of memory in a task shows where the tasks are waited for", "[threads]") {
  for (const unsigned threads : kThreadCounts) {
    ThreadPool pool(threads);
    for (int again = 0; again < 20; ++again)
      CHECK_THROWS_AS(parallelFor(&pool, 100,
                                  [](std::size_t i) {
                                    if (i == 50) throw std::bad_alloc();
                                  }),
                      std::bad_alloc);
    std::atomic<int> visits{0};
    parallelFor(&pool, 100, [&](std::size_t) { ++visits; });
    CHECK(visits == 100);
  }
}

TEST_CASE("a pool whose tasks have ended can be used again, and one never used ends", "[threads]") {
  for (int again = 0; again < 50; ++again) {
    const ThreadPool unused(3);
    CHECK(unused.threads() >= 1);
    ThreadPool pool(3);
    std::vector<std::size_t> square(100);
    for (int loop = 0; loop < 10; ++loop)
      parallelFor(&pool, square.size(), [&](std::size_t i) { square[i] = i * i; });
    CHECK(std::accumulate(square.begin(), square.end(), std::size_t{0}) == 328350);
  }
}
