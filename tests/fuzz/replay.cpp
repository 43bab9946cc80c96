// Runs targets without a fuzzer, with any compiler: on files, or on bytes from a random generator.
// Usage: abflat_replay TARGET FILE...
//        abflat_replay TARGET --random COUNT [--seed SEED]
//        abflat_replay unwrap|flatten|pack|verify --show SEED|FILE     (the case as an OBJ)

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "layout_cases.h"
#include "targets.h"

namespace {

using abflat::fuzz::Target;

Target targetNamed(const char* name) {
  for (const auto& target : abflat::fuzz::kTargets)
    if (std::strcmp(target.name, name) == 0) return target.run;
  return nullptr;
}

int replayFiles(Target target, int count, char** files) {
  for (int i = 0; i < count; ++i) {
    std::ifstream in(files[i], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open()) {
      std::fprintf(stderr, "%s cannot be opened\n", files[i]);
      return 2;
    }
    target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%d files\n", count);
  return 0;
}

std::vector<std::uint8_t> randomBytes(unsigned long seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(64 + random() % 1024);
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random());
  return bytes;
}

int show(const std::string& target, const char* seedOrFile) {
  std::ifstream in(seedOrFile, std::ios::binary);
  const std::vector<std::uint8_t> bytes =
      in.is_open() ? std::vector<std::uint8_t>{std::istreambuf_iterator<char>(in), {}}
                   : randomBytes(std::strtoul(seedOrFile, nullptr, 10));
  using namespace abflat::fuzz;
  const std::string text = target == "unwrap"   ? shown(unwrapCase(bytes.data(), bytes.size()))
                           : target == "pack"   ? shown(packCase(bytes.data(), bytes.size()))
                           : target == "verify" ? shown(verifyCase(bytes.data(), bytes.size()))
                                                : shown(flattenCase(bytes.data(), bytes.size()));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

/// Each input has a seed of its own, so that one that ends the process can be run again alone.
int runRandom(Target target, unsigned long count, unsigned long seed) {
  unsigned long done = 0;
  double longest = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::vector<std::uint8_t> bytes = randomBytes(seed + i);
    std::fprintf(stderr, "\r%lu", seed + i);
    const auto start = std::chrono::steady_clock::now();
    done += target(bytes.data(), bytes.size());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    longest = std::max(longest, seconds.count());
  }
  std::printf("\n%lu inputs, %lu with a result, longest %.2f s\n", count, done, longest);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Target target = argc > 2 ? targetNamed(argv[1]) : nullptr;
  if (target == nullptr) {
    std::fprintf(stderr,
                 "usage: abflat_replay TARGET FILE... | TARGET --random COUNT [--seed SEED]\n");
    return 2;
  }
  if (std::strcmp(argv[2], "--show") == 0) return argc > 3 ? show(argv[1], argv[3]) : 2;
  if (std::strcmp(argv[2], "--random") != 0) return replayFiles(target, argc - 2, argv + 2);
  const unsigned long count = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1;
  const unsigned long seed = argc > 5 ? std::strtoul(argv[5], nullptr, 10) : 1;
  return runRandom(target, count, seed);
}
