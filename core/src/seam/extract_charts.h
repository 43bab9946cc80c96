#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// Some charts of a cut surface as a surface of their own, open where it was cut. Its mesh is
/// numbered independently.
struct SeamPart {
  SeamMesh mesh;
  IdVector<SurfaceCorner, SurfaceCorner>
      wholeHalfEdge;  ///< in the whole, per half-edge of the part
  IdVector<SurfaceVertex, SurfaceVertex> wholeVertex;

  /// Re-expresses this part, whose whole was the mesh of `between`, in terms of the whole of
  /// `between`.
  void embedIn(const SeamPart& between) {
    for (SurfaceCorner& h : wholeHalfEdge) h = between.wholeHalfEdge[h];
    for (SurfaceVertex& v : wholeVertex) v = between.wholeVertex[v];
  }

  /// Picks the part's vertices or corners from values of the whole. Nothing remains nothing.
  template <class T>
  IdVector<SurfaceVertex, T> ofVertices(const IdVector<SurfaceVertex, T>& whole) const {
    return picked(wholeVertex, whole);
  }
  template <class T>
  IdVector<SurfaceCorner, T> ofCorners(const IdVector<SurfaceCorner, T>& whole) const {
    return picked(wholeHalfEdge, whole);
  }

  /// Per corner of the whole, which has so many, its number here; none if it is not in the part.
  IdVector<SurfaceCorner, SurfaceCorner> cornersInPart(std::size_t cornersOfWhole) const {
    IdVector<SurfaceCorner, SurfaceCorner> out(cornersOfWhole);
    for (const SurfaceCorner h : wholeHalfEdge.ids()) out[wholeHalfEdge[h]] = h;
    return out;
  }

  /// Puts the part's values in the place of those of the whole.
  template <class T>
  void putInto(IdVector<SurfaceVertex, T>& whole, const IdVector<SurfaceVertex, T>& part) const {
    for (const SurfaceVertex i : part.ids()) whole[wholeVertex[i]] = part[i];
  }
  template <class T>
  void putInto(IdVector<SurfaceCorner, T>& whole, const IdVector<SurfaceCorner, T>& part) const {
    for (const SurfaceCorner i : part.ids()) whole[wholeHalfEdge[i]] = part[i];
  }

  /// The other way round, if the part has all of the whole.
  template <class T>
  IdVector<SurfaceVertex, T> toWhole(const IdVector<SurfaceVertex, T>& part) const {
    return putBack(wholeVertex, part);
  }
  template <class T>
  IdVector<SurfaceCorner, T> toWhole(const IdVector<SurfaceCorner, T>& part) const {
    return putBack(wholeHalfEdge, part);
  }

 private:
  template <class Id, class T>
  static IdVector<Id, T> picked(const IdVector<Id, Id>& inWhole, const IdVector<Id, T>& whole) {
    if (whole.empty()) return {};
    IdVector<Id, T> out(inWhole.size());
    for (const Id i : out.ids()) out[i] = whole[inWhole[i]];
    return out;
  }
  template <class Id, class T>
  static IdVector<Id, T> putBack(const IdVector<Id, Id>& inWhole, const IdVector<Id, T>& part) {
    IdVector<Id, T> out(part.size());
    for (const Id i : part.ids()) out[inWhole[i]] = part[i];
    return out;
  }
};
SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& surface,
                       const IdVector<CutChartId, std::uint8_t>& isWanted,
                       const Listener& listener = {});

}  // namespace abflat
