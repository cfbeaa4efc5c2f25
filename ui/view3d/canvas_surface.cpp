#include "ui/view3d/canvas_surface.h"

#include <QGuiApplication>
#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include "core/presentation/gl_renderer/gl_renderer.h"

namespace geargraph {
namespace {

/// Some platforms of Qt never give a QOpenGLWidget its context, and report no error.
CanvasSurface bestSurface() {
  const QString platform = QGuiApplication::platformName();
  if (platform == "offscreen" || platform == "minimal" || platform == "vnc" || platform == "linuxfb") {
    return {false, QObject::tr("Qt's platform \"%1\" has no windows with OpenGL.").arg(platform)};
  }
  QOpenGLContext context;
  QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
  wanted.setVersion(3, 3);
  wanted.setProfile(QSurfaceFormat::CoreProfile);
  context.setFormat(wanted);
  if (!context.create() || context.format().version() < qMakePair(3, 3))
    return {false, QObject::tr("This display offers no OpenGL 3.3.")};
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return {};
  const auto text = [&context](unsigned what) {
    const auto* bytes = reinterpret_cast<const char*>(context.functions()->glGetString(what));  // NOLINT
    return QString::fromUtf8(bytes);
  };
  const QString name = text(GL_RENDERER);
  const QString driver = QStringLiteral("%1, %2, OpenGL %3").arg(name, text(GL_VENDOR), text(GL_VERSION));
  context.doneCurrent();
  return {!isSoftwareRenderer(name.toStdString()), {}, driver};
}

}  // namespace

const CanvasSurface& canvasSurface() {
  static const CanvasSurface chosen = [] {
    const QByteArray setting = qgetenv("GEARGRAPH_3D");
    if (setting == "image") return CanvasSurface{false, {}};
    CanvasSurface best = bestSurface();
    if (setting == "window" && best.why.isEmpty()) best.isWindow = true;
    return best;
  }();
  return chosen;
}

}  // namespace geargraph
