#pragma once

#include <QWidget>
#include <array>
#include <set>
#include <vector>

#include "core/derivation/glossary.h"
#include "ui/document/document.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace geargraph {

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

 protected:
  PropertyForm(Document* document, std::vector<ElementId> elements);

  [[nodiscard]] const Mechanism& mechanism() const { return *m_document->mechanism(); }
  [[nodiscard]] const std::vector<ElementId>& elements() const { return m_elements; }
  [[nodiscard]] QString label(const ElementId& element) const;
  void setTitle(const QString& title);
  void addRow(const QString& name, Term term, QWidget* field);
  void addButtons(const std::vector<QPushButton*>& buttons);
  void addNote(const QString& text);
  NumberField* makeNumber(const QString& objectName);

  using Change = std::function<Expected<Mechanism>(Mechanism, const ElementId&)>;
  /// Applies a change to every element, as one edit of the gesture under way.
  void apply(const QString& text, const Change& change);
  void newGesture() { m_gesture = m_document->newGesture(); }
  void endGesture() { m_gesture = 0; }

 private:
  Document* m_document;
  std::vector<ElementId> m_elements;
  QLabel* m_title;
  QFormLayout* m_rows;
  quint64 m_gesture = 0;
};

/// Three numbers, or none: then `auto` stands there.
class TripleField : public QWidget {
  Q_OBJECT

 public:
  /// `whenFirst`: the other two numbers when only one is typed.
  TripleField(const QString& objectName, const NumberTriple& whenFirst);

  void setTriple(const std::optional<NumberTriple>& triple);

 signals:
  void edited(const std::optional<geargraph::NumberTriple>& triple);
  void editingStarted();

 private:
  std::array<NumberField*, 3> m_fields{};
  NumberTriple m_whenFirst;
};

/// The form for what is selected: links, turning joints or meshes; the document where nothing is; a note
/// where it is of several kinds. The caller owns it.
[[nodiscard]] PropertyForm* makePropertyForm(Document* document, const std::set<ElementId>& selected);

}  // namespace geargraph
