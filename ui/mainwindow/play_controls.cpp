#include "ui/mainwindow/play_controls.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "core/foundations/base/locale.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"

namespace geargraph {
namespace {

constexpr int kSteps = 60;    // from the middle to either end
constexpr int kMagnetic = 3;  // steps around the middle that count as it

double speedAt(int step) {
  return std::pow(PlayControls::kFastest, static_cast<double>(step) / kSteps);
}

int stepAt(double speed) {
  if (speed == 0) return -kSteps;
  return static_cast<int>(std::lround(kSteps * std::log(std::abs(speed)) / std::log(PlayControls::kFastest)));
}

}  // namespace

QString printedSpeed(double speed) {
  const QString text = QString::number(std::abs(speed), 'f', std::abs(speed) < 0.95 ? 2 : 1)
                           .replace(QLatin1Char('.'), QLatin1Char(decimalSign()));
  return (speed < 0 ? QStringLiteral("−") : QString()) + text + QStringLiteral("×");
}

PlayControls::PlayControls(Playback* playback, QWidget* parent)
    : QWidget(parent),
      m_playback(playback),
      m_play(new QToolButton(this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_speed(new QLabel(this)) {
  m_play->setObjectName(QStringLiteral("play"));
  m_play->setFocusPolicy(Qt::TabFocus);
  m_slider->setObjectName(QStringLiteral("playSpeed"));
  m_slider->setRange(-kSteps, kSteps);
  m_slider->setPageStep(kSteps / 3);
  m_slider->setFixedWidth(118);
  m_slider->setFocusPolicy(Qt::TabFocus);
  m_slider->setToolTip(tr("How fast the motion is shown; a double click is 1.0×"));
  m_slider->setAccessibleName(tr("Speed of the motion"));
  m_slider->installEventFilter(this);
  m_speed->setProperty("look", "hint");
  m_speed->setObjectName(QStringLiteral("playSpeedText"));
  m_speed->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("−0.13×")));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(m_play);
  row->addWidget(m_slider);
  row->addWidget(m_speed);

  connect(m_play, &QToolButton::clicked, playback, &Playback::toggle);
  connect(m_slider, &QSlider::valueChanged, playback, [playback](int step) {
    const double sign = playback->speed() < 0 ? -1 : 1;
    playback->setSpeed(sign * (std::abs(step) <= kMagnetic ? 1 : speedAt(step)));
  });
  connect(playback, &Playback::playingChanged, this, &PlayControls::updateButton);
  connect(playback, &Playback::speedChanged, this, &PlayControls::showSpeed);
  updateButton();
  showSpeed();
}

void PlayControls::updateButton() {
  const bool playing = m_playback->isPlaying();
  m_play->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play"), ColorRole::accent,
                       themeOf(palette())));
  m_play->setToolTip(playing ? tr("Pause the motion (Space)") : tr("Play the motion (Space)"));
  m_play->setAccessibleName(playing ? tr("Pause") : tr("Play"));
}

void PlayControls::showSpeed() {
  const QSignalBlocker quiet(m_slider);
  if (speedAt(m_slider->value()) != std::abs(m_playback->speed())) {
    m_slider->setValue(stepAt(m_playback->speed()));
  }
  m_speed->setText(printedSpeed(m_playback->speed()));
}

bool PlayControls::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_slider && event->type() == QEvent::MouseButtonDblClick) {
    m_slider->setValue(0);
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void PlayControls::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && m_speed != nullptr && m_playback != nullptr) updateButton();
}

}  // namespace geargraph

#include "moc_play_controls.cpp"
