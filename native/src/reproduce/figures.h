#pragma once

#include <string>
#include <vector>

#include "reproduce/experiment.h"

namespace abflat::cli {

/// A picture of one mesh, stored as a file in the output folder.
struct Figure {
  int number = 0;     ///< of the paper's figure
  std::string file;   ///< name
  std::string title;  ///< the mesh's display name
  std::string svg;
};

/// A heading that says what the paper's figure with this number shows.
std::string figureHeading(int number);

struct FigureSet {
  std::vector<Figure> figures;
  std::vector<std::string> remarks;  ///< what was left out and why, one sentence each
};

/// Makes the figures of one mesh; none if it cannot be flattened.
FigureSet makeFigures(Experiment& experiment);

}  // namespace abflat::cli
