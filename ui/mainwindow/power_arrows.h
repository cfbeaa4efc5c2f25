#pragma once

#include <QObject>

#include "core/presentation/mechanism_scene/train_power.h"
#include "ui/service/service.h"
#include "ui/workbench/workbench.h"

class QAction;

namespace geargraph {

class PowerView;
}
namespace geargraph {
class View3D;
class OverlayLayer;
}  // namespace geargraph

namespace geargraph {

/// Lays arrows along the path of the power over the 3D view, while the bands of the drawings are on, seen by
/// the same link. They are found on a thread of their own, and follow loads, motion and solids.
class PowerArrows : public QObject {
  Q_OBJECT

 public:
  /// `isOn`: the command that shows power.
  PowerArrows(Workbench& workbench, View3D& view, PowerView& power, const QAction& isOn,
              QObject* parent = nullptr);
  ~PowerArrows() override;

  [[nodiscard]] bool isSettled() const { return m_service->isComplete(); }
  /// What is shown; null: nothing is.
  [[nodiscard]] const ScenePowerPtr& shown() const { return m_shown; }

 signals:
  void changed();

 private:
  struct Request {
    ForcesPtr forces;
    MechanismScenePtr stage;
    LinkId observer;
  };
  using Arrows = Service<Request, ScenePowerPtr>;

  static void find(const Request& request, const Arrows::Responder& respond);
  void renew();
  void show(ScenePowerPtr power);

  Workbench& m_workbench;
  View3D& m_view;
  PowerView& m_power;
  const QAction& m_isOn;
  OverlayLayer* m_layer;
  Arrows* m_service;
  ScenePowerPtr m_shown;
};

}  // namespace geargraph
