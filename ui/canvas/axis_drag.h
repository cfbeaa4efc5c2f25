#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/mechanism/placement/placed_mechanism.h"
#include "ui/document/document.h"

class QWidget;

namespace geargraph::inline canvas {

/// An axis that goes along with a hand in any view, as one undo step: every edit begins where the drag did,
/// so that one that is rejected leaves the last valid one. When it is dropped, tooth counts are offered that
/// bring it there with the module as it was.
class AxisDrag final : public QObject {
  Q_OBJECT

 public:
  /// Menus open over `view`.
  AxisDrag(Document* document, QWidget* view);

  [[nodiscard]] bool isUnderWay() const { return m_drag.has_value(); }
  /// Goes on with the drag that is under way, if that is of the same axis.
  void begin(AxisId axis);
  /// What becomes of the document as it was when the drag began. @pre isUnderWay()
  using Move = std::function<Expected<PlacedMechanism>(const PlacedMechanism& before)>;
  void move(const Move& move);
  /// By this way in the base frame, as withAxisDragged() takes it.
  void moveBy(const Vector3& way, bool snapped);
  /// The same at once, as a step of its own.
  void nudge(AxisId axis, const Vector3& way);
  void drop();
  void putBack();
  void end();  ///< without an offer

 signals:
  void hintChanged(const QString& hint);
  void ended();

 private:
  struct Drag {
    quint64 gesture = 0;
    PlacedMechanism before;
    AxisId axis;
  };

  bool apply(const Reduce& reduce);
  /// "Axis c is 48 mm from axis a, module 2.3 mm"; empty where the axis has no such neighbour.
  [[nodiscard]] QString reachText() const;

  Document* m_document;
  QWidget* m_view;
  std::optional<Drag> m_drag;
};

}  // namespace geargraph::inline canvas
