#include "core/presentation/gl_renderer/egl_host.h"

#define EGL_NO_X11  // its types are not needed, and the headers may be missing
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/presentation/gl_renderer/gl_renderer.h"

namespace geargraph {
namespace {

Diagnostic rejected(const std::string& why) {
  Diagnostic diagnostic;
  diagnostic.code = Code::graphics;
  diagnostic.message =
      translated("No 3D pictures: %1. On Debian, the package libgl1-mesa-dri brings what is missing.", {why});
  return diagnostic;
}

EGLDisplay surfacelessDisplay() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));  // NOLINT
  if (extensions != nullptr && getPlatformDisplay != nullptr &&
      std::strstr(extensions, "EGL_MESA_platform_surfaceless") != nullptr) {
    return getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  }
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

/// Contexts of a driver in software take turns on all threads, in the order in which they ask: Mesa 22.3
/// crashed while two windows painted at once. They would share the same processors anyway.
class RenderTicketLock {
 public:
  void take() {
    std::unique_lock lock(m_mutex);
    const std::uint64_t ours = m_asked++;
    m_changed.wait(lock, [&] { return m_served == ours; });
  }
  void give() {
    {
      const std::lock_guard lock(m_mutex);
      ++m_served;
    }
    m_changed.notify_all();
  }
  /// To the next thread that waits. @pre the driver does nothing for this thread
  void pass() {
    give();
    take();
  }

 private:
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::uint64_t m_asked = 0;
  std::uint64_t m_served = 0;
};

RenderTicketLock& turns() {
  static RenderTicketLock all;
  return all;
}

/// A turn as long as it lives, where there are any to take.
class Turn {
 public:
  explicit Turn(bool isTaken) : m_isTaken(isTaken) {
    if (m_isTaken) turns().take();
  }
  ~Turn() {
    if (m_isTaken) turns().give();
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  bool m_isTaken;
};

/// Makes a context current and, when it goes, what was current before.
class Current {
 public:
  Current(EGLDisplay display, EGLContext context)
      : m_ours(display),
        m_display(eglGetCurrentDisplay()),
        m_context(eglGetCurrentContext()),
        m_draw(eglGetCurrentSurface(EGL_DRAW)),
        m_read(eglGetCurrentSurface(EGL_READ)) {
    m_fine = eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  }
  ~Current() {
    if (m_context != EGL_NO_CONTEXT) {
      eglMakeCurrent(m_display, m_draw, m_read, m_context);
    } else {
      eglMakeCurrent(m_ours, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
  }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;
  [[nodiscard]] bool fine() const { return m_fine; }

 private:
  EGLDisplay m_ours;
  EGLDisplay m_display;
  EGLContext m_context;
  EGLSurface m_draw, m_read;
  bool m_fine = false;
};

}  // namespace

// The display is never terminated: it is one a process, and others may use it.
struct EglHost::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Context() = default;
  ~Context() {
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// What went wrong, or nothing.
  [[nodiscard]] std::string open() {
    display = surfacelessDisplay();
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor))
      return translated("EGL finds no device");
    if (!eglBindAPI(EGL_OPENGL_API)) return translated("EGL has no desktop OpenGL");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &found) || found == 0)
      return translated("EGL has no OpenGL configuration");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return context == EGL_NO_CONTEXT ? translated("there is no OpenGL 3.3 core") : "";
  }
};

EglHost::EglHost(std::unique_ptr<Context> context) : m_context(std::move(context)) {}

Expected<std::unique_ptr<EglHost>> EglHost::create() {
  const Turn turn(true);
  auto context = std::make_unique<Context>();
  const std::string problem = context->open();
  if (!problem.empty()) return rejected(problem);
  const Current current(context->display, context->context);
  if (!current.fine()) return rejected(translated("the driver cannot paint without a window"));
  auto renderer = makeGlRenderer(
      [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); });  // NOLINT
  if (!renderer) return renderer.error();
  std::unique_ptr<EglHost> host(new EglHost(std::move(context)));
  host->m_renderer = std::move(renderer).value();
  return host;
}

EglHost::~EglHost() {
  const Turn turn(isSoftware());
  {
    const Current current(m_context->display, m_context->context);
    m_renderer.reset();
  }
  m_context.reset();
}

const std::string& EglHost::name() const {
  return m_renderer->name();
}
bool EglHost::isSoftware() const {
  return m_renderer->isSoftware();
}
int EglHost::maximumSide() const {
  return m_renderer->maximumSide();
}

void EglHost::setScene(const Scene& scene) {
  const Turn turn(isSoftware());
  const Current current(m_context->display, m_context->context);
  m_renderer->setScene(scene);
}

Image EglHost::picture(const Frame& frame) {
  const Turn turn(isSoftware());
  const Current current(m_context->display, m_context->context);
  Frame inTurns = frame;
  if (isSoftware()) inTurns.pause = [] { turns().pass(); };
  return m_renderer->picture(inTurns);
}

std::optional<Hit> EglHost::pick(const Frame& frame, double x, double y) {
  const Turn turn(isSoftware());
  const Current current(m_context->display, m_context->context);
  return m_renderer->pick(frame, x, y);
}

VisibilityBuffer EglHost::seen(const Frame& frame, int columns, int rows) {
  const Turn turn(isSoftware());
  const Current current(m_context->display, m_context->context);
  return m_renderer->seen(frame, columns, rows);
}

}  // namespace geargraph
