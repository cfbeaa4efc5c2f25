#pragma once

#include <QTableWidget>

#include "ui/designer/hub_services.h"

namespace geargraph {

/// Why two sets in series have the ratios: a row for each ratio of the first, a column for each of the
/// second, their products with the gears that they are.
class HubProducts final : public QTableWidget {
  Q_OBJECT

 public:
  explicit HubProducts(QWidget* parent = nullptr);
  /// Hidden where the candidate does not have two sets.
  void setCandidate(const HubCandidate* candidate);
};

/// The candidates with their teeth: those that can be assembled, then the others, dimmed.
class HubTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit HubTable(QWidget* parent = nullptr);

  void setSearch(const HubSearchPtr& search);
  /// Null if none is chosen.
  [[nodiscard]] const HubCandidate* chosen() const;
  /// From 1.
  [[nodiscard]] int chosenNumber() const { return currentRow() + 1; }

 signals:
  void chosenChanged();
  /// Return, or a double click.
  void openWanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void addRow(const HubCandidate& candidate, bool isDimmed);

  HubSearchPtr m_search;
};

}  // namespace geargraph
