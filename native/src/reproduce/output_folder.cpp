#include "reproduce/output_folder.h"

#include <filesystem>

#include "files/output_file.h"

namespace abflat::cli {

namespace fs = std::filesystem;

Status OutputFolder::prepare() const {
  std::error_code error;
  fs::create_directories(path_, error);
  std::error_code ignored;  // then it is not a folder
  if (error || !fs::is_directory(path_, ignored))
    return {StatusCode::CannotWrite,
            "cannot create the folder " + path_ + (error ? ": " + error.message() : "")};
  return OutputFile((fs::path(path_) / "index.html").string()).check();
}

Status OutputFolder::write(const std::string& name, std::string_view bytes) const {
  return OutputFile((fs::path(path_) / name).string()).writeNow(std::string(bytes));
}

}  // namespace abflat::cli
