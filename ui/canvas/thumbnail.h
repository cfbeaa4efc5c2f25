#pragma once

#include <QImage>
#include <optional>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph::inline canvas {

/// Larger mechanisms get no picture: nothing could be told apart on it.
constexpr int kMostThumbnailLinks = 150;

/// The digraph of a mechanism as a small picture of this size in pixels, on a clear ground. Nothing where the
/// mechanism is too large. May be called from any thread.
/// Cost: some milliseconds; a layout where the document gives no places.
[[nodiscard]] std::optional<QImage> digraphThumbnail(const Mechanism& mechanism, Theme theme, QSize pixels);

}  // namespace geargraph::inline canvas
