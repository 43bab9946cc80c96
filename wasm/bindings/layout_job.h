#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/generated/mesh_format.h"
#include "abflat/progress.h"
#include "input_job.h"

namespace abflat::bindings {

/// Files to write besides the arrays of a layout: a bit for each MeshFormat.
using WantedFiles = unsigned;

/// Whether a wanted file has numbers of single precision.
bool wantsSingle(WantedFiles wanted);

/// To what texcoords in an atlas are rounded, unless a glTF is to hold them: to single precision,
/// which is what graphics cards and PLY hold, unless only files of double precision are wanted,
/// which are then written exactly as the program writes them.
void choosePrecision(Precision& precision, WantedFiles wanted);

/// Writes the wanted files, using the text of the source around the new texcoords.
void writeFiles(InputJob& job, WantedFiles wanted, const std::vector<double>& uv,
                const std::vector<std::uint32_t>& cornerUv,
                const std::vector<std::uint32_t>& turned);

/// Frees the source, unless a file is written around it.
void dropSource(InputJob& job, WantedFiles wanted);

/// One run from the input to the arrays, files and report of a layout. `compute()` returns a result
/// whose texcoords are ready to be written, `turned(result)` the faces that were turned over;
/// `arrays(result)` may then take what is no longer needed.
template <class Compute, class Turned, class Arrays, class Json>
Status layoutJob(InputJob& job, WantedFiles wanted, const ProgressCallback& progress,
                 const Compute& compute, const Turned& turned, const Arrays& arrays,
                 const Json& json) {
  using Clock = std::chrono::steady_clock;
  const auto secondsSince = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const Clock::time_point started = Clock::now();
  progress({Stage::Read, 0, 0, 0});
  if (Status s = readInput(job); !s.ok()) return s;
  const double read = secondsSince(started);

  dropSource(job, wanted);
  auto computed = compute();
  if (!computed.ok()) return computed.status();
  auto& result = computed.value();

  progress({Stage::Write, 0, 0, 0.98});
  const Clock::time_point writing = Clock::now();
  writeFiles(job, wanted, result.uv, result.cornerUv, turned(result));
  result.report.path = job.name;
  result.report.timings.read = read;
  arrays(result);
  if (job.isFile) job.layout.positions = outputPositions(job);
  result.report.timings.write = secondsSince(writing);
  result.report.timings.total = secondsSince(started);
  job.text = json(result.report);
  progress({Stage::Write, 0, 0, 1});
  return {};
}

}  // namespace abflat::bindings
