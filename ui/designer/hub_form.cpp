#include "ui/designer/hub_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <algorithm>

#include "core/foundations/files/json_writer.h"
#include "ui/models/term_tips.h"

namespace geargraph {

HubForm::HubForm(QWidget* parent) : FieldForm(parent) {
  setObjectName(QStringLiteral("hubWish"));
  QVBoxLayout* const column = makeColumn();
  makeSheet(*column);
  makeLimits(*column);
  makeCounted(*column);
  column->addStretch(1);
  setFocusProxy(m_ratios);
}

void HubForm::makeSheet(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Ratios"));
  m_ratios = ratiosField("hubRatios", tr("Wheel over sprocket of each gear as the sheet prints it: typed or "
                                         "pasted"));
  m_ratios->setPlaceholderText(tr("0.632 0.741 0.843 …"));
  form->addRow(m_ratios);
  m_direct = spin("hubDirect", 0, static_cast<int>(kMaxHubRatios), 0);
  m_direct->setSpecialValueText(tr("that with 1"));
  m_direct->setToolTip(
      tr("The gear that passes the motion through. The others may then be in percent, or "
         "metres a turn."));
  form->addRow(tr("direct gear"), m_direct);
  m_tolerance = line("hubTolerance", {});
  m_tolerance->setPlaceholderText(tr("rounded as printed"));
  m_tolerance->setToolTip(tr("By how many percent a ratio may differ; empty: ratios are rounded as typed"));
  form->addRow(tr("tolerance, %"), m_tolerance);
  addFault(column, static_cast<int>(Field::ratios));
  auto* known = addForm(column, tr("What is known"));
  m_sets = spin("hubSets", 1, kMaxHubSets, 2);
  m_sets->setToolTip(tr("Planetary sets in series, at most"));
  known->addRow(tr("sets in series"), m_sets);
  m_stepped = new QCheckBox(tr("stepped planets"), this);
  m_stepped->setObjectName(QStringLiteral("hubStepped"));
  m_stepped->setToolTip(tr("Planets with several wheels, each with a sun of its own"));
  m_stepped->setChecked(true);
  connect(m_stepped, &QCheckBox::toggled, this, [this] { onEdited(); });
  known->addRow(m_stepped);
  addFault(column, static_cast<int>(Field::structure));
}

void HubForm::makeLimits(QVBoxLayout& column) {
  constexpr int kFewest = 8;
  constexpr int kMost = 400;
  auto* form = addForm(column, tr("Limits"));
  m_planets = range("hubPlanets", kFewest, kMost, {12, 30});
  m_suns = range("hubSuns", kFewest, kMost, {15, 60});
  m_rings = range("hubRings", kFewest, kMost, {40, 90});
  form->addRow(tr("planets"), fromTo(m_planets[0], m_planets[1]));
  form->addRow(tr("suns"), fromTo(m_suns[0], m_suns[1]));
  form->addRow(tr("rings"), fromTo(m_rings[0], m_rings[1]));
  for (const auto& [ends, name] : {std::pair(&m_planets, tr("planets")), std::pair(&m_suns, tr("suns")),
                                   std::pair(&m_rings, tr("rings"))}) {
    (*ends)[0]->setAccessibleName(tr("Fewest teeth: %1").arg(name));
    (*ends)[1]->setAccessibleName(tr("Most teeth: %1").arg(name));
  }
  m_slack = spin("hubSlack", 0, 4, 0);
  m_slack->setToolTip(tr("Teeth by which the sums of one set may differ, made up by profile shift"));
  form->addRow(tr("slack"), m_slack);
  addFault(column, static_cast<int>(Field::limits));
}

void HubForm::makeCounted(QVBoxLayout& column) {
  auto* form = addForm(column, tr("Counted"));
  m_counted = line("hubCounted", {});
  m_counted->setPlaceholderText(QStringLiteral("1.ring 72, 2.sun2 30"));
  m_counted->setToolTip(tr("Wheels whose teeth have been counted: set and wheel, then the teeth"));
  m_counted->setAccessibleName(tr("Counted teeth"));
  form->addRow(m_counted);
  addFault(column, static_cast<int>(Field::counted));
}

void HubForm::setExample() {
  m_ratios->setPlainText(localNumbers(kExampleRatios));
  m_direct->setValue(0);
  m_tolerance->clear();
  m_sets->setValue(2);
  m_stepped->setChecked(true);
  m_slack->setValue(3);
  m_counted->clear();
}

std::string HubForm::json() const {
  using Row = JsonWriter::Layout;
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject(Row::row);
    json.key("ratios");
    json.beginArray(Row::row);
    for (const QString& each : ratiosIn(m_ratios->toPlainText())) json.string(each.toStdString());
    json.endArray();
    if (m_direct->value() > 0) writeWhole(json, "direct", *m_direct);
    if (!m_tolerance->text().trimmed().isEmpty()) json.member("tolerance", partOfOne(m_tolerance->text()));
    writeWhole(json, "sets", *m_sets);
    json.member("stepped", m_stepped->isChecked());
    writeRange(json, "planets", m_planets);
    writeRange(json, "suns", m_suns);
    writeRange(json, "rings", m_rings);
    writeWhole(json, "slack", *m_slack);
    json.key("counted");
    json.beginObject(Row::row);
    static const QRegularExpression kWheel(QStringLiteral("([^\\s,;=]+)[\\s=]+([^\\s,;]+)"));
    auto wheels = kWheel.globalMatch(m_counted->text());
    while (wheels.hasNext()) {
      const auto wheel = wheels.next();
      json.key(wheel.captured(1).toStdString());
      bool isNumber = false;
      const int teeth = wheel.captured(2).toInt(&isNumber);
      isNumber ? json.number(static_cast<std::int64_t>(teeth)) : json.string(wheel.captured(2).toStdString());
    }
    json.endObject();
    json.endObject();
  }
  return sink.take();
}

HubForm::Field HubForm::fieldAt(const std::string& pointer) {
  for (const std::string_view place : {"/counted"})
    if (pointer.starts_with(place)) return Field::counted;
  for (const std::string_view place : {"/planets", "/suns", "/rings", "/slack"})
    if (pointer.starts_with(place)) return Field::limits;
  for (const std::string_view place : {"/sets", "/stepped"})
    if (pointer.starts_with(place)) return Field::structure;
  return Field::ratios;
}

std::optional<HubWish> HubForm::wish() {
  clearFaults();
  auto wish = readHubWish(json());
  if (wish) return *std::move(wish);
  Field first = Field::counted;
  for (const Diagnostic& each : wish.error()) {
    const Field field = fieldAt(each.pointer);
    first = std::min(first, field);
    showFault(static_cast<int>(field), shownText(each.message));
  }
  const std::array<QWidget*, 4> fields{m_ratios, m_sets, m_planets[0], m_counted};
  fields[static_cast<std::size_t>(first)]->setFocus();
  return std::nullopt;
}

}  // namespace geargraph

#include "moc_hub_form.cpp"
