#include "ui/panels/inputs_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/mechanism/edits.h"
#include "ui/panels/number_field.h"
#include "ui/panels/rate_label.h"
#include "ui/panels/results_delegate.h"
#include "ui/panels/speed_slider.h"
#include "ui/panels/term_tips.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

QPixmap linkDot(int label, qreal ratio) {
  QPixmap pixmap(qRound(12 * ratio), qRound(12 * ratio));
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintLinkDot(painter, {6, 6}, label);
  return pixmap;
}

/// "8 4": the labels of the joint and of the link that it drives.
std::string titleOf(const Mechanism& mechanism, JointId id) {
  const TurningJoint& joint = *mechanism.find(id);
  return labelOf(mechanism, id).value() + ' ' + labelOf(mechanism, joint.head).value();
}

}  // namespace

InputsPanel::InputsPanel(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_grid(new QGridLayout) {
  m_empty =
      new QLabel(tr("No joint is driven yet. Choose the input tool (I), then click a turning joint."), this);
  m_empty->setProperty("look", "empty");
  m_empty->setWordWrap(true);
  m_empty->setAlignment(Qt::AlignCenter);
  m_grid->setContentsMargins(16, 12, 16, 8);
  m_grid->setHorizontalSpacing(10);
  m_grid->setVerticalSpacing(8);
  m_grid->setColumnStretch(2, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(m_grid);
  layout->addWidget(m_empty);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  connect(document, &Document::changed, this, &InputsPanel::renew);
  renew();
}

void InputsPanel::renew() {
  const Mechanism& mechanism = *m_document->mechanism();
  const std::vector<Input> inputs = mechanism.inputs.value_or(std::vector<Input>{});
  std::vector<std::string> titles;
  for (const Input& input : inputs) titles.push_back(titleOf(mechanism, input.joint));
  const bool sameJoints =
      std::equal(inputs.begin(), inputs.end(), m_rows.begin(), m_rows.end(),
                 [](const Input& input, const Row& row) { return input.joint == row.joint; });
  if (!sameJoints || titles != m_shownTitles) {
    m_shownTitles = titles;
    rebuild(mechanism);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) showSpeed(m_rows[i], inputs[i].speed);
  m_empty->setVisible(inputs.empty());
}

void InputsPanel::rebuild(const Mechanism& mechanism) {
  for (const Row& row : m_rows) {
    for (QWidget* widget : row.widgets) {
      m_grid->removeWidget(widget);
      widget->hide();
      widget->deleteLater();  // the edit may come from one of them
    }
  }
  m_rows.clear();
  if (!mechanism.inputs) return;
  for (const Input& input : *mechanism.inputs) {
    m_rows.push_back(makeRow(mechanism, input, static_cast<int>(m_rows.size())));
  }
}

InputsPanel::Row InputsPanel::makeRow(const Mechanism& mechanism, const Input& input, int line) {
  Row row;
  row.joint = input.joint;
  const TurningJoint& joint = *mechanism.find(input.joint);
  const QString jointLabel = shownText(labelOf(mechanism, input.joint).value());
  const QString head = shownText(labelOf(mechanism, joint.head).value());
  const QString tail = shownText(labelOf(mechanism, joint.tail).value());

  auto* dot = new QLabel(this);
  dot->setPixmap(linkDot(head.toInt(), devicePixelRatioF()));
  auto* name = new RateLabel(jointLabel, tr("link %1").arg(head), this);
  name->setToolTip(tr("Speed of joint %1: how fast link %2 turns relative to link %3. Positive: about the "
                      "direction of the axis, by the right-hand rule.")
                       .arg(jointLabel, head, tail));
  row.slider = new SpeedSlider(this);
  row.slider->setObjectName(QStringLiteral("slider.") + jointLabel);
  row.field = new NumberField(this);
  row.field->setObjectName(QStringLiteral("speed.") + jointLabel);
  row.field->setFixedWidth(76);
  row.field->setStep(Rational(1, 10));
  row.field->setAlignment(Qt::AlignCenter);
  auto* unit = new QLabel(tr("rad/s"), this);
  unit->setProperty("look", "hint");
  row.widgets = {dot, name, row.slider, row.field, unit};
  int column = 0;
  for (QWidget* widget : row.widgets) {
    m_grid->addWidget(widget, line, column++);
    widget->setProperty("joint", shownText(input.joint.text()));
    widget->installEventFilter(this);
  }

  const double size = std::abs(input.speed.value());
  row.range = std::max(2, static_cast<int>(std::min(1e6, std::ceil(2 * size))));
  connect(row.slider, &SpeedSlider::sliderPressed, this, [this] { m_gesture = m_document->newGesture(); });
  connect(row.field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(row.slider, &SpeedSlider::valueChanged, this, [this, id = row.joint, range = row.range](int steps) {
    setSpeed(id, Number(Rational(steps, SpeedSlider::kSteps) * Rational(range)));
  });
  connect(row.field, &NumberField::edited, this, [this, id = row.joint](const std::optional<Number>& speed) {
    if (speed) setSpeed(id, *speed);
  });
  return row;
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
