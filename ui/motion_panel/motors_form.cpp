#include "ui/motion_panel/motors_form.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "ui/panels/number_field.h"
#include "ui/theme/laid_out_at_once.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxRows = 40;  // the motors of further inputs give no torque
constexpr int kLawSamples = 1000;
constexpr int kFieldWidths[] = {92, 76, 62, 62};  // px: a torque has more digits than an angle
constexpr double kLeastSeconds = 1e-6, kMaxSeconds = 1e6;
constexpr double kUsualAcceleration = 10;  // rad/s²

/// With one digit, so that it reads well.
Number rounded(double value) {
  if (!(value > 0) || !std::isfinite(value)) return Number(0);
  // By way of its text: a product of powers of ten has a tail of digits.
  return Number::fromDouble(QByteArray::number(value, 'g', 1).toDouble());
}

}  // namespace

MotorsForm::MotorsForm(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout(this)) {
  m_grid->setContentsMargins(12, 0, 8, 0);
  m_grid->setHorizontalSpacing(4);
  m_grid->setVerticalSpacing(2);
  const std::pair<QString, QString> heads[] = {
      {tr("input"), tr("The joint that the motor drives.")},
      {tr("T, N m"), tr("The torque of the motor at rest, by the tail of its joint on the head.")},
      {tr("d, N m s"),
       tr("How much torque the motor loses for each rad/s of its joint: with the torque at rest "
          "over the no-load speed it is a direct-current motor at constant voltage.")},
      {tr("from, °"), tr("The angle of the joint at the start, from the reference pose.")},
      {tr("rad/s"), tr("The speed of the joint at the start.")}};
  int column = 0;
  for (const auto& [text, meaning] : heads) {
    auto* head = new QLabel(text, this);
    head->setProperty("look", "hint");
    head->setToolTip(meaning);
    m_grid->addWidget(head, 0, column++);
  }
  for (int each = 0; const int width : kFieldWidths)
    m_grid->setColumnMinimumWidth(++each, scaledPixels(width));  // also before there are rows
  const QString meaning = tr("How long the motion is followed, in seconds.");
  auto* label = new QLabel(tr("for, s"), this);
  label->setToolTip(meaning);
  m_grid->addWidget(label, static_cast<int>(kMaxRows) + 1, 0);
  NumberField* seconds = makeField(QStringLiteral("seconds"), meaning);
  seconds->setNumber(m_seconds);
  connect(seconds, &NumberField::edited, this, [this, seconds](const std::optional<Number>& value) {
    if (!value || value->value() < kLeastSeconds || value->value() > kMaxSeconds)
      return seconds->reject(tr("The time is %1 s to %2 s.").arg(kLeastSeconds).arg(kMaxSeconds));
    m_seconds = *value;
    seconds->setNumber(m_seconds);
  });
  m_grid->addWidget(seconds, static_cast<int>(kMaxRows) + 1, 1);
  m_grid->setColumnStretch(column, 1);
  m_grid->setRowStretch(static_cast<int>(kMaxRows) + 2, 1);
}

NumberField* MotorsForm::makeField(const QString& name, const QString& meaning) {
  auto* field = new NumberField(this);
  field->setObjectName(name);
  field->setAccessibleName(meaning);
  field->setToolTip(meaning);
  field->setFixedWidth(scaledPixels(kFieldWidths[0]));
  field->setAlignment(Qt::AlignRight);
  return field;
}

void MotorsForm::setInputs(const Mechanism& mechanism, const std::vector<int>& joints,
                           const Eigen::VectorXd& inertias) {
  std::vector<Row> rows;
  QStringList titles;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointId id = mechanism.turningJoints[static_cast<std::size_t>(joints[i])].id;
    const auto known =
        std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.joint == id; });
    const Number torque = rounded(kUsualAcceleration * inertias[static_cast<Eigen::Index>(i)]);
    rows.push_back(known != m_rows.end() ? *known : Row{id, torque, 0, 0, 0});
    titles += QString::number(mechanism.jointLabel(joints[i]));
  }
  const bool isSame =
      titles == m_titles && std::equal(rows.begin(), rows.end(), m_rows.begin(), m_rows.end(),
                                       [](const Row& a, const Row& b) { return a.joint == b.joint; });
  m_rows = std::move(rows);
  m_titles = titles;
  if (!isSame) showRows(mechanism, joints);
}

void MotorsForm::showRows(const Mechanism& mechanism, const std::vector<int>& joints) {
  for (QWidget* widget : std::exchange(m_widgets, {})) removeFrom(*m_grid, widget);
  const LaidOutAtOnce added(this);
  for (int row = 0; row < static_cast<int>(std::min(m_rows.size(), kMaxRows)); ++row) {
    const QString label = QString::number(mechanism.jointLabel(joints[static_cast<std::size_t>(row)]));
    auto* title = new QLabel(label, this);
    title->setToolTip(tr("Joint %1").arg(label));
    m_grid->addWidget(title, row + 1, 0);
    m_widgets.push_back(title);
    addField(QStringLiteral("torque.") + label, tr("Torque of the motor of joint %1, N m").arg(label), row, 1,
             &Row::torque, Quantity::torque);
    addField(QStringLiteral("damping.") + label,
             tr("Torque that the motor of joint %1 loses for each rad/s, N m s").arg(label), row, 2,
             &Row::damping, Quantity::number);
    addField(QStringLiteral("angle.") + label, tr("Angle of joint %1 at the start, degrees").arg(label), row,
             3, &Row::degrees, Quantity::angle);
    addField(QStringLiteral("startSpeed.") + label, tr("Speed of joint %1 at the start, rad/s").arg(label),
             row, 4, &Row::speed, Quantity::speed);
  }
}

void MotorsForm::addField(const QString& name, const QString& meaning, int row, int column,
                          Number Row::*number, Quantity quantity) {
  NumberField* field = makeField(name, meaning);
  field->setQuantity(quantity);
  field->setNumber(m_rows[static_cast<std::size_t>(row)].*number);
  const bool isDamping = number == &Row::damping;
  field->setFixedWidth(scaledPixels(kFieldWidths[column - 1]));
  connect(field, &NumberField::edited, this,
          [this, field, row, number, isDamping](const std::optional<Number>& value) {
            if (!value) return;
            if (isDamping && value->exact().sign() < 0) return field->reject(tr("It is at least 0 N m s."));
            m_rows[static_cast<std::size_t>(row)].*number = *value;
            field->setNumber(*value);
          });
  m_grid->addWidget(field, row + 1, column);
  m_widgets.push_back(field);
}

SimulationOptions MotorsForm::options() const {
  SimulationOptions options;
  const auto inputs = static_cast<Eigen::Index>(m_rows.size());
  options.angles.resize(inputs);
  options.speeds.resize(inputs);
  for (Eigen::Index i = 0; i < inputs; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool isListed = at < kMaxRows;
    options.motors.push_back(isListed ? Motor{m_rows[at].torque.value(), m_rows[at].damping.value()}
                                      : Motor());
    options.angles[i] = m_rows[at].degrees.value() * std::numbers::pi / 180;
    options.speeds[i] = m_rows[at].speed.value();
  }
  options.seconds = m_seconds.value();
  options.interval = options.seconds / kLawSamples;
  return options;
}

}  // namespace geargraph

#include "moc_motors_form.cpp"
