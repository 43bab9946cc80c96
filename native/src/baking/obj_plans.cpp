#include "baking/obj_plans.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace abflat::cli {
namespace {

/// From 0 to 1.
double channelOf(const ImageView& image, std::size_t pixel, std::size_t channel) {
  const std::size_t at = pixel * static_cast<std::size_t>(image.channels) + channel;
  if (image.bits == 8) return static_cast<const std::uint8_t*>(image.pixels)[at] / 255.0;
  std::uint16_t value = 0;
  std::memcpy(&value, static_cast<const char*>(image.pixels) + 2 * at, 2);
  return value / 65535.0;
}

/// Whether alpha says nothing.
bool isOpaque(const ImageView& image) {
  const auto last = static_cast<std::size_t>(image.channels - 1);
  const std::size_t count = std::size_t{image.width} * image.height;
  std::size_t i = 0;
  while (i < count && channelOf(image, i, last) == 1) ++i;
  return i == count;
}

/// Colours of a normal map are vectors of about length 1 that mostly point outwards.
bool looksLikeNormals(const ImageView& image) {
  constexpr std::size_t kMostSamples = 1 << 16;
  constexpr double kLeastOutwards = 0.75, kLeastShare = 0.9, kMostOff = 0.25;
  const std::size_t count = std::size_t{image.width} * image.height;
  const std::size_t step = count / kMostSamples + 1;
  std::size_t samples = 0, vectors = 0;
  double outwards = 0;
  for (std::size_t i = 0; i < count; i += step, ++samples) {
    double squares = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = 2 * channelOf(image, i, d) - 1;
      squares += x * x;
    }
    outwards += channelOf(image, i, 2);
    vectors +=
        squares > (1 - kMostOff) * (1 - kMostOff) && squares < (1 + kMostOff) * (1 + kMostOff);
  }
  return static_cast<double>(vectors) >= kLeastShare * static_cast<double>(samples) &&
         outwards >= kLeastOutwards * static_cast<double>(samples);
}

class Planner {
 public:
  Planner(const ObjMaps& maps, const std::vector<ImageTraits>& traits)
      : maps_(maps), traits_(traits) {}

  ObjPlans run() {
    for (std::size_t m = 0; m < maps_.materials.size(); ++m) {
      std::vector<std::size_t>& row = out_.planOf.emplace_back();
      for (const MtlMap& map : maps_.materials[m])
        row.push_back(map.image == kNoImage ? kNoPlan : add(m, map));
    }
    joinEqual();
    return std::move(out_);
  }

 private:
  ObjPlan planFor(const MtlMap& map) const {
    const ImageTraits& image = traits_[map.image];
    ObjPlan out;
    out.name = map.name;
    const bool isNormal = map.meaning == MtlMeaning::Normal ||
                          (map.meaning == MtlMeaning::Relief && image.isNormalMap);
    if (isNormal) {
      out.name = "normal";
      out.kind = MapKind::Normal;
    } else {
      out.channels = image.channels;
    }
    if (map.meaning == MtlMeaning::Colour) out.space = ColourSpace::Srgb;
    // Steps of heights would show as terraces.
    if (map.name == "displacement" || (map.name == "bump" && !isNormal)) out.bits = image.bits;
    return out;
  }

  /// Programs take the alpha of an opacity if there is any, so images without have one of their
  /// own.
  static bool goTogether(const ObjPlan& a, const ObjPlan& b) {
    return a.name == b.name && (a.name != "opacity" || (a.channels == 4) == (b.channels == 4));
  }

  std::size_t add(std::size_t material, const MtlMap& map) {
    ObjPlan fresh = planFor(map);
    const ObjUse use{map.image, map.scale, map.offset, map.isClamped};
    std::size_t i = 0;
    for (; i < out_.plans.size(); ++i) {
      const std::optional<ObjUse>& known = out_.plans[i].uses[material];
      if (goTogether(out_.plans[i], fresh) && (!known || *known == use)) break;
    }
    if (i == out_.plans.size()) {
      fresh.uses.resize(maps_.materials.size());
      out_.plans.push_back(fresh);
    }
    ObjPlan& plan = out_.plans[i];
    plan.channels = std::max(plan.channels, fresh.channels);
    plan.bits = std::max(plan.bits, fresh.bits);
    plan.uses[material] = use;
    return i;
  }

  /// Whether `first` holds all that `plan` does.
  bool holds(const ObjPlan& first, const ObjPlan& plan) const {
    if (first.kind != MapKind::Colour || plan.kind != MapKind::Colour) return false;
    for (std::size_t m = 0; m < plan.uses.size(); ++m)
      if (plan.uses[m] && !(first.uses[m] == plan.uses[m])) return false;
    const bool isAlpha = plan.name == "opacity" && plan.channels == 4;
    return isAlpha || (first.space == plan.space && first.bits >= plan.bits);
  }

  /// Such as an ambient colour that is the diffuse one.
  void joinEqual() {
    std::vector<std::size_t> numbers;
    std::vector<ObjPlan> kept;
    for (const ObjPlan& plan : out_.plans) {
      const auto same = std::find_if(kept.begin(), kept.end(),
                                     [&](const ObjPlan& first) { return holds(first, plan); });
      numbers.push_back(static_cast<std::size_t>(same - kept.begin()));
      if (same == kept.end()) kept.push_back(plan);
    }
    for (std::vector<std::size_t>& row : out_.planOf)
      for (std::size_t& plan : row)
        if (plan != kNoPlan) plan = numbers[plan];
    out_.plans = std::move(kept);
  }

  const ObjMaps& maps_;
  const std::vector<ImageTraits>& traits_;
  ObjPlans out_;
};

/// So that no two files have one name.
void makeNamesDistinct(std::vector<ObjPlan>& plans) {
  std::map<std::string, int> counts;
  for (ObjPlan& plan : plans) {
    const int count = ++counts[plan.name];
    if (count > 1) plan.name += std::to_string(count);
  }
}

}  // namespace

ImageTraits traitsOf(const ImageView& image) {
  const bool hasAlpha = image.channels % 2 == 0 && !isOpaque(image);
  const int colours = image.channels >= 3 ? 3 : 1;
  return {hasAlpha ? 4 : colours, image.bits, colours == 3 && looksLikeNormals(image)};
}

ObjPlans planObj(const ObjMaps& maps, const std::vector<ImageTraits>& traits) {
  ObjPlans out = Planner(maps, traits).run();
  makeNamesDistinct(out.plans);
  return out;
}

}  // namespace abflat::cli
