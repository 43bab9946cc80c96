#include "images/image.h"

#include <png.h>
#include <turbojpeg.h>

#include <cmath>
#include <cstring>
#include <random>

#include "catch.h"

namespace abflat::images {
namespace {

/// A smooth picture, which JPEG and WebP keep well, with a transparent part.
Image smooth(std::uint32_t width, std::uint32_t height, int channels) {
  Image out{width, height, channels, 8, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (int d = 0; d < channels; ++d)
        out.pixels.push_back(static_cast<std::uint8_t>(128 + 100 * std::sin(0.07 * x + d) *
                                                                 std::cos(0.05 * y - 2 * d)));
  return out;
}

std::string written(const Image& image, ImageFormat format, int quality = 90) {
  const Result<std::string> out = writeImage(image, format, quality);
  REQUIRE(out.ok());
  return out.value();
}

int mostDifferent(const Image& a, const Image& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  int out = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    out = std::max(out, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  return out;
}

/// A PNG of any kind, with rows of random bytes, or of one byte.
std::string oddPng(int colour, int bits, int interlace, int value = -1, bool hasKey = false) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp writer, png_bytep bytes, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(writer))
            ->append(reinterpret_cast<char*>(bytes), size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, 13, 11, bits, colour, interlace, 0, 0);
  const png_color palette[2] = {{10, 20, 30}, {40, 50, 60}};
  const png_byte alpha[2] = {70, 255};
  if (colour == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(png, info, palette, 2);
    if (hasKey) png_set_tRNS(png, info, alpha, 2, nullptr);
  }
  png_write_info(png, info);
  std::mt19937 random(1);
  std::vector<std::vector<png_byte>> rows(11);
  std::vector<png_bytep> pointers;
  for (auto& row : rows) {
    row.resize(png_get_rowbytes(png, info));
    for (png_byte& byte : row) byte = static_cast<png_byte>(value < 0 ? random() : value);
    pointers.push_back(row.data());
  }
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

Image readBack(const std::string& bytes) {
  const Result<Image> image = readImage(bytes, "images[0]");
  INFO(image.status().message);
  REQUIRE(image.ok());
  return image.value();
}

std::string problemOf(const std::string& bytes) {
  const Result<Image> image = readImage(bytes, "images[0]");
  REQUIRE(!image.ok());
  REQUIRE(image.status().code == StatusCode::ParseError);
  return image.status().message;
}

}  // namespace

TEST_CASE("images come back as they were written") {
  for (const int channels : {1, 3, 4}) {
    const Image image = smooth(61, 43, channels);
    const Image png = readBack(written(image, ImageFormat::Png));
    CHECK(png.channels == channels);
    CHECK(mostDifferent(png, image) == 0);
    if (channels == 4) {
      CHECK(mostDifferent(readBack(written(image, ImageFormat::Webp, 100)), image) == 0);
      continue;
    }
    const Image jpeg = readBack(written(image, ImageFormat::Jpeg, 95));
    CHECK(jpeg.channels == channels);
    CHECK(mostDifferent(jpeg, image) < 8);
  }
  const Image image = smooth(61, 43, 3);
  CHECK(mostDifferent(readBack(written(image, ImageFormat::Webp, 100)), image) == 0);
  CHECK(mostDifferent(readBack(written(image, ImageFormat::Webp, 95)), image) < 40);
  const Image grey = readBack(written(smooth(61, 43, 1), ImageFormat::Webp, 100));
  CHECK(grey.channels == 3);
  CHECK(written(image, ImageFormat::Jpeg, 30).size() <
        written(image, ImageFormat::Jpeg, 95).size());
}

TEST_CASE("PNGs of every kind are read") {
  CHECK(readBack(oddPng(PNG_COLOR_TYPE_RGB, 16, 0)).bits == 16);
  const Image deep = readBack(oddPng(PNG_COLOR_TYPE_GRAY, 16, 0));
  const std::string bytes = oddPng(PNG_COLOR_TYPE_GRAY, 16, 0, 0x7f);
  std::uint16_t value;
  std::memcpy(&value, readBack(bytes).pixels.data(), 2);
  CHECK(value == 0x7f7f);
  CHECK(deep.channels == 1);
  const Image palette = readBack(oddPng(PNG_COLOR_TYPE_PALETTE, 1, 0, 0xff));
  CHECK((palette.channels == 3 && palette.bits == 8));
  CHECK((palette.pixels[0] == 40 && palette.pixels[1] == 50 && palette.pixels[2] == 60));
  const Image key = readBack(oddPng(PNG_COLOR_TYPE_PALETTE, 4, 0, 0, true));
  CHECK((key.channels == 4 && key.pixels[0] == 10 && key.pixels[3] == 70));
  const Image bit = readBack(oddPng(PNG_COLOR_TYPE_GRAY, 1, 0, 0xff));
  CHECK((bit.channels == 1 && bit.pixels[5] == 255));
  const Image two = readBack(oddPng(PNG_COLOR_TYPE_GRAY, 2, 0, 0x55));
  CHECK(two.pixels[5] == 85);
  for (const auto& [colour, bits] : {std::pair{PNG_COLOR_TYPE_RGB_ALPHA, 8},
                                     {PNG_COLOR_TYPE_GRAY_ALPHA, 16},
                                     {PNG_COLOR_TYPE_GRAY, 4}})
    CHECK(readBack(oddPng(colour, bits, PNG_INTERLACE_ADAM7)).pixels ==
          readBack(oddPng(colour, bits, PNG_INTERLACE_NONE)).pixels);
}

TEST_CASE("images that cannot be read are refused with a reason") {
  CHECK(problemOf("") == "images[0] is empty");
  CHECK(problemOf("GIF89a") ==
        "images[0] is neither a PNG, a JPEG nor a WebP image. Convert it to PNG");
  CHECK(problemOf(std::string("\xabKTX 20\xbb\r\n\x1a\n")) ==
        "images[0] is a KTX2 texture, which cannot be read. Convert it to PNG, such as with 'ktx "
        "extract'");
  const std::string png = written(smooth(40, 30, 3), ImageFormat::Png);
  CHECK(problemOf(png.substr(0, png.size() / 2)) ==
        "images[0] is a damaged PNG: it ends too early. Export it again");
  std::string huge = png;
  huge[16] = huge[17] = 0;
  huge[18] = static_cast<char>(0x90);  // 36904 wide
  const auto crc = [](const std::string& bytes) {
    unsigned long out = 0xffffffff;
    for (const char byte : bytes) {
      out ^= static_cast<unsigned char>(byte);
      for (int i = 0; i < 8; ++i) out = out & 1 ? out >> 1 ^ 0xedb88320 : out >> 1;
    }
    return out ^ 0xffffffff;
  };
  const unsigned long sum = crc(huge.substr(12, 17));
  for (int i = 0; i < 4; ++i) huge[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
  CHECK(problemOf(huge) ==
        "images[0] has 36904 x 30 pixels, and at most 16384 x 16384 are read. Make it smaller");

  const std::string jpeg = written(smooth(40, 30, 3), ImageFormat::Jpeg);
  CHECK(problemOf(jpeg.substr(0, jpeg.size() / 2)).find("images[0] is a damaged JPEG: ") == 0);
  const Image four = smooth(40, 30, 4);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const tjhandle handle = tjInitCompress();
  REQUIRE(tjCompress2(handle, four.pixels.data(), 40, 0, 30, TJPF_CMYK, &bytes, &size, TJSAMP_444,
                      90, 0) == 0);
  CHECK(problemOf(std::string(reinterpret_cast<char*>(bytes), size)) ==
        "images[0] is a JPEG for print, with CMYK colours. Save it with RGB colours");
  tjFree(bytes);
  tjDestroy(handle);

  const std::string webp = written(four, ImageFormat::Webp);
  CHECK(problemOf(webp.substr(0, webp.size() / 2)) ==
        "images[0] is a damaged WebP: it ends too early. Export it again");
  std::string animated("RIFF\x28\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\x07\0\0\x07\0\0", 30);
  animated += std::string("ANIM\x06\0\0\0\0\0\0\0\0\0", 14);
  CHECK(problemOf(animated) == "images[0] is an animated WebP. Save one of its pictures");
}

TEST_CASE("damaged images are read or refused, and nothing else happens") {
  std::mt19937 random(7);
  const std::string files[] = {written(smooth(40, 30, 4), ImageFormat::Png),
                               written(smooth(40, 30, 3), ImageFormat::Jpeg),
                               written(smooth(40, 30, 4), ImageFormat::Webp, 80),
                               written(smooth(40, 30, 4), ImageFormat::Webp, 100),
                               oddPng(PNG_COLOR_TYPE_PALETTE, 2, 1, 0x11, true)};
  for (int i = 0; i < 400; ++i) {
    std::string bytes = files[random() % 5];
    for (std::size_t n = 1 + random() % 4; n > 0; --n)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    const Result<Image> image = readImage(bytes, "images[0]");
    if (!image.ok()) CHECK(image.status().message.find("images[0] ") == 0);
    if (image.ok())
      CHECK(image.value().pixels.size() ==
            std::size_t{image.value().width} * image.value().height *
                static_cast<std::size_t>(image.value().channels * image.value().bits / 8));
  }
}

}  // namespace abflat::images
