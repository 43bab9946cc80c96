#pragma once

#include <cmath>
#include <vector>

#include "cut/cut_surface.h"
#include "pack/outline.h"

namespace abflat {

/// The charts of the surface come first; each cut adds one piece.
using PieceId = Id<struct PieceTag>;

/// A chart that lies in the plane, or what cuts have left of one.
struct Piece {
  IdVector<BoundaryIndex, OpenVertex> loop;  ///< counter-clockwise
  double area = 0;                           ///< on the surface
  double flatArea = 0;                       ///< of the same, in the plane
};

/// Cuts flattened charts in two along paths of edges that are roughly straight in the plane.
class PieceCutter {
 public:
  /// `at`: positions of the surface's vertices in the plane. The initial pieces are its charts.
  PieceCutter(const SeamMesh& mesh, const CutSurface& surface,
              const IdVector<OpenVertex, PlanePoint>& at);

  const SeamMesh& mesh() const { return mesh_; }
  const IdVector<PieceId, Piece>& pieces() const { return pieces_; }
  const std::vector<SurfaceCorner>& cuts() const { return cuts_; }
  double length() const { return length_; }  ///< of the visible cuts
  double cost() const { return cost_; }      ///< theirs, at most their length

  /// Cuts from near one point of the loop to near another, at most `reach` away from each. What is
  /// on the right of the cut becomes a new piece, the last one. False if there is no path, or if it
  /// costs more than `mostCost` for its length.
  bool split(PieceId piece, BoundaryIndex from, BoundaryIndex to, double reach,
             double mostCost = HUGE_VAL);

 private:
  using Loop = IdVector<BoundaryIndex, OpenVertex>;
  using Vertices = std::vector<OpenVertex>;
  using Path = std::vector<SurfaceCorner>;

  Vertices verticesNear(const Loop& loop, BoundaryIndex i, double reach) const;
  Path findPath(PieceId piece, const Vertices& from, const Vertices& to, double room) const;
  bool isOpen(PieceId piece, SurfaceCorner h) const;
  double costOf(const Path& path) const;
  void take(const Path& path);
  void open(HoleId hole);
  OpenVertex nextAlongRim(HoleId hole, OpenVertex v) const;
  void addRim(HoleId hole, OpenVertex from, OpenVertex to, Vertices& out) const;
  Vertices sideOf(const Path& path, bool isRight) const;
  void addTriangle(SurfaceTriangle triangle, Piece& out) const;
  void relabel(PieceId piece, SurfaceTriangle start, PieceId label, Piece& out);
  double distance(OpenVertex a, OpenVertex b) const;
  HoleId holeAt(SurfaceCorner h) const;
  OpenVertex beginOf(SurfaceCorner h) const { return surface_.tail(h); }
  OpenVertex endOf(SurfaceCorner h) const { return surface_.head(h); }

  const SeamMesh& mesh_;
  const CutSurface& surface_;
  const IdVector<OpenVertex, PlanePoint>& at_;
  IdVector<PieceId, Piece> pieces_;
  IdVector<SurfaceTriangle, PieceId> pieceOfTriangle_;
  IdVector<OpenVertex, std::uint8_t> isTaken_;  ///< on the boundary of its piece
  IdVector<SurfaceCorner, std::uint8_t> isCut_;
  std::vector<SurfaceCorner> cuts_;
  double length_ = 0, cost_ = 0;
};

}  // namespace abflat
