#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace abflat::cli {

constexpr std::string_view kPaperSource =
    "Zayer, Rössl, Seidel: Convex Boundary Angle Based Flattening, VMV 2003, tables 1 and 2";

/// Values of table 2 for one t; empty if the table has no such row.
struct PaperDistortion {
  double t;
  std::string_view angular, length;  ///< with the digits as printed
};

/// The numbers printed in the paper for one model.
struct PaperModel {
  std::string_view stem;  ///< the file's stem, in lower case
  std::string_view name;
  std::string_view faces, seconds, angular, length;  ///< table 1: t = 1, 1.8 GHz Xeon
  std::vector<PaperDistortion> distortions;          ///< table 2
};

/// The paper's row for a model of this name, or null.
const PaperModel* findPaperModel(const std::string& stem);

/// The printed values for one t, or null.
const PaperDistortion* findDistortion(const PaperModel& model, double t);

}  // namespace abflat::cli
