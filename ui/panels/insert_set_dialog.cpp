#include "ui/panels/insert_set_dialog.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>

#include "core/design/synthesis/bevel_sets.h"
#include "core/design/synthesis/drive_sets.h"
#include "core/design/synthesis/shifting_sets.h"
#include "ui/models/minus_sign.h"
#include "ui/panels/set_forms.h"
#include "ui/panels/set_preview.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/looks.h"

namespace geargraph {
namespace {

using Counts = std::vector<int>;

SetForm* differentialForm() {
  return new TeethForm({{InsertSetDialog::tr("Side wheels"), "side", 24},
                        {InsertSetDialog::tr("Pinions' teeth"), "pinion", 18},
                        {InsertSetDialog::tr("Pinions"), "pinions", 2, 1, 8}},
                       [](const Counts& c) { return bevelDifferentialSet(c[0], c[1], c[2]); });
}

SetForm* ravigneauxForm() {
  return new TeethForm({{InsertSetDialog::tr("Small sun"), "smallSun", 30},
                        {InsertSetDialog::tr("Large sun"), "largeSun", 36},
                        {InsertSetDialog::tr("Short planet"), "shortPlanet", 20},
                        {InsertSetDialog::tr("Long planet"), "longPlanet", 18},
                        {InsertSetDialog::tr("Pairs of planets"), "pairs", 3, 1, 6}},
                       [](const Counts& c) {
                         return ravigneauxSet({c[0], c[1], c[2], c[3]}, c[4]);
                       });
}

SetForm* simpsonForm() {
  return new TeethForm({{InsertSetDialog::tr("Suns"), "sun", 33},
                        {InsertSetDialog::tr("Planets' teeth"), "planet", 21},
                        {InsertSetDialog::tr("Planets a set"), "planets", 3, 1, 8}},
                       [](const Counts& c) {
                         return simpsonSet({c[0], c[1]}, c[2]);
                       });
}

SetForm* wristForm() {
  return new TeethForm({{InsertSetDialog::tr("Bend shaft"), "bendShaft", 20},
                        {InsertSetDialog::tr("Bend"), "bend", 30},
                        {InsertSetDialog::tr("Roll shaft"), "rollShaft", 25},
                        {InsertSetDialog::tr("Idler"), "idler", 40},
                        {InsertSetDialog::tr("Idler's pinion"), "idlerPinion", 24},
                        {InsertSetDialog::tr("Tool"), "tool", 18}},
                       [](const Counts& c) -> Expected<Mechanism> {
                         return bevelWrist({c[0], c[1], c[2], c[3], c[4], c[5]});
                       });
}

SetForm* wormForm() {
  return new TeethForm({{InsertSetDialog::tr("Starts of the worm"), "starts", 1, 1, kMaxStarts},
                        {InsertSetDialog::tr("Teeth of the wheel"), "wormWheel", 40}},
                       [](const Counts& c) {
                         return wormStage({c[0], c[1]});
                       });
}

SetForm* beltForm() {
  return new TeethForm({{InsertSetDialog::tr("Driving pulley"), "drivingPulley", 20},
                        {InsertSetDialog::tr("Driven pulley"), "drivenPulley", 40}},
                       [](const Counts& c) {
                         return beltStage({c[0], c[1]});
                       });
}

SetForm* strainWaveForm() {
  return new TeethForm({{InsertSetDialog::tr("Flexspline"), "flexspline", 200},
                        {InsertSetDialog::tr("Circular spline"), "circularSpline", 202}},
                       [](const Counts& c) { return strainWave(c[0], c[1]); });
}

SetForm* cycloidalForm() {
  return new TeethForm({{InsertSetDialog::tr("Pins of the ring"), "pins", 16}},
                       [](const Counts& c) { return cycloidalDrive(c[0]); });
}

SetForm* rvForm() {
  return new TeethForm({{InsertSetDialog::tr("Sun"), "rvSun", 12},
                        {InsertSetDialog::tr("Planet"), "rvPlanet", 36},
                        {InsertSetDialog::tr("Pins of the ring"), "rvPins", 40}},
                       [](const Counts& c) { return rvReducer(c[0], c[1], c[2]); });
}

}  // namespace

InsertSetDialog::InsertSetDialog(QWidget* parent)
    : QDialog(parent),
      m_kinds(new QListWidget(this)),
      m_forms(new QStackedWidget(this)),
      m_preview(new SetPreview(this)),
      m_summary(new QLabel(this)),
      m_insert(new QPushButton(tr("Insert"), this)) {
  setWindowTitle(tr("Insert a set"));
  setObjectName(QStringLiteral("insertSet"));
  m_kinds->setObjectName(QStringLiteral("kinds"));
  m_kinds->setFixedWidth(150);
  m_kinds->setSpacing(3);
  addKind(tr("Planetary set"), new PlanetaryForm);
  addKind(tr("Reverted train"), new RevertedForm);
  addKind(tr("Bevel differential"), differentialForm());
  addKind(tr("Ravigneaux set"), ravigneauxForm());
  addKind(tr("Simpson set"), simpsonForm());
  addKind(tr("Bevel wrist"), wristForm());
  addKind(tr("Worm stage"), wormForm());
  addKind(tr("Belt drive"), beltForm());
  addKind(tr("Strain wave drive"), strainWaveForm());
  addKind(tr("Cycloidal drive"), cycloidalForm());
  addKind(tr("RV reducer"), rvForm());
  m_summary->setWordWrap(true);
  m_summary->setObjectName(QStringLiteral("summary"));
  m_insert->setObjectName(QStringLiteral("insert"));
  m_insert->setDefault(true);
  auto* design = new QPushButton(tr("Gearbox from ratios…"), this);
  design->setObjectName(QStringLiteral("designInstead"));
  design->setToolTip(tr("Search for planetary sets, brakes and clutches that have the ratios you want"));
  design->setAutoDefault(false);
  auto* close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);

  auto* middle = new QHBoxLayout;
  middle->setSpacing(14);
  middle->addWidget(m_kinds);
  middle->addWidget(m_forms, 1);
  middle->addWidget(m_preview, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(design);
  foot->addWidget(m_summary, 1);
  foot->addWidget(close);
  foot->addWidget(m_insert);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(middle, 1);
  layout->addLayout(foot);
  resize(940, 500);

  connect(m_kinds, &QListWidget::currentRowChanged, this, [this](int row) {
    m_forms->setCurrentIndex(row);
    renew();
  });
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(design, &QPushButton::clicked, this, &QDialog::reject);
  connect(design, &QPushButton::clicked, this, &InsertSetDialog::designWanted);
  connect(m_insert, &QPushButton::clicked, this, [this] {
    const auto set = form().set();
    if (!set) return;
    emit insertWanted(*set);
    accept();
  });
  m_kinds->setFixedWidth(std::max(m_kinds->width(), m_kinds->sizeHintForColumn(0) + 4 * m_kinds->spacing()));
  m_kinds->setCurrentRow(0);
}

void InsertSetDialog::addKind(const QString& name, SetForm* form) {
  m_kinds->addItem(name);
  m_forms->addWidget(form);
  connect(form, &SetForm::changed, this, &InsertSetDialog::renew);
}

const SetForm& InsertSetDialog::form() const {
  return static_cast<const SetForm&>(*m_forms->currentWidget());
}

void InsertSetDialog::renew() {
  if (m_kinds->currentRow() < 0) return;
  const auto set = form().set();
  m_insert->setEnabled(set.has_value());
  const ColorRole role = set ? ColorRole::secondary : ColorRole::error;
  setInk(*m_summary, role);
  if (!set) {
    m_summary->setText(shownText(set.error().front().message));
    m_preview->setMechanism(emptyMechanism());
    return;
  }
  QString text = tr("%1 links, %2 joints, %3 meshes").arg(set->n()).arg(set->t()).arg(set->c());
  if (!set->engaged.empty()) text += tr("; brake %1 is engaged").arg(shownText(set->engaged.front().text()));
  if (!set->states.empty())
    text += tr("; %1 couplings and %2 states").arg(set->couplings.size()).arg(set->states.size());
  if (const auto ratio = ratioOfSet(*set)) {
    const auto name = [&](LinkOrdinal link) { return shownText(set->links[link].name); };
    const QString turns = withMinusSign(ratio->speed.toString());
    text += '\n' +
            tr("One turn of \"%1\" turns \"%2\" by %3.").arg(name(ratio->input), name(ratio->output), turns);
  }
  m_summary->setText(text);
  m_preview->setMechanism(*set);
}

}  // namespace geargraph

#include "moc_insert_set_dialog.cpp"
