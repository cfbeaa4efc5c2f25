#pragma once

#include <QDialog>

#include "ui/learning/work_check_service.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QTableWidget;

namespace geargraph {
class Selection;
}  // namespace geargraph

namespace geargraph {

/// Compares the user's matrices and equations (typed, pasted or read from a file) with the derived ones. The
/// verdict follows the text and the document; if the text cannot be read, the last verdict stays and the
/// place of the error is shown. Selecting an item in the lists selects it in all views.
class WorkCheckDialog : public QDialog {
  Q_OBJECT

 public:
  explicit WorkCheckDialog(Selection* selection, QWidget* parent = nullptr);

  /// Sets the mechanism that the text is compared with.
  void setMechanism(const MechanismPtr& mechanism);
  void openFile(const QString& path);
  /// Fills in the rows of Eq. (45) as printed under the labels of Eq. (25): two rows are exchanged.
  void showExample();

  [[nodiscard]] QPlainTextEdit& text() { return *m_text; }
  [[nodiscard]] bool isUpToDate() const { return m_service->isComplete(); }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void askForFile();
  void request();
  void showVerdict(const WorkCheckAnswer& answer);
  void showFault(const Diagnostic& fault);
  void showMatrix(const MatrixVerdict& verdict);
  void showEquations(const std::vector<EquationVerdict>& verdicts);
  void paintEntries();
  void addDifference(const WorkDifference& difference);
  void setVerdict(const QString& text);
  void markLine(int line);
  void select(const std::vector<ElementId>& elements);
  void clear();

  Selection* m_selection;
  WorkCheckService* m_service;
  MechanismPtr m_mechanism;
  WorkCheckAnswerPtr m_shown;  ///< the last answer with a verdict
  QPlainTextEdit* m_text;
  QComboBox* m_kind;
  QLabel* m_verdict;
  QLabel* m_notes;
  QTableWidget* m_yours;
  QTableWidget* m_derived;
  QListWidget* m_differences;
};

}  // namespace geargraph
