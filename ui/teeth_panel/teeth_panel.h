#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/document/document.h"
#include "ui/teeth_panel/choices_model.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QLabel;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class ChoicesTable;
class TeethWishForm;

/// Teeth for wanted ratios: what is wished at the left, the choices at the right. Every edit of the wish or
/// of the train searches anew. A row that is chosen is previewed; taking it is one undo step.
class TeethPanel : public QWidget, public ResultsView {
  Q_OBJECT

 public:
  explicit TeethPanel(Document* document, QWidget* parent = nullptr);

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setAwake(bool awake) override;
  [[nodiscard]] bool isSettled() const override;
  [[nodiscard]] QString emptyText() const override;

  [[nodiscard]] TeethWishForm& form() { return *m_form; }
  [[nodiscard]] ChoicesModel& choices() { return *m_model; }
  [[nodiscard]] ChoicesTable& table() { return *m_table; }
  /// What the badge says of the search, and the line of the conditions below it.
  [[nodiscard]] QString badge() const;
  [[nodiscard]] QString funnel() const;
  /// The keyboard to the first field of a wished ratio.
  void askForRatio();
  /// Takes the teeth of a row. Does nothing while the choices are those of an earlier wish or train.
  void take(int row);
  /// Writes what proves that all choices were tried. @pre mayCertify()
  void saveCertificate(const QString& path);
  [[nodiscard]] bool mayCertify() const;

 signals:
  void settled();
  /// Everything derived from the document is to show it after this edit.
  void previewWanted(const geargraph::Edit& edit);
  void previewEnded();
  /// The table as CSV, with a proposed file name.
  void exportWanted(const QString& name, const QString& csv);
  void rejected(const QString& why);

 private:
  QWidget* makeLeft();
  QWidget* makeRight();
  QWidget* makeSearchBar();
  QWidget* makeFoot();
  void onDocument();
  void onReplaced();
  void searchSoon();
  void search();
  void stopOrGoOn();
  void showRunning();
  void showResult();
  void showFound(const TeethAnswer& answer);
  void showMeant(const TeethResult& result);
  void offerNewSearch();
  void setBadge(const QString& text, bool isFine);
  void updateButtons();
  void onRow();
  void endPreview();
  void copy();
  void chooseCertificate();
  [[nodiscard]] Edit editOf(int row) const;
  [[nodiscard]] bool isCurrent() const;
  [[nodiscard]] bool hasMeshes() const { return !m_document->mechanism()->gearMeshes.empty(); }

  Document* m_document;
  TeethService* m_service;
  ChoicesModel* m_model;
  ChoicesTable* m_table;
  TeethWishForm* m_form;
  QLabel* m_badge = nullptr;
  QLabel* m_funnel = nullptr;
  QProgressBar* m_progress = nullptr;
  QToolButton* m_stop = nullptr;
  QToolButton* m_certificate = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_csv = nullptr;
  QToolButton* m_use = nullptr;
  QStackedWidget* m_pages = nullptr;  ///< the table, or a hint
  QLabel* m_hint = nullptr;
  QStackedWidget* m_whole = nullptr;  ///< the wish and its choices, or what is missing
  QLabel* m_empty = nullptr;
  QTimer m_pause;    ///< until what was typed is searched for
  QTimer m_silence;  ///< until a search that goes on is told of
  QTimer m_telling;
  bool m_isAwake = false;
  bool m_isFilling = false;
  bool m_isPreviewed = false;
};

[[nodiscard]] ViewEntry teethView();

}  // namespace geargraph
