#pragma once

#include <QSignalSpy>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "tests/core/support/mechanisms.h"
#include "ui/canvas/digraph_view.h"

namespace geargraph {

/// The places that the target drawing gives the robot's links.
inline NodePositions robotPositions() {
  const std::array<CanvasPoint, 8> places{
      {{130, 330}, {300, 330}, {470, 250}, {660, 160}, {130, 190}, {300, 140}, {470, 400}, {660, 340}}};
  NodePositions positions;
  for (std::size_t i = 0; i < places.size(); ++i) positions[LinkId(std::to_string(i))] = places[i];
  return positions;
}

inline Mechanism placedRobot() {
  Mechanism robot = test::robotTopology();
  robot.view.nodes = robotPositions();
  return robot;
}

/// A drawing with its document and selection, and a hand that moves the mouse in sheet coordinates.
template <class View>
struct DriverOf {
  Document document;
  Selection selection;
  View view{&document, &selection};

  explicit DriverOf(const std::optional<Mechanism>& mechanism = {}) {
    view.resize(900, 600);
    view.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&view));
    if (mechanism) document.replace(*mechanism, "test.geargraph");
    view.resetZoom();
    QCoreApplication::processEvents();
  }

  [[nodiscard]] const Mechanism& mechanism() const { return *document.mechanism(); }
  [[nodiscard]] LinkId link(int label) const { return mechanism().links[static_cast<std::size_t>(label)].id; }
  [[nodiscard]] CanvasPoint center(int label) const {
    for (const Outline& outline : view.displayList().outlines) {
      const auto* disc = std::get_if<Circle>(&outline.shape);
      if (disc != nullptr && outline.element == ElementId(link(label))) return disc->center;
    }
    return {};
  }
  /// The middle of an arrow.
  [[nodiscard]] CanvasPoint middle(const ElementId& arrow) const {
    for (const Outline& outline : view.displayList().outlines) {
      const auto* curve = std::get_if<Curve>(&outline.shape);
      if (curve != nullptr && outline.element == arrow) return curve->at(0.5);
    }
    return {};
  }
  [[nodiscard]] QPoint onScreen(CanvasPoint p) const { return view.mapFromScene(QPointF(p.x, p.y)); }

  void press(CanvasPoint at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(view.viewport(), button, keys, onScreen(at));
  }
  void move(CanvasPoint at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    moveOnScreen(onScreen(at), keys, button);
  }
  void moveOnScreen(QPoint at, Qt::KeyboardModifiers keys, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(view.viewport(), &event);
  }
  void release(CanvasPoint at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseRelease(view.viewport(), button, keys, onScreen(at));
  }
  void hover(CanvasPoint at) { move(at, {}, Qt::NoButton); }
  void click(CanvasPoint at, Qt::KeyboardModifiers keys = {}) {
    press(at, keys);
    release(at, keys);
  }
  void drag(CanvasPoint from, CanvasPoint to, Qt::KeyboardModifiers keys = {},
            Qt::MouseButton button = Qt::LeftButton) {
    // Screen points now: panning moves the sheet meanwhile.
    const QPoint end = onScreen(to);
    const QPoint half = (onScreen(from) + end) / 2;
    press(from, keys, button);
    moveOnScreen(half, keys, button);
    moveOnScreen(end, keys, button);
    QTest::mouseRelease(view.viewport(), button, keys, end);
  }
  void key(Qt::Key code, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(&view, code, keys); }

  [[nodiscard]] QString selected() const {
    QStringList names;
    for (const ElementId& element : selection.selected()) {
      names << QString::fromStdString(labelOf(mechanism(), element).value_or("?"));
    }
    std::sort(names.begin(), names.end(),
              [](const QString& a, const QString& b) { return a.toInt() < b.toInt(); });
    return names.join(" ");
  }
  [[nodiscard]] int steps() { return document.undoStack().index(); }
};

using ViewDriver = DriverOf<DigraphView>;

}  // namespace geargraph
