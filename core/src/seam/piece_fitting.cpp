#include "seam/piece_fitting.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {
namespace {

double distance(PlanePoint a, PlanePoint b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

double perimeterOf(const std::vector<PlanePoint>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += distance(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

/// Places along a loop, at least so far apart.
std::vector<std::size_t> sampled(const std::vector<PlanePoint>& loop, double spacing) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (out.empty() || distance(loop[i], loop[out.back()]) >= spacing) out.push_back(i);
  return out;
}

/// From one place to another, along a loop of places.
std::vector<PlanePoint> pointsBetween(const std::vector<PlanePoint>& loop,
                                      const std::vector<std::size_t>& places, std::size_t from,
                                      std::size_t to) {
  std::vector<PlanePoint> out;
  for (std::size_t k = from;; k = (k + 1) % places.size()) {
    out.push_back(loop[places[k]]);
    if (k == to) return out;
  }
}

}  // namespace

PieceFitting::PieceFitting(const SeamMesh& mesh, const FlatSurface& flat, const QuickFit& fit)
    : flat_(flat),
      unit_(std::sqrt(mesh.totalArea() * flat.unitArea)),
      fit_(fit),
      cutter_(mesh, flat.surface, flat.at),
      charts_(static_cast<int>(cutter_.pieces().size())),
      size_(std::sqrt(mesh.totalArea())) {
  for (std::uint32_t p = 0; p < cutter_.pieces().size(); ++p) {
    addPiece();
    shapes_[p].canCut = flat.canCut[p] != 0;
    // What has been taken out of a hole takes no room.
    if (!mesh.isFilling(flat.surface.charts[p].firstTriangle)) takeShape(p);
  }
}

PieceFitting::PieceFitting(const PieceFitting&) = default;
PieceFitting::~PieceFitting() = default;

bool PieceFitting::fitInto(double side, double mostCost, int& tries) {
  constexpr int kMostCuts = 40;
  for (int i = 0; i < kMostCuts; ++i) {
    const std::vector<std::uint8_t> isPlaced = fit_.placed(side);
    const double missing = missingArea(isPlaced);
    if (missing == 0) return true;
    if (cost() > mostCost || !cutBest(isPlaced, missing, side, mostCost, tries)) return false;
  }
  return false;
}

double PieceFitting::missingArea(const std::vector<std::uint8_t>& isPlaced) const {
  double sum = 0;
  for (std::size_t i = 0; i < isPlaced.size(); ++i)
    if (!isPlaced[i]) sum += fit_.items()[i].mass.area;
  return sum;
}

void PieceFitting::addPiece() {
  fit_.add({});
  shapes_.emplace_back();
}

void PieceFitting::takeShape(std::uint32_t p) {
  constexpr double kPoints = 400, kEnds = 72;
  const Piece& piece = cutter_.pieces()[p];
  Shape& shape = shapes_[p];
  // Each is to have its own area.
  const double factor =
      piece.flatArea > 0 ? std::sqrt(piece.area * flat_.unitArea / piece.flatArea) : 1;
  shape.loop.clear();
  for (const std::uint32_t v : piece.loop)
    shape.loop.push_back({factor * flat_.at[v].x, factor * flat_.at[v].y});
  const double perimeter = perimeterOf(shape.loop);
  shape.reach = perimeter / kEnds;
  shape.places = sampled(shape.loop, shape.reach);
  shape.chords.reset();
  const std::vector<std::size_t> fine = sampled(shape.loop, perimeter / kPoints);
  PackItem item = fit_.itemOf(pointsBetween(shape.loop, fine, 0, fine.size() - 1));
  // Of a needle rounding may leave no area.
  const double area = std::max(piece.area * flat_.unitArea, 0.0);
  shape.solid = item.mass.area > 0 && area > 0 ? area / item.mass.area : 1;
  item.mass.area = area;
  fit_.exchange(p, std::move(item));
}

double PieceFitting::missingWith(const Candidate& c, double side, double most) {
  constexpr double kHasHole = 0.95;
  if (shapes_[c.piece].solid < kHasHole) {
    // What the cut leaves of the hole's rim belongs to the outlines.
    PieceFitting trial = *this;
    trial.cut(c);
    return trial.missingArea(trial.fit_.placed(side, most));
  }
  const auto part = [&](std::size_t from, std::size_t to) {
    const Shape& shape = shapes_[c.piece];
    PackItem item = fit_.itemOf(pointsBetween(shape.loop, shape.places, from, to));
    item.mass.area = std::max(shape.solid * item.mass.area, 0.0);
    return item;
  };
  PackItem whole = fit_.exchange(c.piece, part(c.chord.to, c.chord.from));
  fit_.add(part(c.chord.from, c.chord.to));
  const double out = missingArea(fit_.placed(side, most));
  fit_.removeLast();
  fit_.exchange(c.piece, std::move(whole));
  return out;
}

/// Cuts of the two largest pieces that have no place.
std::vector<PieceFitting::Candidate> PieceFitting::candidatesOf(
    const std::vector<std::uint8_t>& isPlaced) {
  std::uint32_t asked[] = {kNone, kNone};
  const auto areaOf = [&](std::uint32_t p) { return p == kNone ? -1 : fit_.items()[p].mass.area; };
  for (std::uint32_t p = 0; p < isPlaced.size(); ++p) {
    if (isPlaced[p] || !shapes_[p].canCut || !(areaOf(p) > areaOf(asked[1]))) continue;
    asked[1] = p;
    if (areaOf(p) > areaOf(asked[0])) std::swap(asked[0], asked[1]);
  }
  std::vector<Candidate> out;
  for (const std::uint32_t p : asked) {
    if (p == kNone) continue;
    Shape& shape = shapes_[p];
    if (!shape.chords)
      shape.chords =
          outlineChords(pointsBetween(shape.loop, shape.places, 0, shape.places.size() - 1));
    for (const OutlineChord& chord : *shape.chords)
      out.push_back({p, chord, shape.solid * chord.length + kCostOfCut * unit_, 0});
  }
  return out;
}

bool PieceFitting::cutBest(const std::vector<std::uint8_t>& isPlaced, double missing, double side,
                           double mostCost, int& tries) {
  constexpr double kWithOthers = 1.2;  // of a piece's area may find a place when it is cut
  constexpr double kHalf = 0.3;        // at least
  std::vector<Candidate> candidates = candidatesOf(isPlaced);
  const double affordable = (mostCost - cost()) * unit_;
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const Candidate& c) { return c.cost > affordable; }),
                   candidates.end());
  if (candidates.empty()) return false;
  // What may bring the most for its cost comes first.
  const auto mostOf = [&](const Candidate& c) {
    return std::min(missing, kWithOthers * fit_.items()[c.piece].mass.area);
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) {
                     return mostOf(a) * b.cost > mostOf(b) * a.cost;
                   });
  std::vector<std::uint32_t> asked;
  asked.reserve(candidates.size());
  for (const Candidate& c : candidates) asked.push_back(c.piece);
  fit_.hold(side, asked);
  double best = 0;
  for (Candidate& c : candidates) {
    if (mostOf(c) <= best * c.cost || --tries < 0) continue;
    c.gain = (missing - missingWith(c, side, missing - best * c.cost)) / c.cost;
    best = std::max(best, c.gain);
  }
  fit_.release();
  if (tries < 0) return false;
  if (best > 0 && cost() + missing / (best * unit_) > mostCost) return false;
  while (best > 0) {
    Candidate* first = nullptr;
    for (Candidate& c : candidates)
      if (c.gain > (first ? first->gain : 0)) first = &c;
    if (!first) break;
    if (cut(*first)) return true;
    first->gain = 0;
  }
  // Nothing finds a place yet: one is halved.
  for (const Candidate& c : candidates)
    if (std::min(c.chord.share, 1 - c.chord.share) > kHalf && cut(c)) return true;
  return false;
}

bool PieceFitting::cut(const Candidate& c) {
  const Shape& shape = shapes_[c.piece];
  const std::size_t from = shape.places[c.chord.from], to = shape.places[c.chord.to];
  if (!cutter_.split(c.piece, from, to, shape.reach)) return false;
  addPiece();
  takeShape(c.piece);
  takeShape(static_cast<std::uint32_t>(shapes_.size() - 1));
  return true;
}

}  // namespace abflat
