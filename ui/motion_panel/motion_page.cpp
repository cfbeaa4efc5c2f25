#include "ui/motion_panel/motion_page.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "core/theory/dynamics/motion_table.h"
#include "core/theory/pose/joint_limits.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/motion_panel/motors_form.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/sideways_scroll.h"
#include "ui/theme/theme_colors.h"
#include "ui/view3d/motion_plot.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

constexpr int kProgressInterval = 100;  // ms
constexpr int kProgressSteps = 1000;
constexpr int kLeastFormWidth = 190;  // px: an input and its torque

}  // namespace

MotionPage::MotionPage(Selection* selection, View3D* view, QWidget* parent)
    : QWidget(parent),
      m_selection(selection),
      m_view(view),
      m_simulations(new SimulationService(this)),
      m_plot(new MotionPlot(this)),
      m_hint(emptyLabel(this)),
      m_pages(new QStackedWidget(this)) {
  m_plot->setObjectName(QStringLiteral("dynamicsPlot"));
  m_pages->addWidget(m_hint);
  m_pages->addWidget(m_plot);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(new SidewaysScroll(makeBar(), this));
  right->addWidget(m_pages, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeLeft());
  layout->addLayout(right, 1);

  m_simulations->onAnswer(this, [this](const SimulatedMotionPtr&) { onMotion(); });
  connect(m_simulations, &SimulationService::failed, this, [this](const QString& why) {
    m_hint->setText(tr("The motion could not be followed: %1").arg(why));
    updateState();
  });
  m_clock.setInterval(kProgressInterval);
  connect(&m_clock, &QTimer::timeout, this,
          [this] { m_progress->setValue(qRound(kProgressSteps * m_simulations->progress())); });
  connect(selection, &Selection::selectionChanged, this, &MotionPage::updatePlot);
  connect(view, &View3D::trajectoryChanged, this, &MotionPage::updateState);
  connect(&view->playback(), &Playback::timeChanged, this, [this](double seconds) {
    if (isPlayed()) m_plot->setTime(seconds);
  });
  connect(m_plot, &MotionPlot::timeWanted, this, [this](double seconds) {
    if (!isPlayed()) play(true);
    m_view->playback().setTime(seconds);
  });
  updateState();
}

QWidget* MotionPage::makeLeft() {
  auto* left = new QWidget(this);
  m_motors = new MotorsForm(left);
  m_run = controlButton(QStringLiteral("simulate"), {}, {}, left);
  connect(m_run, &QToolButton::clicked, this, &MotionPage::startOrHalt);
  m_progress = new QProgressBar(left);
  m_progress->setRange(0, kProgressSteps);
  m_progress->setTextVisible(false);
  m_progress->setFixedHeight(6);
  m_progress->setAccessibleName(tr("How much of the motion is followed"));
  QSizePolicy kept = m_progress->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  m_progress->setSizePolicy(kept);
  auto* scroll = new QScrollArea(left);
  scroll->setWidget(m_motors);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  // In a narrow panel the fields scroll sideways, so that the plot is seen, too.
  scroll->setMinimumWidth(scaledPixels(kLeastFormWidth));
  scroll->setMaximumWidth(std::max(scaledPixels(74 * 4 + 76), m_motors->sizeHint().width()));
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 0, 8, 4);
  row->addWidget(m_run);
  row->addWidget(m_progress, 1);
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(scroll, 1);
  layout->addLayout(row);
  return left;
}

QWidget* MotionPage::makeBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(8, 0, 10, 2);
  layout->setSpacing(4);
  m_quantities = new QButtonGroup(this);
  const std::tuple<const char*, QString, QString> chips[] = {
      {"plotSpeeds", tr("Speeds"),
       tr("Speeds of the inputs, and of the joints that are selected, over time")},
      {"plotTorques", tr("Torques"), tr("Torques of the motors over time")},
      {"plotEnergy", tr("Energy"),
       tr("Kinetic and potential energy, the work of motors and loads, and their "
          "balance, over time")}};
  for (int id = 0; const auto& [name, text, tip] : chips) {
    QToolButton* chip = controlButton(QLatin1String(name), text, tip, bar);
    chip->setProperty("look", "chip");
    chip->setCheckable(true);
    m_quantities->addButton(chip, id++);
    layout->addWidget(chip);
  }
  m_quantities->button(0)->setChecked(true);
  connect(m_quantities, &QButtonGroup::idClicked, this, &MotionPage::updatePlot);
  layout->addStretch(1);
  m_play = controlButton(QStringLiteral("playMotion"), tr("Play in 3D"), {}, bar);
  m_play->setCheckable(true);
  connect(m_play, &QToolButton::clicked, this, &MotionPage::play);
  layout->addWidget(m_play);
  return bar;
}

void MotionPage::show(const DynamicsPtr& dynamics) {
  m_dynamics = dynamics;
  if (dynamics && dynamics->train)
    m_motors->setInputs(*dynamics->snapshot->mechanism, dynamics->train->inputs,
                        dynamics->state.equation.inertia.diagonal());
  updateState();
}

void MotionPage::forget() {
  m_dynamics.reset();
  m_simulations->forget();
  updateState();
}

void MotionPage::startOrHalt() {
  if (isRunning()) return m_simulations->halt();
  if (!m_dynamics || !m_dynamics->train) return;
  SimulationOptions options = m_motors->options();
  options.limits = angleLimits(*m_dynamics->snapshot->mechanism);
  m_snapshot = m_dynamics->snapshot;
  m_simulations->start(m_dynamics->train, std::move(options));
  m_clock.start();
  updateState();
}

void MotionPage::onMotion() {
  const bool wasPlayed = isPlayed();
  m_trajectory = hasMotion() ? trajectoryOf(motion()->simulation) : nullptr;
  if (wasPlayed) m_view->setTrajectory(m_trajectory);
  if (motion() && !hasMotion()) m_hint->setText(verdict());
  updateState();
  updatePlot();
  if (hasMotion()) m_plot->showAll();
  emit motionChanged();
}

bool MotionPage::hasMotion() const {
  return motion() && !motion()->simulation.samples.empty();
}

bool MotionPage::isPlayed() const {
  return m_trajectory && m_view->trajectory() == m_trajectory;
}

/// Buttons, and what stands in the place of the plot.
void MotionPage::updateState() {
  const bool isReady = m_dynamics && m_dynamics->train;
  if (!isRunning()) m_clock.stop();
  m_run->setText(isRunning() ? tr("Stop") : tr("Simulate"));
  m_run->setToolTip(isRunning() ? tr("End the motion where it is now")
                    : isReady   ? tr("Follow the motion that these torques, the loads and weight cause")
                                : tr("There is nothing to move yet"));
  m_run->setEnabled(isReady);
  m_progress->setVisible(isRunning());
  const bool moves = hasMotion() && motion()->simulation.samples.size() > 1;
  m_play->setEnabled(moves);
  m_play->setToolTip(moves ? tr("Show this motion in the 3D view instead of that of the input speeds")
                           : tr("Simulate a motion first"));
  m_play->setChecked(isPlayed());
  if (!motion() && !isRunning())
    m_hint->setText(
        tr("Give the motors their torques, then Simulate: speeds, torques and energy appear here."));
  if (isRunning() && !hasMotion()) m_hint->setText(tr("The motion is being followed …"));
  m_pages->setCurrentWidget(moves ? static_cast<QWidget*>(m_plot) : m_hint);
}

void MotionPage::updatePlot() {
  if (!hasMotion()) return;
  m_plot->setSheet(motionSheet(*m_snapshot->mechanism, *motion(),
                               static_cast<MotionQuantity>(m_quantities->checkedId()),
                               m_selection->selected()));
  m_plot->setTime(isPlayed() ? m_view->playback().time() : 0);
}

void MotionPage::play(bool isWanted) {
  m_view->setTrajectory(isWanted ? m_trajectory : nullptr);
  m_view->playback().setPlaying(isWanted);
}

QString MotionPage::verdict() const {
  if (!motion()) return {};
  const Simulation& simulation = motion()->simulation;
  const int joint = simulation.limitJoint;
  QString end = shownText(endSentence(
      simulation.end, joint < 0 ? std::string() : std::to_string(m_snapshot->graph->edgeLabel(joint))));
  if (simulation.end == SimulationEnd::stopped) end = tr("Stopped.");
  if (simulation.samples.empty()) return end;
  const MotionSample& last = simulation.samples.back();
  const QString balance =
      tr("After %1 s: kinetic energy %2 J, potential %3 J, work of motors and loads %4 J; they balance but "
         "for %5 J.")
          .arg(printedNumber(last.time), printedNumber(last.kinetic), printedNumber(last.potential),
               printedNumber(last.work), printedNumber(std::abs(energyDefect(simulation)), 2));
  return end.isEmpty() ? balance : balance + QLatin1Char(' ') + end;
}

std::optional<std::string> MotionPage::csv(char separator) const {
  if (!hasMotion()) return std::nullopt;
  return motionCsv(*m_snapshot->mechanism, *motion(), separator);
}

}  // namespace geargraph

#include "moc_motion_page.cpp"
