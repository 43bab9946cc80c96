#include "refine/foreseen_contacts.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"
#include "check/validity.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Shares of a step at which its course is checked, so that what touches first is found too.
constexpr double kMoments[] = {0.125, 0.25, 0.5, 1};
/// The stiffness of the barrier at half its reach: stiffer than any surface, but within what single
/// precision can hold.
constexpr double kContactStiffness = 64;
/// The same for angles.
constexpr double kAngleStiffness = 210;
/// If one look asks for more springs than this, most of them are behind others.
constexpr std::size_t kCrowd = 300;
/// As a share of the margin: angles this close to their bounds may exceed them in the next step.
constexpr double kNear = 0.25;

std::vector<double> moved(std::vector<double> uv, const std::vector<double>& step, double by) {
  for (std::size_t i = 0; i < uv.size(); ++i) uv[i] += by * step[i];
  return uv;
}

}  // namespace

ForeseenContacts::ForeseenContacts(const DiskChart& chart, const OutlineShape& shape, double reach)
    : chart_(chart), shape_(shape), area_(surfaceArea(chart)), distance_(reach) {}

/// A spring between a point and the place of an edge that is nearest to it `then`. Its gap is not
/// positive if they are on the wrong sides of each other `now`.
ForeseenContacts::Spring ForeseenContacts::springAt(const std::vector<double>& now,
                                                    const std::vector<double>& then,
                                                    BoundaryIndex point, BoundaryIndex edge) const {
  const BoundaryIndex end = chart_.after(edge);
  const double *x = &then[2 * point], *a = &then[2 * edge], *b = &then[2 * end];
  const double ux = b[0] - a[0], uy = b[1] - a[1], length = norm(ux, uy);
  Spring s{point, edge, false, {}, 0, 0, kContactStiffness * length / (distance_ * area_)};
  if (!(length > 0)) return s;
  const double along = ((x[0] - a[0]) * ux + (x[1] - a[1]) * uy) / (length * length);
  const double share = std::clamp(along, 0.0, 1.0);
  s.isBeside = share > 0 && share < 1;
  // Outwards: the surface is on the left.
  s.contact = distanceContact(
      {chart_.boundaryVertex(point), chart_.boundaryVertex(edge), chart_.boundaryVertex(end)},
      share, {uy / length, -ux / length});
  const BoundaryIndex places[3] = {point, edge, end};
  for (std::size_t i = 0; i < 6; ++i) s.gap += s.contact.change[i] * now[2 * places[i / 2] + i % 2];
  s.target = std::min(distance_, s.gap);
  return s;
}

/// A spring that keeps an angle below its bound.
ForeseenContacts::Spring ForeseenContacts::springAt(const OutlineShape::Bound& bound,
                                                    const std::vector<double>& uv) const {
  const OutlineShape::Slack slack = shape_.slackOf(bound, uv);
  const double half = shape_.margin() / 2;
  return {bound.place,
          bound.place,
          true,
          slack.contact,
          slack.value,
          std::min(half, slack.value),
          kAngleStiffness * bound.weight / (4 * half * half)};
}

void ForeseenContacts::begin(const std::vector<double>& uv) {
  isCrowded_ = false;
  const std::vector<double> now = boundaryUv(chart_, uv);
  std::vector<Spring> kept;
  auto bound = shape_.bounds().begin();
  for (const Spring& old : springs_) {
    const bool isAngle = old.point == old.edge;
    while (isAngle && bound->place != old.point) ++bound;
    const Spring s = isAngle ? springAt(*bound, uv) : springAt(now, now, old.point, old.edge);
    if (s.gap > 0 && s.isBeside) kept.push_back(s);
  }
  springs_ = std::move(kept);
}

bool ForeseenContacts::releasePulling(const std::vector<double>& step) {
  const auto pulls = [&](const Spring& s) { return s.gap + s.contact.along(step) > s.target; };
  const auto end = std::remove_if(springs_.begin(), springs_.end(), pulls);
  const bool isAny = end != springs_.end();
  springs_.erase(end, springs_.end());
  return isAny;
}

std::vector<ForeseenContacts::Spring>::iterator ForeseenContacts::placeFor(const Spring& spring) {
  return std::lower_bound(springs_.begin(), springs_.end(), spring, isBefore);
}

bool ForeseenContacts::isBefore(const Spring& a, const Spring& b) {
  return a.point != b.point ? a.point < b.point : a.edge < b.edge;
}

bool ForeseenContacts::add(const Spring& spring) {
  const auto at = placeFor(spring);
  const bool isKnown = at != springs_.end() && !isBefore(spring, *at);
  if (isKnown && !isCrowded_) return false;
  if (isKnown)
    *at = spring;  // it crosses although it is held, so it must do so elsewhere
  else
    springs_.insert(at, spring);
  return true;
}

/// Angles do not change in proportion to a long step, so springs follow their values at its end.
/// True if one exceeds its bound there.
bool ForeseenContacts::updateAngles(const std::vector<double>& uv, const std::vector<double>& step,
                                    double length) {
  if (shape_.bounds().empty()) return false;
  const std::vector<double> then = moved(uv, step, length);
  bool isAny = false;
  for (const OutlineShape::Bound& bound : shape_.bounds()) {
    const OutlineShape::Slack end = shape_.slackOf(bound, then);
    const bool isExceeded = !(end.value > 0);
    isAny |= isExceeded;
    Spring spring = springAt(bound, uv);
    spring.contact = end.contact;
    spring.gap = end.value - length * end.contact.along(step);
    const auto at = placeFor(spring);
    if (at != springs_.end() && !isBefore(spring, *at))
      *at = spring;
    else if (end.value < kNear * shape_.margin())
      springs_.insert(at, spring);
  }
  return isAny;
}

std::vector<ForeseenContacts::Spring> ForeseenContacts::crossed(const std::vector<double>& uv,
                                                                const std::vector<double>& step,
                                                                double length,
                                                                bool& isCrossing) const {
  const std::vector<double> now = boundaryUv(chart_, uv);
  std::vector<Spring> out;
  for (const double moment : kMoments) {
    const std::vector<double> then = boundaryUv(chart_, moved(uv, step, moment * length));
    const Crossings crossings = findCrossings(then);
    isCrossing |= crossings.count > 0;
    for (const auto& pair : crossings.first)
      for (std::size_t k = 0; k < 2; ++k) {
        const BoundaryIndex edge(pair[k]), other(pair[1 - k]);
        for (const BoundaryIndex point : {other, chart_.after(other)}) {
          if (point == edge || point == chart_.after(edge)) continue;
          Spring s = springAt(now, then, point, edge);
          s.moment = moment;
          if (s.gap > 0 && s.gap + s.contact.along(step) < 0) out.push_back(s);
        }
      }
  }
  return out;
}

/// Keeps only what each point meets first.
void ForeseenContacts::keepFirst(std::vector<Spring>& springs) {
  sortStably(springs, [](const Spring& a, const Spring& b) {
    return a.point != b.point     ? a.point < b.point
           : a.moment != b.moment ? a.moment < b.moment
                                  : a.gap < b.gap;
  });
  const auto isSame = [](const Spring& a, const Spring& b) { return a.point == b.point; };
  springs.erase(std::unique(springs.begin(), springs.end(), isSame), springs.end());
}

bool ForeseenContacts::update(const std::vector<double>& uv, const std::vector<double>& step,
                              double length, double angleLength) {
  bool isCrossing = false;
  std::vector<Spring> wanted = crossed(uv, step, length, isCrossing);
  isCrowded_ = isCrowded_ || wanted.size() > kCrowd;
  // In a crowd, a point released from a spring that pulls is pushed by the next one.
  bool isChanged = !isCrowded_ && releasePulling(step);
  if (isCrowded_) keepFirst(wanted);
  if (updateAngles(uv, step, angleLength)) isChanged = isCrossing = true;
  for (const Spring& spring : wanted) isChanged |= add(spring);
  if (isCrowded_ && !isChanged) isChanged = releasePulling(step);
  return isCrossing && isChanged;
}

void ForeseenContacts::addDerivatives(Eigen::VectorXd& gradient, SparseEntries& hessian) const {
  for (const Spring& s : springs_)
    s.contact.addDerivatives(s.stiffness * (s.gap - s.target), s.stiffness, gradient, hessian);
}

}  // namespace abflat
