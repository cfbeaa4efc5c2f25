#include "ui/motion_panel/mass_page.h"

#include <QBoxLayout>
#include <QLabel>
#include <QStyledItemDelegate>

#include "core/mechanism/model/mass_edits.h"
#include "ui/models/term_tips.h"
#include "ui/panels/number_field.h"
#include "ui/panels/property_forms.h"
#include "ui/theme/sideways_scroll.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kMass = static_cast<int>(MassColumn::mass);

/// The model of the page's table: masses can be edited.
class MassModel final : public ValueTableModel {
 public:
  using ValueTableModel::ValueTableModel;

  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override {
    const Qt::ItemFlags flags = ValueTableModel::flags(index);
    return index.column() == kMass ? flags | Qt::ItemIsEditable : flags;
  }
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override {
    const QVariant shown = ValueTableModel::data(index, role);
    if (index.column() != kMass || role != Qt::ToolTipRole) return shown;
    return shown.toString() + QLatin1Char(' ') +
           MassPage::tr("Double-click, or press F2, to state it; empty it to leave it to the solids.");
  }
};

/// Edits a mass in a number field, which commits while it is typed, as all fields do.
class MassDelegate final : public QStyledItemDelegate {
 public:
  MassDelegate(Document* document, MassPage* page)
      : QStyledItemDelegate(page), m_document(document), m_page(page) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex& index) const override {
    auto* field = new NumberField(parent);
    field->setObjectName(QStringLiteral("mass"));
    field->setAccessibleName(MassPage::tr("Mass, kg"));
    field->setOptional(true);
    field->setEmptyText(index.data().toString());
    field->setStep(Rational(1, 10));
    field->setAlignment(Qt::AlignRight);
    connect(field, &NumberField::edited, field,
            [this, field, row = index.row(),
             gesture = m_document->newGesture()](const std::optional<Number>& mass) {
              if (mass && mass->exact().sign() < 0)
                return field->reject(MassPage::tr("A mass is at least 0 kg."));
              if (m_page->setMass(row, mass, gesture)) field->setNumber(mass);
            });
    return field;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    static_cast<NumberField*>(editor)->setNumber(m_page->statedMass(index.row()));
  }
  /// The field has told its number already.
  void setModelData(QWidget*, QAbstractItemModel*, const QModelIndex&) const override {}
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex&) const override {
    QRect place = option.rect;
    place.setWidth(qMax(place.width(), editor->sizeHint().width()));
    editor->setGeometry(place);
  }

 private:
  Document* m_document;
  MassPage* m_page;
};

}  // namespace

MassPage::MassPage(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new MassModel(this)),
      m_table(new LinkedTable(m_model, selection, this)) {
  m_table->setObjectName(QStringLiteral("massTable"));
  m_table->setAccessibleName(tr("Masses of the links"));
  m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                           QAbstractItemView::AnyKeyPressed);
  m_table->setItemDelegateForColumn(kMass, new MassDelegate(document, this));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(new SidewaysScroll(makeFields(), this));
  auto* margin = new QHBoxLayout;
  margin->setContentsMargins(8, 0, 0, 0);
  margin->addWidget(m_table);
  layout->addLayout(margin, 1);
  connect(document, &Document::changed, this, &MassPage::showFields);
  showFields();
}

NumberField* MassPage::makeField(const char* name, const QString& tip, QWidget* parent) {
  auto* field = new NumberField(parent);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(tip);
  field->setToolTip(tip);
  field->setFixedWidth(scaledPixels(84));
  connect(field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  return field;
}

QWidget* MassPage::makeFields() {
  auto* strip = new QWidget(this);
  auto* layout = new QHBoxLayout(strip);
  layout->setContentsMargins(12, 0, 10, 2);
  layout->setSpacing(6);
  const auto addText = [&](const QString& text, const QString& tip) {
    auto* label = new QLabel(text, strip);
    label->setProperty("look", "hint");
    label->setToolTip(tip);
    layout->addWidget(label);
  };
  const QString density = tr("The density of all solids, kg/m³; empty: that of steel");
  addText(tr("Density, kg/m³"), density);
  m_density = makeField("density", density, strip);
  m_density->setOptional(true);
  m_density->setEmptyText(tr("%1, steel").arg(kSteelDensity));
  m_density->setStep(Rational(100));
  m_density->setFixedWidth(scaledPixels(132));
  connect(m_density, &NumberField::edited, this, &MassPage::setDensity);
  layout->addWidget(m_density);
  layout->addSpacing(12);
  const QString gravity = tr("The acceleration of free fall in the base frame, m/s²: x, y, z");
  addText(tr("Gravity, m/s²"), gravity);
  const char* const names[] = {"gravity.x", "gravity.y", "gravity.z"};
  for (std::size_t i = 0; i < 3; ++i) {
    m_gravity[i] = makeField(names[i], gravity, strip);
    connect(m_gravity[i], &NumberField::edited, this, [this, i](const std::optional<Number>& value) {
      if (value) setGravity(i, *value);
    });
    layout->addWidget(m_gravity[i]);
  }
  layout->addStretch(1);
  return strip;
}

void MassPage::show(const DynamicsPtr& dynamics) {
  std::shared_ptr<const ValueTable> table;
  if (dynamics && dynamics->train) {
    table = std::make_shared<const ValueTable>(
        massTable(*dynamics->snapshot->mechanism, dynamics->train->links, dynamics->metres));
  }
  m_model->showTable(std::move(table));
  m_table->resizeColumnsToContents();
  m_table->selectRowOfSelection();
}

void MassPage::showFields() {
  const Mechanism& mechanism = *m_document->mechanism();
  m_density->setNumber(mechanism.density);
  for (std::size_t i = 0; i < 3; ++i)
    m_gravity[i]->setNumber(mechanism.gravity ? (*mechanism.gravity)[i] : Number(0));
}

void MassPage::setDensity(const std::optional<Number>& density) {
  if (density && density->exact().sign() <= 0) return m_density->reject(tr("A density is above 0."));
  m_document->apply({tr("Set density"),
                     [density](const Mechanism& before) { return withDensity(before, density); }, m_gesture});
}

void MassPage::setGravity(std::size_t component, const Number& value) {
  const NumberTriple none{Number(0), Number(0), Number(0)};
  const auto gravity =
      withComponent(m_document->mechanism()->gravity, static_cast<int>(component), value, none);
  m_document->apply({tr("Set gravity"),
                     [gravity](const Mechanism& before) { return withGravity(before, gravity); }, m_gesture});
}

const Link* MassPage::linkAt(int row) const {
  const std::set<ElementId> elements = m_model->elementsAt(row);
  return elements.empty() ? nullptr : m_document->elements().find(LinkId(elements.begin()->id));
}

std::optional<Number> MassPage::statedMass(int row) const {
  const Link* const link = linkAt(row);
  return link != nullptr && link->mass ? std::optional(link->mass->mass) : std::nullopt;
}

bool MassPage::setMass(int row, const std::optional<Number>& mass, quint64 gesture) {
  const Link* const link = linkAt(row);
  if (link == nullptr) return false;
  std::optional<LinkMass> stated;
  if (mass) {
    stated = link->mass ? *link->mass : LinkMass();
    stated->mass = *mass;
  }
  return m_document->apply(
      {tr("Set mass"),
       [id = link->id, stated](const Mechanism& before) { return withLinkMass(before, id, stated); },
       gesture});
}

}  // namespace geargraph

#include "moc_mass_page.cpp"
