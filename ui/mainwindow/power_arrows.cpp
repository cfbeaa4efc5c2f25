#include "ui/mainwindow/power_arrows.h"

#include <QAction>
#include <QPainter>

#include "core/presentation/mechanism_scene/power_overlay.h"
#include "ui/canvas/mark_painter.h"
#include "ui/mainwindow/power_view.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

/// The middle of the legend's first line is below the upper edge by this, px.
constexpr double kFirstLine = 14;

PaintOver paintingOf(const ScenePowerPtr& power) {
  return [power](QPainter& painter, const OverlayPlace& place) {
    const Pose base = basePose(place.ground.stage, place.view);
    const DisplayList list = powerOver(*power, place.ground, base, place.top + kFirstLine, place.highlighted);
    paintMarks(painter, list.marks, place.isDark ? Theme::dark : Theme::light, 1);
  };
}

}  // namespace

PowerArrows::PowerArrows(Workbench& workbench, View3D& view, PowerView& power, const QAction& isOn,
                         QObject* parent)
    : QObject(parent),
      m_workbench(workbench),
      m_view(view),
      m_power(power),
      m_isOn(isOn),
      m_layer(view.findChild<OverlayLayer*>()),
      m_service(new Arrows(&PowerArrows::find, this, {.same = [](const Request& before, const Request& now) {
        return before.forces == now.forces && before.stage == now.stage && before.observer == now.observer;
      }})) {
  m_service->onAnswer(this, [this](const ScenePowerPtr& found) { show(found); });
  m_workbench.forces().onAnswer(this, [this](const ForcesPtr&) { renew(); });
  connect(&view, &View3D::contentChanged, this, &PowerArrows::renew);
  connect(&power, &PowerView::shown, this, &PowerArrows::renew);  // another link sees it
  connect(&isOn, &QAction::toggled, this, &PowerArrows::renew);
  renew();
}

PowerArrows::~PowerArrows() = default;

void PowerArrows::find(const Request& request, const Arrows::Responder& respond) {
  const Forces& forces = *request.forces;
  PowerPicture picture = PowerView::pictureOf(forces, request.observer);
  if (respond.stop().stop_requested()) return;
  respond(
      std::make_shared<const ScenePower>(stagePower(std::move(picture), *forces.solved->mechanism,
                                                    forces.solved->kinematics->placement(), *request.stage)));
}

void PowerArrows::renew() {
  const ForcesPtr& forces = m_workbench.forces().answer();
  const bool isThere = m_isOn.isChecked() && m_view.stage() && m_power.unavailableReason().isEmpty();
  if (isThere) {
    m_service->request({forces, m_view.stage(), m_power.observer()});
    return;
  }
  m_service->cancel();
  if (m_shown) show(nullptr);
}

void PowerArrows::show(ScenePowerPtr power) {
  m_shown = std::move(power);
  m_layer->setPainting(m_shown && !m_shown->arrows.empty() ? paintingOf(m_shown) : PaintOver());
  emit changed();
}

}  // namespace geargraph

#include "moc_power_arrows.cpp"
