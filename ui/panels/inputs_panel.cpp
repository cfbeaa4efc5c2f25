#include "ui/panels/inputs_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/matroid/input_roles.h"
#include "ui/models/link_text.h"
#include "ui/models/speed_unit.h"
#include "ui/models/term_tips.h"
#include "ui/panels/engagement_edits.h"
#include "ui/panels/number_field.h"
#include "ui/panels/rate_label.h"
#include "ui/panels/results_delegate.h"
#include "ui/panels/speed_slider.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/laid_out_at_once.h"

namespace geargraph {
namespace {

/// Rows that are made at once: each is half a dozen widgets, and a train may have thousands of inputs.
constexpr std::size_t kRowsAtOnce = 30;
/// With more of them every change of the list holds the window.
constexpr std::size_t kMaxRows = 90;

/// rad/s, or lengths a second, at the ends of a slider that is made for this speed.
int rangeFor(const Number& speed) {
  return std::max(2, static_cast<int>(std::min(1e6, std::ceil(2 * std::abs(speed.value())))));
}

}  // namespace

InputsPanel::InputsPanel(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_list(new QWidget(this)),
      m_grid(new QGridLayout(m_list)),
      m_mostRows(kRowsAtOnce) {
  m_empty =
      emptyLabel(this, tr("No joint is driven yet. Choose the input tool (I), then click a turning joint."));
  m_empty->setObjectName(QStringLiteral("noInputs"));
  m_more = new QToolButton(this);
  m_more->setObjectName(QStringLiteral("moreInputs"));
  m_more->setProperty("look", "control");
  connect(m_more, &QToolButton::clicked, this, [this] {
    m_mostRows = std::min(kMaxRows, m_mostRows + kRowsAtOnce);
    renew();
  });
  m_choose = new QToolButton(this);
  m_choose->setObjectName(QStringLiteral("chooseInputs"));
  m_choose->setProperty("look", "control");
  connect(m_choose, &QToolButton::clicked, this, [this] { drive(m_snapshot->matroid()->choice.joints); });
  m_engaged = new QLabel(this);
  m_engaged->setObjectName(QStringLiteral("engaged"));
  m_engaged->setWordWrap(true);
  m_release = new QToolButton(this);
  m_release->setObjectName(QStringLiteral("releaseAll"));
  m_release->setProperty("look", "control");
  m_release->setText(tr("Release all"));
  m_release->setToolTip(tr("Release every brake and clutch; the motion goes on (Ctrl+B)"));
  connect(m_release, &QToolButton::clicked, this, [this] { m_document->apply(releaseAllEdit()); });
  auto* engaged = new QHBoxLayout;
  engaged->setContentsMargins(16, 8, 12, 0);
  engaged->addWidget(m_engaged, 1);
  engaged->addWidget(m_release, 0, Qt::AlignTop);
  m_grid->setContentsMargins(16, 8, 16, 4);
  m_grid->setHorizontalSpacing(10);
  m_grid->setVerticalSpacing(4);
  m_grid->setColumnStretch(2, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(engaged);
  layout->addWidget(m_list);
  layout->addWidget(m_more, 0, Qt::AlignHCenter);
  layout->addWidget(m_empty);
  layout->addWidget(m_choose, 0, Qt::AlignHCenter);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  connect(document, &Document::changed, this, &InputsPanel::renew);
  connect(document, &Document::replaced, this, &InputsPanel::startAnew);
  renew();
}

std::string InputsPanel::titleOf(JointId joint) const {
  const ElementIndex& index = m_document->elements();
  const TurningJoint& turning = *index.find(joint);
  std::string title = index.labelOf(joint).value();
  for (const LinkId link : {turning.head, turning.tail})
    title += ' ' + index.labelOf(link).value() + ' ' + index.find(link)->name;
  return title + ' ' + unitOfRate(*m_document->mechanism(), slides(turning)).toStdString();
}

/// Rows of the former document stay where joints have the same ids, and sliders the range of the speeds.
void InputsPanel::startAnew() {
  m_mostRows = kRowsAtOnce;
  std::size_t kept = 0;
  while (kept < std::min(m_rows.size(), m_mostRows) &&
         m_rows[kept].range == rangeFor((*m_document->mechanism()->inputs)[kept].speed))
    ++kept;
  removeRows(kept);
  renew();
}

void InputsPanel::renew() {
  static const std::vector<Input> kNone;
  const auto& stated = m_document->mechanism()->inputs;
  const std::vector<Input>& inputs = stated ? *stated : kNone;
  const std::size_t shown = std::min(inputs.size(), m_mostRows);
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < shown; ++i) titles.push_back(titleOf(inputs[i].joint));
  std::size_t kept = 0;
  while (kept < std::min(m_rows.size(), shown) && m_rows[kept].joint == inputs[kept].joint) ++kept;
  removeRows(kept);
  if (m_rows.size() < shown) {
    const LaidOutAtOnce added(m_list);
    while (m_rows.size() < shown) {
      m_rows.push_back(makeRow(inputs[m_rows.size()], static_cast<int>(m_rows.size())));
      showTitle(m_rows.back());
    }
  }
  for (std::size_t i = 0; i < kept; ++i)
    if (m_shownTitles[i] != titles[i]) showTitle(m_rows[i]);
  m_list->setVisible(shown > 0);
  m_shownTitles = std::move(titles);
  for (std::size_t i = 0; i < shown; ++i) showSpeed(m_rows[i], inputs[i].speed);
  m_more->setText(tr("Show more: %1 of %2 inputs are listed").arg(shown).arg(inputs.size()));
  m_more->setVisible(shown < inputs.size());
  m_more->setEnabled(shown < kMaxRows);
  m_more->setToolTip(m_more->isEnabled() ? QString() : tr("At most %1 inputs are listed.").arg(kMaxRows));
  m_empty->setVisible(inputs.empty());
  updateEngaged();
}

/// "Engaged: state 1, with A (2 held), C (1 = 6)".
void InputsPanel::updateEngaged() {
  constexpr int kMaxNames = 12;
  const Mechanism& mechanism = *m_document->mechanism();
  const bool any = !mechanism.engaged.empty();
  m_engaged->setVisible(any);
  m_release->setVisible(any);
  if (!any) return;
  const ElementIndex& index = m_document->elements();
  const auto label = [&](LinkId link) { return shownText(index.labelOf(link).value()); };
  QStringList names;
  for (const ShiftElementId id : mechanism.engaged) {
    const ShiftElement& coupling = *mechanism.find(id);
    const QString holds =
        coupling.kind == ShiftElementKind::brake
            ? tr("link %1 held").arg(label(coupling.links.front()))
            : tr("links %1 and %2 as one").arg(label(coupling.links.front()), label(coupling.links.back()));
    names << tr("%1 (%2)").arg(shownText(id.text()), holds);
    if (names.size() == kMaxNames) {
      names << QStringLiteral("…");
      break;
    }
  }
  const int state = engagedState(mechanism);
  const QString list = names.join(QStringLiteral(", "));
  m_engaged->setText(state < 0
                         ? tr("Engaged: %1").arg(list)
                         : tr("Engaged: state %1, with %2")
                               .arg(shownText(mechanism.states[static_cast<std::size_t>(state)].name), list));
}

void InputsPanel::removeRows(std::size_t first) {
  for (std::size_t i = first; i < m_rows.size(); ++i) {
    for (QWidget* widget : m_rows[i].widgets) removeFrom(*m_grid, widget);
  }
  m_rows.resize(std::min(m_rows.size(), first));
}

/// Its title is still to be shown.
InputsPanel::Row InputsPanel::makeRow(const Input& input, int line) {
  Row row;
  row.joint = input.joint;
  row.dot = new QLabel(m_list);
  row.name = new RateLabel(m_list);
  row.slider = new SpeedSlider(m_list);
  row.field = new NumberField(m_list);
  row.field->setFixedWidth(76);
  row.field->setStep(Rational(1, 10));
  row.field->setAlignment(Qt::AlignCenter);
  row.unit = new QLabel(m_list);
  row.unit->setProperty("look", "hint");
  row.exchange = makeExchange(input.joint);
  row.widgets = {row.dot, row.name, row.slider, row.field, row.unit, row.exchange};
  int column = 0;
  for (QWidget* widget : row.widgets) {
    m_grid->addWidget(widget, line, column++);
    widget->setProperty("joint", shownText(input.joint.text()));
    widget->installEventFilter(this);
  }

  row.range = rangeFor(input.speed);
  row.field->setQuantity(Quantity::speed);
  connect(row.slider, &SpeedSlider::sliderPressed, this, [this] { m_gesture = m_document->newGesture(); });
  connect(row.field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(row.slider, &SpeedSlider::valueChanged, this, [this, id = row.joint, range = row.range](int steps) {
    setSpeed(id, Number(Rational(steps, SpeedSlider::kSteps) * Rational(range)));
  });
  connect(row.field, &NumberField::wrongChanged, row.field, [field = row.field](const QString& why) {
    QToolTip::showText(field->mapToGlobal(QPoint(0, field->height())), why, field);
  });
  connect(row.field, &NumberField::edited, this, [this, id = row.joint](const std::optional<Number>& speed) {
    if (speed) setSpeed(id, *speed);
  });
  return row;
}

/// Labels change with every link that is added or deleted.
void InputsPanel::showTitle(const Row& row) {
  const ElementIndex& index = m_document->elements();
  const TurningJoint& joint = *index.find(row.joint);
  const QString jointLabel = shownText(index.labelOf(row.joint).value());
  const QString head = shownText(index.labelOf(joint.head).value());
  const QString tail = shownText(index.labelOf(joint.tail).value());
  const std::string& headName = index.find(joint.head)->name;
  const QString words = relativeText(head, headName, tail);

  row.dot->setPixmap(
      linkDot(m_document->mechanism()->view.colorNumber(joint.head, head.toInt()), devicePixelRatioF()));
  row.dot->setAccessibleName(tr("Colour of link %1").arg(head));
  row.name->setRate(jointLabel, words);
  const QString meaning = slides(joint)
                              ? tr("Speed of joint %1: how fast %2 slides along %3. Positive: in the "
                                   "direction of the axis.")
                              : tr("Speed of joint %1: how fast %2 turns relative to %3. Positive: "
                                   "about the direction of the axis, by the right-hand rule.");
  row.name->setToolTip(
      meaning.arg(jointLabel, linkText(head, headName), linkText(tail, index.find(joint.tail)->name)));
  row.unit->setText(unitOfRate(*m_document->mechanism(), slides(joint)));
  if (slides(joint)) {
    row.field->setLengthRate(m_document->mechanism()->unit);
  } else {
    row.field->setLengthUnit(std::nullopt);
  }
  row.slider->setObjectName(QStringLiteral("slider.") + jointLabel);
  row.slider->setAccessibleName(tr("Speed of joint %1, %2").arg(jointLabel, words));
  row.field->setObjectName(QStringLiteral("speed.") + jointLabel);
  row.field->setAccessibleName(row.slider->accessibleName());
  row.exchange->setObjectName(QStringLiteral("exchange.") + jointLabel);
}

QToolButton* InputsPanel::makeExchange(JointId joint) {
  auto* button = new QToolButton(m_list);
  button->setText(QStringLiteral("⇄"));
  button->setProperty("look", "control");
  button->setToolTip(tr("Drive another joint instead; the motion stays as it is"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  button->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu, joint] {
    menu->clear();
    fillExchange(*menu, joint);
  });
  return button;
}

/// Every other joint: those that leave the set valid can be chosen, the others say what stands against it.
void InputsPanel::fillExchange(QMenu& menu, JointId input) {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  const bool isFresh = m_snapshot && m_snapshot->revision == m_document->mechanicsRevision();
  if (!isFresh || matroid == nullptr || !matroid->solution || matroid->solution->matrix.empty()) {
    menu.addAction(tr("Nothing is solved yet"))->setEnabled(false);
    return;
  }
  const LiveSolution& solution = *matroid->solution;
  const Digraph& graph = *m_snapshot->graph;
  const auto place = std::find_if(solution.inputs.begin(), solution.inputs.end(),
                                  [&](int joint) { return graph.edgeId(joint) == ElementId(input); });
  if (place == solution.inputs.end()) return;
  const QString label = QString::number(graph.edgeLabel(*place));
  for (const int output : solution.outputs) {
    const std::vector<int> commanders = commandersOf(solution, output);
    const QString name = QString::number(graph.edgeLabel(output));
    if (std::find(commanders.begin(), commanders.end(), *place) != commanders.end()) {
      std::vector<int> joints = solution.inputs;
      joints[static_cast<std::size_t>(place - solution.inputs.begin())] = output;
      QAction* action = menu.addAction(tr("Joint %1 instead of %2").arg(name, label), this,
                                       [this, joints] { drive(joints); });
      connect(action, &QAction::hovered, this, [this, id = graph.edgeId(output)] { m_selection->hover(id); });
      continue;
    }
    QStringList others;
    for (const int commander : commanders) others << QString::number(graph.edgeLabel(commander));
    menu.addAction(others.isEmpty() ? tr("Joint %1 never turns").arg(name)
                                    : tr("Joint %1 does not depend on %2; it could replace %3")
                                          .arg(name, label, others.join(tr(" or "))))
        ->setEnabled(false);
  }
}

void InputsPanel::drive(const std::vector<int>& joints) {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (matroid == nullptr) return;
  std::vector<Input> inputs;
  for (const int joint : joints) {
    Number speed(1);
    if (m_snapshot->solved && m_snapshot->solved->exact) {
      speed = Number(m_snapshot->solved->exact->rates[static_cast<std::size_t>(joint)]);
    } else if (matroid->solution) {
      speed = Number::fromDouble(matroid->solution->rates[static_cast<std::size_t>(joint)]);
    }
    inputs.push_back({JointId(m_snapshot->graph->edgeId(joint).id), speed, {}});
  }
  m_selection->unhover();
  m_document->apply(
      {tr("Choose inputs"), [inputs](const Mechanism& before) { return withInputs(before, inputs); }, 0});
}

void InputsPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  updateEmptyText();
  updateChoice();
}

/// What the empty panel says depends on whether there is anything to drive.
void InputsPanel::updateEmptyText() {
  const MatroidAnalysis* matroid = m_snapshot->matroid();
  if (m_snapshot->mechanism->t() == 0) {
    m_empty->setText(tr("There is nothing to drive yet. Draw a turning joint: T, then drag."));
  } else if (matroid != nullptr && matroid->dof == 0) {
    m_empty->setText(tr("There is nothing to drive: the mechanism has no degree of freedom."));
  } else {
    m_empty->setText(tr("No joint is driven yet. Choose the input tool (I), then click a turning joint."));
  }
}

/// A valid set is one click away where there is none.
void InputsPanel::updateChoice() {
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  const bool needed = matroid != nullptr && !matroid->choice.joints.empty() &&
                      (!matroid->inputsGiven || !matroid->choice.wantedIsValid());
  m_choose->setVisible(needed);
  if (!needed) return;
  constexpr std::size_t kMaxNames = 8;
  QStringList names;
  for (std::size_t i = 0; i < matroid->choice.joints.size() && i < kMaxNames; ++i)
    names << QString::number(m_snapshot->graph->edgeLabel(matroid->choice.joints[i]));
  if (matroid->choice.joints.size() > kMaxNames) names << QStringLiteral("…");
  m_choose->setText(names.size() == 1 ? tr("Drive joint %1").arg(names.front())
                                      : tr("Drive joints %1").arg(names.join(QStringLiteral(", "))));
}

void InputsPanel::showSpeed(Row& row, const Number& speed) {
  row.field->setNumber(speed);
  const QSignalBlocker quiet(row.slider);
  row.slider->setValue(
      static_cast<int>(std::lround(std::clamp(speed.value() / row.range, -1.0, 1.0) * SpeedSlider::kSteps)));
}

void InputsPanel::setSpeed(JointId joint, const Number& speed) {
  m_document->apply({tr("Set speed"),
                     [joint, speed](const Mechanism& mechanism) -> Expected<Mechanism> {
                       auto inputs = mechanism.inputs;
                       if (!inputs) return mechanism;
                       for (Input& input : *inputs) {
                         if (input.joint == joint) input.speed = speed;
                       }
                       return withInputs(mechanism, std::move(inputs));
                     },
                     m_gesture});
}

bool InputsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) {
    const JointId joint(watched->property("joint").toString().toStdString());
    const TurningJoint* found = m_document->mechanism()->find(joint);
    if (found != nullptr) m_selection->hover({ElementId(joint), ElementId(found->head)});
  } else if (event->type() == QEvent::Leave) {
    m_selection->unhover();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_inputs_panel.cpp"
