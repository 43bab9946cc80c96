#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "pack/outline_chords.h"
#include "pack/quick_fit.h"
#include "seam/chart_length.h"
#include "seam/piece_cutter.h"

namespace abflat {

/// Charts that have been flattened, on their cut surface.
struct FlatSurface {
  CutSurface surface;
  IdVector<OpenVertex, PlanePoint> at;
  IdVector<CutChartId, std::uint8_t> canCut;
  IdVector<CutChartId, double> density;  ///< in the atlas, relative to each other
  double unitArea = 1;                   ///< area in the plane of an area of 1 on the mesh
};

/// A chart that is far longer than wide.
struct LongChart {
  PieceId piece;
  ChartLength across;
  double length = 0;  ///< in the unit of the sides of squares
};

/// Cuts charts until they fit into a square.
class PieceFitting {
 public:
  /// `mostCost`: the most that a cut may cost for its length, except in long charts.
  PieceFitting(const SeamMesh& mesh, const FlatSurface& flat, const QuickFit& fit,
               double mostCost = HUGE_VAL);
  PieceFitting(const PieceFitting& other);  // out of line: there is much to copy
  ~PieceFitting();

  /// Approximate side of the smallest square that holds the pieces as they are.
  double leastSide() { return fit_.leastSide(); }

  /// Cuts where the most area finds a place for the length of the cut, one cut after the other,
  /// until everything fits into a square of that side. False if that would cost more than
  /// `mostCost`, if nothing helps, or if `tries`, which counts down, runs out.
  bool fitInto(double side, double mostCost, int& tries);

  /// Whether all pieces fit into a square of that side as they are.
  bool fits(double side);
  /// Charts that may be cut, before anything has been cut.
  std::vector<LongChart> longCharts() const;
  /// Cuts a chart that has not been cut yet across, into that many parts or fewer.
  void cutAcross(const LongChart& chart, int parts);

  /// Lets a long chart without creases be cut in plain sight.
  void cutAnywhere(const LongChart& chart) {
    if (!chart.across.hasPreferred()) shapes_[chart.piece].mostCost = HUGE_VAL;
  }

  const std::vector<SurfaceCorner>& cuts() const { return cutter_.cuts(); }
  int count() const { return static_cast<int>(cutter_.pieces().size()) - charts_; }
  /// Length of the cuts, divided by the root of the surface area.
  double length() const { return cutter_.length() / size_; }
  double cost() const { return costOf(count(), cutter_.cost() / size_); }
  /// A cut costs what its seam does plus a fixed amount: more charts are harder to paint on, and
  /// the first few of them are what people see.
  static double costOf(int count, double seams) {
    return seams + kCostOfCut * count + kCostOfFirst * std::min(count, 4);
  }

 private:
  using Placed = IdVector<PieceId, std::uint8_t>;

  struct Candidate {
    PieceId piece;
    OutlineChord chord;
    double cost = 0;  ///< approximate, in the plane, without the parts inside holes
    double gain = 0;  ///< area that finds a place, divided by the cost
  };

  PieceId addPiece();
  void takeShape(PieceId piece);
  Placed placed(double side);
  Placed placed(double side, double mostMissing);
  double missingArea(const Placed& isPlaced) const;
  double missingWith(const Candidate& candidate, double side, double most);
  std::vector<Candidate> candidatesOf(const Placed& isPlaced);
  bool cutBest(const Placed& isPlaced, double missing, double side, double mostCost, int& tries);
  bool cut(const Candidate& candidate);
  /// What lies on one side becomes a piece of its own; the shape of the other is not taken anew.
  bool split(PieceId piece, BoundaryIndex from, BoundaryIndex to, double reach);

  /// One piece, in the form used for packing.
  struct Shape {
    IdVector<BoundaryIndex, PlanePoint> loop;
    std::vector<BoundaryIndex> ends;  ///< points of the loop where cuts may end
    double reach = 0;                 ///< distance from one end to the next
    double solid = 1;                 ///< share of the area within the loop that is not a hole
    std::optional<std::vector<OutlineChord>> chords;
    double density = 1;
    bool canCut = true;
    double mostCost = HUGE_VAL;  ///< of a cut, for its length
  };

  static constexpr double kCostOfCut = 0.5, kCostOfFirst = 0.75;

  IdVector<OpenVertex, std::uint8_t> verticesOnCreases() const;
  std::vector<std::uint8_t> endsOnCreases(PieceId piece) const;
  bool isOnCrease(PieceId piece, BoundaryIndex i) const {
    return !isOnCrease_.empty() && isOnCrease_[cutter_.pieces()[piece].loop[i]];
  }
  double areaOf(PieceId piece) const;
  double scaleOf(PieceId piece) const;

  const FlatSurface& flat_;
  double unit_ = 1;  ///< root of the area, in the plane
  QuickFit fit_;     ///< items are numbered like pieces
  PieceCutter cutter_;
  IdVector<PieceId, Shape> shapes_;
  double mostCost_;
  IdVector<OpenVertex, std::uint8_t> isOnCrease_;  ///< of the charts, see verticesOnCreases
  int charts_ = 0;
  double size_ = 1;
};

}  // namespace abflat
