#include "ui/view3d/image_canvas.h"

#include <QBackingStore>
#include <QLinearGradient>
#include <QPaintEngine>
#include <QPainter>
#include <utility>

#include "ui/view3d/overlay.h"
#include "ui/view3d/overlay_layer.h"

namespace geargraph {
namespace {

constexpr double kFewerPixels = 0.7;  // of a side: half of all

void simplify(Frame& frame, double& scale, int level) {
  if (level >= 1) {
    frame.style.edges = false;
    frame.style.litByVertex = true;
  }
  if (level >= 2) scale = kFewerPixels;
}

QColor colorOf(const Rgb& rgb) {
  return QColor::fromRgbF(rgb.red, rgb.green, rgb.blue);
}

/// As the raster engine copies it to the screen without a look at its pixels. A picture with fewer pixels is
/// stretched to all of them.
QImage screenImage(const PaintedPicture& picture) {
  const Frame& frame = picture.order.frame->frame();
  const Image& pixels = picture.image;
  const QImage read(pixels.rgba.data(), pixels.width, pixels.height, 4 * pixels.width,
                    QImage::Format_RGBX8888);
  QImage image = read.convertToFormat(QImage::Format_RGB32);
  const QSize whole(frame.viewport.width, frame.viewport.height);
  if (picture.order.scale < 1) image = image.scaled(whole, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  image.setDevicePixelRatio(frame.pixelRatio);
  return image;
}

}  // namespace

ImageCanvas::ImageCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent)
    : QWidget(parent), m_viewer(viewer), m_labels(labels), m_pace(viewer, labels, this) {
  setMouseTracking(true);
  installEventFilter(viewer);
  setAttribute(Qt::WA_OpaquePaintEvent);
  auto thread = PictureThread::start([this](PaintedPicture picture) { deliver(std::move(picture)); });
  if (!thread) {
    m_problem = QString::fromStdString(thread.error().front().message);
    return;
  }
  m_thread = std::move(thread).value();
  m_pace.setSoftware(m_thread->isSoftware());
  connect(&m_pace, &PicturePace::rested, this, &ImageCanvas::orderSoon);
  connect(viewer, &Viewer::viewChanged, this, &ImageCanvas::orderSoon);
  viewer->setPick([this](const Frame& frame, double x, double y, Viewer::PickFor use, Viewer::Answer answer) {
    pick(frame, x, y, use, std::move(answer));
  });
}

ImageCanvas::~ImageCanvas() {
  m_viewer->setPick({});
}

void ImageCanvas::requestStop() {
  if (m_thread != nullptr) m_thread->requestStop();
}

QString ImageCanvas::rendererName() const {
  return m_thread == nullptr ? QString() : QString::fromStdString(m_thread->name());
}

bool ImageCanvas::isUpToDate() const {
  return m_thread == nullptr || !isVisible() ||
         (!m_willOrder && m_isPainted && m_shown.frame != nullptr && m_shown.frame == m_ordered);
}

void ImageCanvas::orderSoon() {
  if (m_willOrder || m_thread == nullptr) return;
  m_willOrder = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (m_willOrder && isVisible()) order(m_pace.isDraft());
      },
      Qt::QueuedConnection);
}

void ImageCanvas::order(bool draft) {
  m_willOrder = false;
  Frame frame = m_viewer->frame(draft);
  double scale = 1;
  if (draft) simplify(frame, scale, m_draftLevel.level());
  if (draft) m_isStep = m_ordered == nullptr || m_ordered->stage() != m_viewer->stage();
  m_ordered = std::make_shared<const FrameSnapshot>(m_viewer->stage(), frame);
  if (draft) m_draft = m_ordered;
  PictureOrder order{m_ordered, scale, {}};
  // A map that has been superseded once is not put off again.
  order.mapMayFollow = draft && !m_owesMap && !m_labels->areNew();
  m_owesMap = m_pace.takeMap() || m_owesMap;
  if (m_owesMap) order.cells = labelCells(m_viewer->viewport(), m_viewer->pixelRatio());
  m_thread->order(std::move(order));
}

// The first pictures of a movement would wait for the driver to compile what only draft frames need; it does
// when the first picture at rest is there, step by step: the ground, faces, lines, the rest. So small a
// picture costs nothing else.
void ImageCanvas::rehearse() {
  if (std::exchange(m_hasRehearsed, true) || m_viewer->stage() == nullptr) return;
  Frame frame = m_viewer->frame(true);
  std::vector<Visibility> visibility(frame.poses.size(), Visibility::hidden);
  frame.visibility = visibility;
  frame.viewport = {16, 16};
  frame.style.edges = frame.style.triad = false;
  std::vector<PictureOrder> orders;
  const auto add = [&] {
    orders.push_back({std::make_shared<const FrameSnapshot>(m_viewer->stage(), frame), 1, {}});
  };
  add();
  visibility.assign(visibility.size(), Visibility::solid);
  add();
  frame.style.litByVertex = true;
  add();
  frame.style.edges = true;
  add();
  frame.style.triad = true;
  add();
  orders.back().cells = frame.viewport;
  m_thread->rehearse(std::move(orders));
}

void ImageCanvas::deliver(PaintedPicture picture) {
  std::optional<Shown> shown;
  if (!picture.isMapAlone) shown = {picture.order.frame, screenImage(picture), picture.cost};
  const MechanismScenePtr& stage = picture.order.frame->stage();
  {
    const std::lock_guard lock(m_mutex);
    if (shown) m_delivered = std::move(shown);
    if (picture.seen && stage) m_deliveredMap = {*std::move(picture.seen), stage->scene.instances.size()};
  }
  QMetaObject::invokeMethod(this, &ImageCanvas::takeUp, Qt::QueuedConnection);
}

void ImageCanvas::takeUp() {
  std::optional<Shown> delivered;
  {
    const std::lock_guard lock(m_mutex);
    delivered = std::exchange(m_delivered, std::nullopt);
    if (m_deliveredMap) {
      m_map = std::exchange(m_deliveredMap, std::nullopt);
      m_owesMap = false;
    }
  }
  if (!delivered) return;
  m_viewer->setPictureCost(delivered->cost);
  if (delivered->frame == m_draft) {
    m_draftLevel.took(delivered->cost, m_isStep);
  } else {
    rehearse();
  }
  m_shown = std::move(*delivered);
  m_isPainted = false;
  update();
}

void ImageCanvas::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_willOrder = false;
  orderSoon();
}

void ImageCanvas::resizeEvent(QResizeEvent* event) {
  const double ratio = devicePixelRatioF();
  m_viewer->setViewport({qMax(1, qRound(width() * ratio)), qMax(1, qRound(height() * ratio))}, ratio);
  orderSoon();
  QWidget::resizeEvent(event);
}

// While a widget is being grabbed it paints somewhere else. QPainter::device() is the widget all the same.
bool ImageCanvas::isOnScreen(const QPainter& painter) const {
  QBackingStore* store = backingStore();
  return store != nullptr && painter.paintEngine()->paintDevice() == store->paintDevice();
}

void ImageCanvas::paintGround(QPainter& painter) const {
  const RenderStyle& style = m_viewer->view().style;
  QLinearGradient ground(0, 0, 0, height());
  ground.setColorAt(0, colorOf(style.groundTop));
  ground.setColorAt(1, colorOf(style.groundBottom));
  painter.fillRect(rect(), ground);
}

// After a change of size, until its picture is there, the last one stands where the train will be: the
// camera's angle is that of the height.
void ImageCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (m_thread != nullptr && !isOnScreen(painter)) {
    m_owesMap = m_labels->isShown(LabelKind::link);
    order(false);
    m_thread->finish();
    takeUp();
  }
  const QSizeF size = QSizeF(m_shown.image.size()) / m_shown.image.devicePixelRatio();
  if (size != QSizeF(this->size())) paintGround(painter);
  if (m_shown.image.isNull()) return paintWords(painter, isWaiting() ? m_waitingText : m_problem);
  if (!std::exchange(m_isPainted, true)) {
    m_pace.shown();
    addOverlay();
  }
  if (size != QSizeF(this->size())) {
    const double factor = height() / size.height();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.translate(0.5 * (width() - factor * size.width()), 0);
    painter.scale(factor, factor);
  }
  painter.drawImage(QPointF(), m_shown.image);
  painter.resetTransform();
  if (isWaiting()) paintWords(painter, m_waitingText);
}

// The first picture of a train may have to wait for the driver: an empty area would say that there is none.
bool ImageCanvas::isWaiting() const {
  const auto hasBodies = [](const MechanismScenePtr& stage) {
    return stage != nullptr && !stage->scene.instances.empty();
  };
  return m_thread != nullptr && hasBodies(m_viewer->stage()) &&
         (m_shown.frame == nullptr || !hasBodies(m_shown.frame->stage()));
}

void ImageCanvas::paintWords(QPainter& painter, const QString& text) const {
  painter.setPen(m_dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80));
  painter.drawText(rect().adjusted(30, 30, -30, -30), Qt::AlignCenter | Qt::TextWordWrap, text);
}

// Into the picture, once: what stands on it, buttons and a clock, has it painted again and again. A map holds
// for later pictures too, of a train with the same parts.
void ImageCanvas::addOverlay() {
  const FrameSnapshot& kept = *m_shown.frame;
  if (kept.stage() == nullptr) return;
  const Frame& frame = kept.frame();
  const std::optional<Map> map = std::exchange(m_map, std::nullopt);
  const bool fits = map && map->parts == kept.stage()->scene.instances.size();
  if (map && !fits) m_owesMap = true;
  const LabelGround ground{*kept.stage(),
                           frame.poses,
                           frame.visibility,
                           frame.camera,
                           frame.viewport,
                           frame.pixelRatio,
                           fits ? &map->seen : nullptr,
                           m_labels->above(),
                           m_labels->below()};
  QPainter painter(&m_shown.image);
  painter.setFont(font());
  paintOverlay(painter, ground, *m_labels, m_viewer->options().scaleBar, m_dark, m_viewer->shownForces());
  paintLayer(painter, ground, *m_viewer, m_dark);
}

void ImageCanvas::pick(const Frame& frame, double x, double y, Viewer::PickFor use, Viewer::Answer answer) {
  if (m_shown.frame == nullptr || m_shown.frame->stage() != m_viewer->stage())
    return answer(std::nullopt);  // nothing is seen yet that could be meant
  const QPointF at = m_labels->meant(QPointF(x, y) / frame.pixelRatio) * frame.pixelRatio;
  PictureQuestion question{std::make_shared<const FrameSnapshot>(m_viewer->stage(), frame),
                           at.x(),
                           at.y(),
                           use == Viewer::PickFor::hover,
                           {}};
  question.answer = [this, answer = std::move(answer)](const std::optional<Hit>& hit) {
    QMetaObject::invokeMethod(
        this, [answer, hit] { answer(hit); }, Qt::QueuedConnection);
  };
  m_thread->ask(std::move(question));
}

}  // namespace geargraph

#include "moc_image_canvas.cpp"
