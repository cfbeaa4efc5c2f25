#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/grading/grade.h"
#include "ui/document/selection.h"

class QButtonGroup;
class QComboBox;
class QGridLayout;
class QLineEdit;

namespace geargraph {

/// The fields of a question: cells of a table, lines, lists of options. A set of elements can be typed, or
/// selected in any view. The field with the focus highlights the elements that it is about.
class AnswerForm : public QWidget {
  Q_OBJECT

 public:
  explicit AnswerForm(Selection* selection, QWidget* parent = nullptr);

  /// `mechanism`: that of the elements in the options of sets.
  void setQuestion(const Question& question, const MechanismPtr& mechanism);
  void clear();
  /// One text per field.
  [[nodiscard]] std::vector<std::string> answer() const;
  void setAnswer(const std::vector<std::string>& answer);
  /// Marks the wrong fields and, in a table, the right ones.
  void mark(const Verdict& verdict);
  void unmark();
  /// Focuses the first field that is marked wrong, else the first field.
  void focusFirst();
  void setReadOnly(bool readOnly);
  /// Is a field filled in by selecting elements?
  [[nodiscard]] bool picks() const { return m_picked != nullptr; }

 signals:
  void edited();
  void submitted();  ///< by Return in a field

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Field {
    QLineEdit* line = nullptr;
    QComboBox* list = nullptr;
    QButtonGroup* choices = nullptr;
  };

  void addTable(QGridLayout* grid);
  void addList(QGridLayout* grid);
  [[nodiscard]] QLineEdit* makeLine(const AnswerField& field, bool isCell);
  [[nodiscard]] QWidget* makeField(const AnswerField& field, Field& made);
  [[nodiscard]] QWidget* makeChoices(const AnswerField& field, Field& made);
  [[nodiscard]] QWidget* widgetOf(std::size_t field) const;
  void setMark(std::size_t field, const char* mark);
  void takeSelection();

  Selection* m_selection;
  Question m_question;
  MechanismPtr m_mechanism;
  std::vector<Field> m_fields;
  QWidget* m_page = nullptr;                         ///< container of the fields of one question
  QLineEdit* m_picked = nullptr;                     ///< the field of the set that follows the selection
  std::vector<std::optional<ElementId>> m_pickable;  ///< by option of this set
};

}  // namespace geargraph
