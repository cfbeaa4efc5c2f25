#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "ui/designer/hub_services.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace geargraph {

class HubCard;
class HubForm;
class HubProducts;
class HubTable;

/// Ratios to hardware: what a maker's sheet says of a hub gear, all tooth sets that explain it, and what to
/// count or measure to tell them apart. Knows nothing of the document. Its fields are made when it is shown
/// first.
class HubPanel final : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit HubPanel(QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  [[nodiscard]] bool isSettled() const override;

  void search();
  void prepare();
  [[nodiscard]] HubForm* form() const { return m_form; }
  [[nodiscard]] HubTable* table() const { return m_table; }
  /// What is left after the answers; null before the first search.
  [[nodiscard]] const HubSearchPtr& left() const { return m_left; }

 signals:
  void settled();
  /// A candidate should be opened as a document.
  void openWanted(const geargraph::MechanismPtr& document);

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QWidget* makeLeft();
  [[nodiscard]] QWidget* makeMiddle();
  void onChosen();
  void onDetail(const HubDetailPtr& detail);
  void open();
  void answer(const HubQuestion& question, const QString& text);
  void narrow();
  void updateWords();
  void updateChips();

  HubService* m_service;
  HubDetailService* m_details;
  HubSearchPtr m_search;
  HubSearchPtr m_left;
  std::vector<std::pair<HubQuestion, QString>> m_answers;  ///< that were given, in this order
  bool m_isEarlier = false;                                ///< the fields have another wish than the list
  bool m_isToOpen = false;                                 ///< as soon as the document is there

  HubForm* m_form = nullptr;
  HubProducts* m_products = nullptr;
  HubTable* m_table = nullptr;
  HubCard* m_card = nullptr;
  QStackedWidget* m_pages = nullptr;
  QLabel* m_empty = nullptr;
  QLabel* m_title = nullptr;
  QLabel* m_proof = nullptr;
  QLabel* m_earlier = nullptr;
  QHBoxLayout* m_chips = nullptr;
  QPushButton* m_find = nullptr;
};

[[nodiscard]] ViewEntry hardwareView();

}  // namespace geargraph
