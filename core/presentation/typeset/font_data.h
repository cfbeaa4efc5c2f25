#pragma once

#include <span>

namespace geargraph {

/// The files of the faces in resources/fonts, in the order of FontFace.
[[nodiscard]] std::span<const std::span<const unsigned char>> fontFiles();

}  // namespace geargraph
