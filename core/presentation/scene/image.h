#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace geargraph {

/// An image: rows from the top, four bytes per pixel (red, green, blue, alpha; not premultiplied).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  [[nodiscard]] std::array<std::uint8_t, 4> at(int x, int y) const {
    const std::size_t first =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgba[first], rgba[first + 1], rgba[first + 2], rgba[first + 3]};
  }
};

/// The bytes of a PNG file. Empty if libpng fails (out of memory), the image is empty or `stop` was requested
/// meanwhile.
[[nodiscard]] std::vector<std::uint8_t> pngBytes(const Image& image, const std::stop_token& stop = {});

}  // namespace geargraph
