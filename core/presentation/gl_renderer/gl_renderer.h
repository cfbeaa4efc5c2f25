#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/presentation/scene/renderer.h"

namespace geargraph {

/// Returns an OpenGL function by name: eglGetProcAddress, QOpenGLContext::getProcAddress.
using GetProcAddress = std::function<void*(const char*)>;

/// A renderer for the current OpenGL context, 3.3 core or newer. Fails with `graphics`, naming what the
/// driver lacks.
[[nodiscard]] Expected<std::unique_ptr<Renderer>> makeGlRenderer(const GetProcAddress& getProcAddress);

/// Does this GL_RENDERER name a software rasterizer?
[[nodiscard]] bool isSoftwareRenderer(std::string_view name);

}  // namespace geargraph
