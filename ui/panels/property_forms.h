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

namespace geargraph {

class NumberField;

/// A form with the properties of elements of one kind. Every change is an edit of all of them; all changes
/// until a field loses focus are one undo step.
class PropertyForm : public QWidget {
  Q_OBJECT

 public:
  /// Updates the fields from the document. @pre isAboutExisting()
  virtual void refresh() = 0;
  /// Are all elements of the form still in the document?
  [[nodiscard]] bool isAboutExisting() const;

 signals:
  /// A hyperlink in a text of the form was clicked, or hovered.
  void elementChosen(const geargraph::ElementId& element);
  void elementHovered(const std::optional<geargraph::ElementId>& element);

 protected:
  PropertyForm(Document* document, std::vector<ElementId> elements);

  [[nodiscard]] const Mechanism& mechanism() const { return *m_document->mechanism(); }
  [[nodiscard]] const PlacedMechanism& placed() const { return m_document->placed(); }
  /// The index of the document's elements, since a form may have all of them.
  [[nodiscard]] const ElementIndex& index() const { return m_document->elements(); }
  [[nodiscard]] const std::vector<ElementId>& elements() const { return m_elements; }
  [[nodiscard]] QString label(const ElementId& element) const;
  void setTitle(const QString& title);
  void addRow(const QString& name, Term term, QWidget* field);
  /// Shows or hides a row, under this name.
  void setRowShown(QWidget* field, bool shown, const QString& name);
  QLabel* addParts(const QString& name, Term term);
  /// Rich text with hyperlinks (addressOf()); empty: there are none.
  static void showParts(QLabel& parts, const QString& text);
  void addButtons(const std::vector<QAbstractButton*>& buttons, const QString& name = {});
  void addWide(QWidget* widget);
  void addNote(const QString& text);
  NumberField* makeNumber(const QString& objectName);
  /// A check box that pins the part of each element that `of` returns.
  using PinnedPart = std::function<ElementId(const ElementIndex&, const ElementId&)>;
  QCheckBox* makePin(const QString& text, const QString& tip, const PinnedPart& of);
  void showPin(QCheckBox& box, const PinnedPart& of) const;

  using Change = std::function<Expected<Mechanism>(Mechanism, const ElementId&)>;
  /// A change that needs the placement (fitting).
  using FittedChange = std::function<Expected<PlacedMechanism>(const PlacedMechanism&, const ElementId&)>;
  /// Applies a change to every element, as one edit of the current gesture. The reason of a rejection is
  /// shown below the fields until an edit is accepted.
  void apply(const QString& text, const Change& change);
  void applyFitted(const QString& text, const FittedChange& change);
  void applyAtOnce(const QString& text, const Reduce& reduce);
  void applyToEach(const QString& text, const LongEdit::Work& work);
  /// Shows below the fields why a text is invalid; empty: it is valid.
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

/// Fields for the three components of points or directions: each shows the common value, "several" if they
/// differ, or "auto" if there is none.
class TripleField : public QWidget {
  Q_OBJECT

 public:
  explicit TripleField(const QString& objectName);

  using Triples = std::vector<std::optional<NumberTriple>>;
  /// Makes the triples points in this unit of length.
  void setLengthUnit(const std::string& unit);
  /// Sets one triple per element.
  void setTriples(const Triples& triples);

 signals:
  /// Component `index` of each triple is to become this number; std::nullopt: the triples are to be removed.
  void edited(int index, const std::optional<geargraph::Number>& number);
  void editingStarted();
  void wrongChanged(const QString& why);

 private:
  std::array<NumberField*, 3> m_fields{};
};

/// A triple with one component changed; if there was no triple the other components are taken from
/// `otherwise`. std::nullopt without a number.
[[nodiscard]] std::optional<NumberTriple> withComponent(const std::optional<NumberTriple>& triple, int index,
                                                        const std::optional<Number>& number,
                                                        const NumberTriple& otherwise);

}  // namespace geargraph
