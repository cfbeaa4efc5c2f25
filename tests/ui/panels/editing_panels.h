#pragma once

#include <QLineEdit>
#include <QTest>

#include "tests/core/support/mechanisms.h"
#include "ui/panels/inputs_panel.h"
#include "ui/panels/number_field.h"
#include "ui/panels/properties_panel.h"

namespace geargraph {

/// The panels by which the paper's robot is edited, side by side, and hands that type into them.
struct EditingPanels {
  std::unique_ptr<Document> document;
  Selection selection;
  std::unique_ptr<PropertiesPanel> properties;
  std::unique_ptr<InputsPanel> inputs;

  NumberField* field(QWidget& panel, const char* name) {
    for (auto* found : panel.findChildren<NumberField*>(QLatin1String(name))) {
      if (found->isVisible()) return found;
    }
    return nullptr;
  }
  NumberField* numberOf(const char* name) { return field(*properties, name); }
  const GearMesh& mesh(const char* id) { return *document->mechanism()->find(MeshId(id)); }
  static void focus(QWidget* widget) {
    widget->window()->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(widget->window()));
    widget->setFocus();
  }
  static QLineEdit* lineOf(NumberField* field) { return field->findChild<QLineEdit*>(); }
  template <class Field>
  static void type(Field* into, const QString& text) {
    focus(into);
    into->selectAll();
    QTest::keyClicks(into, text);
    QTest::keyClick(into, Qt::Key_Return);
  }

  void open() {
    selection.clear();
    document = std::make_unique<Document>();
    Mechanism robot = test::robotTopology();
    robot.inputs = std::vector<Input>{{JointId("8"), Number(1), {}}, {JointId("9"), Number(0), {}}};
    document->replace(std::move(robot), {});
    properties = std::make_unique<PropertiesPanel>(document.get(), &selection);
    inputs = std::make_unique<InputsPanel>(document.get(), &selection);
    for (QWidget* panel : {static_cast<QWidget*>(properties.get()), static_cast<QWidget*>(inputs.get())}) {
      panel->resize(500, 300);
      panel->show();
      QVERIFY(QTest::qWaitForWindowExposed(panel));
    }
  }
  void close() {
    properties.reset();
    inputs.reset();
    document.reset();
  }
};

}  // namespace geargraph
