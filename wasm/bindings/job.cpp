#include "job.h"

#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "abflat/inspect.h"
#include "abflat/io.h"
#include "abflat/pack_layout.h"
#include "abflat/peak_memory.h"
#include "abflat/pin_weights.h"
#include "abflat/samples.h"
#include "abflat/texcoord_faces.h"
#include "abflat/unit_square.h"
#include "abflat/unwrap.h"
#include "io/settle_normals.h"
#include "mesh/triangulate.h"

namespace abflat::bindings {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class T>
Bytes bytesOf(const T& container) {
  return {container.data(), container.size() * sizeof(*container.data())};
}

/// Picks the given `rows` of `size` numbers each.
std::vector<double> gather(const std::vector<double>& values, std::size_t size,
                           const std::vector<std::uint32_t>& rows) {
  std::vector<double> out;
  out.reserve(size * rows.size());
  for (const std::uint32_t row : rows)
    for (std::size_t k = 0; k < size; ++k) out.push_back(values[size * row + k]);
  return out;
}

}  // namespace

Bytes resultOf(const Job& job, Field field) {
  switch (field) {
    case Field::Uv:
      return bytesOf(job.layout.uv);
    case Field::Indices:
      return bytesOf(job.layout.triangles);
    case Field::VertexMap:
      return bytesOf(job.layout.vertexMap);
    case Field::Positions:
      return bytesOf(job.layout.positions);
    case Field::Text:
      return bytesOf(job.text);
    case Field::ChartOfTriangle:
      return bytesOf(job.layout.chartOfTriangle);
    case Field::Seams:
      return bytesOf(job.layout.seams);
    case Field::Unpacked:
      return bytesOf(job.layout.unpacked);
    case Field::Faces:
      return bytesOf(job.layout.faces);
    case Field::Faults:
      return bytesOf(job.layout.faults);
  }
  return bytesOf(job.files[static_cast<int>(field) - kFirstFile]);
}

Bytes methodUvOf(const Job& job, std::size_t method) { return bytesOf(job.methods[method].uv); }

void* knownRoom(Job& job, Field field, std::size_t size) {
  KnownLayout& known = job.unwrapOptions.reuse.known;
  if (field == Field::Unpacked || field == Field::Uv) {
    std::vector<double>& reals = field == Field::Uv ? known.uv : known.unpacked;
    reals.resize(size);
    return reals.data();
  }
  std::vector<std::uint32_t>& numbers = field == Field::Indices     ? known.triangles
                                        : field == Field::VertexMap ? known.vertexMap
                                                                    : known.chartOfTriangle;
  numbers.resize(size);
  return numbers.data();
}

namespace {

/// Arrays have texcoords per vertex; a vertex without texcoord has NaN.
Status readArrays(PolygonMesh& mesh, bool hasCornerNormals) {
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (hasCornerNormals) {
    mesh.faceNormals.resize(mesh.faceVertices.size());
    std::iota(mesh.faceNormals.begin(), mesh.faceNormals.end(), 0u);
    settleNormals(mesh);
  } else {
    takeVertexNormals(mesh);
  }
  if (mesh.texcoords.empty()) return {};
  mesh.faceTexcoords.reserve(mesh.faceVertices.size());
  for (const std::uint32_t v : mesh.faceVertices)
    mesh.faceTexcoords.push_back(std::isnan(mesh.texcoords[2 * v]) ? kNoTexcoord : v);
  return {};
}

}  // namespace

Status readInput(Job& job) {
  if (!job.isFile) return readArrays(job.mesh, job.hasCornerNormals);
  const Result<MeshFormat> format = detectFormat(job.name, job.source);
  if (!format.ok()) return format.status();
  job.format = format.value();
  Result<PolygonMesh> mesh = readMesh(job.source, format.value(), job.name);
  if (!mesh.ok()) return mesh.status();
  job.mesh = std::move(mesh.value());
  return {};
}

namespace {

std::vector<std::uint32_t> turnedFaces(const FlattenResult&) { return {}; }
std::vector<std::uint32_t> turnedFaces(const PackLayoutResult&) { return {}; }
const std::vector<std::uint32_t>& turnedFaces(const UnwrapResult& result) {
  return result.report.repair.turnedFaces;
}

/// The bit of a format.
constexpr WantedFiles fileOf(MeshFormat format) { return 1u << static_cast<int>(format); }

constexpr WantedFiles filesOfSinglePrecision() {
  WantedFiles out = 0;
  for (int i = 0; i < kWrittenFormatCount; ++i)
    if (precisionOf(static_cast<MeshFormat>(i)) == Precision::Single) out |= 1u << i;
  return out;
}
constexpr WantedFiles kSingle = filesOfSinglePrecision();

/// To what texcoords in an atlas are rounded, unless a glTF is to hold them.
void choosePrecision(Precision& precision, WantedFiles wanted) {
  if (precision != Precision::Gltf)
    precision = wanted == 0 || (wanted & kSingle) ? Precision::Single : Precision::Double;
}

/// A file is written using the text of its source around the new texcoords.
void writeFiles(Job& job, WantedFiles wanted, const std::vector<double>& uv,
                const std::vector<std::uint32_t>& cornerUv,
                const std::vector<std::uint32_t>& turned) {
  for (int i = 0; i < kWrittenFormatCount; ++i) {
    const auto format = static_cast<MeshFormat>(i);
    if ((wanted & fileOf(format)) == 0) continue;
    const std::string_view source = format == job.format ? job.source : std::string_view();
    job.files[i] = writeMesh(format, job.mesh, uv, cornerUv, source, turned);
  }
}

/// One run from the input to the arrays, files and report of a layout. `compute()` returns a result
/// whose texcoords are ready to be written; `arrays(result)` may then take what is no longer
/// needed.
template <class Compute, class Arrays, class Json>
Status layoutJob(Job& job, WantedFiles wanted, const ProgressCallback& progress,
                 const Compute& compute, const Arrays& arrays, const Json& json) {
  const Clock::time_point started = Clock::now();
  progress({Stage::Read, 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  const double read = secondsSince(started);

  if ((wanted & fileOf(job.format)) == 0) std::string().swap(job.source);
  auto computed = compute();
  if (!computed.ok()) return computed.status();
  auto& result = computed.value();

  progress({Stage::Write, 0, 0, 0.98});
  const Clock::time_point writing = Clock::now();
  writeFiles(job, wanted, result.uv, result.cornerUv, turnedFaces(result));
  result.report.path = job.name;
  result.report.timings.read = read;
  arrays(result);
  if (job.isFile) job.layout.positions = gather(job.mesh.positions, 3, job.layout.vertexMap);
  result.report.timings.write = secondsSince(writing);
  result.report.timings.total = secondsSince(started);
  job.text = json(result.report);
  progress({Stage::Write, 0, 0, 1});
  return {};
}

}  // namespace

Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  job.options.progress = progress;
  const auto compute = [&] {
    Result<FlattenResult> flat = flatten(job.mesh, job.options);
    if (!flat.ok()) return flat;
    if (job.normalizes) fitUnitSquare(job.mesh, flat.value());
    if (job.unwrapOptions.precision == Precision::Gltf)
      roundForGltf(job.mesh, flat.value());
    else if (wanted & kSingle)
      roundToSinglePrecision(job.mesh, flat.value());
    return flat;
  };
  const auto arrays = [&](FlattenResult& flat) {
    job.layout.uv = std::move(flat.uv);
    job.layout.triangles = std::move(flat.triangles);
    job.layout.vertexMap = std::move(flat.vertexMap);
  };
  return layoutJob(job, wanted, progress, compute, arrays, reportJson);
}

namespace {

Result<UnwrapResult> unwrapMesh(Job& job) {
  const double afterReading = peakMemory();
  if (job.keepsUv) {
    Result<std::vector<std::uint32_t>> faces = facesWithTexcoords(job.mesh);
    if (!faces.ok()) return Status{faces.status().code, "fixedFaces: " + faces.status().message};
    job.unwrapOptions.reuse.fixedFaces = std::move(faces.value());
  }
  Result<UnwrapResult> atlas = unwrap(job.mesh, job.unwrapOptions);
  if (!atlas.ok()) return atlas;
  turnFaces(job.mesh, atlas.value());
  atlas.value().report.peakMemory.read = afterReading;
  return atlas;
}

}  // namespace

Status unwrapJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  Result<SeamSources> seams = parseSeams(job.seams);
  if (!seams.ok()) return {seams.status().code, "seams: " + seams.status().message};
  seams.value().edges = std::move(job.unwrapOptions.seams.edges);
  job.unwrapOptions.seams = std::move(seams.value());
  job.unwrapOptions.progress = progress;
  choosePrecision(job.unwrapOptions.precision, wanted);
  const auto compute = [&] { return unwrapMesh(job); };
  const auto arrays = [&](UnwrapResult& atlas) {
    job.layout.uv = gather(atlas.uv, 2, atlas.vertexUv);
    job.layout.unpacked = gather(atlas.unpacked, 2, atlas.vertexUv);
    job.layout.triangles = std::move(atlas.triangles);
    job.layout.vertexMap = std::move(atlas.vertexMap);
    job.layout.chartOfTriangle = std::move(atlas.chartOfTriangle);
    job.layout.seams = std::move(atlas.seams);
  };
  const auto json = [](UnwrapReport& report) {
    report.peakMemory.write = peakMemory();
    return unwrapReportJson(report);
  };
  return layoutJob(job, wanted, progress, compute, arrays, json);
}

Status packJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  job.packOptions.progress = progress;
  choosePrecision(job.packOptions.precision, wanted);
  const auto compute = [&] { return packLayout(job.mesh, job.packOptions); };
  const auto arrays = [&](PackLayoutResult& packed) {
    PackedVertices vertices = packedVertices(job.mesh, packed);
    job.layout.uv = std::move(vertices.uv);
    job.layout.triangles = std::move(vertices.triangles);
    job.layout.vertexMap = std::move(vertices.vertexMap);
    job.layout.chartOfTriangle = std::move(vertices.islandOfTriangle);
    job.layout.faults = std::move(packed.faults);
  };
  return layoutJob(job, wanted, progress, compute, arrays, packReportJson);
}

Status compareJob(Job& job, const ProgressCallback& progress) {
  progress({Stage::Read, 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  std::string().swap(job.source);
  Result<Comparison> compared = compare(job.mesh, {progress});
  if (!compared.ok()) return compared.status();
  Comparison& comparison = compared.value();
  if (job.isFile) job.layout.positions = gather(job.mesh.positions, 3, comparison.vertexMap);
  job.text = compareJson(comparison, job.name);
  job.methods = std::move(comparison.methods);
  job.layout.triangles = std::move(comparison.triangles);
  job.layout.vertexMap = std::move(comparison.vertexMap);
  progress({Stage::Check, 0, 0, 1, job.methods.back().method});
  return {};
}

Status inspectJob(Job& job) {
  if (Status s = readInput(job); !s.ok()) return s;
  job.text = inspectJson(inspect(job.mesh), job.name);
  return {};
}

Status pinWeightsJob(Job& job) {
  PinnedMesh layout{std::move(job.mesh), {}, {}};
  layout.uv.swap(layout.mesh.texcoords);
  for (const Pin& pin : job.options.pins) layout.pins.push_back(pin.vertex);
  Result<std::vector<double>> weights = pinWeights(layout);
  if (!weights.ok()) return weights.status();
  job.layout.uv = std::move(weights.value());
  return {};
}

Status loadJob(Job& job) {
  if (Status s = readInput(job); !s.ok()) return s;
  const Triangulation triangulation = triangulate(job.mesh);
  job.layout.triangles.assign(triangulation.vertex.begin(), triangulation.vertex.end());
  job.layout.faces.assign(triangulation.face.begin(), triangulation.face.end());
  job.layout.positions = std::move(job.mesh.positions);
  return {};
}

Status sampleJob(Job& job, double detail) {
  if (!(detail >= kMinSampleDetail && detail <= kMaxSampleDetail)) {
    const std::string most = std::to_string(static_cast<int>(kMaxSampleDetail));
    return {StatusCode::InvalidOption, "detail must be at most " + most};
  }
  std::string names;
  for (const Sample& sample : samples()) {
    if (sample.name == job.name) {
      PolygonMesh mesh = sample.make(detail);
      job.layout.positions = std::move(mesh.positions);
      job.layout.triangles = std::move(mesh.faceVertices);
      return {};
    }
    names.append(names.empty() ? "" : ", ").append(sample.name);
  }
  return {StatusCode::InvalidOption, "there is no sample \"" + job.name + "\". Use " + names};
}

}  // namespace abflat::bindings
