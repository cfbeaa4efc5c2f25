#pragma once

#include <QFrame>

class QToolButton;

namespace geargraph {

/// A small bar beside the point of a link that was clicked: hold the link or let go of it, lock it with
/// another one.
class PointOffers final : public QFrame {
  Q_OBJECT

 public:
  explicit PointOffers(QWidget* parent);

  /// Shows the bar below a disc that reaches from `low` to `high` (y), centred on `x`, inside the parent.
  /// `canHold`: false for links of the ground.
  void showAt(int x, int high, int low, bool canHold, bool isHeld);

  [[nodiscard]] QToolButton& hold() const { return *m_hold; }
  [[nodiscard]] QToolButton& lockWith() const { return *m_lock; }

 signals:
  void holdWanted();
  void lockWanted();

 private:
  QToolButton* m_hold;
  QToolButton* m_lock;
};

}  // namespace geargraph
