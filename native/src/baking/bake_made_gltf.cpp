#include "baking/bake_made_gltf.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace abflat::cli {
namespace {

class GltfLookMaker {
 public:
  GltfLookMaker(const OldObj& old, ObjBaker& baker, ImageFormat format, Appearance& look,
                BakingReport& report, std::vector<std::string>& notes)
      : old_(old),
        baker_(baker),
        format_(format),
        look_(look),
        report_(report),
        notes_(notes),
        planOf_(std::max<std::size_t>(old.maps.materials.size(), 1)) {}

  Status make() {
    look_.images.clear();
    for (MaterialLook& material : look_.materials) material.image = kNoImage;
    look_.materials.resize(std::max(look_.materials.size(), planOf_.size()));
    findPlans();
    if (Status s = makeColour(); !s.ok()) return s;
    if (Status s = makeMetal(); !s.ok()) return s;
    if (Status s = makeOne("normal", &MaterialLook::normalImage); !s.ok()) return s;
    if (Status s = makeOne("emissive", &MaterialLook::emissiveImage); !s.ok()) return s;
    setNumbers();
    noteRest();
    return {};
  }

 private:
  /// What the first map of a name is baked into, and its line.
  struct Found {
    std::string name;
    std::size_t plan;
    const MtlMap* map;
  };

  void findPlans() {
    for (std::size_t m = 0; m < old_.maps.materials.size(); ++m)
      for (std::size_t k = 0; k < old_.maps.materials[m].size(); ++k) {
        const std::size_t plan = old_.plans.planOf[m][k];
        if (plan == kNoPlan) continue;
        const MtlMap& map = old_.maps.materials[m][k];
        const bool isNormal = old_.plans.plans[plan].kind == MapKind::Normal;
        const std::string name = isNormal ? "normal" : map.name;
        if (found(m, name) == nullptr) planOf_[m].push_back({name, plan, &map});
      }
  }

  const Found* found(std::size_t material, std::string_view name) const {
    for (const Found& each : planOf_[material])
      if (each.name == name) return &each;
    return nullptr;
  }

  /// Plans of all materials for a name.
  std::set<std::size_t> plansOf(std::string_view name) const {
    std::set<std::size_t> out;
    for (std::size_t m = 0; m < planOf_.size(); ++m)
      if (const Found* const each = found(m, name)) out.insert(each->plan);
    return out;
  }

  AtlasSize sizeOf(const std::set<std::size_t>& plans) const {
    AtlasSize out;
    for (const std::size_t plan : plans) {
      const AtlasSize size = baker_.sizeOf(old_.plans.plans[plan]);
      if (size.width > out.width) out = size;
    }
    return out;
  }

  static AtlasSize sizeOf(const images::Image& image) {
    return {static_cast<int>(image.width), static_cast<int>(image.height)};
  }

  /// Multiplies a channel of `to` by one of each plan: its alpha, if that is what counts, or red.
  /// Where a material has no image of the plan, that is white.
  Status multiply(const std::set<std::size_t>& plans, bool byAlpha, int channel,
                  images::Image& to) const {
    for (const std::size_t number : plans) {
      const ObjPlan& plan = old_.plans.plans[number];
      const Result<images::Image> image = baker_.bake(plan, sizeOf(to), 8);
      if (!image.ok()) return image.status();
      const auto from = static_cast<std::size_t>(byAlpha && plan.channels == 4 ? 3 : 0);
      const auto stepFrom = static_cast<std::size_t>(plan.channels);
      const auto stepTo = static_cast<std::size_t>(to.channels);
      const std::size_t count = std::size_t{to.width} * to.height;
      for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t& value = to.pixels[i * stepTo + static_cast<std::size_t>(channel)];
        value = static_cast<std::uint8_t>(
            (value * image.value().pixels[i * stepFrom + from] + 127) / 255);
      }
    }
    return {};
  }

  static images::Image white(const AtlasSize& size, int channels) {
    const auto width = static_cast<std::uint32_t>(size.width);
    const auto height = static_cast<std::uint32_t>(size.height);
    images::Image out{width, height, channels, 8, {}};
    out.pixels.assign(std::size_t{width} * height * static_cast<std::size_t>(channels), 255);
    return out;
  }

  /// An image of three or four channels with the colours of another.
  static images::Image withChannels(const images::Image& from, int channels) {
    images::Image out = white(sizeOf(from), channels);
    const auto was = static_cast<std::size_t>(from.channels),
               is = static_cast<std::size_t>(channels);
    for (std::size_t i = 0; i < out.pixels.size() / is; ++i)
      for (std::size_t d = 0; d < 3; ++d)
        out.pixels[i * is + d] = from.pixels[i * was + (was < 3 ? 0 : d)];
    return out;
  }

  /// Colours of materials and of vertices, and opacities. Any vertex has a colour, so all materials
  /// have the image then, and vertices lose theirs.
  Status makeColour() {
    const std::set<std::size_t> colours = plansOf("diffuse"), opacities = plansOf("opacity");
    std::set<std::size_t> all = colours;
    all.insert(opacities.begin(), opacities.end());
    const bool isPainted = !look_.colors.empty();
    if (all.empty() && !isPainted) return {};
    ObjPlan plan;
    plan.name = "baseColor";
    plan.space = ColourSpace::Srgb;
    plan.channels = opacities.empty() ? 3 : 4;
    ObjPlan first = colours.empty() ? plan : old_.plans.plans[*colours.begin()];
    first.hasVertexColours = isPainted;
    images::Image image = white(all.empty() ? baker_.sizeOf(first) : sizeOf(all), plan.channels);
    if (isPainted || !colours.empty()) {
      const Result<images::Image> baked = baker_.bake(first, sizeOf(image), 8);
      if (!baked.ok()) return baked.status();
      image = withChannels(baked.value(), plan.channels);
    }
    if (Status s = multiply(opacities, true, 3, image); !s.ok()) return s;
    if (Status s = put(image, plan, {"diffuse", "opacity"}, &MaterialLook::image); !s.ok())
      return s;
    if (!isPainted) return {};
    for (MaterialLook& material : look_.materials) material.image = look_.images.size() - 1;
    look_.colors.clear();
    return {};
  }

  Status makeMetal() {
    const std::set<std::size_t> rough = plansOf("roughness"), metal = plansOf("metallic");
    std::set<std::size_t> all = rough;
    all.insert(metal.begin(), metal.end());
    if (all.empty()) return {};
    ObjPlan plan;
    plan.name = "metallicRoughness";
    images::Image image = white(sizeOf(all), plan.channels);
    if (Status s = multiply(rough, false, 1, image); !s.ok()) return s;
    if (Status s = multiply(metal, false, 2, image); !s.ok()) return s;
    return put(image, plan, {"roughness", "metallic"}, &MaterialLook::metallicRoughnessImage);
  }

  Status makeOne(const char* name, std::size_t MaterialLook::*place) {
    const std::set<std::size_t> plans = plansOf(name);
    if (plans.empty()) return {};
    ObjPlan plan = old_.plans.plans[*plans.begin()];
    const Result<images::Image> image = baker_.bake(plan, baker_.sizeOf(plan), 8);
    if (!image.ok()) return image.status();
    plan.name = name;
    plan.channels = 3;
    return put(withChannels(image.value(), 3), plan, {name}, place);
  }

  /// Materials with any of these maps use the image.
  Status put(const images::Image& image, const ObjPlan& plan,
             const std::vector<std::string_view>& names, std::size_t MaterialLook::*place) {
    Result<ImageFile> file = baker_.write(image, plan, formatFor(plan, format_, notes_), report_);
    if (!file.ok()) return file.status();
    for (std::size_t m = 0; m < planOf_.size(); ++m)
      for (const std::string_view name : names)
        if (found(m, name)) look_.materials[m].*place = look_.images.size();
    look_.images.push_back(std::move(file).value());
    return {};
  }

  /// An image replaces the number of a material.
  void setNumbers() {
    for (std::size_t m = 0; m < planOf_.size(); ++m) {
      MaterialLook& material = look_.materials[m];
      if (found(m, "roughness")) material.roughness = 1;
      if (found(m, "metallic")) material.metallic = 1;
      if (found(m, "emissive")) material.emission = {1, 1, 1};
      if (const Found* const normal = found(m, "normal"))
        material.normalScale = normal->map->strength;
      material.hasOpacityImage = found(m, "opacity") != nullptr;
    }
  }

  void noteRest() {
    static const std::set<std::string> kHeld = {"diffuse",  "opacity", "roughness",
                                                "metallic", "normal",  "emissive"};
    std::set<std::string> rest;
    for (const std::vector<Found>& row : planOf_)
      for (const Found& each : row)
        if (kHeld.count(each.name) == 0) rest.insert(each.name);
    for (const std::string& name : rest)
      notes_.push_back("images for " + name + " were left out, because glTF has no such map");
  }

  const OldObj& old_;
  ObjBaker& baker_;
  const ImageFormat format_;
  Appearance& look_;
  BakingReport& report_;
  std::vector<std::string>& notes_;
  std::vector<std::vector<Found>> planOf_;  ///< by material
};

}  // namespace

Status bakeMadeGltf(const OldObj& old, ObjBaker& baker, ImageFormat format, Appearance& look,
                    BakingReport& report, std::vector<std::string>& notes) {
  return GltfLookMaker(old, baker, format, look, report, notes).make();
}

}  // namespace abflat::cli
