#pragma once

#include "abflat/mesh.h"

// One generator per file; `detail` as in abflat/samples.h.
namespace abflat {

/// Exact half of the unit sphere.
PolygonMesh makeHemisphere(double detail);

/// Long band with waves along it and ruffles at its sides.
PolygonMesh makeWavyStrip(double detail);

/// Head with nose, eye sockets, chin and ears, open at the neck and cut from there to the crown.
PolygonMesh makeHead(double detail);

/// Ribbon along a Greek alpha: its ends cross at different heights.
PolygonMesh makeAlphaBand(double detail);

/// Flat square with three balls on narrow necks.
PolygonMesh makeThreeBalls(double detail);

}  // namespace abflat
