#include "alike/find_alike.h"

#include <algorithm>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// A part that others are compared with.
struct Model {
  PartId part;
  PartSeed seed;
  std::vector<PartId> others;  ///< parts that are like it
};

/// Where a part is, as one number that no two parts share.
double placeOf(const PartShape& shape) { return dot(shape.centre, kNoAxis); }

/// Parts in the order in which they are compared: those that may be alike follow each other.
std::vector<PartId> inOrder(const PartShapes& shapes) {
  std::vector<PartId> out;
  for (const PartId i : shapes.part.ids())
    if (shapes.part[i].radius > 0) out.push_back(i);
  sortStably(out, [&](PartId a, PartId b) {
    const PartShape &p = shapes.part[a], &q = shapes.part[b];
    if (p.key != q.key) return p.key < q.key;
    return p.radius != q.radius ? p.radius < q.radius : placeOf(p) < placeOf(q);
  });
  return out;
}

class AlikeFinder {
 public:
  AlikeFinder(const Cells& cells, const PartShapes& shapes, bool mayMirror)
      : cells_(cells), shapes_(shapes), mayMirror_(mayMirror), matcher_(cells, shapes) {}

  CornerMatch run() {
    for (const PartId part : inOrder(shapes_)) {
      if (models_.empty() || shapes_.part[models_.back().part].key != shapes_.part[part].key)
        finish();
      if (!isLikeModel(part)) models_.push_back({part, {}, {}});
    }
    finish();
    CornerMatch out = matcher_.take();
    for (const PolygonFace f : cells_.part.ids())
      for (const PolygonCorner c : cells_.corners(f))
        if (cells_.part[f].exists() && !out[c].exists()) out[c] = c;
    onto_.resize(out.size());
    for (const Model& model : found_) moveToFirst(model, out);
    return out;
  }

 private:
  /// Compares with the nearest models only. Models are in the order of their radius.
  bool isLikeModel(PartId part) {
    constexpr int kMostLooks = 1000, kMostWalks = 24;
    int looks = 0, walks = 0;
    for (auto m = models_.rbegin(); m != models_.rend(); ++m) {
      if (++looks > kMostLooks || walks >= kMostWalks) return false;
      const PartShape &own = shapes_.part[part], &other = shapes_.part[m->part];
      if (own.radius - other.radius > 2 * kAlikeTolerance * own.radius) return false;
      if (!shapes_.mayBeAlike(m->part, part)) continue;
      ++walks;
      if (!m->seed.corner.exists()) m->seed = seedOf(cells_, shapes_, m->part);
      if (!matcher_.match(m->part, m->seed, part, false) &&
          !(mayMirror_ && matcher_.match(m->part, m->seed, part, true)))
        continue;
      m->others.push_back(part);
      return true;
    }
    return false;
  }

  void finish() {
    for (Model& model : models_)
      if (!model.others.empty()) found_.push_back(std::move(model));
    models_.clear();
  }

  /// Makes the part with the least place the model of all, so that which one it is does not depend
  /// on rounding.
  void moveToFirst(const Model& model, CornerMatch& match) {
    const auto place = [&](PartId i) { return placeOf(shapes_.part[i]); };
    PartId first = model.part;
    for (const PartId i : model.others)
      if (place(i) < place(first)) first = i;
    if (first == model.part) return;
    for (const PolygonFace f : shapes_.facesOf(first))
      for (const PolygonCorner c : cells_.corners(f)) onto_[match[c]] = c;
    const auto move = [&](PartId i) {
      for (const PolygonFace f : shapes_.facesOf(i))
        for (const PolygonCorner c : cells_.corners(f)) match[c] = onto_[match[c]];
    };
    move(model.part);
    for (const PartId i : model.others) move(i);
  }

  const Cells& cells_;
  const PartShapes& shapes_;
  const bool mayMirror_;
  PartMatcher matcher_;
  std::vector<Model> models_;  ///< that hang together alike
  std::vector<Model> found_;   ///< with others
  CornerMatch onto_;           ///< where corners of a former model lie on the new one
};

}  // namespace

CornerMatch findAlike(const Cells& cells, const IdVector<PartId, std::uint8_t>& isLeftOut,
                      bool mayMirror) {
  const PartShapes shapes = shapesOf(cells, isLeftOut);
  return AlikeFinder(cells, shapes, mayMirror).run();
}

bool isMirroredAt(const Cells& cells, const CornerMatch& match, PolygonCorner c) {
  return match[cells.next(c)] != cells.next(match[c]);
}

}  // namespace abflat
