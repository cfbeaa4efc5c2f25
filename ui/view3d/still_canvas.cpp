#include "ui/view3d/still_canvas.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>

#include "ui/view3d/overlay.h"

namespace geargraph {

StillCanvas::StillCanvas(Viewer* viewer, LabelLayer* labels, const QString& why, QWidget* parent)
    : QWidget(parent), m_viewer(viewer), m_labels(labels), m_sentence(tr("Still picture")) {
  setToolTip(tr("%1 The picture is painted beside the screen, so it moves in steps.").arg(why));
  setMouseTracking(true);
  auto host = EglHost::create();
  if (host) {
    m_host = std::move(host).value();
    viewer->setPick([this](const Frame& frame, double x, double y) -> std::optional<Hit> {
      if (m_sceneIsNew) return std::nullopt;
      const QPointF at = m_labels->meant(QPointF(x, y) / frame.pixelRatio) * frame.pixelRatio;
      return m_host->pick(frame, at.x(), at.y());
    });
  } else {
    m_sentence = QString::fromStdString(host.error().front().message);
  }
  connect(viewer, &Viewer::sceneChanged, this, [this] { m_sceneIsNew = true; });
  connect(viewer, &Viewer::viewChanged, this, [this] {
    m_imageIsOld = true;
    update();
  });
}

StillCanvas::~StillCanvas() {
  m_viewer->setPick({});
}

QString StillCanvas::rendererName() const {
  return m_host == nullptr ? QString() : QString::fromStdString(m_host->name());
}

void StillCanvas::resizeEvent(QResizeEvent* event) {
  const double ratio = devicePixelRatioF();
  m_viewer->setViewport({qMax(1, qRound(width() * ratio)), qMax(1, qRound(height() * ratio))}, ratio);
  m_imageIsOld = true;
  QWidget::resizeEvent(event);
}

void StillCanvas::paintPicture(QPainter& painter) {
  if (m_sceneIsNew) m_host->setScene(m_viewer->stage() ? m_viewer->stage()->scene : Scene{});
  std::optional<SeenMap> seen;
  if (m_sceneIsNew || m_imageIsOld) {
    QElapsedTimer cost;
    cost.start();
    const Image image = m_host->picture(m_viewer->frame());
    m_viewer->setPictureCost(static_cast<double>(cost.nsecsElapsed()) / 1e6);
    const Viewport cells = labelCells(m_viewer->viewport(), m_viewer->pixelRatio());
    if (m_labels->isShown(LabelKind::link)) seen = m_host->seen(m_viewer->frame(), cells.width, cells.height);
    m_image = QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
  }
  m_sceneIsNew = m_imageIsOld = false;
  painter.drawImage(rect(), m_image);
  paintOverlay(painter, *m_viewer, *m_labels, seen ? &*seen : nullptr, m_dark);
}

void StillCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (m_host != nullptr) paintPicture(painter);
  painter.setPen(m_dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80));
  const QRect inside = rect().adjusted(12, 10, -12, -10);
  const int where = m_host != nullptr ? Qt::AlignTop | Qt::AlignLeft : Qt::AlignCenter;
  painter.drawText(inside, where | Qt::TextWordWrap, m_sentence);
}

void StillCanvas::mousePressEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mousePress(*event));
}
void StillCanvas::mouseMoveEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mouseMove(*event));
}
void StillCanvas::mouseReleaseEvent(QMouseEvent* event) {
  event->setAccepted(m_viewer->mouseRelease(*event));
}
void StillCanvas::wheelEvent(QWheelEvent* event) {
  event->setAccepted(m_viewer->wheel(*event));
}

bool StillCanvas::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture)
    return m_viewer->nativeGesture(*static_cast<QNativeGestureEvent*>(event));
  return QWidget::event(event);
}

void StillCanvas::leaveEvent(QEvent* event) {
  m_viewer->leave();
  QWidget::leaveEvent(event);
}

}  // namespace geargraph
