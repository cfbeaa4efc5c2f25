#pragma once

#include <QLabel>

#include "ui/selection/selection.h"
#include "ui/statics/forces_service.h"

namespace geargraph::inline forces {

/// The row of P that holds the speeds of a mesh beside the column that holds the torque in a joint, with the
/// entry that both use framed. It follows the joint and mesh that are pointed at, else those selected. The
/// framed entry can be clicked.
class TwinLine : public QLabel {
  Q_OBJECT

 public:
  explicit TwinLine(Selection* selection, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);
  /// The row and column of a matrix whose cell is under the mouse; both empty: none is. What is no joint or
  /// mesh leaves the choice to what else is pointed at.
  void pointAt(const ElementId& row, const ElementId& column);

 signals:
  /// There is something to show, or no longer.
  void filled(bool isFilled);
  /// Another entry is chosen, by what is pointed at or selected or by a click on it; both empty: none is.
  void entryChanged(const geargraph::ElementId& mesh, const geargraph::ElementId& joint);
  /// The framed entry was clicked.
  void entryWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void renew();
  [[nodiscard]] std::set<ElementId> pointedAt() const;
  void tell(const ElementId& mesh, const ElementId& joint);

  Selection* m_selection;
  ForcesPtr m_forces;
  std::set<ElementId> m_cell;  ///< that of a matrix, under the mouse
  ElementId m_mesh, m_joint;   ///< of the entry that is framed here
  std::set<ElementId> m_entry{
      ElementId()};  ///< that others were told; nobody is told of one that nobody chose
};

}  // namespace geargraph::inline forces
