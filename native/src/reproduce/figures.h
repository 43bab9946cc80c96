#pragma once

#include <string>
#include <vector>

#include "reproduce/experiment.h"

namespace abflat::cli {

/// A picture of one mesh, as a file of the output folder.
struct Figure {
  int number = 0;     ///< of the paper's figure
  std::string file;   ///< name
  std::string title;  ///< for people: the mesh
  std::string svg;
};

/// What the paper's figure of this number shows, for a heading.
std::string figureHeading(int number);

struct FigureSet {
  std::vector<Figure> figures;
  std::vector<std::string> remarks;  ///< what was left out and why, one sentence each
};

/// The figures of one mesh; none when it cannot be flattened.
FigureSet makeFigures(Experiment& experiment);

}  // namespace abflat::cli
