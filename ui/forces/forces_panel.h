#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/forces/force_views.h"
#include "ui/workbench/forces_service.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class DualityLine;
class EfficiencyCard;
class EfficiencyPage;
class EfficiencyView;
class ForceTableModel;
class LinkedTable;
class LoadsList;
class QuestionBar;
class TotalsStrip;
class WhyPage;

/// Torques, forces and powers of the newest snapshot, one question at a time: what has to be provided, where
/// the power goes, what parts carry, and why. A question has one or several views, each a table or a picture
/// of the panel's height. Rows are linked with the selection in both directions. Documents without loads are
/// solved only while the panel is visible.
class ForcesPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  /// `service`: the window's, which follows the document
  ForcesPanel(Document* document, Selection* selection, ForcesService* service, QWidget* parent = nullptr);
  ~ForcesPanel() override;

  [[nodiscard]] QWidget& widget() override { return *this; }
  /// Sets the snapshot, whose states can be chosen.
  void setSnapshot(const SnapshotPtr& snapshot) override;
  void setAwake(bool awake) override;
  /// Shows a view, and with it its question.
  void showView(ForceView view);
  /// Shows the view of a question that was last in front.
  void ask(ForceQuestion question);
  /// Shows the forces of this state; -1: of the document's engagement.
  void showState(int state);

  [[nodiscard]] ForceView view() const { return m_view; }
  [[nodiscard]] bool isUpToDate() const;
  [[nodiscard]] const ForcesPtr& forces() const { return m_service->answer(); }
  [[nodiscard]] ForceTableModel& model() { return *m_model; }
  [[nodiscard]] LinkedTable& table() { return *m_table; }
  [[nodiscard]] EfficiencyPage& plots();
  [[nodiscard]] EfficiencyCard& efficiency();
  [[nodiscard]] DualityLine& dualityLine();
  [[nodiscard]] QuestionBar& questions() { return *m_questions; }
  /// The diagnostic under the table; empty if there is none.
  [[nodiscard]] QString remark() const;
  /// The text of the ExplanationLabel: the cutset of the one selected joint with its equation, or which gear
  /// of the one selected mesh drives; else empty.
  [[nodiscard]] QString explanation() const;
  [[nodiscard]] QString emptyText() const override;
  /// A number of the power balance, by its name: "fed", "forward".
  [[nodiscard]] QString total(const QString& name) const;

 signals:
  /// The shown table as CSV, with a name for its file.
  void exportWanted(const QString& name, const QString& csv);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeQuestions();
  QWidget* makeControls();
  void makeShare(QWidget* parent);
  void askService();
  void updateStates(const Mechanism& mechanism);
  void present(ForceView view);
  void chooseUsualView(const Mechanism& mechanism);
  [[nodiscard]] bool isPossible(ForceView view) const;
  void showControls();
  void showForces();
  void showPage();
  void showShare();
  void showRemark();
  [[nodiscard]] std::optional<ValueTable> shownTable() const;
  void wantExport();
  void copy();
  [[nodiscard]] QString whyEmpty() const;

  Document* m_document;
  Selection* m_selection;
  ForcesService* m_service;
  ForceTableModel* m_model;
  QuestionBar* m_questions;
  LoadsList* m_loads = nullptr;
  std::unique_ptr<TotalsStrip> m_totals;
  LinkedTable* m_table;
  QWidget* m_tablePage = nullptr;
  QStackedWidget* m_pages;
  EfficiencyView* m_efficiency;
  WhyPage* m_why = nullptr;
  QLabel* m_empty;
  QLabel* m_remark;
  QButtonGroup* m_chips = nullptr;  ///< of the views, by their number
  QComboBox* m_states = nullptr;
  QToolButton* m_share = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_export = nullptr;
  ForceView m_view = ForceView::needs;
  std::map<ForceQuestion, ForceView> m_lastViews;
  bool m_isViewChosen = false;  ///< of the first question, by showView()
  bool m_isAwake = false;
};

[[nodiscard]] ViewEntry forcesView();

}  // namespace geargraph
