#pragma once

#include <vector>

#include "cut/cut_surface.h"
#include "pack/outline.h"

namespace abflat {

/// A chart that lies in the plane, or what cuts have left of it.
struct Piece {
  std::vector<std::uint32_t> loop;  ///< vertices of the cut surface, counter-clockwise
  double area = 0;                  ///< of the surface
  double flatArea = 0;              ///< of that where it lies
};

/// Cuts charts in two along paths of edges that are about straight where the charts lie.
class PieceCutter {
 public:
  /// `at`: where the vertices of the surface lie. The pieces are its charts.
  PieceCutter(const SeamMesh& mesh, const CutSurface& surface, const std::vector<PlanePoint>& at);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<std::uint32_t>& cuts() const { return cuts_; }  ///< half-edges
  double length() const { return length_; }  ///< of the cuts that can be seen

  /// From about one place of its loop to about another, at most `reach` away. What is on the right
  /// of the cut becomes a new piece, the last. False where there is no path.
  bool split(std::uint32_t piece, std::size_t from, std::size_t to, double reach);

 private:
  using Vertices = std::vector<std::uint32_t>;
  using Path = std::vector<std::uint32_t>;  ///< half-edges

  Vertices verticesNear(const Vertices& loop, std::size_t place, double reach) const;
  Path findPath(std::uint32_t piece, const Vertices& from, const Vertices& to, double room) const;
  bool isOpen(std::uint32_t piece, std::uint32_t h) const;
  void take(const Path& path);
  void open(std::uint32_t hole);
  void addRim(std::uint32_t hole, std::uint32_t from, std::uint32_t to, Vertices& out) const;
  Vertices sideOf(const Path& path, bool isRight) const;
  void addTriangle(std::uint32_t triangle, Piece& out) const;
  void relabel(std::uint32_t piece, std::uint32_t start, std::uint32_t label, Piece& out);
  double distance(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t holeAt(std::uint32_t h) const;
  std::uint32_t beginOf(std::uint32_t h) const { return surface_.vertexOfCorner[h]; }
  std::uint32_t endOf(std::uint32_t h) const { return surface_.vertexOfCorner[nextCorner(h)]; }

  const SeamMesh& mesh_;
  const CutSurface& surface_;
  const std::vector<PlanePoint>& at_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> pieceOfTriangle_;
  std::vector<std::uint8_t> isTaken_;  ///< per vertex: at the boundary of its piece
  std::vector<std::uint8_t> isCut_;    ///< per half-edge
  std::vector<std::uint32_t> cuts_;
  double length_ = 0;
};

}  // namespace abflat
