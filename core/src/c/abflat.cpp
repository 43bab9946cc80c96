#include "abflat/abflat.h"

#include <new>
#include <string>
#include <utility>
#include <vector>

#include "abflat/option_text.h"
#include "abflat/unwrap.h"
#include "abflat/version.h"
#include "base/guarded.h"

struct abflat_options {
  abflat::UnwrapOptions values;
  std::string message;
};

struct abflat_result {
  abflat::UnwrapResult unwrapped;
  std::vector<double> uv;  ///< 2 per output vertex
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

Status set(UnwrapOptions& options, const std::string& name, const std::string& text) {
  if (name == "seams" || name == "--seams") {
    Result<SeamSources> seams = parseSeams(text);
    if (seams.ok()) options.seams = std::move(seams.value());
    return seams.status();
  }
  const OptionInfos infos = optionInfos(options);
  for (int i = 0; i < infos.count; ++i) {
    if (name != infos[i].name && name != infos[i].flag) continue;
    double value = 0;
    bool isWord = false;
    if (readOption(options, i, text, value, isWord) && setOption(options, i, value, isWord))
      return {};
    return notAValue(infos[i], text);
  }
  return unknown(name);
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

Status unwrapInto(abflat_result& out, const abflat_mesh& mesh, const UnwrapOptions& options) {
  if (Status s = checkIndexSize(mesh.index_size); !s.ok()) return s;
  Result<UnwrapResult> result = unwrap(MeshView{pointsOf(mesh), trianglesOf(mesh)}, options);
  if (!result.ok()) return result.status();
  out.unwrapped = std::move(result.value());
  const UnwrapResult& r = out.unwrapped;
  out.uv.reserve(2 * r.vertexUv.size());
  for (const std::uint32_t i : r.vertexUv)
    out.uv.insert(out.uv.end(), {r.uv[2 * std::size_t{i}], r.uv[2 * std::size_t{i} + 1]});
  out.report = unwrapReportJson(r.report);
  return {};
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
  Status status = abflat::guarded([&] { return abflat::set(options->values, name, value); });
  options->message = std::move(status.message);
  return static_cast<int>(status.code);
}

const char* abflat_option_message(const abflat_options* options) {
  return options->message.c_str();
}

int abflat_unwrap(const abflat_mesh* mesh, const abflat_options* options, abflat_progress progress,
                  void* user, abflat_result** result) {
  *result = new (std::nothrow) abflat_result;
  if (*result == nullptr) return static_cast<int>(StatusCode::OutOfMemory);
  Status status = abflat::guarded([&] {
    abflat::UnwrapOptions values = options != nullptr ? options->values : abflat::UnwrapOptions();
    if (progress != nullptr)
      values.progress = [=](const abflat::Progress& now) {
        return progress(nameOf(now), now.fraction, user) != 0;
      };
    return abflat::unwrapInto(**result, *mesh, values);
  });
  (*result)->message = std::move(status.message);
  return static_cast<int>(status.code);
}

void abflat_free_result(abflat_result* result) { delete result; }

const char* abflat_message(const abflat_result* result) { return result->message.c_str(); }

int abflat_is_valid(const abflat_result* result) { return result->unwrapped.report.valid ? 1 : 0; }

const char* abflat_report(const abflat_result* result) { return result->report.c_str(); }

const std::uint32_t* abflat_vertices(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->unwrapped.vertexMap, 1, count);
}

const double* abflat_uv(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->uv, 2, count);
}

const std::uint32_t* abflat_triangles(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->unwrapped.triangles, 3, count);
}

const std::uint32_t* abflat_charts(const abflat_result* result, std::size_t* count) {
  return abflat::array(result->unwrapped.chartOfTriangle, 1, count);
}
