#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/presentation/painting/renderer.h"

namespace geargraph::inline painting {

/// Finds a function of OpenGL by name: eglGetProcAddress, QOpenGLContext::getProcAddress.
using GetProcAddress = std::function<void*(const char*)>;

/// A renderer on the OpenGL context that is current: 3.3 core or newer. `getProcAddress` finds its functions.
/// Fails with `graphics`, naming what the driver lacks.
[[nodiscard]] Expected<std::unique_ptr<Renderer>> makeGlRenderer(const GetProcAddress& getProcAddress);

/// Is it the processor that paints under this GL_RENDERER?
[[nodiscard]] bool isSoftwareRenderer(std::string_view name);

}  // namespace geargraph::inline painting
