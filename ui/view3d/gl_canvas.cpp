#include "ui/view3d/gl_canvas.h"

#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include "core/presentation/gl_renderer/gl_renderer.h"
#include "ui/view3d/overlay.h"
#include "ui/view3d/overlay_layer.h"

namespace geargraph {
GlCanvas::GlCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent)
    : QOpenGLWidget(parent), m_viewer(viewer), m_labels(labels), m_pace(viewer, labels, this) {
  QSurfaceFormat wanted = format();
  wanted.setVersion(3, 3);
  wanted.setProfile(QSurfaceFormat::CoreProfile);
  setFormat(wanted);
  setMouseTracking(true);
  installEventFilter(viewer);
  connect(&m_pace, &PicturePace::rested, this, qOverload<>(&GlCanvas::update));
  connect(viewer, &Viewer::sceneChanged, this, [this] { m_sceneIsNew = true; });
  connect(viewer, &Viewer::viewChanged, this, qOverload<>(&GlCanvas::update));
  connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
    if (m_picture.isValid()) m_viewer->setPictureCost(static_cast<double>(m_picture.nsecsElapsed()) / 1e6);
    m_picture.invalidate();
  });
  viewer->setPick([this](const Frame& frame, double x, double y, Viewer::PickFor,
                         const Viewer::Answer& answer) { answer(pick(frame, x, y)); });
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
  m_pace.setSoftware(m_renderer->isSoftware());
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
  const Viewport& viewport = m_viewer->viewport();
  const double ratio = m_viewer->pixelRatio();
  const Frame frame = m_viewer->frame(m_pace.isDraft());
  std::optional<VisibilityBuffer> seen;
  if (m_pace.takeMap()) {
    const Viewport cells = labelCells(viewport, ratio);
    seen = m_renderer->seen(m_viewer->frame(), cells.width, cells.height);
  }
  m_renderer->draw(frame, defaultFramebufferObject());
  m_pace.shown();
  if (m_viewer->stage() == nullptr) return;
  // Not on the widget: while it is being grabbed, that paints somewhere else.
  QOpenGLPaintDevice device(viewport.width, viewport.height);
  device.setDevicePixelRatio(ratio);
  QPainter painter(&device);
  painter.setFont(font());
  const LabelGround ground{*m_viewer->stage(), frame.poses, frame.visibility,        frame.camera,
                           viewport,           ratio,       seen ? &*seen : nullptr, m_labels->above(),
                           m_labels->below()};
  paintOverlay(painter, ground, *m_labels, m_viewer->options().scaleBar, m_dark, m_viewer->shownForces());
  paintLayer(painter, ground, *m_viewer, m_dark);
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

}  // namespace geargraph

#include "moc_gl_canvas.cpp"
