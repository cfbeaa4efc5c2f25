#pragma once

#include <QImage>
#include <optional>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// Larger mechanisms get no thumbnail, because nothing would be distinguishable.
constexpr int kMaxThumbnailLinks = 150;

/// The digraph of a mechanism as a thumbnail of this size in pixels, on a transparent background.
/// std::nullopt if the mechanism is too large. Thread-safe.
/// Cost: some milliseconds, and a layout if the document has no places.
[[nodiscard]] std::optional<QImage> digraphThumbnail(const Mechanism& mechanism, Theme theme, QSize pixels);

}  // namespace geargraph
