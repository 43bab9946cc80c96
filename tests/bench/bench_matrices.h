#pragma once

#include <Eigen/SparseCore>
#include <string>

#include "abflat/mesh.h"

namespace abflat::bench {

/// Rectangle of about `faces` triangles on a sphere, with noise in all coordinates.
PolygonMesh noisyCap(unsigned faces);

/// The sample "head" with about `faces` triangles and deterministic noise in all coordinates.
PolygonMesh noisyHead(unsigned faces);

/// Each triangle becomes four.
PolygonMesh subdivided(const PolygonMesh& mesh);

/// N: noisyCap(N); head-N: noisyHead(N); FILE or FILE+N: of a file, subdivided N times. False, with
/// a message on standard error, where it cannot be read.
bool makeMesh(const std::string& what, PolygonMesh& mesh);

/// Lower triangle of the cotangent Laplacian, weights at least 1e-3, plus 1e-3 on the diagonal.
Eigen::SparseMatrix<double> cotangentLaplacian(const PolygonMesh& mesh);

/// Lower triangle of the first Newton step's matrix; empty, with a message, where the mesh is not a
/// disk.
Eigen::SparseMatrix<double> schurMatrix(const PolygonMesh& mesh, std::string& message);

}  // namespace abflat::bench
