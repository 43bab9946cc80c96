#pragma once

#include <string>
#include <vector>

#include "reproduce/tables.h"

namespace abflat::cli {

/// A picture file beside the page.
struct PagePicture {
  std::string section;  ///< heading under which it is shown
  std::string file, title;
};

/// The content of the page; parts that were not asked for are left out.
struct PageContent {
  const PaperTables* tables = nullptr;  ///< null: none
  std::vector<PagePicture> pictures;    ///< in the order they are shown
  std::vector<std::string> remarks;     ///< what is missing and why, one sentence each
};

/// A static page without scripts.
std::string pageHtml(const PageContent& content);

}  // namespace abflat::cli
