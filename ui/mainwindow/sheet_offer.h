#pragma once

#include <QFrame>
#include <vector>

class QToolButton;

namespace geargraph {

/// What an empty sheet offers: to draw, or to insert a gear set, with pictures. In the middle of a drawing;
/// hidden where that is too small for it.
class SheetOffer : public QFrame {
  Q_OBJECT

 public:
  explicit SheetOffer(QWidget* sheet);

  /// Shows or hides the offer.
  void setWanted(bool wanted);

 signals:
  void drawWanted();
  /// A set of this kind (InsertableSet::id) is to be inserted; empty: of any.
  void setWantedOf(const QString& kind);
  void examplesWanted();
  void designWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QToolButton* addCard(const QString& text, const QString& tip, const char* name);
  void paintCards();
  void fitSheet();

  std::vector<QToolButton*> m_cards;  ///< drawing first, then the kinds of sets, then all sets
  QToolButton* m_more = nullptr;
  bool m_isWanted = false;
};

}  // namespace geargraph
