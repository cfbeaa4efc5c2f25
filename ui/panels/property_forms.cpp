#include "ui/panels/property_forms.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <atomic>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/pins.h"
#include "ui/models/term_tips.h"
#include "ui/panels/link_parts.h"
#include "ui/panels/number_field.h"

namespace geargraph {
namespace {

/// Elements to be changed times joints and meshes: some tens of milliseconds.
constexpr std::size_t kMaxAtOnce = 20'000;

}  // namespace

PropertyForm::PropertyForm(Document* document, std::vector<ElementId> elements)
    : m_document(document),
      m_elements(std::move(elements)),
      m_title(new QLabel(this)),
      m_rows(new QFormLayout),
      m_wrong(new QLabel(this)) {
  m_title->setProperty("look", "title");
  m_title->setWordWrap(true);
  m_wrong->setProperty("look", "problem");
  m_wrong->setObjectName(QStringLiteral("wrong"));
  m_wrong->setWordWrap(true);
  m_wrong->hide();
  m_rows->setHorizontalSpacing(14);
  m_rows->setVerticalSpacing(7);
  m_rows->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 12, 16, 12);
  layout->setSpacing(9);
  layout->addWidget(m_title);
  layout->addLayout(m_rows);
  layout->addWidget(m_wrong);
  layout->addStretch(1);
}

bool PropertyForm::isAboutExisting() const {
  return std::all_of(m_elements.begin(), m_elements.end(),
                     [this](const ElementId& element) { return index().contains(element); });
}

QString PropertyForm::label(const ElementId& element) const {
  return shownText(index().labelOf(element).value_or(std::string()));
}

void PropertyForm::setTitle(const QString& title) {
  m_title->setText(title);
}

void PropertyForm::addRow(const QString& name, Term term, QWidget* field) {
  auto* rowLabel = new QLabel(name);
  rowLabel->setProperty("look", "hint");
  rowLabel->setToolTip(tipOf(term));
  rowLabel->setBuddy(field);  // its name for screen readers, where it has none of its own
  m_rows->addRow(rowLabel, field);
}

void PropertyForm::setRowShown(QWidget* field, bool shown, const QString& name) {
  auto* rowLabel = static_cast<QLabel*>(m_rows->labelForField(field));
  field->setVisible(shown);
  rowLabel->setVisible(shown);
  rowLabel->setText(name);
}

/// A row of elements that belong to those of the form; they are highlighted under the mouse and selected by a
/// click.
QLabel* PropertyForm::addParts(const QString& name, Term term) {
  auto* parts = new QLabel(this);
  parts->setObjectName(QStringLiteral("parts.") + name.toLower());
  parts->setTextFormat(Qt::RichText);
  parts->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  parts->setWordWrap(true);
  connect(parts, &QLabel::linkActivated, this,
          [this](const QString& address) { emit elementChosen(elementAt(address)); });
  connect(parts, &QLabel::linkHovered, this, [this](const QString& address) {
    emit elementHovered(address.isEmpty() ? std::nullopt : std::optional(elementAt(address)));
  });
  addRow(name, term, parts);
  auto* rowLabel = static_cast<QLabel*>(m_rows->labelForField(parts));
  rowLabel->setSizePolicy(QSizePolicy::Preferred,
                          QSizePolicy::Expanding);  // else somewhat below the first line
  rowLabel->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return parts;
}

void PropertyForm::showParts(QLabel& parts, const QString& text) {
  const QString shown = text.isEmpty() ? tr("none") : text;
  if (parts.text() != shown) parts.setText(shown);
}

void PropertyForm::addWide(QWidget* widget) {
  m_rows->addRow(widget);
}

void PropertyForm::addButtons(const std::vector<QAbstractButton*>& buttons, const QString& name) {
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  for (QAbstractButton* button : buttons) line->addWidget(button);
  line->addStretch(1);
  if (name.isEmpty()) return m_rows->addRow(line);
  auto* rowLabel = new QLabel(name);
  rowLabel->setProperty("look", "hint");
  m_rows->addRow(rowLabel, line);
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
  connect(field, &NumberField::wrongChanged, this, &PropertyForm::showWrong);
  return field;
}

QCheckBox* PropertyForm::makePin(const QString& text, const QString& tip, const PinnedPart& of) {
  auto* box = new QCheckBox(text, this);
  box->setToolTip(tip);
  connect(box, &QCheckBox::clicked, this, [this, of](bool on) {
    newGesture();
    std::vector<ElementId> parts;
    for (const ElementId& element : m_elements) parts.push_back(of(index(), element));
    applyAtOnce(on ? tr("Pin") : tr("Unpin"),
                [parts, on](const PlacedMechanism& before) { return withAllPinned(before, parts, on); });
  });
  return box;
}

void PropertyForm::showPin(QCheckBox& box, const PinnedPart& of) const {
  const QSignalBlocker quiet(&box);
  box.setChecked(std::all_of(m_elements.begin(), m_elements.end(), [&](const ElementId& element) {
    const ElementId part = of(index(), element);
    if (part.kind == ElementKind::axis) return isPinned(*index().find(AxisId(part.id)));
    if (part.kind == ElementKind::gearMesh) return isPinned(*index().find(MeshId(part.id)));
    return isPinned(*index().find(LinkId(part.id)));
  }));
}

void PropertyForm::showWrong(const QString& why) {
  m_wrong->setText(why);
  m_wrong->setVisible(!why.isEmpty());
}

void PropertyForm::apply(const QString& text, const Change& change) {
  applyToEach(text,
              [change, ids = m_elements](const PlacedMechanism& before, const LongEdit::Progress& progress) {
                return unplaced(changedInTurn<Mechanism>(before.mechanism(), ids, progress, change));
              });
}

void PropertyForm::applyFitted(const QString& text, const FittedChange& change) {
  applyToEach(text,
              [change, ids = m_elements](const PlacedMechanism& before, const LongEdit::Progress& progress) {
                return changedInTurn<PlacedMechanism>(before, ids, progress, change);
              });
}

/// The change of one element takes as long as the document is large.
void PropertyForm::applyToEach(const QString& text, const LongEdit::Work& work) {
  const std::size_t size = mechanism().turningJoints.size() + mechanism().gearMeshes.size();
  if (m_elements.size() == 1 || m_elements.size() * size <= kMaxAtOnce) {
    return applyAtOnce(text, [work](const PlacedMechanism& before) {
      std::atomic<int> done = 0;
      return work(before, {{}, &done});
    });
  }
  showWrong({});
  const auto* edit =
      new LongEdit(m_document, window(), text, m_gesture, static_cast<int>(m_elements.size()), work);
  connect(edit, &LongEdit::ended, this, [this](const QString& why) {
    if (isAboutExisting()) refresh();  // fields may show what was not accepted
    showWrong(why);
  });
}

void PropertyForm::applyAtOnce(const QString& text, const Reduce& reduce) {
  const QString why = rejectionOf(*m_document, {text, reduce, m_gesture});
  if (!why.isEmpty()) {
    for (NumberField* field : findChildren<NumberField*>()) {
      if (field->isCommitting()) field->reject(why);
    }
    refresh();  // or fields would go on showing what the document does not hold
  }
  showWrong(why);
}

TripleField::TripleField(const QString& objectName) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  for (std::size_t i = 0; i < 3; ++i) {
    auto* field = new NumberField(this);
    field->setObjectName(objectName + QLatin1Char('.') + QLatin1Char("xyz"[i]));
    field->setOptional(true);
    field->setMinimumWidth(56);
    layout->addWidget(field, 1);
    m_fields[i] = field;
    connect(field, &NumberField::editingStarted, this, &TripleField::editingStarted);
    connect(field, &NumberField::wrongChanged, this, &TripleField::wrongChanged);
    connect(field, &NumberField::edited, this,
            [this, i](const std::optional<Number>& number) { emit edited(static_cast<int>(i), number); });
  }
}

void TripleField::setLengthUnit(const std::string& unit) {
  for (NumberField* field : m_fields) field->setLengthUnit(unit);
}

void TripleField::setTriples(const Triples& triples) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [i](const std::optional<NumberTriple>& triple) {
      return triple ? std::optional<Number>((*triple)[i]) : std::nullopt;
    };
    const bool same = std::all_of(triples.begin(), triples.end(),
                                  [&](const auto& triple) { return at(triple) == at(triples.front()); });
    m_fields[i]->setEmptyText(same ? tr("auto") : tr("several"));
    m_fields[i]->setNumber(same ? at(triples.front()) : std::nullopt);
  }
}

std::optional<NumberTriple> withComponent(const std::optional<NumberTriple>& triple, int index,
                                          const std::optional<Number>& number,
                                          const NumberTriple& otherwise) {
  if (!number) return std::nullopt;
  NumberTriple changed = triple.value_or(otherwise);
  changed[static_cast<std::size_t>(index)] = *number;
  return changed;
}

}  // namespace geargraph

#include "moc_property_forms.cpp"
