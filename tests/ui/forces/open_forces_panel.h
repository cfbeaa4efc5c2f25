#pragma once

#include <QTest>
#include <memory>

#include "tests/core/support/gearboxes.h"
#include "ui/forces/forces_panel.h"
#include "ui/panels/number_field.h"

namespace geargraph {

/// Sun 5 at 100 rad/s with 10 N m, ring 6 held, carrier 7 out.
inline Mechanism loadedSet(int planets = 1) {
  Mechanism mechanism = test::planetary(24, 18, planets);
  mechanism.inputs = std::vector<Input>{{mechanism.turningJoints[0].id, Number(100), {}},
                                        {mechanism.turningJoints[1].id, Number(0), {}}};
  mechanism.balances =
      std::vector<HoldingTorque>{{mechanism.turningJoints[1].id}, {mechanism.turningJoints[2].id}};
  mechanism.loads = {{{}, JointTorque{mechanism.turningJoints[0].id, Number(10)}}};
  return mechanism;
}

/// The panel of forces with what it follows.
struct OpenForcesPanel {
  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<ForcesService> service;
  std::unique_ptr<ForcesPanel> panel;

  void show() {
    selection.clear();
    document = std::make_unique<Document>();
    service = std::make_unique<ForcesService>();
    panel = std::make_unique<ForcesPanel>(document.get(), &selection, service.get());
    panel->resize(900, 300);
    panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel.get()));
    panel->setAwake(true);
  }
  void close() {
    panel.reset();
    service.reset();
  }
  void open(Mechanism mechanism) {
    document->replace(std::move(mechanism), {});
    settle();
  }
  void settle() {
    const SnapshotPtr snapshot = analyze(document->mechanism(), document->revision());
    service->follow(snapshot);
    panel->setSnapshot(snapshot);
    QTRY_VERIFY(panel->isUpToDate());
  }
  NumberField& field(const char* name) { return *panel->findChild<NumberField*>(QLatin1String(name)); }
};

}  // namespace geargraph
