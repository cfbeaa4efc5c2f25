#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/teaching/derivation/glossary.h"
#include "ui/document/document.h"
#include "ui/panels/long_edit.h"

class QAbstractButton;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace geargraph::inline panels {

class NumberField;

/// Fields about some elements of one kind. Every change is an edit of all of them; what is typed or spun
/// until the field is left is one undo step.
class PropertyForm : public QWidget {
  Q_OBJECT

 public:
  /// Shows the document as it is now. @pre isAboutExisting()
  virtual void refresh() = 0;
  /// Are all its elements still in the document?
  [[nodiscard]] bool isAboutExisting() const;

 signals:
  /// A link in a text of the form was clicked, or is under the mouse.
  void elementChosen(const geargraph::ElementId& element);
  void elementHovered(const std::optional<geargraph::ElementId>& element);

 protected:
  PropertyForm(Document* document, std::vector<ElementId> elements);

  [[nodiscard]] const Mechanism& mechanism() const { return *m_document->mechanism(); }
  [[nodiscard]] const PlacedMechanism& placed() const { return m_document->placed(); }
  /// Its elements by id: a form may be about all of a document.
  [[nodiscard]] const ElementIndex& index() const { return m_document->elements(); }
  [[nodiscard]] const std::vector<ElementId>& elements() const { return m_elements; }
  [[nodiscard]] QString label(const ElementId& element) const;
  void setTitle(const QString& title);
  void addRow(const QString& name, Term term, QWidget* field);
  void addButtons(const std::vector<QAbstractButton*>& buttons, const QString& name = {});
  void addWide(QWidget* widget);
  void addNote(const QString& text);
  NumberField* makeNumber(const QString& objectName);
  /// A box that pins, of each element of the form, what `of` says.
  using PinnedPart = std::function<ElementId(const ElementIndex&, const ElementId&)>;
  QCheckBox* makePin(const QString& text, const QString& tip, const PinnedPart& of);
  void showPin(QCheckBox& box, const PinnedPart& of) const;

  using Change = std::function<Expected<Mechanism>(Mechanism, const ElementId&)>;
  /// One that reads the placement (fitting).
  using FittedChange = std::function<Expected<PlacedMechanism>(const PlacedMechanism&, const ElementId&)>;
  /// Applies a change to every element, as one edit of the gesture under way. Why it was refused stands below
  /// the fields until something is accepted.
  void apply(const QString& text, const Change& change);
  void applyFitted(const QString& text, const FittedChange& change);
  void applyAtOnce(const QString& text, const Reduce& reduce);
  void applyToEach(const QString& text, const LongEdit::Work& work);
  /// What is wrong with what stands in a field, below the fields; empty: nothing.
  void showWrong(const QString& why);
  void newGesture() { m_gesture = m_document->newGesture(); }
  void endGesture() { m_gesture = 0; }

 private:
  Document* m_document;
  std::vector<ElementId> m_elements;
  QLabel* m_title;
  QFormLayout* m_rows;
  QLabel* m_wrong;
  quint64 m_gesture = 0;
};

/// The three components of points or directions: each shows what all of them share, "several", or "auto"
/// where there is none.
class TripleField : public QWidget {
  Q_OBJECT

 public:
  explicit TripleField(const QString& objectName);

  using Triples = std::vector<std::optional<NumberTriple>>;
  /// A point, in this unit of length.
  void setLengthUnit(const std::string& unit);
  /// One for each element.
  void setTriples(const Triples& triples);

 signals:
  /// Component `index` of each becomes this number; without one the triples go.
  void edited(int index, const std::optional<geargraph::Number>& number);
  void editingStarted();
  void wrongChanged(const QString& why);

 private:
  std::array<NumberField*, 3> m_fields{};
};

/// A triple with one component changed; the others are those of `otherwise` where there was none. Without a
/// number: none.
[[nodiscard]] std::optional<NumberTriple> withComponent(const std::optional<NumberTriple>& triple, int index,
                                                        const std::optional<Number>& number,
                                                        const NumberTriple& otherwise);

}  // namespace geargraph::inline panels
