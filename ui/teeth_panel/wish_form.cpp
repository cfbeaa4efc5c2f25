#include "ui/teeth_panel/wish_form.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "core/design/teeth_wish/teeth_wish.h"
#include "core/foundations/base/locale.h"
#include "core/foundations/files/json_writer.h"
#include "ui/document/typed_length.h"
#include "ui/models/term_tips.h"
#include "ui/teeth_panel/ratio_row.h"
#include "ui/theme/control_button.h"

namespace geargraph {
namespace {

constexpr int kLeastAsked = 6;  // teeth: below, gears can hardly be made

QFrame* partLine(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setProperty("look", "rule");
  line->setFixedHeight(1);
  return line;
}

/// "/ratios/2/held/0" as row 2 and "held"; none for pointers elsewhere.
struct RatioPlace {
  int row = -1;
  QString member;
};
RatioPlace ratioPlaceOf(const std::string& pointer) {
  const QStringList steps = QString::fromStdString(pointer).split(QLatin1Char('/'));
  if (steps.size() < 3 || steps[1] != QLatin1String("ratios")) return {};
  return {steps[2].toInt(), steps.size() > 3 ? steps[3] : QString()};
}

}  // namespace

TeethWishForm::TeethWishForm(QWidget* parent)
    : QWidget(parent),
      m_rows(new QVBoxLayout),
      m_wheels(new WheelsList(this)),
      m_limits(new QGridLayout),
      m_problem(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 8, 8, 8);
  layout->setSpacing(6);
  auto* add = controlButton(QStringLiteral("addRatio"), tr("+ Ratio"),
                            tr("Another ratio of the same train: all of them have to be met"), this);
  connect(add, &QToolButton::clicked, this, [this] {
    addRatio();
    emit edited();
  });
  addTitle(*layout, tr("Wanted"), add);
  m_rows->setSpacing(2);
  layout->addLayout(m_rows);
  makeMeant(*layout);
  layout->addWidget(partLine(this));
  addTitle(*layout, tr("Wheels"), nullptr);
  layout->addWidget(m_wheels);
  connect(m_wheels, &WheelsList::edited, this, &TeethWishForm::edited);
  layout->addWidget(partLine(this));
  auto* defaults = controlButton(QStringLiteral("defaultLimits"), tr("Defaults"),
                                 tr("The limits as they are at first"), this);
  connect(defaults, &QToolButton::clicked, this, [this] {
    toDefaults();
    emit edited();
  });
  addTitle(*layout, tr("Limits"), defaults);
  makeLimits();
  layout->addLayout(m_limits);
  m_problem->setObjectName(QStringLiteral("limitsProblem"));
  m_problem->setProperty("look", "problem");
  m_problem->setWordWrap(true);
  m_problem->hide();
  layout->addWidget(m_problem);
  layout->addStretch(1);
  toDefaults();
  addRatio();
}

QLabel* TeethWishForm::addTitle(QVBoxLayout& layout, const QString& text, QWidget* atEnd) {
  auto* title = new QLabel(text, this);
  title->setProperty("look", "title");
  auto* row = new QHBoxLayout;
  row->addWidget(title, 1);
  if (atEnd != nullptr) row->addWidget(atEnd);
  layout.addLayout(row);
  return title;
}

QSpinBox* TeethWishForm::makeSpin(const QString& name, const QString& tip, int least, int most) {
  auto* spin = new QSpinBox(this);
  spin->setObjectName(name);
  spin->setRange(least, most);
  spin->setToolTip(tip);
  spin->setAccessibleName(tip);
  connect(spin, &QSpinBox::valueChanged, this, &TeethWishForm::edited);
  return spin;
}

QLineEdit* TeethWishForm::makeField(const QString& name, const QString& tip) {
  auto* field = new QLineEdit(this);
  field->setObjectName(name);
  field->setToolTip(tip);
  field->setAccessibleName(tip);
  field->setMaxLength(kMaxTyped);
  connect(field, &QLineEdit::textEdited, this, &TeethWishForm::edited);
  return field;
}

QCheckBox* TeethWishForm::makeCheck(const QString& name, const QString& text, const QString& tip) {
  auto* check = new QCheckBox(text, this);
  check->setObjectName(name);
  check->setToolTip(tip);
  connect(check, &QCheckBox::toggled, this, &TeethWishForm::edited);
  return check;
}

/// A row: its title in a column of its own, and the fields side by side.
void TeethWishForm::addLimit(const QString& title, std::initializer_list<QWidget*> fields) {
  const int row = m_limits->rowCount();
  auto* label = new QLabel(title, this);
  label->setProperty("look", "hint");
  label->setWordWrap(true);
  m_limits->addWidget(label, row, 0);
  auto* beside = new QHBoxLayout;
  beside->setSpacing(6);
  for (QWidget* field : fields) beside->addWidget(field, qobject_cast<QLabel*>(field) == nullptr ? 1 : 0);
  m_limits->addLayout(beside, row, 1);
}

void TeethWishForm::makeMeant(QVBoxLayout& layout) {
  const MeantTeethOptions usual;
  m_isMeant = makeCheck(QStringLiteral("meantTeeth"), tr("stated: which teeth were meant?"),
                        tr("The ratios are those that somebody states, and the drawn teeth are in doubt: "
                           "looks for teeth near them with all of these ratios, by the fewest wheels"));
  m_near = new QWidget(this);
  m_differing = makeSpin(QStringLiteral("meantWheels"), tr("Wheels that may differ from the drawn ones"), 1,
                         kMaxMeantWheels);
  m_differing->setValue(usual.wheels);
  m_by = makeSpin(QStringLiteral("meantBy"), tr("Teeth by which each of them may differ"), 1, kMaxMeantTeeth);
  m_by->setValue(usual.by);
  auto* near = new QGridLayout(m_near);
  near->setContentsMargins(0, 0, 0, 0);
  near->setVerticalSpacing(4);
  near->setColumnStretch(1, 1);
  for (const auto& [title, spin] :
       {std::pair(tr("Wheels that differ"), m_differing), std::pair(tr("Teeth apart"), m_by)}) {
    auto* label = new QLabel(title, m_near);
    label->setProperty("look", "hint");
    label->setWordWrap(true);
    const int row = near->rowCount();
    near->addWidget(label, row, 0);
    near->addWidget(spin, row, 1);
  }
  layout.addWidget(m_isMeant);
  layout.addWidget(m_near);
  connect(m_isMeant, &QCheckBox::toggled, this, &TeethWishForm::showMeant);
  m_near->hide();
}

/// Limits on numbers of teeth are those of a new choice: of meant teeth the drawn ones are the middle.
void TeethWishForm::showMeant() {
  const bool isMeant = m_isMeant->isChecked();
  m_near->setVisible(isMeant);
  for (QWidget* limit : std::initializer_list<QWidget*>{m_fewest, m_most, m_mostRing, m_stock, m_once})
    limit->setEnabled(!isMeant);
}

std::optional<MeantTeethOptions> TeethWishForm::meant() const {
  if (!m_isMeant->isChecked()) return std::nullopt;
  return MeantTeethOptions{m_by->value(), m_differing->value()};
}

void TeethWishForm::makeLimits() {
  m_limits->setHorizontalSpacing(8);
  m_limits->setVerticalSpacing(4);
  m_limits->setColumnStretch(1, 1);
  m_fewest =
      makeSpin(QStringLiteral("fewestTeeth"), tr("Fewest teeth of a wheel"), kLeastAsked, kMaxSearchedTeeth);
  m_most = makeSpin(QStringLiteral("mostTeeth"), tr("Most teeth of a gear"), kLeastAsked, kMaxSearchedTeeth);
  m_mostRing = makeSpin(QStringLiteral("mostRingTeeth"), tr("Most teeth of a ring gear"), kLeastAsked,
                        kMaxSearchedTeeth);
  m_planets = makeSpin(QStringLiteral("wishedPlanets"),
                       tr("Equal planets at equal distances that have to go in and to clear each other"), 0,
                       kMaxWishedPlanets);
  m_planets->setSpecialValueText(tr("as drawn"));
  m_slack = makeSpin(QStringLiteral("slack"),
                     tr("Whole teeth by which the sums of two pairs between the same axes may differ; a "
                        "profile shift makes up for it"),
                     0, kMaxSlack);
  m_module = new QComboBox(this);
  m_module->setObjectName(QStringLiteral("moduleChoice"));
  m_module->addItem(tr("one for all"), QStringLiteral("one"));
  m_module->addItem(tr("free for each pair"), QStringLiteral("free"));
  m_module->setToolTip(tr("With one module, pairs between the same two axes have one sum of teeth"));
  m_module->setAccessibleName(tr("Module"));
  m_module->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(m_module, &QComboBox::activated, this, &TeethWishForm::edited);
  m_stock =
      makeField(QStringLiteral("stock"), tr("The only teeth that there are, such as 8 16 24 40; empty: any"));
  m_stock->setPlaceholderText(tr("any, or only these: 8 16 24 40"));
  m_efficiency = makeField(QStringLiteral("wishedEfficiency"),
                           tr("Efficiency of every mesh; empty: as the document states, if it does"));
  m_least = makeField(QStringLiteral("leastEfficiency"),
                      tr("The least efficiency that every ratio must have; empty: any"));
  m_once = makeCheck(QStringLiteral("stockOnce"), tr("each of these once"),
                     tr("Of the wheels that are listed each is used once at most"));
  m_keepsDistances = makeCheck(QStringLiteral("keepsDistances"), tr("axes stay where they are"),
                               tr("Centre distances and modules stay as they are"));
  m_hunting = makeCheck(QStringLiteral("onlyHunting"), tr("only with hunting teeth"),
                        tr("No two teeth meet again before each has met all others"));
  m_noUndercut = makeCheck(QStringLiteral("noUndercut"), tr("no undercut"),
                           tr("No gear has fewer teeth than a rack cuts without undercut and profile shift"));
  addLimit(tr("Teeth"), {m_fewest, new QLabel(QStringLiteral("–"), this), m_most});
  addLimit(tr("Rings to"), {m_mostRing});
  addLimit(tr("Planets"), {m_planets});
  addLimit(tr("Module"), {m_module});
  addLimit(tr("Slack"), {m_slack});
  addLimit(tr("In stock"), {m_stock});
  addLimit(tr("η of a mesh"), {m_efficiency});
  addLimit(tr("Least η"), {m_least});
  for (QCheckBox* check : {m_once, m_keepsDistances, m_hunting, m_noUndercut})
    m_limits->addWidget(check, m_limits->rowCount(), 0, 1, 2);
}

void TeethWishForm::toDefaults() {
  const QSignalBlocker quiet(this);
  const TeethWish usual;
  m_fewest->setValue(usual.fewest);
  m_most->setValue(usual.most);
  m_mostRing->setValue(usual.mostRing);
  m_planets->setValue(usual.planets);
  m_slack->setValue(usual.slack);
  m_module->setCurrentIndex(0);
  m_stock->clear();
  m_efficiency->setText(shownText(localizedNumber("0.98")));
  m_least->clear();
  for (QCheckBox* check : {m_once, m_keepsDistances, m_hunting, m_noUndercut}) check->setChecked(false);
}

void TeethWishForm::addRatio() {
  if (m_ratios.size() >= std::size_t{kMaxWishedRatios}) return;
  auto* row = new RatioRow(m_made++, this);
  if (m_mechanism) row->setMechanism(*m_mechanism);
  connect(row, &RatioRow::edited, this, &TeethWishForm::edited);
  connect(row, &RatioRow::removeWanted, this, [this, row] { removeRatio(row); });
  m_ratios.push_back(row);
  m_rows->addWidget(row);
  updateRemovable();
}

void TeethWishForm::askForRatio() {
  m_ratios.front()->askForRatio();
}

void TeethWishForm::reset(const MechanismPtr& mechanism) {
  for (RatioRow* row : std::exchange(m_ratios, {})) {
    row->hide();
    row->deleteLater();
  }
  m_made = 0;
  m_mechanism = mechanism;
  m_isMeant->setChecked(false);
  m_wheels->reset();
  toDefaults();
  addRatio();
}

void TeethWishForm::removeRatio(RatioRow* row) {
  if (m_ratios.size() < 2) return;
  m_ratios.erase(std::find(m_ratios.begin(), m_ratios.end(), row));
  row->hide();
  row->deleteLater();
  updateRemovable();
  emit edited();
}

void TeethWishForm::updateRemovable() {
  for (RatioRow* row : m_ratios) row->setRemovable(m_ratios.size() > 1);
}

void TeethWishForm::setMechanism(const MechanismPtr& mechanism) {
  m_mechanism = mechanism;
  m_wheels->forgetUnknown(*mechanism);
  for (RatioRow* row : m_ratios) row->setMechanism(*mechanism);
}

bool TeethWishForm::isWhole() const {
  return std::all_of(m_ratios.begin(), m_ratios.end(), [](const RatioRow* row) { return row->hasRatio(); });
}

void TeethWishForm::writeLimits(JsonWriter& json) const {
  static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
  const QStringList stock = m_stock->text().split(between, Qt::SkipEmptyParts);
  int fewest = m_fewest->value();
  // A wheel that is listed is meant, however small.
  for (const QString& teeth : stock)
    if (const int number = teeth.toInt(); number > 0) fewest = std::min(fewest, number);
  json.member("fewest", fewest);
  json.member("most", m_most->value());
  json.member("mostRing", m_mostRing->value());
  if (m_planets->value() > 0) json.member("planets", m_planets->value());
  json.member("slack", m_slack->value());
  json.member("module", m_module->currentData().toString().toStdString());
  if (m_keepsDistances->isChecked()) json.member("distances", "kept");
  if (m_hunting->isChecked()) json.member("hunting", true);
  if (m_noUndercut->isChecked()) json.member("undercut", false);
  if (!stock.isEmpty()) {
    json.key("wheels");
    json.beginArray(JsonWriter::Layout::row);
    for (const QString& teeth : stock) {
      bool isWhole = false;
      const int number = teeth.toInt(&isWhole);
      isWhole ? json.number(std::int64_t{number}) : json.string(teeth.toStdString());
    }
    json.endArray();
    if (m_once->isChecked()) json.member("once", true);
  }
}

std::string TeethWishForm::wish() const {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.key("ratios");
    json.beginArray();
    for (const RatioRow* row : m_ratios) row->write(json);
    json.endArray();
    writeLimits(json);
    if (!m_wheels->kept().empty()) {
      json.key("kept");
      json.beginArray(JsonWriter::Layout::row);
      for (const std::string& name : m_wheels->kept()) json.string(name);
      json.endArray();
    }
    const std::string mesh = plainNumber(m_efficiency->text());
    const std::string least = plainNumber(m_least->text());
    if (!mesh.empty() || !least.empty()) {
      json.key("efficiency");
      json.beginObject(JsonWriter::Layout::row);
      if (!mesh.empty()) json.member("mesh", mesh);
      if (!least.empty()) json.member("least", least);
      json.endObject();
    }
    json.endObject();
  }
  return sink.take();
}

void TeethWishForm::setRatiosNow(const std::vector<std::optional<Rational>>& ratios) {
  for (std::size_t row = 0; row < m_ratios.size(); ++row)
    m_ratios[row]->setRatioNow(row < ratios.size() ? ratios[row] : std::nullopt);
}

QString TeethWishForm::showProblems(const Diagnostics& problems) {
  QStringList ofLimits;
  QStringList others;
  std::vector<std::pair<QString, QString>> ofRows(m_ratios.size());
  for (QLineEdit* field : {m_stock, m_efficiency, m_least}) markField(*field, false);
  for (const Diagnostic& problem : problems) {
    const QString text = shownText(problem.message);
    const RatioPlace place = ratioPlaceOf(problem.pointer);
    const std::pair<const char*, QLineEdit*> fields[] = {
        {"/wheels", m_stock}, {"/efficiency/mesh", m_efficiency}, {"/efficiency/least", m_least}};
    for (const auto& [pointer, field] : fields)
      if (problem.pointer.rfind(pointer, 0) == 0) markField(*field, true);
    if (place.row >= 0 && static_cast<std::size_t>(place.row) < ofRows.size()) {
      auto& [member, said] = ofRows[static_cast<std::size_t>(place.row)];
      if (said.isEmpty()) member = place.member;
      said += (said.isEmpty() ? QString() : QStringLiteral(" ")) + text;
    } else if (!problem.pointer.empty()) {
      ofLimits << text;
    } else {
      others << text;
    }
  }
  for (std::size_t row = 0; row < m_ratios.size(); ++row)
    m_ratios[row]->setProblem(ofRows[row].first, ofRows[row].second);
  m_problem->setText(ofLimits.join(QLatin1Char('\n')));
  m_problem->setVisible(!ofLimits.isEmpty());
  return others.join(QLatin1Char('\n'));
}

}  // namespace geargraph

#include "moc_wish_form.cpp"
