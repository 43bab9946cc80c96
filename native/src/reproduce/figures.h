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

/// Figures 2, 4, 6 and 8 of one mesh; none when it cannot be flattened. The system matrix is left
/// out for meshes of which a picture could show nothing.
std::vector<Figure> makeFigures(Experiment& experiment);

}  // namespace abflat::cli
