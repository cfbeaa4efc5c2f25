#include "ui/designer/wish_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "core/design/gearboxes/gearbox_run.h"
#include "core/foundations/files/json_writer.h"
#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr std::array kKindNames{"simple", "double", "ravigneaux"};

}  // namespace

WishForm::WishForm(QWidget* parent) : FieldForm(parent) {
  setObjectName(QStringLiteral("wish"));
  QVBoxLayout* const column = makeColumn();
  makeRatios(*column);
  makeSets(*column);
  makeElements(*column);
  makeLimits(*column);
  column->addStretch(1);
  boundLinks();
  setFocusProxy(m_ratios);
}

void WishForm::makeRatios(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Ratios"));
  m_ratios = ratiosField("wishRatios", tr("Input over output of each gear, first gear first: decimals or "
                                          "fractions, typed or pasted"));
  m_ratios->setPlaceholderText(tr("4.17 2.34 1.52 …"));
  form->addRow(m_ratios);
  m_reverse = new QComboBox(this);
  m_reverse->setObjectName(QStringLiteral("wishReverse"));
  m_reverse->addItems({tr("any ratio"), tr("this ratio"), tr("no reverse")});
  m_reverseRatio = line("wishReverseRatio", {});
  m_reverseRatio->setAccessibleName(tr("Wanted ratio of the reverse"));
  m_reverseRatio->hide();
  connect(m_reverse, &QComboBox::currentIndexChanged, this, [this](int choice) {
    m_reverseRatio->setVisible(choice == 1);
    onEdited();
  });
  auto* reverse = new QHBoxLayout;
  reverse->addWidget(m_reverse);
  reverse->addWidget(m_reverseRatio);
  form->addRow(tr("Reverse"), reverse);
  m_tolerance = line("wishTolerance", QStringLiteral("1"));
  m_tolerance->setToolTip(tr("By how many percent a ratio may differ; empty: ratios are rounded as typed"));
  m_tolerance->setAccessibleName(tr("Tolerance in percent"));
  auto* tolerance = new QHBoxLayout;
  tolerance->addWidget(m_tolerance);
  tolerance->addWidget(new QLabel(tr("% of every ratio"), this));
  form->addRow(tr("Tolerance"), tolerance);
  addFault(column, Field::ratios);
  addFault(column, Field::reverse);
  addFault(column, Field::tolerance);
}

void WishForm::makeSets(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Sets"));
  m_sets[0] = spin("wishSimple", 0, kMaxSets, 2);
  m_sets[1] = spin("wishDouble", 0, kMaxSets, 0);
  m_sets[2] = spin("wishRavigneaux", 0, kMaxSets / 2, 0);
  form->addRow(tr("simple"), m_sets[0]);
  form->addRow(tr("double planets"), m_sets[1]);
  form->addRow(tr("Ravigneaux"), m_sets[2]);
  addFault(column, Field::sets);
  m_links = spin("wishLinks", 3, kMaxShafts, 5);
  m_links->setToolTip(tr("Shafts that can turn, the input shaft too"));
  form->addRow(tr("rotating links"), m_links);
  m_held = spin("wishHeld", 0, 3, 0);
  m_held->setToolTip(tr("Members of sets that are part of the housing"));
  form->addRow(tr("members held"), m_held);
  m_freeInput = new QCheckBox(tr("input joined by clutches only"), this);
  m_freeInput->setObjectName(QStringLiteral("wishFreeInput"));
  m_freeInput->setToolTip(tr("Also layouts whose input shaft has no member of a set"));
  m_freeInput->setChecked(true);
  connect(m_freeInput, &QCheckBox::toggled, this, &WishForm::onEdited);
  form->addRow(m_freeInput);
  addFault(column, Field::layout);
}

void WishForm::makeElements(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Elements"));
  m_elements = spin("wishElements", 1, kMaxElements, 4);
  m_elements->setToolTip(tr("Brakes and clutches together"));
  form->addRow(tr("at most"), m_elements);
  m_brakes = range("wishBrakes", 0, kMaxElements, {0, kMaxElements});
  m_clutches = range("wishClutches", 0, kMaxElements, {0, kMaxElements});
  m_brakes[0]->setAccessibleName(tr("Fewest brakes"));
  m_brakes[1]->setAccessibleName(tr("Most brakes"));
  m_clutches[0]->setAccessibleName(tr("Fewest clutches"));
  m_clutches[1]->setAccessibleName(tr("Most clutches"));
  form->addRow(tr("brakes"), fromTo(m_brakes[0], m_brakes[1]));
  form->addRow(tr("clutches"), fromTo(m_clutches[0], m_clutches[1]));
  m_singleShift = new QCheckBox(tr("one let go, one taken per shift"), this);
  m_singleShift->setObjectName(QStringLiteral("wishSingleShift"));
  m_singleShift->setChecked(true);
  connect(m_singleShift, &QCheckBox::toggled, this, &WishForm::onEdited);
  form->addRow(m_singleShift);
  addFault(column, Field::elements);
}

void WishForm::makeLimits(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Limits"));
  m_k = {line("wishLeastK", localNumbers("1.5")), line("wishMostK", QStringLiteral("4"))};
  m_k[0]->setAccessibleName(tr("Least ring : sun"));
  m_k[1]->setAccessibleName(tr("Largest ring : sun"));
  form->addRow(tr("ring : sun"), fromTo(m_k[0], m_k[1]));
  m_fewestTeeth = spin("wishFewestTeeth", 6, 400, 17);
  m_mostRing = spin("wishMostRing", 20, 400, 120);
  form->addRow(tr("teeth from"), m_fewestTeeth);
  form->addRow(tr("rings to"), m_mostRing);
  m_efficiency = line("wishEfficiency", {});
  m_efficiency->setPlaceholderText(tr("not computed"));
  m_efficiency->setToolTip(tr("Efficiency of a mesh, such as 0.98, from which that of each gear follows"));
  form->addRow(tr("η of a mesh"), m_efficiency);
  m_buildable = new QCheckBox(tr("buildable only"), this);
  m_buildable->setObjectName(QStringLiteral("wishBuildable"));
  m_buildable->setToolTip(tr("Only gearboxes whose section can be drawn without shafts that cross"));
  connect(m_buildable, &QCheckBox::toggled, this, &WishForm::onEdited);
  form->addRow(m_buildable);
  addFault(column, Field::k);
  addFault(column, Field::teeth);
  addFault(column, Field::efficiency);
}

int WishForm::basicSetCount() const {
  return m_sets[0]->value() + m_sets[1]->value() + 2 * m_sets[2]->value();
}

/// With fewer links nothing is left to engage, with more too much is free.
void WishForm::boundLinks() {
  const int sets = basicSetCount();
  const QSignalBlocker blocker(m_links);
  m_links->setRange(std::min(sets + 2, kMaxShafts), std::min(sets + kMaxFreedom, kMaxShafts));
}

void WishForm::onEdited() {
  boundLinks();
  FieldForm::onEdited();
}

void WishForm::setExample() {
  m_ratios->setPlainText(localNumbers(kExampleRatios));
  m_reverse->setCurrentIndex(0);
  m_tolerance->setText(QStringLiteral("1"));
  m_sets[0]->setValue(1);
  m_sets[1]->setValue(0);
  m_sets[2]->setValue(1);
  m_links->setValue(6);
  m_held->setValue(1);
  m_elements->setValue(5);
}

std::string WishForm::json() const {
  TextSink sink;
  {
    JsonWriter json(sink);
    writeWish(json);
  }
  return sink.take();
}

void WishForm::writeWish(JsonWriter& json) const {
  using enum JsonWriter::Layout;
  json.beginObject(row);
  json.key("forward");
  json.beginArray(row);
  for (const QString& each : ratiosIn(m_ratios->toPlainText())) json.string(each.toStdString());
  json.endArray();
  json.key("reverse");
  switch (m_reverse->currentIndex()) {
    case 0:
      json.string("any");
      break;
    case 1:
      json.string(plainNumber(m_reverseRatio->text()));
      break;
    default:
      json.null();
  }
  if (!m_tolerance->text().trimmed().isEmpty()) json.member("tolerance", partOfOne(m_tolerance->text()));
  json.key("sets");
  json.beginArray(row);
  for (std::size_t kind = 0; kind < m_sets.size(); ++kind)
    for (int i = 0; i < m_sets[kind]->value(); ++i) json.string(kKindNames[kind]);
  json.endArray();
  writeWhole(json, "links", *m_links);
  writeWhole(json, "held", *m_held);
  json.member("freeInput", m_freeInput->isChecked());
  writeWhole(json, "elements", *m_elements);
  writeRange(json, "brakes", m_brakes);
  writeRange(json, "clutches", m_clutches);
  json.member("singleShift", m_singleShift->isChecked());
  json.key("k");
  json.beginArray(row);
  for (const QLineEdit* each : m_k) json.string(plainNumber(each->text()));
  json.endArray();
  json.key("teeth");
  json.beginObject(row);
  writeWhole(json, "fewest", *m_fewestTeeth);
  writeWhole(json, "mostRing", *m_mostRing);
  json.endObject();
  if (!m_efficiency->text().trimmed().isEmpty()) {
    json.key("efficiency");
    json.beginObject(row);
    json.member("mesh", plainNumber(m_efficiency->text()));
    json.endObject();
  }
  json.member("buildable", m_buildable->isChecked());
  json.endObject();
}

std::optional<WishForm::Field> WishForm::fieldAt(const std::string& pointer) {
  using enum Field;
  static const std::vector<std::pair<std::string_view, Field>> kPlaces = {
      {"/forward", ratios},      {"/reverse", reverse},
      {"/tolerance", tolerance}, {"/sets", sets},
      {"/links", layout},        {"/held", layout},
      {"/elements", elements},   {"/brakes", elements},
      {"/clutches", elements},   {"/k", k},
      {"/teeth", teeth},         {"/efficiency", efficiency}};
  for (const auto& [place, field] : kPlaces)
    if (pointer.starts_with(place)) return field;
  return std::nullopt;
}

QWidget* WishForm::widgetOf(Field field) const {
  switch (field) {
    case Field::reverse:
      return m_reverseRatio;
    case Field::tolerance:
      return m_tolerance;
    case Field::sets:
      return m_sets[0];
    case Field::layout:
      return m_links;
    case Field::elements:
      return m_elements;
    case Field::k:
      return m_k[0];
    case Field::teeth:
      return m_fewestTeeth;
    case Field::efficiency:
      return m_efficiency;
    default:
      return m_ratios;
  }
}

std::optional<GearboxWish> WishForm::wish() {
  clearFaults();
  auto wish = readGearboxWish(json());
  std::optional<Field> first;
  if (!wish) {
    for (const Diagnostic& each : wish.error()) {
      const Field field = fieldAt(each.pointer).value_or(Field::ratios);
      if (!first || field < *first) first = field;
      showFault(field, shownText(each.message));
    }
  } else if (hasTooFewStates(*wish)) {
    first = Field::elements;
    const int wanted = static_cast<int>(wish->forward.size()) + (wish->reverse == ReverseWish::none ? 0 : 1);
    showFault(*first, tr("Impossible: %1 gears need as many states; %2 of %3 elements give fewer.")
                          .arg(wanted)
                          .arg(wish->limits.shafts - basicSetCount() - 1)
                          .arg(wish->elements));
  }
  if (!first) return *std::move(wish);
  widgetOf(*first)->setFocus();
  return std::nullopt;
}

}  // namespace geargraph

#include "moc_wish_form.cpp"
