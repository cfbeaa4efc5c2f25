#include "ui/view3d/axis_hold.h"

#include <algorithm>

#include "ui/view3d/axis_handle.h"

namespace geargraph {

AxisHold::AxisHold(Viewer* viewer, Selection* selection, QWidget* view)
    : QObject(view), m_viewer(viewer), m_selection(selection), m_view(view), m_handle(new AxisHandle(view)) {
  connect(selection, &Selection::selectionChanged, this, &AxisHold::renew);
  connect(viewer, &Viewer::viewChanged, this, &AxisHold::renew);
  connect(m_handle, &AxisHandle::grabbed, this, &AxisHold::grab);
  connect(m_handle, &AxisHandle::pulled, this,
          [this](const QPointF& way, bool isFree) { emit pulled(pullBy(way, isFree)); });
  connect(m_handle, &AxisHandle::dropped, this, &AxisHold::dropped);
  connect(m_handle, &AxisHandle::putBack, this, &AxisHold::putBack);
  connect(m_handle, &AxisHandle::nudged, this, [this](const QPointF& way) {
    grab();
    emit nudged(pullBy(way, true));
  });
}

/// What a pixel is stays as it was then, though the picture may change meanwhile.
void AxisHold::grab() {
  emit grabbed();
  const SceneLabel* const label = heldLabel();
  const std::optional<ScreenPoint> at = place();
  if (label == nullptr || !at) return;
  const Camera& camera = m_viewer->camera();
  m_held = label->element;
  m_perPixel = camera.millimetresPerPixel(m_viewer->viewport()) * m_viewer->pixelRatio() * at->depth /
               camera.distance();
  m_right = camera.right();
  m_up = camera.up();
}

AxisPull AxisHold::pullBy(const QPointF& way, bool isFree) const {
  const Eigen::Vector3d moved = m_perPixel * (way.x() * m_right - way.y() * m_up);
  return {m_held, {moved.x(), moved.y(), moved.z()}, isFree};
}

const SceneLabel* AxisHold::heldLabel() const {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() != 1 || m_viewer->stage() == nullptr) return nullptr;
  const ElementId element = *selected.begin();
  if (element.kind != ElementKind::axis && element.kind != ElementKind::turningJoint) return nullptr;
  const std::vector<SceneLabel>& labels = m_viewer->stage()->labels;
  const auto found = std::find_if(labels.begin(), labels.end(),
                                  [&](const SceneLabel& label) { return label.element == element; });
  return found == labels.end() ? nullptr : &*found;
}

std::optional<ScreenPoint> AxisHold::place() const {
  const SceneLabel* const label = heldLabel();
  if (label == nullptr || label->instance >= m_viewer->poses().size()) return std::nullopt;
  const ScreenPoint at =
      m_viewer->camera().project(m_viewer->poses()[label->instance] * label->place, m_viewer->viewport());
  return at.depth > 0 ? std::optional(at) : std::nullopt;
}

void AxisHold::renew() {
  const std::optional<ScreenPoint> at = place();
  if (!at) {
    if (!m_handle->isDragged()) m_handle->hide();  // a stage that comes in between may lack the axis
    return;
  }
  const SceneLabel& label = *heldLabel();
  const QString text = QString::fromStdString(label.text);
  m_handle->setName(label.kind == LabelKind::axis ? tr("axis %1").arg(text)
                                                  : tr("the axis of joint %1").arg(text));
  constexpr double kMargin = 18, kBelow = 56;  // within reach and above the playback, wherever the axis ends
  const double ratio = m_viewer->pixelRatio();
  m_handle->showAt({std::clamp(at->x / ratio, kMargin, std::max(kMargin, m_view->width() - kMargin)),
                    std::clamp(at->y / ratio, kMargin, std::max(kMargin, m_view->height() - kBelow))});
}

bool AxisHold::takeFocus() {
  renew();
  if (m_handle->isHidden()) return false;
  m_handle->setFocus(Qt::ShortcutFocusReason);
  return true;
}

}  // namespace geargraph

#include "moc_axis_hold.cpp"
