#include "ui/view3d/canvas_host.h"

#include <QLayout>
#include <utility>

#include "ui/view3d/canvas_surface.h"
#include "ui/view3d/gl_canvas.h"
#include "ui/view3d/image_canvas.h"

namespace geargraph {

CanvasHost::CanvasHost(Viewer* viewer, LabelLayer* labels, QWidget* view)
    : QObject(view), m_viewer(viewer), m_labels(labels), m_view(view) {}

void CanvasHost::start(const QString& waiting) {
  m_waiting = waiting;
  const CanvasSurface& surface = canvasSurface();
  surface.isWindow ? useGl() : useImage(surface.why);
}

void CanvasHost::stop() {
  delete canvas();
  m_gl = nullptr;
  m_image = nullptr;
}

QWidget* CanvasHost::canvas() const {
  return m_gl != nullptr ? static_cast<QWidget*>(m_gl) : m_image;
}

void CanvasHost::setDark(bool dark) {
  m_isDark = dark;
  if (m_gl != nullptr) m_gl->setDark(dark);
  if (m_image != nullptr) m_image->setDark(dark);
}

QString CanvasHost::rendererName() const {
  return m_gl != nullptr ? m_gl->rendererName() : m_image->rendererName();
}

bool CanvasHost::isUpToDate() const {
  return m_image == nullptr || m_image->isUpToDate();
}

void CanvasHost::place(QWidget* canvas) {
  canvas->setObjectName("view3dCanvas");
  canvas->setFocusProxy(m_view);
  m_view->layout()->addWidget(canvas);
  canvas->lower();
}

void CanvasHost::useGl() {
  m_gl = new GlCanvas(m_viewer, m_labels, m_view);
  m_gl->setDark(m_isDark);
  place(m_gl);
  connect(m_gl, &GlCanvas::started, this, [this] { emit started(m_gl->isSoftware(), {}); });
  // Not at once: the canvas is in the middle of its own event.
  connect(
      m_gl, &GlCanvas::failed, this,
      [this](const QString& why) {
        m_gl->deleteLater();
        m_gl = nullptr;
        useImage(why);
      },
      Qt::QueuedConnection);
}

/// `why` there is no window of the graphics card; empty where there could be one.
void CanvasHost::useImage(const QString& why) {
  m_image = new ImageCanvas(m_viewer, m_labels, m_view);
  if (!m_image->problem().isEmpty() && why.isEmpty()) {
    delete std::exchange(m_image, nullptr);
    return useGl();
  }
  m_image->setDark(m_isDark);
  m_image->setWaitingText(m_waiting);
  place(m_image);
  m_image->show();
  emit started(m_image->isSoftware(), why);
}

}  // namespace geargraph

#include "moc_canvas_host.cpp"
