#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/designer/designer_services.h"

class QLabel;
class QMenu;
class QPushButton;
class QTableWidget;
class QToolButton;

namespace geargraph {

class DrawingPreview;

/// A gearbox of the list with its number there.
struct NumberedHit {
  GearboxPtr gearbox;
  int number = 0;
};

/// One gearbox, or two beside each other: levers and schematic, what the elements join, the shift table with
/// wanted and found ratios, what they are compared by, and the buttons that open them as documents.
class HitCard final : public QWidget {
  Q_OBJECT

 public:
  explicit HitCard(QWidget* parent = nullptr);

  /// Shows numbers at once; drawings and losses come by setDetail(). At most two.
  void setHits(const GearboxWishPtr& wish, std::vector<NumberedHit> hits);
  /// Ignored unless it is of a gearbox that is shown.
  void setDetail(const HitDetailPtr& detail);
  [[nodiscard]] const std::vector<NumberedHit>& hits() const { return m_hits; }

 signals:
  void openWanted(const geargraph::GearboxPtr& gearbox);
  /// Another choice of elements of a gearbox that is shown, of the same speeds.
  void variantWanted(const geargraph::GearboxPtr& gearbox, const geargraph::GearboxPtr& variant);

 private:
  static constexpr std::size_t kMost = 2;

  [[nodiscard]] QWidget* makePictures();
  [[nodiscard]] QTableWidget* makeTable(const char* name);
  [[nodiscard]] const Gearbox& gearboxAt(std::size_t position) const;
  [[nodiscard]] QString wantedOf(std::size_t gear) const;
  void updateDrawings();
  void fillOneTable();
  void fillTwoTable();
  void fillMeasures();
  void updateWords();
  void fillVariants();

  GearboxWishPtr m_wish;
  std::vector<NumberedHit> m_hits;
  std::array<HitDetailPtr, kMost> m_details;  ///< null until they come
  bool m_showsSchematics = false;             ///< of two gearboxes; of one both drawings are shown
  std::array<QLabel*, kMost> m_titles;
  std::array<DrawingPreview*, kMost> m_drawings;
  std::array<QLabel*, kMost> m_elements;
  QWidget* m_kinds = nullptr;
  QTableWidget* m_states;
  QTableWidget* m_measures;
  QLabel* m_words;
  QToolButton* m_variants;
  QMenu* m_variantMenu;
  std::array<QPushButton*, kMost> m_open;
};

}  // namespace geargraph
