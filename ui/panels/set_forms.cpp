#include "ui/panels/set_forms.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <cmath>

#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/foundations/base/translation.h"
#include "ui/models/printed_number.h"
#include "ui/panels/number_field.h"

namespace geargraph {
namespace {

QString errorText(double error) {
  if (error == 0) return SetForm::tr("exact");
  return printedNumber(100 * error, 2) + QStringLiteral(" %");
}

/// Which members drive and are driven, in the order of the combo box; the third is held.
struct Use {
  PlanetaryMember drive;
  PlanetaryMember driven;
};
constexpr Use kUses[] = {
    {PlanetaryMember::sun, PlanetaryMember::carrier},  {PlanetaryMember::ring, PlanetaryMember::carrier},
    {PlanetaryMember::sun, PlanetaryMember::ring},     {PlanetaryMember::carrier, PlanetaryMember::sun},
    {PlanetaryMember::carrier, PlanetaryMember::ring}, {PlanetaryMember::ring, PlanetaryMember::sun}};

}  // namespace

SetForm::SetForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
  m_form->setContentsMargins(4, 4, 4, 4);
  m_form->setVerticalSpacing(8);
}

NumberField* SetForm::addWhole(const QString& label, const char* name, int value, int least, int most) {
  auto* field = new NumberField(this);
  field->setObjectName(QLatin1String(name));
  field->setWhole(least, most);
  field->setNumber(Number(value));
  field->setMaximumWidth(90);
  connect(field, &NumberField::edited, this, [this, field](const std::optional<Number>& number) {
    if (!number) return;
    field->setNumber(number);
    emit changed();
  });
  m_form->addRow(label, field);
  return field;
}

int SetForm::wholeOf(const NumberField* field) {
  return static_cast<int>(std::lround(field->number()->value()));
}

TeethForm::TeethForm(const std::vector<Count>& counts, Make make, QWidget* parent)
    : SetForm(parent), m_make(std::move(make)) {
  for (const Count& count : counts)
    m_fields.push_back(addWhole(count.label, count.name, count.value, count.least, count.most));
}

Expected<Mechanism> TeethForm::set() const {
  std::vector<int> counts;
  for (const NumberField* field : m_fields) counts.push_back(wholeOf(field));
  return m_make(counts);
}

LengthsForm::LengthsForm(const std::vector<Length>& lengths, bool hasHand, Make make, QWidget* parent)
    : SetForm(parent), m_make(std::move(make)) {
  for (const Length& length : lengths) {
    auto* field = new NumberField(this);
    field->setObjectName(QLatin1String(length.name));
    field->setLengthUnit(emptyMechanism().unit);
    field->setNumber(length.value);
    field->setMaximumWidth(90);
    connect(field, &NumberField::edited, this, [this, field](const std::optional<Number>& number) {
      if (!number) return;
      field->setNumber(number);
      emit changed();
    });
    form().addRow(length.label, field);
    m_fields.push_back(field);
  }
  if (!hasHand) return;
  m_hand = new QComboBox(this);
  m_hand->setObjectName(QStringLiteral("threadHand"));
  for (const Hand hand : {Hand::right, Hand::left}) m_hand->addItem(QString::fromStdString(handWord(hand)));
  connect(m_hand, &QComboBox::activated, this, &SetForm::changed);
  form().addRow(tr("Hand of the thread"), m_hand);
}

Expected<Mechanism> LengthsForm::set() const {
  std::vector<Number> lengths;
  for (const NumberField* field : m_fields) lengths.push_back(*field->number());
  return m_make(lengths, m_hand != nullptr && m_hand->currentIndex() == 1 ? Hand::left : Hand::right);
}

ChoiceForm::ChoiceForm(const QStringList& teethHeads, const Rational& ratio, QWidget* parent)
    : SetForm(parent), m_ratio(new NumberField(this)), m_table(new QTableWidget(this)) {
  m_ratio->setObjectName(QStringLiteral("wishedRatio"));
  m_ratio->setNumber(Number(ratio));
  m_ratio->setStep(Rational(1, 10));
  m_ratio->setMaximumWidth(90);
  form().addRow(tr("Ratio wanted"), m_ratio);
  connect(m_ratio, &NumberField::edited, this, [this](const std::optional<Number>& number) {
    if (!number) return;
    m_ratio->setNumber(number);
    renew();
  });
  m_table->setObjectName(QStringLiteral("choices"));
  m_table->setColumnCount(static_cast<int>(teethHeads.size()) + 2);
  m_table->setHorizontalHeaderLabels(teethHeads + QStringList{tr("ratio"), tr("error")});
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(24);
  m_table->horizontalHeader()->setHighlightSections(false);
  // As wide as the words, the rest for the fractions: an elided ratio is no ratio.
  QHeaderView* header = m_table->horizontalHeader();
  const int teeth = static_cast<int>(teethHeads.size());
  header->setMinimumSectionSize(40);
  header->setSectionResizeMode(QHeaderView::Stretch);
  for (int column = 0; column < teeth; ++column) {
    header->setSectionResizeMode(column, QHeaderView::Fixed);
    header->resizeSection(column, header->sectionSizeHint(column));
  }
  m_table->setShowGrid(false);
  m_table->setFrameShape(QFrame::NoFrame);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  connect(m_table, &QTableWidget::itemSelectionChanged, this, &SetForm::changed);
}

void ChoiceForm::addTable() {
  form().addRow(m_table);
  renew();
}

void ChoiceForm::renew() {
  const QSignalBlocker quiet(m_table);
  m_choices = choices(m_ratio->number()->exact());
  m_table->setRowCount(static_cast<int>(m_choices.size()));
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const Choice& choice = m_choices[static_cast<std::size_t>(row)];
    const QStringList cells =
        choice.teeth + QStringList{printedFraction(choice.ratio), errorText(choice.error)};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_table->setItem(row, column, item);
    }
  }
  m_table->selectRow(0);
  emit changed();
}

Expected<Mechanism> ChoiceForm::set() const {
  const int row = m_table->currentRow();
  if (m_choices.empty()) {
    return Diagnostic{
        Code::schema,
        translated(
            "No tooth counts within these limits come near this ratio with this sign. What fits: wider "
            "limits, or other members."),
        {},
        {},
        0,
        0};
  }
  return m_choices[static_cast<std::size_t>(std::max(row, 0))].make();
}

PlanetaryForm::PlanetaryForm(QWidget* parent)
    : ChoiceForm({tr("sun"), tr("planet"), tr("ring")}, Rational(7, 2), parent),
      m_use(new QComboBox(this)),
      m_held(new QComboBox(this)) {
  m_use->setObjectName(QStringLiteral("use"));
  m_use->addItems({tr("sun to carrier, ring held"), tr("ring to carrier, sun held"),
                   tr("sun to ring, carrier held"), tr("carrier to sun, ring held"),
                   tr("carrier to ring, sun held"), tr("ring to sun, carrier held")});
  form().addRow(tr("From, to"), m_use);
  m_held->setObjectName(QStringLiteral("held"));
  m_held->addItems({tr("by an engaged brake"), tr("cut into the ground")});
  m_held->setToolTip(tr(
      "What \"held\" means: a link of its own with a brake that is engaged, so that you can release it; or "
      "no link of its own, its teeth are the ground's, as in the example \"Planetary train, ring held\". "
      "The speeds are the same."));
  form().addRow(tr("Held"), m_held);
  m_planets = addWhole(tr("Planets"), "planets", 3, 1, 12);
  m_fewest = addWhole(tr("Fewest teeth"), "fewest", 17, 6, 200);
  m_most = addWhole(tr("Most teeth"), "most", 120, 20, 400);
  for (const QComboBox* choice : {m_use, m_held})
    connect(choice, &QComboBox::activated, this, [this] { renew(); });
  for (NumberField* field : {m_planets, m_fewest, m_most})
    connect(field, &NumberField::edited, this, [this] { renew(); });
  addTable();
}

std::vector<ChoiceForm::Choice> PlanetaryForm::choices(const Rational& ratio) const {
  const Use& use = kUses[m_use->currentIndex()];
  PlanetaryRequirements requirements{
      ratio, use.drive, use.driven, wholeOf(m_planets), wholeOf(m_fewest), wholeOf(m_most)};
  const PlanetaryUse made{use.drive, use.driven,
                          m_held->currentIndex() == 0 ? PlanetaryHolding::brake : PlanetaryHolding::ground};
  std::vector<Choice> choices;
  for (const PlanetaryChoice& choice : planetaryChoices(requirements)) {
    const PlanetaryTeeth teeth = choice.teeth;
    choices.push_back(
        {{QString::number(teeth.sun), QString::number(teeth.planet), QString::number(teeth.ring())},
         choice.ratio,
         choice.error,
         [teeth, planets = requirements.planets, made] { return planetarySet(teeth, planets, made); }});
  }
  return choices;
}

RevertedForm::RevertedForm(QWidget* parent)
    : ChoiceForm({tr("first"), tr("second"), tr("third"), tr("fourth")}, Rational(4), parent) {
  m_fewest = addWhole(tr("Fewest teeth"), "fewest", 17, 6, 200);
  m_most = addWhole(tr("Most teeth"), "most", 80, 20, 400);
  for (NumberField* field : {m_fewest, m_most})
    connect(field, &NumberField::edited, this, [this] { renew(); });
  addTable();
}

std::vector<ChoiceForm::Choice> RevertedForm::choices(const Rational& ratio) const {
  std::vector<Choice> choices;
  for (const RevertedChoice& choice : revertedChoices({ratio, wholeOf(m_fewest), wholeOf(m_most)})) {
    const RevertedTeeth teeth = choice.teeth;
    choices.push_back({{QString::number(teeth.first), QString::number(teeth.second),
                        QString::number(teeth.third), QString::number(teeth.fourth)},
                       choice.ratio,
                       choice.error,
                       [teeth] { return revertedTrain(teeth); }});
  }
  return choices;
}

}  // namespace geargraph

#include "moc_set_forms.cpp"
