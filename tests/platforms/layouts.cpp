// Writes the files that `abflat sample` and, with default options, `abflat unwrap` and `abflat
// flatten` write.
// Usage: abflat_layouts sample NAME OUT | unwrap MESH OUT | flatten MESH OUT

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "abflat/flatten.h"
#include "abflat/io.h"
#include "abflat/orient.h"
#include "abflat/samples.h"
#include "abflat/unwrap.h"

namespace abflat {
namespace {

Result<std::string> sampleText(const std::string& name) {
  for (const Sample& sample : samples())
    if (sample.name == name) {
      const PolygonMesh mesh = sample.make(kMinSampleDetail);
      return writeMesh(MeshFormat::Obj, mesh, {}, {});
    }
  return Status{StatusCode::InvalidOption, "there is no sample '" + name + "'"};
}

Result<std::string> layoutText(const std::string& command, const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const Result<MeshFormat> format = detectFormat(path, bytes);
  if (!format.ok()) return format.status();
  Result<PolygonMesh> mesh = readMesh(bytes, format.value(), path);
  if (!mesh.ok()) return mesh.status();
  const std::string_view source = format.value() == MeshFormat::Obj ? bytes : std::string_view();
  if (command == "flatten") {
    const Result<FlattenResult> flat = flatten(mesh.value(), {});
    if (!flat.ok()) return flat.status();
    return writeMesh(MeshFormat::Obj, mesh.value(), flat.value().uv, flat.value().cornerUv, source);
  }
  Result<UnwrapResult> result = unwrap(mesh.value(), {});
  if (!result.ok()) return result.status();
  turnFaces(mesh.value(), result.value());
  return writeMesh(MeshFormat::Obj, mesh.value(), result.value().uv, result.value().cornerUv,
                   source, result.value().report.repair.turnedFaces);
}

}  // namespace
}  // namespace abflat

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string command = argv[1], from = argv[2];
  const abflat::Result<std::string> text =
      command == "sample" ? abflat::sampleText(from) : abflat::layoutText(command, from);
  if (!text.ok()) {
    std::cerr << text.status().message << "\n";
    return 1;
  }
  std::ofstream out(argv[3], std::ios::binary);
  out << text.value();
  return out.flush() ? 0 : 1;
}
