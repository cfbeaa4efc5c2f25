#pragma once

#include <memory>

#include "core/foundations/base/expected.h"
#include "core/presentation/scene/renderer.h"

namespace geargraph {

/// A renderer without any window or display: OpenGL on a surfaceless EGL context of its own, for pictures on
/// servers and in tests. To be used on the thread that made it; calls restore the thread's current context.
class EglHost {
 public:
  /// Fails with `graphics` if there is no EGL, no OpenGL 3.3 or no driver.
  [[nodiscard]] static Expected<std::unique_ptr<EglHost>> create();
  ~EglHost();
  EglHost(const EglHost&) = delete;
  EglHost& operator=(const EglHost&) = delete;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] bool isSoftware() const;
  void setScene(const Scene& scene);
  [[nodiscard]] Image picture(const Frame& frame);
  [[nodiscard]] std::optional<Hit> pick(const Frame& frame, double x, double y);
  [[nodiscard]] VisibilityBuffer seen(const Frame& frame, int columns, int rows);
  [[nodiscard]] int maximumSide() const;

 private:
  struct Context;
  explicit EglHost(std::unique_ptr<Context> context);
  std::unique_ptr<Context> m_context;
  std::unique_ptr<Renderer> m_renderer;
};

}  // namespace geargraph
