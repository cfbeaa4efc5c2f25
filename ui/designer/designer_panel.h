#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <map>

#include "ui/designer/designer_services.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTimer;

namespace geargraph {

class FilterBar;
class HitCard;
class HitsTable;
class WishForm;

/// Searches for gearboxes with wanted ratios: the wish, what was found so far with filters, and the gearbox
/// chosen of it, or two that are compared. Knows nothing of the document. Its fields are made when it is
/// shown first.
class DesignerPanel final : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit DesignerPanel(QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  [[nodiscard]] bool isSettled() const override;

  /// From the beginning, if the wish has no fault. What was found for the former wish is dropped.
  void search();
  /// Stops without forgetting anything.
  void pause();
  /// Continues a search that was paused.
  void goOn();
  [[nodiscard]] bool isSearching() const { return m_phase == Phase::searching; }
  /// Is no part of the layouts left?
  [[nodiscard]] bool isDone() const { return m_phase == Phase::done; }
  /// Makes the fields, if that has not been done.
  void prepare();
  [[nodiscard]] WishForm* form() const { return m_form; }
  [[nodiscard]] HitsTable* hits() const { return m_hits; }
  [[nodiscard]] HitCard* card() const { return m_card; }
  /// Null until it has been worked out.
  [[nodiscard]] HitDetailPtr detailOf(const GearboxPtr& gearbox) const;
  /// Writes the wish as `geargraph-cli gearbox` reads it.
  void saveWish(const QString& path);

 signals:
  void settled();
  /// A gearbox should be opened as a document.
  void openWanted(const geargraph::MechanismPtr& document);
  void rejected(const QString& why);

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Phase { idle, searching, paused, done };

  [[nodiscard]] QWidget* makeLeft();
  [[nodiscard]] QWidget* makeMiddle();
  [[nodiscard]] QWidget* makeHead();
  void onProgress(const DesignProgress& progress);
  void takeKeysToList();
  void onFailed();
  void onDetail(const HitDetailPtr& detail);
  void showHits();
  void open(const GearboxPtr& gearbox);
  void addVariant(const GearboxPtr& gearbox, const GearboxPtr& variant);
  void chooseWishFile();
  void onWishEdited();
  void setPhase(Phase phase);
  void updateWords();
  [[nodiscard]] QString titleText() const;
  [[nodiscard]] QString sampledText() const;
  [[nodiscard]] QString sampledReason() const;
  [[nodiscard]] QString countText() const;
  [[nodiscard]] QString remainingText() const;
  [[nodiscard]] QString emptyListText() const;

  DesignService* m_service;
  HitService* m_detailService;
  GearboxWishPtr m_wish;  ///< searched for; null before the first search
  std::int64_t m_layouts = 0;
  std::int64_t m_total = 0;
  JudgeCounts m_judged;
  QElapsedTimer m_clock;              ///< since the search began or went on
  std::int64_t m_layoutsAtStart = 0;  ///< that were done then
  bool m_isProof = false;
  bool m_isEarlier = false;  ///< the fields have another wish than the list
  Phase m_phase = Phase::idle;
  std::map<GearboxPtr, HitDetailPtr> m_details;
  std::vector<GearboxPtr> m_asked;  ///< whose details are on their way
  GearboxPtr m_toOpen;              ///< to be opened as soon as its document is there

  WishForm* m_form = nullptr;
  HitsTable* m_hits = nullptr;
  HitCard* m_card = nullptr;
  FilterBar* m_filters = nullptr;
  QStackedWidget* m_pages = nullptr;
  QLabel* m_empty = nullptr;
  QLabel* m_title = nullptr;
  QLabel* m_count = nullptr;
  QLabel* m_sampled = nullptr;
  QLabel* m_earlier = nullptr;
  QProgressBar* m_bar = nullptr;
  QTimer* m_barSoon = nullptr;
  QPushButton* m_search = nullptr;
  QPushButton* m_pause = nullptr;
};

[[nodiscard]] ViewEntry designerView();

}  // namespace geargraph
