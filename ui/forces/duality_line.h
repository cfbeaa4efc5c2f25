#pragma once

#include <QLabel>

#include "ui/document/selection.h"
#include "ui/service/turns.h"
#include "ui/workbench/forces_service.h"

namespace geargraph {

/// The row of P for the speeds of a mesh and the column of P for the torque in a joint, with their common
/// entry framed. It follows the hovered joint and mesh, else the selected ones. The framed entry can be
/// clicked.
class DualityLine : public QLabel {
  Q_OBJECT

 public:
  explicit DualityLine(Selection* selection, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);
  /// Sets the row and column of the matrix cell under the mouse; both empty: none. Elements other than joints
  /// and meshes are ignored.
  void pointAt(const ElementId& row, const ElementId& column);

  /// That of the text, laid out once. A QLabel lays its tables out six times to know as much.
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  /// Emitted when there is something to show, or no longer.
  void filled(bool isFilled);
  /// Another entry is shown, by hovering, selection or a click; both empty: none.
  void entryChanged(const geargraph::ElementId& mesh, const geargraph::ElementId& joint);
  /// The framed entry was clicked.
  void entryWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void renew();
  void updateText(const QString& html);
  [[nodiscard]] std::set<ElementId> pointedAt() const;
  void tell(const ElementId& mesh, const ElementId& joint);

  Selection* m_selection;
  ForcesPtr m_forces;
  mutable QSize m_textSize;                              ///< empty: not known yet
  CoalescedTask m_styleTurn{this, [this] { renew(); }};  ///< for other colours or another font
  std::set<ElementId> m_cell;                            ///< that of a matrix, under the mouse
  ElementId m_mesh, m_joint;                             ///< of the entry that is framed here
  std::set<ElementId> m_entry{ElementId()};  ///< last emitted; initially a value that no entry has
};

}  // namespace geargraph
