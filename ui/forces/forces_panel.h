#pragma once

#include <QWidget>
#include <optional>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/workbench/forces_service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class EfficiencyCard;
class EfficiencyPage;
class ExplanationLabel;
class ForceTableModel;
class LinkedTable;
class LoadsList;
class DualityLine;

/// Torques, forces and powers of the newest snapshot: the loads, a table of the torques that hold them, and
/// the power balance. Rows are linked with the selection in both directions. Documents without loads are
/// solved only while the panel is visible.
class ForcesPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  /// `service`: the window's, which follows the document
  ForcesPanel(Document* document, Selection* selection, ForcesService* service, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  /// Sets the snapshot, whose states can be chosen.
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  void showTable(ForceTableKind kind);
  /// Shows the forces of this state; -1: of the document's engagement.
  void showState(int state);

  [[nodiscard]] bool isUpToDate() const;
  [[nodiscard]] const ForcesPtr& forces() const { return m_service->answer(); }
  [[nodiscard]] ForceTableModel& model() { return *m_model; }
  [[nodiscard]] LinkedTable& table() { return *m_table; }
  /// Shows the plots of the efficiency instead of a table.
  void showPlots();
  [[nodiscard]] EfficiencyPage& plots() { return *m_plots; }
  [[nodiscard]] EfficiencyCard& efficiency() { return *m_card; }
  [[nodiscard]] DualityLine& dualityLine() { return *m_duality; }
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// The diagnostic under the table; empty if there is none.
  [[nodiscard]] QString remark() const;
  /// The text of the ExplanationLabel: the cutset of the one selected joint with its equation, or which gear
  /// of the one selected mesh drives; else empty.
  [[nodiscard]] QString explanation() const;
  [[nodiscard]] QString emptyText() const override;
  /// A value below the table, by its name: "fed", "forward".
  [[nodiscard]] QString total(const QString& name) const;

 signals:
  /// The shown table as CSV, with a name for its file.
  void exportWanted(const QString& name, const QString& csv);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeBar();
  QWidget* makeMiddle();
  QWidget* makeTotals();
  QWidget* makeShareButton();
  void addColumn(QHBoxLayout* layout, const QString& text, const QString& meaning, QWidget* value);
  void addTotal(QHBoxLayout* layout, const char* name, const QString& text, const QString& meaning);
  void ask();
  void updateStates(const Mechanism& mechanism);
  void showForces();
  void showTotals();
  void showRemark();
  /// `exact`: the number as a fraction, for the tooltip.
  void setTotal(const char* name, const QString& text, const QString& exact = {});
  void fitSide();
  void placeCard();
  [[nodiscard]] bool showsPlots() const;
  void showPage();
  [[nodiscard]] std::optional<ValueTable> shownTable() const;
  void wantExport();
  void copy();
  void showDuality();
  [[nodiscard]] QString whyEmpty() const;

  Document* m_document;
  ForcesService* m_service;
  ForceTableModel* m_model;
  LoadsList* m_loads;
  QWidget* m_side = nullptr;  ///< the loads, with the card below them if it has no column of its own
  QScrollArea* m_sideView = nullptr;
  LinkedTable* m_table;
  QStackedWidget* m_pages;
  EfficiencyPage* m_plots;
  EfficiencyCard* m_card;
  QScrollArea* m_cardView = nullptr;
  QLabel* m_empty;
  QLabel* m_remark;
  DualityLine* m_duality = nullptr;
  QWidget* m_dualityStrip = nullptr;
  bool m_isDualityFilled = false;  ///< is there an entry to show?
  ExplanationLabel* m_explanation;
  QButtonGroup* m_chips = nullptr;
  QComboBox* m_states = nullptr;
  QToolButton* m_share = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_export = nullptr;
  QLabel* m_verdict = nullptr;
};

[[nodiscard]] ViewEntry forcesView();

}  // namespace geargraph
