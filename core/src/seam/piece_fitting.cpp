#include "seam/piece_fitting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// What differs by less is alike, so that it is not rounding that decides.
constexpr double kAlike = 1e-9;

using FlatLoop = IdVector<BoundaryIndex, PlanePoint>;

double perimeterOf(const FlatLoop& loop) {
  double sum = 0;
  for (const BoundaryIndex i : loop.ids())
    sum += distance(loop[i], loop[nextAlong(i, loop.size())]);
  return sum;
}

/// Points of a loop, at least `spacing` apart, and rather those that are `preferred`.
template <typename Preferred>
std::vector<BoundaryIndex> sampled(const FlatLoop& loop, double spacing, Preferred preferred) {
  std::vector<BoundaryIndex> out;
  for (const BoundaryIndex i : loop.ids()) {
    if (out.empty() || distance(loop[i], loop[out.back()]) >= (1 - kAlike) * spacing)
      out.push_back(i);
    else if (preferred(i) && !preferred(out.back()))
      out.back() = i;
  }
  return out;
}

/// Points from one of the `asked` points to another.
std::vector<PlanePoint> pointsBetween(const FlatLoop& loop, const std::vector<BoundaryIndex>& asked,
                                      std::size_t from, std::size_t to) {
  std::vector<PlanePoint> out;
  for (std::size_t k = from;; k = (k + 1) % asked.size()) {
    out.push_back(loop[asked[k]]);
    if (k == to) return out;
  }
}

/// Whether the loop fills its smallest box, which is not very long.
bool isRectangle(const FlatLoop& loop) {
  constexpr double kNearlyAll = 0.97, kLong = 5;
  const std::vector<PlanePoint> points(loop.begin(), loop.end());
  const Pose box = leastBoxPose(convexHull(points));
  return box.width <= kLong * box.height &&
         massOf(points).area >= kNearlyAll * box.width * box.height;
}

}  // namespace

PieceFitting::PieceFitting(const SeamMesh& mesh, const FlatSurface& flat, const QuickFit& fit,
                           double mostCost)
    : flat_(flat),
      unit_(std::sqrt(mesh.totalArea() * flat.unitArea)),
      fit_(fit),
      cutter_(mesh, flat.surface, flat.at),
      mostCost_(mostCost),
      isOnCrease_(verticesOnCreases()),
      charts_(static_cast<int>(cutter_.pieces().size())),
      size_(std::sqrt(mesh.totalArea())) {
  for (const CutChartId chart : flat.surface.charts.ids()) {
    const PieceId piece = addPiece();
    shapes_[piece].canCut = flat.canCut[chart] != 0;
    shapes_[piece].density = flat.density[chart];
    shapes_[piece].mostCost = mostCost;
    // The filling taken out of a hole needs no room.
    if (mesh.isFilling(flat.surface.charts[chart].firstTriangle)) continue;
    takeShape(piece);
    // A rectangle lies well.
    if (mostCost < HUGE_VAL && isRectangle(shapes_[piece].loop)) shapes_[piece].mostCost = 0;
  }
}

PieceFitting::PieceFitting(const PieceFitting&) = default;
PieceFitting::~PieceFitting() = default;

bool PieceFitting::fitInto(double side, double mostCost, int& tries) {
  constexpr int kMostCuts = 40;
  for (int i = 0; i < kMostCuts; ++i) {
    const Placed isPlaced = placed(side);
    const double missing = missingArea(isPlaced);
    if (missing == 0) return true;
    if (cost() > mostCost || !cutBest(isPlaced, missing, side, mostCost, tries)) return false;
  }
  return false;
}

bool PieceFitting::fits(double side) { return missingArea(placed(side, 0)) == 0; }

std::vector<LongChart> PieceFitting::longCharts() const {
  constexpr double kLong = 10;  // the square of half the outline, relative to the area: 8 by 1
  std::vector<LongChart> out;
  for (const CutChartId chart : flat_.surface.charts.ids()) {
    const PieceId p(std::uint32_t{chart});
    const Shape& shape = shapes_[p];
    const auto isLong = [&](double length) { return length * length > kLong * areaOf(p); };
    if (!shape.canCut || shape.loop.empty() || !isLong(perimeterOf(shape.loop) / 2)) continue;
    ChartLength across(flat_.surface, flat_.at, chart, isOnCrease_);
    const double length = scaleOf(p) * across.length();
    if (isLong(length)) out.push_back({p, std::move(across), length});
  }
  return out;
}

/// Those on edges within charts where cuts are hidden well enough; empty if they may go anywhere.
IdVector<OpenVertex, std::uint8_t> PieceFitting::verticesOnCreases() const {
  if (!std::isfinite(mostCost_)) return {};
  const SeamMesh& mesh = cutter_.mesh();
  const CutSurface& s = flat_.surface;
  IdVector<OpenVertex, std::uint8_t> out(s.vertexCount(), 0);
  for (const SurfaceCorner h : mesh.corners())
    if (s.twin[h].exists() && mesh.cost[h] <= mostCost_ * mesh.length[h])
      out[s.tail(h)] = out[s.head(h)] = 1;
  return out;
}

void PieceFitting::cutAcross(const LongChart& chart, int parts) {
  for (const AcrossPlace& place : chart.across.places(parts)) {
    const auto& loop = cutter_.pieces()[chart.piece].loop;
    const auto from = std::find(loop.begin(), loop.end(), place.before);
    const auto to = std::find(loop.begin(), loop.end(), place.after);
    if (from == loop.end() || to == loop.end()) continue;
    // As far as the cut is long, so that it can go straight across.
    const double reach = distance(flat_.at[*from], flat_.at[*to]);
    const BoundaryIndex first(from - loop.begin()), last(to - loop.begin());
    split(chart.piece, first, last, reach);
  }
  takeShape(chart.piece);
}

bool PieceFitting::split(PieceId piece, BoundaryIndex from, BoundaryIndex to, double reach) {
  if (!cutter_.split(piece, from, to, reach, shapes_[piece].mostCost)) return false;
  const PieceId added = addPiece();
  shapes_[added].density = shapes_[piece].density;
  shapes_[added].mostCost = shapes_[piece].mostCost;
  takeShape(added);
  return true;
}

PieceFitting::Placed PieceFitting::placed(double side) { return Placed(fit_.placed(side)); }
PieceFitting::Placed PieceFitting::placed(double side, double mostMissing) {
  return Placed(fit_.placed(side, mostMissing));
}

double PieceFitting::missingArea(const Placed& isPlaced) const {
  double sum = 0;
  for (const PieceId i : isPlaced.ids())
    if (!isPlaced[i]) sum += fit_.items()[i].mass.area;
  return sum;
}

PieceId PieceFitting::addPiece() {
  fit_.add({});
  return shapes_.push_back({});
}

double PieceFitting::areaOf(PieceId p) const {
  const double density = shapes_[p].density;
  // Rounding may leave a needle without area.
  return std::max(cutter_.pieces()[p].area * flat_.unitArea, 0.0) * density * density;
}

/// Scales each piece to its own area, at its density.
double PieceFitting::scaleOf(PieceId p) const {
  const double flatArea = cutter_.pieces()[p].flatArea;
  return flatArea > 0 ? std::sqrt(areaOf(p) / flatArea) : 1;
}

void PieceFitting::takeShape(PieceId p) {
  constexpr double kPoints = 400, kEnds = 72;
  const Piece& piece = cutter_.pieces()[p];
  Shape& shape = shapes_[p];
  const double area = areaOf(p), factor = scaleOf(p);
  shape.loop.clear();
  for (const OpenVertex v : piece.loop)
    shape.loop.push_back({factor * flat_.at[v].x, factor * flat_.at[v].y});
  const double perimeter = perimeterOf(shape.loop);
  shape.reach = perimeter / kEnds;
  shape.ends = sampled(shape.loop, shape.reach, [&](BoundaryIndex i) { return isOnCrease(p, i); });
  shape.chords.reset();
  const std::vector<BoundaryIndex> fine =
      sampled(shape.loop, perimeter / kPoints, [](BoundaryIndex) { return false; });
  PackItem item = fit_.itemOf(pointsBetween(shape.loop, fine, 0, fine.size() - 1));
  shape.solid = item.mass.area > 0 && area > 0 ? area / item.mass.area : 1;
  item.mass.area = area;
  fit_.exchange(p, std::move(item));
}

double PieceFitting::missingWith(const Candidate& c, double side, double most) {
  constexpr double kHasHole = 0.95;
  if (shapes_[c.piece].solid < kHasHole) {
    // What the cut leaves of the hole's rim becomes part of the outlines.
    PieceFitting trial = *this;
    trial.cut(c);
    return trial.missingArea(trial.placed(side, most));
  }
  const auto part = [&](std::size_t from, std::size_t to) {
    const Shape& shape = shapes_[c.piece];
    PackItem item = fit_.itemOf(pointsBetween(shape.loop, shape.ends, from, to));
    item.mass.area = std::max(shape.solid * item.mass.area, 0.0);
    return item;
  };
  PackItem whole = fit_.exchange(c.piece, part(c.chord.to, c.chord.from));
  fit_.add(part(c.chord.from, c.chord.to));
  const double out = missingArea(placed(side, most));
  fit_.removeLast();
  fit_.exchange(c.piece, std::move(whole));
  return out;
}

/// For each end, whether a crease within the charts ends there; empty if cuts may go anywhere.
std::vector<std::uint8_t> PieceFitting::endsOnCreases(PieceId p) const {
  std::vector<std::uint8_t> out;
  if (std::isfinite(shapes_[p].mostCost))
    for (const BoundaryIndex i : shapes_[p].ends) out.push_back(isOnCrease(p, i));
  return out;
}

/// Possible cuts of the two largest pieces without a place.
std::vector<PieceFitting::Candidate> PieceFitting::candidatesOf(const Placed& isPlaced) {
  constexpr double kMore = 1 + kAlike;
  PieceId asked[2];
  const auto massOf = [&](PieceId p) { return p.exists() ? fit_.items()[p].mass.area : -1; };
  for (const PieceId p : isPlaced.ids()) {
    const bool mayCut = shapes_[p].canCut && shapes_[p].mostCost > 0;
    if (isPlaced[p] || !mayCut || !(massOf(p) > kMore * massOf(asked[1]))) continue;
    asked[1] = p;
    if (massOf(p) > kMore * massOf(asked[0])) std::swap(asked[0], asked[1]);
  }
  std::vector<Candidate> out;
  for (const PieceId p : asked) {
    if (!p.exists()) continue;
    Shape& shape = shapes_[p];
    if (!shape.chords)
      shape.chords = outlineChords(pointsBetween(shape.loop, shape.ends, 0, shape.ends.size() - 1),
                                   endsOnCreases(p));
    for (const OutlineChord& chord : *shape.chords)
      out.push_back({p, chord, shape.solid * chord.length + kCostOfCut * unit_, 0});
  }
  return out;
}

bool PieceFitting::cutBest(const Placed& isPlaced, double missing, double side, double mostCost,
                           int& tries) {
  constexpr double kWithOthers = 1.2;  // times a piece's area may find a place when it is cut
  constexpr double kHalf = 0.3;        // of the area, at least
  std::vector<Candidate> candidates = candidatesOf(isPlaced);
  const double affordable = (mostCost - cost()) * unit_;
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const Candidate& c) { return c.cost > affordable; }),
                   candidates.end());
  if (candidates.empty()) return false;
  // Starts with cuts that may gain the most for their cost.
  const auto mostOf = [&](const Candidate& c) {
    return std::min(missing, kWithOthers * fit_.items()[c.piece].mass.area);
  };
  // Those that promise the same halve their piece.
  const auto rank = [&](const Candidate& c) {
    return std::make_pair(std::round(mostOf(c) / (c.cost * unit_) / kAlike),
                          std::round(c.chord.smallerShare() / kAlike));
  };
  sortStably(candidates, [&](const Candidate& a, const Candidate& b) { return rank(a) > rank(b); });
  std::vector<std::uint32_t> asked;
  asked.reserve(candidates.size());
  for (const Candidate& c : candidates) asked.push_back(c.piece);
  fit_.hold(side, asked);
  double best = 0;
  for (Candidate& c : candidates) {
    if (mostOf(c) <= (1 + kAlike) * best * c.cost || --tries < 0) continue;
    c.gain = (missing - missingWith(c, side, missing - best * c.cost)) / c.cost;
    best = std::max(best, c.gain);
  }
  fit_.release();
  if (tries < 0) return false;
  if (best > 0 && cost() + missing / (best * unit_) > mostCost) return false;
  while (best > 0) {
    Candidate* first = nullptr;
    for (Candidate& c : candidates)
      if (c.gain > (first ? (1 + kAlike) * first->gain : 0)) first = &c;
    if (!first) break;
    if (cut(*first)) return true;
    first->gain = 0;
  }
  // No cut lets anything find a place yet, so halve a piece.
  for (const Candidate& c : candidates)
    if (c.chord.smallerShare() > kHalf && cut(c)) return true;
  return false;
}

bool PieceFitting::cut(const Candidate& c) {
  const Shape& shape = shapes_[c.piece];
  const BoundaryIndex from = shape.ends[c.chord.from], to = shape.ends[c.chord.to];
  if (!split(c.piece, from, to, shape.reach)) return false;
  takeShape(c.piece);
  return true;
}

}  // namespace abflat
