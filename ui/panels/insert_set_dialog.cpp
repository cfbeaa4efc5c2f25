#include "ui/panels/insert_set_dialog.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QStackedWidget>
#include <algorithm>

#include "core/design/synthesis/bevel_sets.h"
#include "core/design/synthesis/drive_sets.h"
#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/design/synthesis/shifting_sets.h"
#include "ui/models/minus_sign.h"
#include "ui/models/printed_number.h"
#include "ui/panels/set_forms.h"
#include "ui/panels/set_preview.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/looks.h"

namespace geargraph {
namespace {

using Counts = std::vector<int>;

constexpr QSize kKindPicture(44, 34);

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

SetForm* faceForm() {
  return new TeethForm(
      {{InsertSetDialog::tr("Pinion"), "facePinion", 18}, {InsertSetDialog::tr("Face gear"), "faceGear", 40}},
      [](const Counts& c) { return faceDrive(c[0], c[1]); });
}

SetForm* hypoidForm() {
  return new TeethForm(
      {{InsertSetDialog::tr("Pinion"), "axlePinion", 10}, {InsertSetDialog::tr("Axle gear"), "axleGear", 41}},
      [](const Counts& c) { return hypoidAxle(c[0], c[1]); });
}

SetForm* beltForm() {
  return new TeethForm({{InsertSetDialog::tr("Driving pulley"), "drivingPulley", 20},
                        {InsertSetDialog::tr("Driven pulley"), "drivenPulley", 40}},
                       [](const Counts& c) {
                         return beltStage({c[0], c[1]});
                       });
}

SetForm* rackForm() {
  return new LengthsForm({{InsertSetDialog::tr("Travel a turn, about"), "travel", RackDrive().travel},
                          {InsertSetDialog::tr("Module"), "rackModule", RackDrive().module}},
                         false, [](const std::vector<Number>& lengths, Hand) {
                           return rackDrive({lengths[0], lengths[1]});
                         });
}

SetForm* screwForm() {
  return new LengthsForm({{InsertSetDialog::tr("Lead, advance of a turn"), "lead", ScrewDrive().lead}}, true,
                         [](const std::vector<Number>& lengths, Hand hand) {
                           return screwDrive({lengths[0], hand});
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

std::vector<InsertableSet> insertableSets() {
  return {
      {"planetary", InsertSetDialog::tr("Planetary set"), []() -> SetForm* { return new PlanetaryForm; },
       [] {
         return planetarySet({24, 18}, 3, PlanetaryUse{});
       }},
      {"reverted", InsertSetDialog::tr("Reverted train"), []() -> SetForm* { return new RevertedForm; },
       [] {
         return revertedTrain({20, 40, 20, 40});
       }},
      {"differential", InsertSetDialog::tr("Bevel differential"), &differentialForm,
       [] { return bevelDifferentialSet(24, 18, 2); }},
      {"ravigneaux", InsertSetDialog::tr("Ravigneaux set"), &ravigneauxForm,
       [] {
         return ravigneauxSet({30, 36, 20, 18}, 3);
       }},
      {"simpson", InsertSetDialog::tr("Simpson set"), &simpsonForm,
       [] {
         return simpsonSet({33, 21}, 3);
       }},
      {"wrist", InsertSetDialog::tr("Bevel wrist"), &wristForm,
       [] {
         return bevelWrist({20, 30, 25, 40, 24, 18});
       }},
      {"worm", InsertSetDialog::tr("Worm stage"), &wormForm,
       [] {
         return wormStage({1, 40});
       }},
      {"face", InsertSetDialog::tr("Face gear drive"), &faceForm, [] { return faceDrive(18, 40); }},
      {"hypoid", InsertSetDialog::tr("Hypoid axle"), &hypoidForm, [] { return hypoidAxle(10, 41); }},
      {"belt", InsertSetDialog::tr("Belt drive"), &beltForm,
       [] {
         return beltStage({20, 40});
       }},
      {"rack", InsertSetDialog::tr("Rack drive"), &rackForm, [] { return rackDrive({}); }},
      {"screw", InsertSetDialog::tr("Screw drive"), &screwForm, [] { return screwDrive({}); }},
      {"strainWave", InsertSetDialog::tr("Strain wave drive"), &strainWaveForm,
       [] { return strainWave(200, 202); }},
      {"cycloidal", InsertSetDialog::tr("Cycloidal drive"), &cycloidalForm,
       [] { return cycloidalDrive(16); }},
      {"rv", InsertSetDialog::tr("RV reducer"), &rvForm, [] { return rvReducer(12, 36, 40); }},
  };
}

InsertSetDialog::InsertSetDialog(QWidget* parent)
    : QDialog(parent),
      m_known(insertableSets()),
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
  m_kinds->setIconSize(kKindPicture);
  for (const InsertableSet& kind : m_known) addKind(kind);
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
  const int bar = m_kinds->verticalScrollBar()->sizeHint().width();
  m_kinds->setFixedWidth(
      std::max(m_kinds->width(), m_kinds->sizeHintForColumn(0) + 4 * m_kinds->spacing() + bar));
  m_kinds->setCurrentRow(0);
}

void InsertSetDialog::addKind(const InsertableSet& kind) {
  auto* item = new QListWidgetItem(kind.name, m_kinds);
  // Room for the picture, which is painted when the dialog is shown.
  QPixmap empty(kKindPicture);
  empty.fill(Qt::transparent);
  item->setIcon(empty);
  SetForm* form = kind.makeForm();
  m_forms->addWidget(form);
  connect(form, &SetForm::changed, this, &InsertSetDialog::renew);
}

void InsertSetDialog::paintKinds() {
  for (std::size_t i = 0; i < m_known.size(); ++i) {
    const auto set = m_known[i].usual();
    if (!set) continue;
    const QPixmap picture = SetPreview::picture(*set, kKindPicture, palette(), devicePixelRatioF());
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) icon.addPixmap(picture, mode);
    m_kinds->item(static_cast<int>(i))->setIcon(icon);  // in the colours of the links also while selected
  }
}

void InsertSetDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  paintKinds();
}

void InsertSetDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && isVisible()) paintKinds();
}

void InsertSetDialog::choose(const QString& kind) {
  for (std::size_t i = 0; i < m_known.size(); ++i) {
    if (kind == QLatin1String(m_known[i].id)) m_kinds->setCurrentRow(static_cast<int>(i));
  }
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
  const auto counted = [](int count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
  };
  QString text = QStringList{counted(set->n(), tr("1 link"), tr("%1 links")),
                             counted(set->t(), tr("1 joint"), tr("%1 joints")),
                             counted(set->c(), tr("1 mesh"), tr("%1 meshes"))}
                     .join(QStringLiteral(", "));
  if (!set->engaged.empty()) text += tr("; brake %1 is engaged").arg(shownText(set->engaged.front().text()));
  if (!set->states.empty())
    text += tr("; %1 couplings and %2 states").arg(set->couplings.size()).arg(set->states.size());
  if (const auto ratio = ratioOfSet(*set)) {
    const auto name = [&](LinkOrdinal link) { return shownText(set->links[link].name); };
    const PiNumber ofTurn = ratio->ofTurn();
    QString moved = ratio->slides ? printedExact(ofTurn) : withMinusSign(ofTurn.toString());
    if (ratio->slides) moved += QLatin1Char(' ') + QString::fromStdString(set->unit);
    if (!ofTurn.isRational()) moved = tr("%1 (%2)").arg(moved, printedNumber(ofTurn.toDouble()));
    const QString words = ratio->slides ? tr("One turn of \"%1\" moves \"%2\" by %3.")
                                        : tr("One turn of \"%1\" turns \"%2\" by %3.");
    text += '\n' + words.arg(name(ratio->input), name(ratio->output), moved);
  }
  m_summary->setText(text);
  m_preview->setMechanism(*set);
}

}  // namespace geargraph

#include "moc_insert_set_dialog.cpp"
