#include "ui/view3d/picture_pace.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr int kStillAfter = 180;  // ms
constexpr int kMapAfter = 150;    // ms; less, so that the picture at rest has a map of its own
constexpr int kExpensiveMapAfter = 600;
constexpr int kOneAfterTheOther = 500;  // ms: scenes that follow as soon as this are steps of a drag
constexpr int kPatience = 2;            // steps of a drag that a hand may hesitate

}  // namespace

PicturePace::PicturePace(const Viewer* viewer, const LabelLayer* labels, QObject* parent)
    : QObject(parent), m_labels(labels) {
  m_whenStill.setSingleShot(true);
  connect(&m_whenStill, &QTimer::timeout, this, [this] {
    m_isStill = true;
    if (m_isSoftware || m_mapIsOld) emit rested();
  });
  connect(viewer, &Viewer::sceneChanged, this, [this] {
    const qint64 step = m_sinceScene.isValid() ? m_sinceScene.elapsed() : kOneAfterTheOther;
    onMoving(step < kOneAfterTheOther ? kPatience * static_cast<int>(step) : 0);
    m_sinceScene.start();
  });
  connect(viewer, &Viewer::moving, this, [this] { onMoving(0); });
}

// Where steps are slow, a fine picture between two of them would only make the next one slower.
void PicturePace::onMoving(int stillAfter) {
  m_isStill = false;
  m_whenStill.start(std::max(stillAfter, kStillAfter));
}

void PicturePace::shown() {
  if (!m_isStill) m_whenStill.start(std::max(kStillAfter, m_whenStill.remainingTime()));
}

bool PicturePace::takeMap() {
  if (!m_labels->isShown(LabelKind::link)) return false;
  const int enough = isDraft() ? kExpensiveMapAfter : kMapAfter;
  if (!m_labels->areNew() && m_sinceMap.isValid() && m_sinceMap.elapsed() < enough) {
    m_mapIsOld = true;
    m_whenStill.start(kStillAfter);
    return false;
  }
  m_mapIsOld = false;
  m_sinceMap.start();
  return true;
}

}  // namespace geargraph

#include "moc_picture_pace.cpp"
