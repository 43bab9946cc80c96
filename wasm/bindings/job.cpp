#include "job.h"

#include <chrono>
#include <utility>

#include "abflat/inspect.h"
#include "abflat/io.h"
#include "abflat/samples.h"
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

std::vector<double> gatherPositions(const PolygonMesh& mesh,
                                    const std::vector<std::uint32_t>& vertexMap) {
  std::vector<double> out;
  out.reserve(3 * vertexMap.size());
  for (const std::uint32_t v : vertexMap)
    for (std::size_t k = 0; k < 3; ++k) out.push_back(mesh.positions[3 * v + k]);
  return out;
}

}  // namespace

Bytes resultOf(const Job& job, Field field) {
  switch (field) {
    case Field::Uv:
      return bytesOf(job.result.uv);
    case Field::Indices:
      return bytesOf(job.result.triangles);
    case Field::VertexMap:
      return bytesOf(job.result.vertexMap);
    case Field::Positions:
      return bytesOf(job.positions);
    case Field::Obj:
      return bytesOf(job.obj);
    case Field::Ply:
      return bytesOf(job.ply);
    case Field::Text:
      return bytesOf(job.text);
  }
  return {};
}

Bytes methodUvOf(const Job& job, std::size_t method) { return bytesOf(job.methods[method].uv); }

Status readInput(Job& job) {
  if (!job.isFile) return validateArrays(job.mesh);
  const Result<MeshFormat> format = detectFormat(job.name, job.source);
  if (!format.ok()) return format.status;
  job.format = format.value;
  Result<PolygonMesh> mesh = readMesh(job.source, format.value, job.name);
  job.mesh = std::move(mesh.value);
  return mesh.status;
}

Status flattenJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  const Clock::time_point started = Clock::now();
  progress({"read", 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  const double read = secondsSince(started);

  // A file is written with the text of its source around the new texcoords.
  const bool isObj = job.format == MeshFormat::Obj && wanted.obj;
  const bool isPly = job.format == MeshFormat::Ply && wanted.ply;
  if (!isObj && !isPly) std::string().swap(job.source);
  job.options.progress = progress;
  Result<FlattenResult> flat = flatten(job.mesh, job.options);
  if (!flat.ok()) return flat.status;
  job.result = std::move(flat.value);

  progress({"write", 0, 0, 0.98});
  if (wanted.ply) roundToSinglePrecision(job.mesh, job.result);
  const Clock::time_point writing = Clock::now();
  if (job.isFile) job.positions = gatherPositions(job.mesh, job.result.vertexMap);
  const auto source = [&](bool isKept) { return isKept ? job.source : std::string_view(); };
  if (wanted.obj) job.obj = writeObj(job.mesh, job.result.uv, job.result.cornerUv, source(isObj));
  if (wanted.ply) job.ply = writePly(job.mesh, job.result.uv, job.result.cornerUv, source(isPly));
  job.result.report.path = job.name;
  job.result.report.timings.read = read;
  job.result.report.timings.write = secondsSince(writing);
  job.result.report.timings.total = secondsSince(started);
  job.text = reportJson(job.result.report);
  progress({"write", 0, 0, 1});
  return {};
}

Status compareJob(Job& job, const ProgressCallback& progress) {
  progress({"read", 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  std::string().swap(job.source);
  Result<Comparison> compared = compare(job.mesh, {progress});
  if (!compared.ok()) return compared.status;
  Comparison& comparison = compared.value;
  if (job.isFile) job.positions = gatherPositions(job.mesh, comparison.vertexMap);
  job.text = compareJson(comparison, job.name);
  job.methods = std::move(comparison.methods);
  job.result.triangles = std::move(comparison.triangles);
  job.result.vertexMap = std::move(comparison.vertexMap);
  progress({job.methods.back().method.c_str(), 0, 0, 1});
  return {};
}

Status inspectJob(Job& job) {
  if (Status s = readInput(job); !s.ok()) return s;
  job.text = inspectJson(inspect(job.mesh), job.name);
  return {};
}

Status loadJob(Job& job) {
  if (Status s = readInput(job); !s.ok()) return s;
  job.result.triangles = triangulate(job.mesh).vertex;
  job.positions = std::move(job.mesh.positions);
  return {};
}

Status sampleJob(Job& job, double detail) {
  std::string names;
  for (const Sample& sample : samples()) {
    if (sample.name == job.name) {
      PolygonMesh mesh = sample.make(detail);
      job.positions = std::move(mesh.positions);
      job.result.triangles = std::move(mesh.faceVertices);
      return {};
    }
    names.append(names.empty() ? "" : ", ").append(sample.name);
  }
  return {StatusCode::InvalidOption,
          "there is no sample \"" + job.name + "\"; there are: " + names};
}

}  // namespace abflat::bindings
