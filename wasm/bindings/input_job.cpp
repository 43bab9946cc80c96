#include "input_job.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "io/settle_normals.h"

namespace abflat::bindings {

std::vector<double> gather(const std::vector<double>& values, std::size_t size,
                           const std::vector<std::uint32_t>& rows) {
  std::vector<double> out;
  out.reserve(size * rows.size());
  for (const std::uint32_t row : rows)
    for (std::size_t k = 0; k < size; ++k) out.push_back(values[size * row + k]);
  return out;
}

Bytes resultOf(const InputJob& job, Field field) {
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
    case Field::IslandOfFace:
      return bytesOf(job.layout.islandOfFace);
  }
  return bytesOf(job.files[static_cast<int>(field) - kFirstFile]);
}

int finish(InputJob& job, const Status& status) {
  if (!status.ok()) job.text = status.message;
  return static_cast<int>(status.code);
}

std::vector<double> outputPositions(const InputJob& job) {
  return gather(job.mesh.positions, 3, job.layout.vertexMap);
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

Status readInput(InputJob& job) {
  if (!job.isFile) return readArrays(job.mesh, job.hasCornerNormals);
  const Result<MeshFormat> format = detectFormat(job.name, job.source);
  if (!format.ok()) return format.status();
  job.format = format.value();
  Result<PolygonMesh> mesh = readMesh(job.source, format.value(), job.name);
  if (!mesh.ok()) return mesh.status();
  job.mesh = std::move(mesh.value());
  return {};
}

}  // namespace abflat::bindings
