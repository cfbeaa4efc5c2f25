#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace geargraph {

class HitsModel;
class ShownHits;

/// Which gearboxes of the list are shown: a chip for each condition, which a click lets go of, and a button
/// that adds others.
class FilterBar final : public QWidget {
  Q_OBJECT

 public:
  FilterBar(HitsModel* hits, ShownHits* shown, QWidget* parent = nullptr);

  /// Opens the menu of conditions.
  void openMenu();

 private:
  void renew();
  void fillMenu();
  QToolButton* addChip(const QString& name, const QString& text, int hidden);

  HitsModel* m_hits;
  ShownHits* m_shown;
  QHBoxLayout* m_chips;
  QToolButton* m_add;
  QMenu* m_menu;
  QLabel* m_count;
};

}  // namespace geargraph
