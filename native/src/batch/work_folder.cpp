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
  const fs::path results = folder / "results";
  std::error_code error;
  fs::create_directories(results, error);
  if (error) return cannotMake(results.string(), error.message());
  return WorkPlace{folder.string(),
                   results.string(),
                   (results / fs::path(task.output).filename()).string(),
                   (folder / "report.json").string(),
                   (folder / ("layout" + fs::path(task.picture).extension().string())).string(),
                   (folder / "said.txt").string()};
}

void WorkFolder::remove(const WorkPlace& place) {
  std::error_code ignored;  // it is removed with the whole folder
  fs::remove_all(place.folder, ignored);
}

}  // namespace abflat::cli
