#include "ui/motion_panel/dynamics_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QClipboard>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/models/term_tips.h"
#include "ui/motion_panel/equation_page.h"
#include "ui/motion_panel/inertia_bars.h"
#include "ui/motion_panel/mass_page.h"
#include "ui/motion_panel/motion_page.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/sideways_scroll.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/views.h"

namespace geargraph {

DynamicsPanel::DynamicsPanel(Document* document, Selection* selection, View3D* view, QWidget* parent)
    : QWidget(parent),
      m_view3d(view),
      m_service(new DynamicsService(this)),
      m_pages(new QStackedWidget(this)),
      m_empty(emptyLabel(this)),
      m_remark(new QLabel(this)),
      m_masses(new MassPage(document, selection, this)),
      m_bars(new InertiaBars(selection)),
      m_equation(new EquationPage(selection, this)),
      m_motion(new MotionPage(selection, view, this)) {
  m_remark->setObjectName(QStringLiteral("dynamicsRemark"));
  m_remark->setWordWrap(true);
  m_remark->setProperty("look", "hint");
  m_remark->setContentsMargins(12, 2, 12, 4);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(m_bars);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  for (QWidget* page :
       {static_cast<QWidget*>(m_masses), static_cast<QWidget*>(scroll), static_cast<QWidget*>(m_equation),
        static_cast<QWidget*>(m_motion), static_cast<QWidget*>(m_empty)})
    m_pages->addWidget(page);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(new SidewaysScroll(makeBar(), this));
  layout->addWidget(m_pages, 1);
  layout->addWidget(m_remark);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  m_service->onAnswer(this, [this](const DynamicsPtr&) { showDynamics(); });
  connect(m_service, &DynamicsService::failed, this, [this](const QString& why) {
    m_empty->setText(tr("The dynamics could not be worked out: %1").arg(why));
    m_pages->setCurrentWidget(m_empty);
  });
  connect(&view->playback(), &Playback::timeChanged, this, &DynamicsPanel::ask);
  connect(view, &View3D::contentChanged, this, &DynamicsPanel::ask);
  connect(view, &View3D::trajectoryChanged, this, &DynamicsPanel::ask);
  connect(m_motion, &MotionPage::motionChanged, this, &DynamicsPanel::showRemark);
  showDynamics();
}

QWidget* DynamicsPanel::makeBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(12, 6, 10, 2);
  layout->setSpacing(4);
  m_chips = new QButtonGroup(this);
  const std::tuple<const char*, QString, QString> chips[] = {
      {"chip.masses", tr("Masses"), tr("Mass and moments of inertia of every link, density and gravity")},
      {"chip.inertia", tr("Inertia at the motors"),
       tr("How much of the inertia that each motor feels every link makes up (reflected inertia)")},
      {"chip.equation", tr("Equation of motion"),
       tr("Generalised inertia, Coriolis and centrifugal torques, weight and loads in the inputs")},
      {"chip.motion", tr("Motion"), tr("The motion that torques of the motors cause: simulated and played")}};
  for (int id = 0; const auto& [name, text, tip] : chips) {
    auto* chip = new QToolButton(bar);
    chip->setObjectName(QLatin1String(name));
    chip->setText(text);
    chip->setToolTip(tip);
    chip->setCheckable(true);
    chip->setProperty("look", "chip");
    m_chips->addButton(chip, id++);
    layout->addWidget(chip);
  }
  m_chips->button(0)->setChecked(true);
  connect(m_chips, &QButtonGroup::idClicked, this,
          [this](int id) { showView(static_cast<DynamicsView>(id)); });
  layout->addStretch(1);
  m_copy =
      controlButton(QStringLiteral("copyDynamics"), tr("Copy"), tr("Copy the table for a spreadsheet"), bar);
  connect(m_copy, &QToolButton::clicked, this, [this] {
    if (const auto table = csv('\t'))
      QApplication::clipboard()->setText(QString::fromStdString(table->second));
  });
  layout->addWidget(m_copy);
  m_export = controlButton(QStringLiteral("exportDynamics"), tr("CSV…"),
                           tr("Export the table, or the simulated motion, to a CSV file"), bar);
  connect(m_export, &QToolButton::clicked, this, [this] {
    if (const auto table = csv(',')) emit exportWanted(table->first, QString::fromStdString(table->second));
  });
  layout->addWidget(m_export);
  return bar;
}

DynamicsView DynamicsPanel::view() const {
  return static_cast<DynamicsView>(m_chips->checkedId());
}

void DynamicsPanel::showView(DynamicsView view) {
  m_chips->button(static_cast<int>(view))->setChecked(true);
  showDynamics();
  ask();
}

/// The complete snapshot that follows the live one, and one of other places in the drawings, have the same
/// dynamics.
void DynamicsPanel::setSnapshot(const SnapshotPtr& snapshot) {
  if (m_snapshot && m_snapshot->geometry == snapshot->geometry) return;
  m_snapshot = snapshot;
  m_motion->forget();
  ask();
}

void DynamicsPanel::setAwake(bool awake) {
  m_isAwake = awake;
  ask();
}

/// What depends on the pose is asked for at the moment of the 3D view.
void DynamicsPanel::ask() {
  if (!m_isAwake || !m_snapshot) return;
  InputMoment moment;
  const bool isOfMoment = view() == DynamicsView::inertia || view() == DynamicsView::equation;
  if (const MechanismScenePtr& stage = m_view3d->stage(); stage && isOfMoment) {
    moment.angles = inputAngles(*stage, m_view3d->view());
    moment.speeds = inputSpeeds(*stage, m_view3d->view());
  }
  m_service->request({m_snapshot, std::move(moment)});
}

void DynamicsPanel::showDynamics() {
  const DynamicsPtr& shown = dynamics();
  const bool isThere = shown && shown->train;
  // One that is not in front is renewed when it comes there.
  if (view() == DynamicsView::masses) m_masses->show(shown);
  if (view() == DynamicsView::inertia) m_bars->show(shown);
  if (view() == DynamicsView::equation) m_equation->show(shown);
  if (view() == DynamicsView::motion) m_motion->show(shown);
  if (!isThere)
    m_empty->setText(shown ? shownText(shown->unavailableReason)
                           : tr("Masses and motion appear here as soon as the mechanism is analysed."));
  m_pages->setCurrentIndex(isThere ? m_chips->checkedId() : m_pages->indexOf(m_empty));
  showRemark();
}

void DynamicsPanel::showRemark() {
  const DynamicsPtr& shown = dynamics();
  QString text;
  if (shown && shown->train) {
    if (shown->isMassless)
      text = tr("A motion of the inputs moves no mass: state masses of its links, or give its wheels teeth.");
    else if (view() == DynamicsView::motion)
      text = m_motion->verdict();
    else if (view() != DynamicsView::masses)
      text = tr("At the moment that the 3D view shows.");
  }
  m_remark->setText(text);
  m_remark->setVisible(!text.isEmpty());
  const bool hasTable = shown && shown->train && (view() != DynamicsView::motion || m_motion->hasMotion());
  for (QToolButton* button : {m_copy, m_export}) button->setEnabled(hasTable);
  m_copy->setToolTip(hasTable ? tr("Copy the table for a spreadsheet") : tr("There is nothing to copy yet"));
  m_export->setToolTip(hasTable ? tr("Export the table, or the simulated motion, to a CSV file")
                                : tr("There is nothing to export yet"));
}

QString DynamicsPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

QString DynamicsPanel::remark() const {
  return m_remark->text();
}

std::optional<std::pair<QString, std::string>> DynamicsPanel::csv(char separator) const {
  const DynamicsPtr& shown = dynamics();
  if (!shown || !shown->train) return std::nullopt;
  const auto written = [&](const QString& name, const ValueTable& table) {
    TextSink sink;
    CsvOptions options;
    options.separator = separator;
    writeForceCsv(sink, table, options);
    return std::pair(name, sink.take());
  };
  const Mechanism& mechanism = *shown->snapshot->mechanism;
  switch (view()) {
    case DynamicsView::masses:
      return written(tr("masses.csv"), massTable(mechanism, shown->train->links, shown->metres));
    case DynamicsView::inertia:
      return written(tr("reflected-inertia.csv"), reflectedTable(mechanism, *shown->train, shown->state));
    case DynamicsView::equation:
      return written(tr("equation-of-motion.csv"), equationTable(mechanism, *shown->train, shown->state));
    case DynamicsView::motion:
      break;
  }
  const auto motion = m_motion->csv(separator);
  return motion ? std::optional(std::pair(tr("motion.csv"), *motion)) : std::nullopt;
}

ViewEntry dynamicsView() {
  return {
      .id = QStringLiteral("dynamics"),
      .title = DynamicsPanel::tr("Dynamics"),
      .purpose = DynamicsPanel::tr("Masses, the inertia at each motor, and the motion that torques cause."),
      .helpPage = QStringLiteral("forces-and-dynamics#dynamics"),
      .searchWords = QStringLiteral(
          "mass inertia weight density gravity acceleration simulation dynamic energy equation of motion "
          "motor torque"),
      .place = ViewPlace::bottom,
      .make = [](Views& views, QWidget* parent) -> ResultsView* {
        auto* panel = new DynamicsPanel(views.document(), views.selection(), &views.get<View3D>(), parent);
        QObject::connect(panel, &DynamicsPanel::exportWanted, &views, &Views::tableExportWanted);
        return panel;
      }};
}

}  // namespace geargraph

#include "moc_dynamics_panel.cpp"
