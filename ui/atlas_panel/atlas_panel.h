#pragma once

#include <QWidget>

#include "ui/atlas_panel/train_identification.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace geargraph {

class ChainCard;
class ChainGrid;
class ChainPreviewService;
class ComparisonService;
class ChainListModel;
class FilterChips;
class TrainChoicesService;

/// The atlas of geared kinematic chains: filters, the chains that they leave, and the chosen chain beside
/// what the document is. It identifies the document while it is in sight, and shows its chain until the user
/// chooses another one.
class AtlasPanel final : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  AtlasPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setAwake(bool awake) override;
  [[nodiscard]] bool isSettled() const override;

  [[nodiscard]] const ChainFilter& filter() const { return m_filter; }
  void setFilter(const ChainFilter& filter);
  /// Shows a chain, or the first of a rotation graph; filters that would hide it are let go of. False if the
  /// atlas has none such.
  bool showChain(const ChainNumber& number);
  /// Makes a document of the chosen chain; documentWanted() follows.
  void openChosen();

 signals:
  void settled();
  /// A document of a chain, to be shown in a window of its own.
  void documentWanted(const geargraph::MechanismPtr& mechanism);
  void rejected(const QString& why);

 private:
  [[nodiscard]] QWidget* makeFilters();
  [[nodiscard]] QWidget* makeMiddle();
  void connectTrainDetails();
  void request();
  void onTrain(const TrainAnswerPtr& train);
  void onChosen(const AtlasChain* chain);
  void onFilterChanged();
  void takeCatalogue(const std::shared_ptr<const ChainCatalogue>& catalogue);
  void followTrain();
  void renew();
  void updateEquations();
  void find();
  void showTrainsThatCannotTurn();
  void showInTrain(const std::set<ElementId>& elements);
  void emitSettledIfIdle();

  Document* m_document;
  Selection* m_selection;
  IdentificationService* m_identification;
  ChainDetailsService* m_details;
  ChainDocumentService* m_documents;
  ChainPreviewService* m_previews;
  TrainChoicesService* m_choices;
  ComparisonService* m_comparisons;
  std::shared_ptr<const ChainCatalogue> m_catalogue;  ///< null until the first answer
  ChainFilter m_filter;
  std::optional<ChainNumber> m_equations;  ///< that the box offers as a filter
  bool m_isAwake = false;
  bool m_followsTrain = true;  ///< the user has not chosen a chain
  bool m_isShowing = false;    ///< a chain is being chosen by the program

  ChainListModel* m_model;
  ChainGrid* m_grid;
  ChainCard* m_card;
  FilterChips* m_links = nullptr;
  FilterChips* m_dof = nullptr;
  FilterChips* m_axes = nullptr;
  QCheckBox* m_whole = nullptr;
  QCheckBox* m_sameEquations = nullptr;
  QVBoxLayout* m_filterLayout = nullptr;
  QLabel* m_count = nullptr;
  QLabel* m_definition = nullptr;
  QLineEdit* m_find = nullptr;
};

[[nodiscard]] ViewEntry atlasView();

}  // namespace geargraph
