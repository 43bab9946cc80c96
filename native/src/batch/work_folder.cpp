#include "batch/work_folder.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

Status cannotMake(const std::string& folder, const std::string& reason) {
  return {StatusCode::CannotWrite, "cannot create the folder " + folder + ": " + reason};
}

}  // namespace

WorkFolder::WorkFolder(std::string out, const std::string& tag)
    : out_(std::move(out)), prefix_(".abflat-batch-" + tag + "-") {}

WorkFolder::~WorkFolder() {
  std::error_code ignored;  // the next run tries again
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Status WorkFolder::make() {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(out_, error)) {
    std::error_code ignored;  // what cannot be removed is in nobody's way
    if (entry.path().filename().string().compare(0, prefix_.size(), prefix_) == 0)
      fs::remove_all(entry.path(), ignored);
  }
  std::string path = (fs::path(out_) / (prefix_ + "XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) return cannotMake(path, std::strerror(errno));
  path_ = path;
  return {};
}

Result<WorkPlace> WorkFolder::placeFor(std::size_t number, const Task& task) const {
  const fs::path folder = fs::path(path_) / std::to_string(number);
  WorkPlace out;
  out.folder = folder.string();
  out.report = (folder / "report.json").string();
  out.layout = (folder / ("layout" + fs::path(task.picture).extension().string())).string();
  out.said = (folder / "said.txt").string();
  out.parts = (folder / "parts").string();
  std::error_code error;
  fs::create_directories(folder, error);
  for (std::size_t i = 0; i < task.outputs.size() && !error; ++i) {
    const fs::path results = folder / "results" / std::to_string(i);
    fs::create_directories(results, error);
    out.meshes.push_back((results / fs::path(task.outputs[i]).filename()).string());
  }
  if (error) return cannotMake(folder.string(), error.message());
  return out;
}

void WorkFolder::remove(const WorkPlace& place) {
  std::error_code ignored;  // it is removed with the whole folder
  fs::remove_all(place.folder, ignored);
}

}  // namespace abflat::cli
