#include "ui/view3d/gl_canvas.h"

#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include "core/render/gl_renderer.h"
#include "ui/view3d/overlay.h"

namespace geargraph {
namespace {

constexpr int kStillAfter = 180;  // ms
constexpr int kMapAfter = 150;    // ms; less, so that the picture at rest has a map of its own
constexpr int kDearMapAfter = 600;
constexpr int kOneAfterTheOther = 500;  // ms: scenes that follow as soon as this are steps of a drag

}  // namespace

GlCanvas::GlCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent)
    : QOpenGLWidget(parent), m_viewer(viewer), m_labels(labels) {
  QSurfaceFormat wanted = format();
  wanted.setVersion(3, 3);
  wanted.setProfile(QSurfaceFormat::CoreProfile);
  setFormat(wanted);
  setMouseTracking(true);
  m_whenStill.setSingleShot(true);
  m_whenStill.setInterval(kStillAfter);
  connect(&m_whenStill, &QTimer::timeout, this, [this] {
    m_still = true;
    if (isSoftware() || m_mapIsOld) update();
  });
  connect(viewer, &Viewer::sceneChanged, this, [this] {
    m_sceneIsNew = true;
    if (m_sinceScene.isValid() && m_sinceScene.elapsed() < kOneAfterTheOther) onMoving();
    m_sinceScene.start();
  });
  connect(viewer, &Viewer::moving, this, &GlCanvas::onMoving);
  connect(viewer, &Viewer::viewChanged, this, qOverload<>(&GlCanvas::update));
  connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
    if (m_picture.isValid()) m_viewer->setPictureCost(static_cast<double>(m_picture.nsecsElapsed()) / 1e6);
    m_picture.invalidate();
  });
  viewer->setPick([this](const Frame& frame, double x, double y) { return pick(frame, x, y); });
}

GlCanvas::~GlCanvas() {
  m_viewer->setPick({});
  release();
}

QString GlCanvas::rendererName() const {
  return m_renderer == nullptr ? QString() : QString::fromStdString(m_renderer->name());
}

// The context may go while the widget stays: a dock that floats where contexts are not shared.
void GlCanvas::release() {
  if (m_renderer == nullptr) return;
  makeCurrent();
  m_renderer.reset();
  doneCurrent();
}

void GlCanvas::onMoving() {
  m_still = false;
  m_whenStill.start();
}

void GlCanvas::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::release, Qt::UniqueConnection);
  auto renderer = makeGlRenderer([this](const char* name) {
    return reinterpret_cast<void*>(context()->getProcAddress(name));
  });  // NOLINT
  if (!renderer) {
    emit failed(QString::fromStdString(renderer.error().front().message));
    return;
  }
  m_renderer = std::move(renderer).value();
  m_sceneIsNew = true;
  emit started();
}

void GlCanvas::resizeEvent(QResizeEvent* event) {
  const double ratio = devicePixelRatioF();
  m_viewer->setViewport({qMax(1, qRound(width() * ratio)), qMax(1, qRound(height() * ratio))}, ratio);
  QOpenGLWidget::resizeEvent(event);
}

void GlCanvas::paintGL() {
  if (m_renderer == nullptr) return;
  if (isSoftware()) m_picture.start();  // a graphics card keeps up
  if (m_sceneIsNew) m_renderer->setScene(m_viewer->stage() ? m_viewer->stage()->scene : Scene{});
  m_sceneIsNew = false;
  const std::optional<SeenMap> seen = seenNow();
  m_renderer->draw(m_viewer->frame(isSoftware() && !m_still), defaultFramebufferObject());
  if (m_viewer->stage() == nullptr) return;
  // Not on the widget: while it is being grabbed, that paints somewhere else.
  QOpenGLPaintDevice device(m_viewer->viewport().width, m_viewer->viewport().height);
  device.setDevicePixelRatio(m_viewer->pixelRatio());
  QPainter painter(&device);
  painter.setFont(font());
  paintOverlay(painter, *m_viewer, *m_labels, seen ? &*seen : nullptr, m_dark);
}

// While the picture moves, labels go with their parts; where they stand is looked at now and then only, and
// once more when it has come to rest.
std::optional<SeenMap> GlCanvas::seenNow() {
  if (!m_labels->isShown(LabelKind::link)) return std::nullopt;
  const int enough = isSoftware() && !m_still ? kDearMapAfter : kMapAfter;
  if (!m_labels->areNew() && m_sinceMap.isValid() && m_sinceMap.elapsed() < enough) {
    m_mapIsOld = true;
    m_whenStill.start();
    return std::nullopt;
  }
  m_mapIsOld = false;
  m_sinceMap.start();
  const Viewport cells = labelCells(m_viewer->viewport(), m_viewer->pixelRatio());
  return m_renderer->seen(m_viewer->frame(), cells.width, cells.height);
}

std::optional<Hit> GlCanvas::pick(const Frame& frame, double x, double y) {
  if (m_renderer == nullptr || m_sceneIsNew)
    return std::nullopt;  // nothing was painted yet that could be meant
  makeCurrent();
  const QPointF at = m_labels->meant(QPointF(x, y) / frame.pixelRatio) * frame.pixelRatio;
  const auto hit = m_renderer->pick(frame, at.x(), at.y());
  doneCurrent();
  return hit;
}

void GlCanvas::mousePressEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mousePress(*event));
}
void GlCanvas::mouseMoveEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mouseMove(*event));
}
void GlCanvas::mouseReleaseEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mouseRelease(*event));
}
void GlCanvas::wheelEvent(QWheelEvent* event) {
  event->setAccepted(m_viewer->wheel(*event));
}

bool GlCanvas::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture)
    return m_viewer->nativeGesture(*static_cast<QNativeGestureEvent*>(event));
  return QOpenGLWidget::event(event);
}

void GlCanvas::leaveEvent(QEvent* event) {
  m_viewer->leave();
  QOpenGLWidget::leaveEvent(event);
}

}  // namespace geargraph
