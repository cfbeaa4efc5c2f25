#include "ui/panels/property_forms.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/panels/element_forms.h"
#include "ui/panels/number_field.h"
#include "ui/panels/term_tips.h"

namespace geargraph {

PropertyForm::PropertyForm(Document* document, std::vector<ElementId> elements)
    : m_document(document),
      m_elements(std::move(elements)),
      m_title(new QLabel(this)),
      m_rows(new QFormLayout) {
  m_title->setProperty("look", "title");
  m_title->setWordWrap(true);
  m_rows->setHorizontalSpacing(14);
  m_rows->setVerticalSpacing(7);
  m_rows->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 12, 16, 12);
  layout->setSpacing(9);
  layout->addWidget(m_title);
  layout->addLayout(m_rows);
  layout->addStretch(1);
}

bool PropertyForm::isAboutExisting() const {
  return std::all_of(m_elements.begin(), m_elements.end(),
                     [this](const ElementId& element) { return labelOf(mechanism(), element).has_value(); });
}

QString PropertyForm::label(const ElementId& element) const {
  return shownText(labelOf(mechanism(), element).value_or(std::string()));
}

void PropertyForm::setTitle(const QString& title) {
  m_title->setText(title);
}

void PropertyForm::addRow(const QString& name, Term term, QWidget* field) {
  auto* rowLabel = new QLabel(name);
  rowLabel->setProperty("look", "hint");
  rowLabel->setToolTip(tipOf(term));
  m_rows->addRow(rowLabel, field);
}

void PropertyForm::addButtons(const std::vector<QPushButton*>& buttons) {
  auto* line = new QHBoxLayout;
  for (QPushButton* button : buttons) line->addWidget(button);
  line->addStretch(1);
  m_rows->addRow(line);
}

void PropertyForm::addNote(const QString& text) {
  auto* note = new QLabel(text);
  note->setProperty("look", "hint");
  note->setWordWrap(true);
  m_rows->addRow(note);
}

NumberField* PropertyForm::makeNumber(const QString& objectName) {
  auto* field = new NumberField(this);
  field->setObjectName(objectName);
  connect(field, &NumberField::editingStarted, this, &PropertyForm::newGesture);
  return field;
}

void PropertyForm::apply(const QString& text, const Change& change) {
  m_document->apply({text,
                     [change, ids = m_elements](const Mechanism& before) -> Expected<Mechanism> {
                       Mechanism next = before;
                       for (const ElementId& element : ids) {
                         Expected<Mechanism> changed = change(std::move(next), element);
                         if (!changed) return changed.error();
                         next = std::move(changed).value();
                       }
                       return next;
                     },
                     m_gesture});
}

TripleField::TripleField(const QString& objectName, const NumberTriple& whenFirst) : m_whenFirst(whenFirst) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  for (std::size_t i = 0; i < 3; ++i) {
    auto* field = new NumberField(this);
    field->setObjectName(objectName + QLatin1Char('.') + QLatin1Char("xyz"[i]));
    field->setEmptyText(tr("auto"));
    field->setOptional(true);
    field->setMinimumWidth(56);
    layout->addWidget(field, 1);
    m_fields[i] = field;
    connect(field, &NumberField::editingStarted, this, &TripleField::editingStarted);
    connect(field, &NumberField::edited, this, [this](const std::optional<Number>& number) {
      if (!number) return emit edited(std::nullopt);
      NumberTriple triple = m_whenFirst;
      for (std::size_t j = 0; j < 3; ++j) triple[j] = m_fields[j]->number().value_or(m_whenFirst[j]);
      emit edited(triple);
    });
  }
}

void TripleField::setTriple(const std::optional<NumberTriple>& triple) {
  for (std::size_t i = 0; i < 3; ++i) {
    m_fields[i]->setNumber(triple ? std::optional<Number>((*triple)[i]) : std::nullopt);
  }
}

PropertyForm* makePropertyForm(Document* document, const std::set<ElementId>& selected) {
  std::vector<ElementId> elements;
  for (const ElementId& element : selected) {
    if (labelOf(*document->mechanism(), element)) elements.push_back(element);
  }
  if (elements.empty()) return new DocumentForm(document);
  const ElementKind kind = elements.front().kind;
  const bool oneKind = std::all_of(elements.begin(), elements.end(),
                                   [kind](const ElementId& element) { return element.kind == kind; });
  if (oneKind && kind == ElementKind::link) return new LinkForm(document, std::move(elements));
  if (oneKind && kind == ElementKind::turningJoint) return new JointForm(document, std::move(elements));
  if (oneKind && kind == ElementKind::gearMesh) return new MeshForm(document, std::move(elements));
  return new MixedForm(document, std::move(elements));
}

}  // namespace geargraph
