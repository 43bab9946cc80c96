#pragma once

#include <cstddef>
#include <vector>

#include "abflat/compare_meshes.h"
#include "files/input_file.h"

namespace abflat::cli {

/// In what a file differs from the one it was made from, apart from the texcoords of a glTF set.
/// Faces of two glTF files, or of two others, have to be in the same order; so have vertices, if
/// neither is a glTF. Errors: OutOfMemory.
Result<std::vector<MeshDifference>> compareFiles(InputFile& was, InputFile& now,
                                                 std::size_t texcoord);

}  // namespace abflat::cli
