#pragma once

#include <QWidget>

#include "ui/designer/designer_services.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace geargraph::inline designer {

class LeverPreview;

/// The chosen gearbox: its levers, its shift table with wanted and exact ratios, what its elements join, and
/// the button that opens it as a document.
class HitCard final : public QWidget {
  Q_OBJECT

 public:
  explicit HitCard(QWidget* parent = nullptr);

  /// Shows numbers at once; levers and losses come by setDetail(). Null: nothing is chosen.
  void setHit(const GearboxWishPtr& wish, const GearboxPtr& gearbox, int number);
  /// Ignored unless it is of the gearbox that is shown.
  void setDetail(const HitDetailPtr& detail);
  /// Null until it has come.
  [[nodiscard]] const HitDetailPtr& detail() const { return m_detail; }

 signals:
  void openWanted();

 private:
  void fillTable(const Gearbox& gearbox);
  [[nodiscard]] QString wantedOf(std::size_t gear) const;

  GearboxWishPtr m_wish;
  GearboxPtr m_gearbox;
  HitDetailPtr m_detail;
  QLabel* m_title;
  LeverPreview* m_levers;
  QTableWidget* m_states;
  QLabel* m_words;
  QPushButton* m_open;
};

}  // namespace geargraph::inline designer
