#include "abflat/abflat.h"

#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "abflat/option_text.h"
#include "abflat/pack_layout.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"
#include "abflat/version.h"
#include "base/guarded.h"
#include "mesh/input_mesh.h"

struct abflat_options {
  abflat::UnwrapOptions unwrap;
  abflat::PackLayoutOptions pack;
  abflat::VerifyOptions verify;
  std::string message;
};

struct abflat_result {
  std::vector<std::uint32_t> vertices;           ///< of the input, per output vertex
  std::vector<double> uv;                        ///< 2 per output vertex
  std::vector<std::uint32_t> triangles, charts;  ///< 3 output vertices and 1 chart each
  std::vector<std::uint8_t> faults;              ///< of each triangle, see UvFault
  bool isValid = false;
  std::string message, report;
};

namespace abflat {
namespace {

Status unknown(const std::string& name) {
  return {StatusCode::InvalidOption, "there is no option " + name};
}

Status notAValue(const OptionInfo& option, const std::string& text) {
  return {StatusCode::InvalidOption,
          std::string(option.name) + " cannot be \"" + text + "\"; it is " + option.range};
}

/// Null: there is none of that name, and `options` have not changed.
template <class Options>
std::optional<Status> setNamed(Options& options, const std::string& name, const std::string& text) {
  const OptionInfos infos = optionInfos(options);
  for (int i = 0; i < infos.count; ++i) {
    if (name != infos[i].name && name != infos[i].flag) continue;
    double value = 0;
    bool isWord = false;
    if (readOption(options, i, text, value, isWord) && setOption(options, i, value, isWord))
      return Status{};
    return notAValue(infos[i], text);
  }
  return std::nullopt;
}

Status set(abflat_options& options, const std::string& name, const std::string& text) {
  if (name == "seams" || name == "--seams") {
    Result<SeamSources> seams = parseSeams(text);
    if (seams.ok()) options.unwrap.seams = std::move(seams.value());
    return seams.status();
  }
  // What both have has the same values in both.
  const std::optional<Status> forUnwrap = setNamed(options.unwrap, name, text);
  const std::optional<Status> forPack = setNamed(options.pack, name, text);
  return forUnwrap ? *forUnwrap : forPack ? *forPack : unknown(name);
}

Status setRule(abflat_options& options, const std::string& name, const std::string& text) {
  const std::optional<Status> done = setNamed(options.verify, name, text);
  return done ? *done : Status{StatusCode::InvalidOption, "there is no rule " + name};
}

PointView pointsOf(const abflat_mesh& mesh) {
  const auto view = [&](const auto* first) {
    const std::size_t stride = mesh.position_stride != 0 ? mesh.position_stride : 3 * sizeof *first;
    return PointView(first, mesh.vertex_count, stride);
  };
  return mesh.positions_are_floats != 0 ? view(static_cast<const float*>(mesh.positions))
                                        : view(static_cast<const double*>(mesh.positions));
}

TriangleView trianglesOf(const abflat_mesh& mesh) {
  const auto view = [&](const auto* first) {
    const std::size_t stride = mesh.triangle_stride != 0 ? mesh.triangle_stride : 3 * sizeof *first;
    return TriangleView(first, mesh.triangle_count, stride);
  };
  switch (mesh.index_size) {
    case 2:
      return view(static_cast<const std::uint16_t*>(mesh.triangles));
    case 8:
      return view(static_cast<const std::uint64_t*>(mesh.triangles));
    default:
      return view(static_cast<const std::uint32_t*>(mesh.triangles));
  }
}

Status checkIndexSize(std::size_t size) {
  if (size == 0 || size == 2 || size == 4 || size == 8) return {};
  return {StatusCode::InvalidMesh,
          "index_size is " + std::to_string(size) + "; it must be 2, 4, 8, or 0 for 4"};
}

/// The mesh in memory of its own, with the texcoords of its vertices.
PolygonMesh withTexcoords(const abflat_mesh& mesh) {
  PolygonMesh out = InputMesh(MeshView{pointsOf(mesh), trianglesOf(mesh)}).copy();
  if (mesh.texcoords == nullptr) return out;
  const auto copy = [&](const auto* first) {
    const std::size_t stride = mesh.texcoord_stride != 0 ? mesh.texcoord_stride : 2 * sizeof *first;
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
      std::array<std::decay_t<decltype(*first)>, 2> uv;
      std::memcpy(uv.data(), reinterpret_cast<const char*>(first) + v * stride, sizeof uv);
      out.texcoords.insert(out.texcoords.end(), {uv[0], uv[1]});
    }
  };
  out.texcoords.reserve(2 * mesh.vertex_count);
  if (mesh.texcoords_are_floats != 0)
    copy(static_cast<const float*>(mesh.texcoords));
  else
    copy(static_cast<const double*>(mesh.texcoords));
  out.faceTexcoords.reserve(out.faceVertices.size());
  for (const std::uint32_t v : out.faceVertices)
    out.faceTexcoords.push_back(std::isnan(out.texcoords[2 * std::size_t{v}]) ? kNoTexcoord : v);
  return out;
}

Status unwrapInto(abflat_result& out, const abflat_mesh& mesh, const UnwrapOptions& options) {
  Result<UnwrapResult> result = unwrap(MeshView{pointsOf(mesh), trianglesOf(mesh)}, options);
  if (!result.ok()) return result.status();
  UnwrapResult& r = result.value();
  out.uv.reserve(2 * r.vertexUv.size());
  for (const std::uint32_t i : r.vertexUv)
    out.uv.insert(out.uv.end(), {r.uv[2 * std::size_t{i}], r.uv[2 * std::size_t{i} + 1]});
  out.vertices = std::move(r.vertexMap);
  out.triangles = std::move(r.triangles);
  out.charts = std::move(r.chartOfTriangle);
  out.isValid = r.report.valid;
  out.report = unwrapReportJson(r.report);
  return {};
}

Status packInto(abflat_result& out, const abflat_mesh& mesh, const PackLayoutOptions& options) {
  if (Status s = InputMesh(MeshView{pointsOf(mesh), trianglesOf(mesh)}).validate(); !s.ok())
    return s;
  const PolygonMesh polygons = withTexcoords(mesh);
  Result<PackLayoutResult> result = packLayout(polygons, options);
  if (!result.ok()) return result.status();
  PackedVertices vertices = packedVertices(polygons, result.value());
  out.vertices = std::move(vertices.vertexMap);
  out.uv = std::move(vertices.uv);
  out.triangles = std::move(vertices.triangles);
  out.charts = std::move(vertices.islandOfTriangle);
  out.isValid = result.value().report.valid;
  out.report = packReportJson(result.value().report);
  return {};
}

/// Faces are triangles here.
Status verifyInto(abflat_result& out, const abflat_mesh& mesh, const VerifyOptions& options) {
  if (Status s = InputMesh(MeshView{pointsOf(mesh), trianglesOf(mesh)}).validate(); !s.ok())
    return s;
  Result<VerifyResult> result = verifyLayout(withTexcoords(mesh), options);
  if (!result.ok()) return result.status();
  out.charts = std::move(result.value().islandOfFace);
  out.faults = std::move(result.value().faults);
  out.isValid = result.value().report.valid;
  out.report = verifyReportJson(result.value().report);
  return {};
}

/// A call that fills a result, which `run` does with the options that it is given. Copying them
/// takes memory, too.
template <class Options, class Run>
int call(const abflat_mesh& mesh, const Options* given, abflat_progress progress, void* user,
         abflat_result** result, const Run& run) {
  *result = new (std::nothrow) abflat_result;
  if (*result == nullptr) return static_cast<int>(StatusCode::OutOfMemory);
  Status status = guarded([&]() -> Status {
    if (Status s = checkIndexSize(mesh.index_size); !s.ok()) return s;
    Options options = given != nullptr ? *given : Options();
    if (progress != nullptr)
      options.progress = [=](const Progress& now) {
        return progress(nameOf(now), now.fraction, user) != 0;
      };
    return run(**result, mesh, options);
  });
  (*result)->message = std::move(status.message);
  return static_cast<int>(status.code);
}

template <class T>
const T* array(const std::vector<T>& values, std::size_t perItem, std::size_t* count) {
  if (count != nullptr) *count = values.size() / perItem;
  return values.data();
}

}  // namespace
}  // namespace abflat

using abflat::Status;
using abflat::StatusCode;

const char* abflat_version(void) { return ABFLAT_VERSION; }

const char* abflat_status_name(int status) {
  return abflat::statusName(static_cast<StatusCode>(status));
}

abflat_options* abflat_new_options(void) { return new (std::nothrow) abflat_options; }

void abflat_free_options(abflat_options* options) { delete options; }

int abflat_set_option(abflat_options* options, const char* name, const char* value) {
  Status status = abflat::guarded([&] { return abflat::set(*options, name, value); });
  options->message = std::move(status.message);
  return static_cast<int>(status.code);
}

int abflat_set_rule(abflat_options* options, const char* name, const char* value) {
  Status status = abflat::guarded([&] { return abflat::setRule(*options, name, value); });
  options->message = std::move(status.message);
  return static_cast<int>(status.code);
}

const char* abflat_option_message(const abflat_options* options) {
  return options->message.c_str();
}

int abflat_unwrap(const abflat_mesh* mesh, const abflat_options* options, abflat_progress progress,
                  void* user, abflat_result** result) {
  return abflat::call(*mesh, options != nullptr ? &options->unwrap : nullptr, progress, user,
                      result, abflat::unwrapInto);
}

int abflat_pack(const abflat_mesh* mesh, const abflat_options* options, abflat_progress progress,
                void* user, abflat_result** result) {
  return abflat::call(*mesh, options != nullptr ? &options->pack : nullptr, progress, user, result,
                      abflat::packInto);
}

int abflat_verify(const abflat_mesh* mesh, const abflat_options* options, abflat_progress progress,
                  void* user, abflat_result** result) {
  return abflat::call(*mesh, options != nullptr ? &options->verify : nullptr, progress, user,
                      result, abflat::verifyInto);
}

void abflat_free_result(abflat_result* result) { delete result; }

const char* abflat_message(const abflat_result* result) { return result->message.c_str(); }

int abflat_is_valid(const abflat_result* result) { return result->isValid ? 1 : 0; }

const char* abflat_report(const abflat_result* result) { return result->report.c_str(); }

const std::uint32_t* abflat_vertices(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->vertices, 1, count);
}

const double* abflat_uv(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->uv, 2, count);
}

const std::uint32_t* abflat_triangles(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->triangles, 3, count);
}

const std::uint32_t* abflat_charts(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->charts, 1, count);
}

const std::uint8_t* abflat_faults(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->faults, 1, count);
}
