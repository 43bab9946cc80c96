#pragma once

#include <string>
#include <string_view>

#include "images/image.h"

// The functions of each library. Messages of readers follow the name of the image.

namespace abflat::images {

Result<Size> sizeOfPng(std::string_view bytes);
Result<Size> sizeOfJpeg(std::string_view bytes);
Result<Size> sizeOfWebp(std::string_view bytes);

Result<Image> readPng(std::string_view bytes);
Result<Image> readJpeg(std::string_view bytes);
Result<Image> readWebp(std::string_view bytes);

Result<std::string> writePng(const Image& image);
Result<std::string> writeJpeg(const Image& image, int quality);
Result<std::string> writeWebp(const Image& image, int quality);

Status damaged(const std::string& what);
Status cannotWrite(const std::string& what);

/// The size of an image, unless it is too large to be read.
Result<Size> checkedSize(std::uint64_t width, std::uint64_t height);

/// An image with room for its pixels.
Image blank(Size size, int channels, int bits = 8);

}  // namespace abflat::images
