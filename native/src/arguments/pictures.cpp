#include "arguments/pictures.h"

#include "abflat/draw.h"
#include "arguments/options.h"
#include "files/paths.h"

namespace abflat::cli {

CLI::Validator pictureName(const std::vector<std::string>& endings, const std::string& inWords) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        const std::string ending = endingOf(text);
        for (const std::string& known : endings)
          if (ending == known) return "";
        return "use a name that ends in " + inWords + ", not '" + text + "'";
      },
      "");
}

void addLayoutPicture(CLI::App& app, std::string& layout) {
  app.add_option(
         "--layout", layout,
         wrapped("picture of the atlas, .svg or .png: charts in colour, with all edges; a PNG "
                 "has one pixel per texel"))
      ->check(notEmpty())
      ->check(pictureName({".svg", ".png"}, ".svg or .png"))
      ->type_name("FILE");
}

void checkPicture(const char* option, const std::string& path, const AtlasSize& resolution) {
  if (endingOf(path) == ".png" && resolution.longer() > kMostPictureTexels)
    throw CLI::ValidationError(
        option, "a PNG has at most " + std::to_string(kMostPictureTexels) +
                    " pixels along a side. Lower --resolution, or write the layout as .svg");
}

}  // namespace abflat::cli
