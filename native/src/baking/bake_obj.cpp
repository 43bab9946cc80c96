#include "baking/bake_obj.h"

#include <utility>

namespace abflat::cli {

std::string objImageName(const std::string& stem, const ObjPlan& plan, ImageFormat format) {
  return stem + "-" + plan.name + images::endingOf(format);
}

Result<NewObj> bakeObj(OldObj& old, ObjBaker& baker, const std::string& stem, ImageFormat wanted) {
  NewObj out;
  for (const ObjPlan& plan : old.plans.plans) {
    const ImageFormat format = formatFor(plan, wanted, out.notes);
    const Result<images::Image> image =
        baker.bake(plan, baker.sizeOf(plan), format == ImageFormat::Png ? plan.bits : 8);
    if (!image.ok()) return image.status();
    Result<ImageFile> file = baker.write(image.value(), plan, format, out.report);
    if (!file.ok()) return file.status();
    out.images.push_back(std::move(file).value());
    out.images.back().name = objImageName(stem, plan, format);
  }
  std::vector<std::vector<std::string>> names;
  for (const std::vector<std::size_t>& row : old.plans.planOf) {
    names.emplace_back();
    for (const std::size_t plan : row)
      names.back().push_back(plan == kNoPlan ? "" : out.images[plan].name);
  }
  out.mtl = writeMtl(old.maps, names);
  return out;
}

}  // namespace abflat::cli
