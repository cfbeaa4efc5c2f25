#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <string>

#include "core/foundations/base/request_worker.h"
#include "core/teaching/derivation/glossary.h"
#include "ui/document/selection.h"
#include "ui/models/matrix_model.h"
#include "ui/service/background_work.h"
#include "ui/workbench/results_view.h"
#include "ui/workbench/view_entry.h"

class QButtonGroup;
class QFrame;
class QLabel;
class QLayout;
class QStackedWidget;
class QToolButton;

namespace geargraph {

class MatrixView;

/// The matrices of the newest snapshot: a chip for each, the matrix, and an explanation of the hovered cell.
class MatricesPanel : public QWidget, public ResultsView, public BackgroundWork {
  Q_OBJECT

 public:
  explicit MatricesPanel(Selection* selection, QWidget* parent = nullptr);

  void requestStop() override { m_writer.requestStop(); }
  [[nodiscard]] bool hasStopped() const override { return m_writer.hasStopped(); }

  [[nodiscard]] QWidget& widget() override { return *this; }
  void setSnapshot(const SnapshotPtr& snapshot) override;
  [[nodiscard]] QString emptyText() const override;
  void setPreview(std::optional<PreviewSnapshot> preview);
  /// Shows a result that has a chip, in the last chosen form.
  void showResult(const NamedResult& result);

  /// Requests the export of what is shown.
  void wantExport();

  [[nodiscard]] MatrixModel& model() { return *m_model; }
  [[nodiscard]] MatrixView& view() { return *m_view; }

 signals:
  void exportWanted(const geargraph::ResultTablePtr& table);
  void copied();
  void rejected(const QString& why);  ///< copying failed: why, as a sentence

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeBar();
  void addChip(QLayout* layout, const NamedResult& result);
  void nameChip(int id, bool isChosen);
  QToolButton* makeCopyButton();
  void copy(std::function<std::string()> write);
  QToolButton* makeFormButton();
  void chooseForm(EntryForm form);
  QFrame* makeCard();
  void explain(const QModelIndex& index);
  /// Gives the card the least width at which its text is not cut off, as long as the matrix keeps most of the
  /// room.
  void fitCard();
  void renew();
  void updateForm();
  [[nodiscard]] QString whyEmpty() const;
  [[nodiscard]] QString whyNoTable() const;

  MatrixModel* m_model;
  MatrixView* m_view;
  QButtonGroup* m_chips = nullptr;            ///< a button's id is the place in m_results
  std::vector<const NamedResult*> m_results;  ///< those that have a chip
  QToolButton* m_form = nullptr;
  QToolButton* m_copy = nullptr;
  QToolButton* m_export = nullptr;
  QStackedWidget* m_pages = nullptr;
  QLabel* m_empty = nullptr;
  QFrame* m_card = nullptr;
  QLabel* m_cardTitle = nullptr;
  QLabel* m_cardText = nullptr;
  RequestWorker<std::function<std::string()>> m_writer;  ///< last: uses the members above
};

[[nodiscard]] ViewEntry matricesView();

}  // namespace geargraph
