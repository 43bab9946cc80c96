#include "job.h"

#include <utility>

#include "abflat/inspect.h"
#include "abflat/peak_memory.h"
#include "abflat/pin_weights.h"
#include "abflat/samples.h"
#include "abflat/texcoord_faces.h"
#include "abflat/unit_square.h"
#include "mesh/triangulate.h"

namespace abflat::bindings {

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

Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  job.options.progress = progress;
  const auto compute = [&] {
    Result<FlattenResult> flat = flatten(job.mesh, job.options);
    if (!flat.ok()) return flat;
    if (job.normalizes) fitUnitSquare(job.mesh, flat.value());
    if (job.unwrapOptions.precision == Precision::Gltf)
      roundForGltf(job.mesh, flat.value());
    else if (wantsSingle(wanted))
      roundToSinglePrecision(job.mesh, flat.value());
    return flat;
  };
  const auto arrays = [&](FlattenResult& flat) {
    job.layout.uv = std::move(flat.uv);
    job.layout.triangles = std::move(flat.triangles);
    job.layout.vertexMap = std::move(flat.vertexMap);
  };
  const auto turned = [](const FlattenResult&) { return std::vector<std::uint32_t>(); };
  return layoutJob(job, wanted, progress, compute, turned, arrays, reportJson);
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
  const auto turned = [](const UnwrapResult& atlas) { return atlas.report.repair.turnedFaces; };
  return layoutJob(job, wanted, progress, compute, turned, arrays, json);
}

Status compareJob(Job& job, const ProgressCallback& progress) {
  progress({Stage::Read, 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  std::string().swap(job.source);
  Result<Comparison> compared = compare(job.mesh, {progress});
  if (!compared.ok()) return compared.status();
  Comparison& comparison = compared.value();
  job.text = compareJson(comparison, job.name);
  job.methods = std::move(comparison.methods);
  job.layout.triangles = std::move(comparison.triangles);
  job.layout.vertexMap = std::move(comparison.vertexMap);
  if (job.isFile) job.layout.positions = outputPositions(job);
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
