#include "ui/forces/efficiency_card.h"

#include <QBoxLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/panels/mesh_efficiency_field.h"

namespace geargraph {
namespace {

constexpr int kSteps = 200;       ///< of the slider from 0 to 1
constexpr int kLeastSteps = 100;  ///< it begins at 0.5
constexpr int kMaxLinks = 100;    ///< formulas of larger trains are too long to be read
constexpr std::size_t kMaxLetters = 400;
constexpr int kMaxMeshes = 500;  ///< some 80 solutions are needed to find where it locks

bool isSolved(const std::optional<LossySolution>& solution) {
  return solution && solution->outcome == LossySolution::Outcome::solved;
}

void workOut(const ForcesPtr& forces, const Service<ForcesPtr, EfficiencyAnswerPtr>::Responder& respond) {
  const AnalysisSnapshot& snapshot = *forces->solved;
  const Mechanism& mechanism = *snapshot.mechanism;
  const KinematicModel& model = *snapshot.kinematics->model;
  const Placement& placement = snapshot.kinematics->placement();
  StaticsOptions options = optionsOf(forces->question);
  auto answer = std::make_shared<EfficiencyAnswer>();
  answer->forces = forces;
  if (mechanism.c() <= kMaxMeshes && hasLockingLimits(*forces->report)) {
    answer->limits = lockingLimits(mechanism, model, placement, *forces->report, options, respond.stop());
    if (respond.stop().stop_requested()) return;
    respond.partly(std::make_shared<const EfficiencyAnswer>(*answer));
  }
  if (isSolved(forces->report->lossy) && mechanism.n() <= kMaxLinks) {
    options.symbolic = true;
    const auto symbolic = analyzeStatics(mechanism, model, placement, *snapshot.kinematics->ttGraph,
                                         *snapshot.matroid(), options, respond.stop());
    if (!symbolic) return;
    if (symbolic->efficiency) answer->formula = symbolic->efficiency->toText();
    if (answer->formula.size() > kMaxLetters) answer->formula.clear();
  }
  respond(std::move(answer));
}

/// "(i9*i10 + eta9*eta10)/(i9*i10 + 1)" with its indices set lower and its powers higher.
QString formulaHtml(const std::string& text) {
  static const QRegularExpression kPower(QStringLiteral("\\^(\\d+)"));
  static const QRegularExpression kName(QStringLiteral("(i|eta)(\\d+)"));
  QString html = shownText(text).toHtmlEscaped();
  html.replace(kPower, QStringLiteral("<sup>\\1</sup>"));
  html.replace(kName, QStringLiteral("\\1<sub>\\2</sub>"));
  html.replace(QLatin1String("eta"), QStringLiteral("\u03B7"));
  html.replace(QLatin1Char('*'), QStringLiteral("\u2009"));
  return html.replace(QLatin1Char('-'), QChar(0x2212));
}

QString limitText(double limit) {
  return shownText(shownNumber(std::round(limit * 1e4) / 1e4));
}

/// Where self-locking begins: along one efficiency, or in per cent of the losses that the meshes state.
QString lockingText(const LockingLimits& limits) {
  const bool isForward = limits.forward.has_value();
  const std::optional<LockingBracket>& bracket = isForward ? limits.forward : limits.backward;
  const bool areStated = limits.scale == LockingScale::statedLosses;
  if (!bracket) {
    return areStated ? EfficiencyCard::tr("Never self-locking, however large the losses")
                     : EfficiencyCard::tr("Never self-locking, at any efficiency");
  }
  if (!bracket->isProven) {
    if (areStated) {
      const QString percent = limitText(100 * bracket->moves);
      return isForward
                 ? EfficiencyCard::tr("Moves up to %1 % of these losses; beyond, not decided").arg(percent)
                 : EfficiencyCard::tr("Moves backward up to %1 % of these losses; beyond, not decided")
                       .arg(percent);
    }
    const QString eta = limitText(bracket->moves);
    return isForward ? EfficiencyCard::tr("Moves down to η = %1; below, not decided").arg(eta)
                     : EfficiencyCard::tr("Moves backward down to η = %1; below, not decided").arg(eta);
  }
  const double middle = (bracket->moves + bracket->locks) / 2;
  if (areStated) {
    const QString percent = limitText(100 * middle);
    return isForward ? EfficiencyCard::tr("Self-locking from %1 % of these losses on").arg(percent)
                     : EfficiencyCard::tr("Self-locking backward from %1 % of these losses on").arg(percent);
  }
  return isForward ? EfficiencyCard::tr("Self-locking below η = %1").arg(limitText(middle))
                   : EfficiencyCard::tr("Self-locking backward below η = %1").arg(limitText(middle));
}

/// What that means, and the two values between which it begins.
QString lockingTip(const LockingLimits& limits) {
  QString tip = EfficiencyCard::tr(
      "Where a train locks itself, no torque of what holds the loads moves them, however large.");
  const bool areStated = limits.scale == LockingScale::statedLosses;
  tip += QLatin1Char(' ');
  tip += areStated ? EfficiencyCard::tr(
                         "The meshes state different efficiencies: all their losses, 1 − η, are "
                         "multiplied by one factor.")
                   : EfficiencyCard::tr("The efficiency counts as the same in all meshes.");
  const std::optional<LockingBracket>& bracket = limits.forward ? limits.forward : limits.backward;
  if (!bracket) return tip;
  const auto value = [&](double limit) {
    return printedNumber(areStated ? 100 * limit : limit, areStated ? 4 : 6, 'f');
  };
  tip += QLatin1Char('\n');
  tip += areStated ? EfficiencyCard::tr("At %1 % it moves, at %2 % no choice of driving gears solves it.")
                         .arg(value(bracket->moves), value(bracket->locks))
                   : EfficiencyCard::tr("At η = %1 it moves, at %2 no choice of driving gears solves it.")
                         .arg(value(bracket->moves), value(bracket->locks));
  if (!bracket->isProven) {
    tip += QLatin1Char(' ');
    tip += EfficiencyCard::tr("Of that many meshes not all choices were tried.");
  }
  return tip;
}

bool doMeshesStateLosses(const Mechanism& mechanism) {
  return !mechanism.gearMeshes.empty() &&
         std::all_of(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                     [](const GearMesh& mesh) { return mesh.efficiency || mesh.friction; });
}

}  // namespace

EfficiencyCard::EfficiencyCard(Document* document, QWidget* parent)
    : QFrame(parent),
      m_document(document),
      m_answers(new Answers(&workOut, this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_field(new MeshEfficiencyField(document, this)),
      m_own(new QLabel(this)),
      m_locking(new QLabel(this)),
      m_formula(new QLabel(this)) {
  setProperty("look", "card");
  setObjectName(QStringLiteral("efficiencyCard"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(2);
  auto* title = new QLabel(tr("Efficiency"), this);
  title->setProperty("look", "title");
  layout->addWidget(title);
  makeMover();
  m_own->setObjectName(QStringLiteral("ownLosses"));
  m_own->setProperty("look", "hint");
  m_own->setWordWrap(true);
  m_own->setToolTip(
      tr("An efficiency or a coefficient of friction of a mesh is among its properties; friction becomes an "
         "efficiency by the teeth that touch."));
  layout->addWidget(m_own);
  makeValue("forward", tr("forward"), tr("Power taken over power fed."));
  makeValue("backward", tr("backward"),
            tr("The efficiency of the same motion with all known torques reversed: the output drives."));
  for (QLabel* label : {m_locking, m_formula}) {
    label->setWordWrap(true);
    label->setProperty("look", "hint");
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(label);
  }
  m_locking->setObjectName(QStringLiteral("selfLocking"));
  m_formula->setObjectName(QStringLiteral("efficiencyFormula"));
  m_formula->setTextFormat(Qt::RichText);
  m_formula->setToolTip(
      tr("i: the teeth of the tail's gear over those of the head's; η: the efficiency of a "
         "mesh. It holds as long as the same gears drive."));
  layout->addStretch(1);
  m_answers->onAnswer(this, [this](const EfficiencyAnswerPtr&) { showAnswer(); });
  connect(document, &Document::changed, this, &EfficiencyCard::showStated);
  connect(m_answers, &Answers::failed, this, [this] {
    m_locking->clear();
    m_formula->clear();
  });
  showStated();
  show(nullptr);
}

void EfficiencyCard::makeMover() {
  const QString meaning = MeshEfficiencyField::meaning();
  auto* title = new QLabel(tr("η of a mesh"), this);
  title->setProperty("look", "hint");
  title->setToolTip(meaning);
  m_slider->setObjectName(QStringLiteral("meshEfficiencySlider"));
  m_slider->setRange(kLeastSteps, kSteps);
  m_slider->setAccessibleName(tr("Efficiency of a mesh"));
  m_slider->setMinimumWidth(60);
  m_field->setObjectName(QStringLiteral("meshEfficiency"));
  m_slider->setToolTip(meaning);
  connect(m_slider, &QSlider::actionTriggered, this, [this] {
    if (!m_slider->isSliderDown()) m_gesture = m_document->newGesture();
  });
  connect(m_slider, &QSlider::sliderPressed, this, [this] { m_gesture = m_document->newGesture(); });
  connect(m_slider, &QSlider::valueChanged, this, [this](int steps) {
    MeshEfficiencyField::apply(*m_document, Number(Rational(steps, kSteps)), m_gesture);
  });
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  row->addWidget(title);
  row->addWidget(m_slider, 1);
  row->addWidget(m_field);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

/// Its title, the fraction, the decimal.
void EfficiencyCard::makeValue(const char* name, const QString& title, const QString& meaning) {
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(title, this);
  auto* exact = new QLabel(this);
  exact->setObjectName(QStringLiteral("exact.") + QLatin1String(name));
  exact->setProperty("look", "hint");
  auto* value = new QLabel(this);
  value->setObjectName(QStringLiteral("total.") + QLatin1String(name));
  value->setProperty("look", "number");
  value->setWhatsThis(meaning);
  for (QLabel* each : {exact, value}) each->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (QLabel* each : {label, exact, value}) each->setToolTip(meaning);
  row->addWidget(label);
  row->addStretch(1);
  row->addWidget(exact);
  row->addWidget(value);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

/// What the document states.
void EfficiencyCard::showStated() {
  const Mechanism& mechanism = *m_document->mechanism();
  const std::optional<Number> stated =
      mechanism.gearDefaults ? mechanism.gearDefaults->efficiency : std::nullopt;
  const QSignalBlocker quiet(m_slider);
  m_slider->setValue(stated ? qRound(stated->value() * kSteps) : kSteps);
  const bool hasFriction = mechanism.gearDefaults && mechanism.gearDefaults->friction;
  const bool isUseless = doMeshesStateLosses(mechanism);
  m_slider->setEnabled(!isUseless);
  m_slider->setToolTip(isUseless     ? tr("Every mesh states an efficiency or a friction of its own.")
                       : hasFriction ? tr("An efficiency replaces the coefficient of friction that the "
                                          "document states for all meshes.")
                                     : m_field->toolTip());
  m_own->setText(ownLosses());
  m_own->setVisible(!m_own->text().isEmpty());
}

/// "Friction 0.05 in all meshes that state nothing. Meshes 9 (η 0.99) and 10 (μ 0.04) state their own."
QString EfficiencyCard::ownLosses() const {
  const Mechanism& mechanism = *m_document->mechanism();
  QStringList sentences;
  if (mechanism.gearDefaults && mechanism.gearDefaults->friction)
    sentences += tr("Coefficient of friction μ = %1 of meshes that state none")
                     .arg(withPrintedMinus(shownText(mechanism.gearDefaults->friction->text())));
  constexpr qsizetype kMaxNames = 4;
  QStringList own;
  int count = 0;
  for (int i = 0; i < mechanism.c(); ++i) {
    const GearMesh& mesh = mechanism.gearMeshes[static_cast<std::size_t>(i)];
    if (!mesh.efficiency && !mesh.friction) continue;
    ++count;
    if (own.size() == kMaxNames) continue;
    own += mesh.efficiency
               ? tr("mesh %1: η = %2").arg(mechanism.meshLabel(i)).arg(shownText(mesh.efficiency->text()))
               : tr("mesh %1: μ = %2").arg(mechanism.meshLabel(i)).arg(shownText(mesh.friction->text()));
  }
  if (count > own.size()) own += tr("%1 more").arg(count - own.size());
  if (!own.empty()) sentences += own.join(QStringLiteral(", "));
  return sentences.join(QStringLiteral("; "));
}

void EfficiencyCard::show(const ForcesPtr& forces) {
  if (forces && forces == m_forces) return;
  m_forces = forces;
  showValues();
  ask();
}

void EfficiencyCard::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  ask();
}

void EfficiencyCard::showValues() {
  const StaticsReport none;
  const StaticsReport& report = m_forces && m_forces->report ? *m_forces->report : none;
  showValue("forward", report.lossy, report.sums);
  showValue("backward", report.backward, report.backwardSums);
}

void EfficiencyCard::showValue(const char* name, const std::optional<LossySolution>& solution,
                               const std::optional<PowerSums>& sums) {
  QString text = QStringLiteral("–");
  QString exact;
  if (solution && solution->outcome == LossySolution::Outcome::selfLocking) text = tr("locks itself");
  const auto value = isSolved(solution) && sums ? sums->efficiency() : std::nullopt;
  if (value) text = shownText(shownNumber(value->number()));
  if (value && value->isExact()) exact = shownText(shownReal(*value));
  auto* label = findChild<QLabel*>(QStringLiteral("total.") + QLatin1String(name));
  label->setText(text);
  label->setToolTip(exact.isEmpty() ? label->whatsThis()
                                    : label->whatsThis() + QLatin1Char('\n') + tr("Exactly %1").arg(exact));
  constexpr int kMaxDigits = 14;
  findChild<QLabel*>(QStringLiteral("exact.") + QLatin1String(name))
      ->setText(exact.size() <= kMaxDigits ? exact : QString());
}

/// Only while it is seen.
void EfficiencyCard::ask() {
  const bool canFollow = m_forces && m_forces->report && m_forces->report->motion &&
                         m_forces->solved->matroid() != nullptr && m_forces->report->isSolved;
  if (!canFollow) {
    m_answers->cancel();
    m_locking->clear();
    m_formula->clear();
    return;
  }
  if (!isVisible()) return;
  const EfficiencyAnswerPtr& answer = m_answers->answer();
  if (answer && answer->forces == m_forces && m_answers->isComplete()) return showAnswer();
  m_answers->request(m_forces);
}

void EfficiencyCard::showAnswer() {
  const EfficiencyAnswerPtr& answer = m_answers->answer();
  if (!answer || answer->forces != m_forces) return;
  m_locking->clear();
  if (answer->limits) {
    m_locking->setText(lockingText(*answer->limits));
    m_locking->setToolTip(lockingTip(*answer->limits));
  }
  m_formula->setText(answer->formula.empty() ? QString()
                                             : QStringLiteral("η = ") + formulaHtml(answer->formula));
}

QString EfficiencyCard::formula() const {
  return m_formula->text();
}

QString EfficiencyCard::locking() const {
  return m_locking->text();
}

}  // namespace geargraph

#include "moc_efficiency_card.cpp"
