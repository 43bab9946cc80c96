#include "images/image.h"

#include <new>

#include "images/codecs.h"

namespace abflat::images {
namespace {

using namespace std::string_view_literals;

bool startsWith(std::string_view bytes, std::string_view mark) {
  return bytes.substr(0, mark.size()) == mark;
}

/// What a reader of the format that the bytes begin with makes of them.
template <class T>
Result<T> readBy(std::string_view bytes, Result<T> (*png)(std::string_view),
                 Result<T> (*jpeg)(std::string_view), Result<T> (*webp)(std::string_view)) {
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return png(bytes);
  if (startsWith(bytes, "\xff\xd8\xff"sv)) return jpeg(bytes);
  if (startsWith(bytes, "RIFF"sv) && bytes.substr(8, 4) == "WEBP"sv) return webp(bytes);
  if (startsWith(bytes, "\xabKTX 20"sv))
    return damaged(
        "is a KTX2 texture, which cannot be read. Convert it to PNG, such as with 'ktx extract'");
  if (bytes.empty()) return damaged("is empty");
  return damaged("is neither a PNG, a JPEG nor a WebP image. Convert it to PNG");
}

/// Runs a reader, and puts the name of the image in front of what is wrong.
template <class Read>
auto named(const std::string& name, const Read& read) -> decltype(read()) {
  try {
    auto out = read();
    if (out.ok()) return out;
    return Status{out.status().code, name + " " + out.status().message};
  } catch (const std::bad_alloc&) {
    return Status{StatusCode::OutOfMemory,
                  name + ": there is not enough memory for this image. Make it smaller"};
  }
}

}  // namespace

Status damaged(const std::string& what) { return {StatusCode::ParseError, what}; }

Status cannotWrite(const std::string& what) { return {StatusCode::CannotWrite, what}; }

Result<Size> checkedSize(std::uint64_t width, std::uint64_t height) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) return damaged("has " + size);
  if (width > kMostSide || height > kMostSide || width * height > kMostPixels)
    return damaged("has " + size + ", and at most 16384 x 16384 are read. Make it smaller");
  return Size{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

Image blank(Size size, int channels, int bits) {
  Image out{size.width, size.height, channels, bits, {}};
  out.pixels.resize(size.pixels() * static_cast<std::size_t>(channels * bits / 8));
  return out;
}

Result<Size> imageSize(std::string_view bytes, const std::string& name) {
  return named(name, [&] { return readBy(bytes, sizeOfPng, sizeOfJpeg, sizeOfWebp); });
}

Result<Image> readImage(std::string_view bytes, const std::string& name) {
  return named(name, [&] { return readBy(bytes, readPng, readJpeg, readWebp); });
}

const char* mimeTypeOf(ImageFormat format) {
  switch (format) {
    case ImageFormat::Png:
      return "image/png";
    case ImageFormat::Jpeg:
      return "image/jpeg";
    case ImageFormat::Webp:
      return "image/webp";
  }
  return "";
}

const char* endingOf(ImageFormat format) {
  switch (format) {
    case ImageFormat::Png:
      return ".png";
    case ImageFormat::Jpeg:
      return ".jpg";
    case ImageFormat::Webp:
      return ".webp";
  }
  return "";
}

Result<std::string> writeImage(const Image& image, ImageFormat format, int quality) {
  try {
    switch (format) {
      case ImageFormat::Png:
        return writePng(image);
      case ImageFormat::Jpeg:
        return writeJpeg(image, quality);
      case ImageFormat::Webp:
        return writeWebp(image, quality);
    }
  } catch (const std::bad_alloc&) {
    return Status{StatusCode::OutOfMemory,
                  "there is not enough memory to write an image. Use a lower resolution"};
  }
  return cannotWrite("there is no such format of images");
}

}  // namespace abflat::images
