// How well and how fast charts are packed.
//
//   abflat_pack_bench [KIND] [COUNT] [SPREAD] [RESOLUTION] [PADDING] [--dump FILE] [--threads N]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "pack/shapes.h"

using namespace abflat;

namespace {

/// Charts before and after packing as lines of numbers: counts, then uv, triangles, placement.
void dump(const char* file, const std::vector<PackShape>& shapes, const Packing& packing) {
  std::ofstream out(file);
  out.precision(17);
  out << shapes.size() << '\n';
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    out << shapes[i].uv.size() / 2 << ' ' << shapes[i].triangles.size() / 3 << '\n';
    for (const double x : shapes[i].uv) out << x << ' ';
    out << '\n';
    for (const std::uint32_t v : shapes[i].triangles) out << v << ' ';
    const Placement& p = packing.placements[i];
    out << '\n' << p.a << ' ' << p.b << ' ' << p.x << ' ' << p.y << ' ' << p.tile << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<const char*> words;
  const char* file = nullptr;
  unsigned threads = 1;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--dump") && i + 1 < argc) {
      file = argv[++i];
    } else if (!std::strcmp(argv[i], "--threads") && i + 1 < argc) {
      threads = static_cast<unsigned>(std::atoi(argv[++i]));
    } else {
      words.push_back(argv[i]);
    }
  }
  const auto word = [&words](std::size_t i, const char* otherwise) {
    return words.size() > i ? words[i] : otherwise;
  };
  ThreadPool pool(threads);
  PackOptions options;
  options.pool = &pool;
  options.resolution = std::atoi(word(3, "1024"));
  options.padding = std::atoi(word(4, "2"));
  const std::vector<PackShape> shapes =
      test::makePackShapes(word(0, "mixed"), static_cast<std::size_t>(std::atoll(word(1, "100"))),
                           std::atof(word(2, "8")), 1);
  const Result<Packing> packing = pack(shapes, options);
  if (!packing.ok()) {
    std::fprintf(stderr, "%s\n", packing.status().message.c_str());
    return 1;
  }
  std::printf("%-10s %6zu charts at %5d, padding %d: %.4f used, %2d tries, %8.4f s\n",
              word(0, "mixed"), shapes.size(), options.resolution, options.padding,
              packing.value().utilization, packing.value().tries, packing.value().seconds);
  if (file) dump(file, shapes, packing.value());
  return 0;
}
