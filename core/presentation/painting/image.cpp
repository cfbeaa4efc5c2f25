#include "core/presentation/painting/image.h"

#include <png.h>

namespace geargraph::inline painting {

std::vector<std::uint8_t> pngBytes(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGBA;
  header.flags = PNG_IMAGE_FLAG_FAST;  // a third of the time, and with flat faces the same size
  if (image.rgba.empty()) return {};
  // Asking for the size would compress everything once more.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr)) return {};
  bytes.resize(size);
  return bytes;
}

}  // namespace geargraph::inline painting
