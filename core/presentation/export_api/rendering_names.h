#pragma once

#include <optional>
#include <string_view>

#include "core/presentation/mechanism_scene/scene_labels.h"
#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/render_style.h"
#include "core/presentation/scene3d/scene_lines.h"

namespace geargraph {

// Names for the options of 3D pictures, for the command line and Python.

/// "front", "back", "left", "right", "top", "bottom", "iso".
[[nodiscard]] std::optional<StandardView> standardViewNamed(std::string_view name);

/// "shaded", "lines" (hidden ones left out), "edges" (all of them).
[[nodiscard]] std::optional<Faces> facesNamed(std::string_view name);

/// "pitch-circles", "pitch-points", "axes", "instant-axes", "velocities"; false for another name.
bool showMark(MarkChoice& marks, std::string_view name);

/// "labels", "joint-labels", "axis-labels", "scale", "forces", "power"; false for another name.
bool showOverlay(OverlayChoice& overlay, std::string_view name);

}  // namespace geargraph
