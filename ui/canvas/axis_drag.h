#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/mechanism/placement/placed_mechanism.h"
#include "ui/document/document.h"

class QWidget;

namespace geargraph {

/// Drags an axis, in any view, as one undo step. Every edit starts from the document before the drag, so that
/// a rejected edit leaves the last valid one. After the drop, a menu offers tooth counts that bring the axis
/// there with the module as it was.
class AxisDrag final : public QObject {
  Q_OBJECT

 public:
  /// `view`: the parent of the menu.
  AxisDrag(Document* document, QWidget* view);

  [[nodiscard]] bool isUnderWay() const { return m_drag.has_value(); }
  /// Continues a drag of the same axis that has not ended.
  void begin(AxisId axis);
  /// The edit of the document before the drag. @pre isUnderWay()
  using Move = std::function<Expected<PlacedMechanism>(const PlacedMechanism& before)>;
  void move(const Move& move);
  /// Moves the axis by a displacement in the base frame, as withAxisDragged().
  void moveBy(const Vector3& way, bool snapped);
  /// The same without snapping, as a separate undo step without an offer.
  void nudge(AxisId axis, const Vector3& way);
  void drop();
  void putBack();
  void end();  ///< without offering tooth counts

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
  /// "Axis c is 48 mm from axis a, module 2.3 mm"; empty if the axis has no neighbour in mesh.
  [[nodiscard]] QString reachText() const;

  Document* m_document;
  QWidget* m_view;
  std::optional<Drag> m_drag;
};

}  // namespace geargraph
