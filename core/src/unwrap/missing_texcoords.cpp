#include "unwrap/missing_texcoords.h"

#include <algorithm>
#include <utility>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// Fills one face after another; a face without area may have to wait for one beside it.
class Filler {
 public:
  Filler(const SurfaceMap& map, const IdVector<SurfaceCorner, TexcoordId>& ofSurface,
         IdVector<InputCorner, TexcoordId>& ofCorner)
      : map_(map), ofSurface_(ofSurface), ofCorner_(ofCorner) {
    for (const InputFace f : IdRange<InputFace>(map.input().faceCount()))
      if (isMissing(f)) faces_.push_back(f);
    if (!faces_.empty()) findSurfaceCorners();
  }

  void run() {
    std::vector<InputFace> waiting;
    for (const InputFace f : faces_)
      if (!fill(f)) waiting.push_back(f);
    // Others that wait at the places of a face that is filled may go on.
    std::vector<std::pair<InputVertex, InputFace>> waitsAt;
    for (const InputFace f : waiting)
      for (const InputCorner c : cornersOf(f)) waitsAt.emplace_back(placeOf(c), f);
    sortStably(waitsAt, std::less<>());
    while (!reached_.empty()) {
      const InputVertex place = reached_.back();
      reached_.pop_back();
      auto at = std::lower_bound(waitsAt.begin(), waitsAt.end(), std::pair(place, InputFace(0)));
      for (; at != waitsAt.end() && at->first == place; ++at)
        if (isMissing(at->second)) fill(at->second);
    }
  }

 private:
  /// Texcoords of a face's corners at a place: one that was known, and one that was not.
  struct InFace {
    TexcoordId known, filled;
  };

  IdRange<InputCorner> cornersOf(InputFace f) const {
    const InputMesh& input = map_.input();
    return {InputCorner(input.firstCorner(f)), InputCorner(input.firstCorner(f + 1))};
  }
  InputVertex placeOf(InputCorner c) const {
    return map_.welded().firstAtPlace[InputVertex(map_.input().vertex(c))];
  }
  InputVertex placeOf(SurfaceCorner c) const { return map_.welded().firstAtPlace[map_.vertex(c)]; }
  bool isMissing(InputFace f) const {
    for (const InputCorner c : cornersOf(f))
      if (!ofCorner_[c].exists()) return true;
    return false;
  }

  /// Groups the surface's corners by place, where corners of the input have none.
  void findSurfaceCorners() {
    const std::size_t places = map_.welded().firstAtPlace.size();
    first_.assign(places + 1, 0);
    texcoordAt_.assign(places, {});
    inFace_.assign(places, {});
    IdVector<InputVertex, std::uint8_t> isWanted(places, 0);
    for (const InputFace f : faces_)
      for (const InputCorner c : cornersOf(f)) isWanted[placeOf(c)] = 1;
    const IdRange<SurfaceCorner> corners = map_.surface().table.corners();
    for (const SurfaceCorner c : corners)
      if (isWanted[placeOf(c)]) ++first_[placeOf(c) + 1];
    for (std::size_t v = 0; v < places; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    corners_.resize(first_.back());
    for (const SurfaceCorner c : corners)
      if (isWanted[placeOf(c)]) corners_[next[placeOf(c)]++] = c;
  }

  /// Calls `see` for the corners at both ends of each triangle's edges between two places, until it
  /// returns true.
  template <class See>
  bool anyEdge(InputVertex from, InputVertex to, const See& see) const {
    const auto count = [&](InputVertex place) { return first_[place + 1] - first_[place]; };
    const bool isTurned = count(to) < count(from);
    const auto [here, there] = isTurned ? std::pair(to, from) : std::pair(from, to);
    for (std::uint32_t i = first_[here]; i < first_[here + 1]; ++i)
      for (const SurfaceCorner other : {nextCorner(corners_[i]), prevCorner(corners_[i])})
        if (placeOf(other) == there &&
            (isTurned ? see(other, corners_[i]) : see(corners_[i], other)))
          return true;
    return false;
  }

  void set(InputCorner c, TexcoordId texcoord) {
    ofCorner_[c] = texcoord;
    const InputVertex place = placeOf(c);
    if (!inFace_[place].filled.exists()) inFace_[place].filled = texcoord;
    if (first_[place] < first_[place + 1] || texcoordAt_[place].exists()) return;
    texcoordAt_[place] = texcoord;
    reached_.push_back(place);
  }

  /// False if the face is not beside a chart.
  bool fill(InputFace f) {
    const IdRange<InputCorner> corners = cornersOf(f);
    std::vector<InputCorner> known;
    for (const InputCorner c : corners)
      if (ofCorner_[c].exists()) known.push_back(c);
    for (const InputCorner c : known) inFace_[placeOf(c)].known = ofCorner_[c];
    if (known.empty()) known = seed(corners);
    const InputCorner first = *corners.begin(), last(first + corners.size() - 1);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const InputCorner c = known[i];
      for (const InputCorner next :
           {c == first ? last : InputCorner(c - 1), c == last ? first : InputCorner(c + 1)}) {
        if (ofCorner_[next].exists()) continue;
        set(next, step(c, next));
        known.push_back(next);
      }
    }
    for (const InputCorner c : corners) inFace_[placeOf(c)] = {};
    return !known.empty();
  }

  /// Texcoords of two corners, beside another face if possible; returns those corners.
  std::vector<InputCorner> seed(const IdRange<InputCorner>& corners) {
    InputCorner before(*corners.begin() + corners.size() - 1);
    for (const InputCorner c : corners) {
      const auto take = [&](SurfaceCorner here, SurfaceCorner there) {
        set(before, ofSurface_[here]);
        set(c, ofSurface_[there]);
        return true;
      };
      if (placeOf(c) != placeOf(before) && anyEdge(placeOf(before), placeOf(c), take))
        return {before, c};
      before = c;
    }
    for (const InputCorner c : corners) {
      const InputVertex place = placeOf(c);
      const TexcoordId found = first_[place] < first_[place + 1]
                                   ? ofSurface_[corners_[first_[place]]]
                                   : texcoordAt_[place];
      if (!found.exists()) continue;
      set(c, found);
      return {c};
    }
    return {};
  }

  /// The texcoord of a corner beside one that has some.
  TexcoordId step(InputCorner from, InputCorner to) const {
    const InputVertex place = placeOf(to);
    if (place == placeOf(from)) return ofCorner_[from];
    TexcoordId found = inFace_[place].filled;
    const auto take = [&](SurfaceCorner here, SurfaceCorner there) {
      if (ofSurface_[here] == ofCorner_[from]) found = ofSurface_[there];
      return found.exists();
    };
    if (!found.exists()) anyEdge(placeOf(from), place, take);
    if (!found.exists()) found = inFace_[place].known;
    return found.exists() ? found : ofCorner_[from];
  }

  const SurfaceMap& map_;
  const IdVector<SurfaceCorner, TexcoordId>& ofSurface_;
  IdVector<InputCorner, TexcoordId>& ofCorner_;
  std::vector<InputFace> faces_;      ///< with corners that have no texcoord
  std::vector<std::uint32_t> first_;  ///< per place, in corners_
  std::vector<SurfaceCorner> corners_;
  IdVector<InputVertex, InFace> inFace_;          ///< of the face being filled
  IdVector<InputVertex, TexcoordId> texcoordAt_;  ///< given to places that no triangle has
  std::vector<InputVertex> reached_;              ///< places that have been given one
};

}  // namespace

void fillMissing(const SurfaceMap& map, const IdVector<SurfaceCorner, TexcoordId>& ofSurface,
                 IdVector<InputCorner, TexcoordId>& ofCorner) {
  Filler(map, ofSurface, ofCorner).run();
}

}  // namespace abflat
