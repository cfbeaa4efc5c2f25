#pragma once

#include <QLabel>

#include "ui/selection/selection.h"
#include "ui/statics/forces_service.h"

namespace geargraph::inline forces {

/// The row of P that holds the speeds of a mesh beside the column that holds the torque in a joint, with the
/// entry that both use framed. It follows the selected joint and mesh.
class TwinLine : public QLabel {
  Q_OBJECT

 public:
  explicit TwinLine(Selection* selection, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);

 signals:
  /// There is something to show, or no longer.
  void filled(bool isFilled);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void renew();

  Selection* m_selection;
  ForcesPtr m_forces;
};

}  // namespace geargraph::inline forces
