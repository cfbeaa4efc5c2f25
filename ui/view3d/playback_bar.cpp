#include "ui/view3d/playback_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

namespace geargraph {
namespace {

constexpr int kSteps = 2000;
constexpr double kSpanWithoutPeriod = 60;  // s

QString seconds(double value) {
  return QString::number(value, 'f', value < 99.95 ? 1 : 0);
}

}  // namespace

PlaybackBar::PlaybackBar(Playback* playback, QWidget* parent)
    : QWidget(parent),
      m_playback(playback),
      m_play(new QToolButton(this)),
      m_scrub(new QSlider(Qt::Horizontal, this)),
      m_time(new QLabel(this)) {
  m_play->setObjectName("view3dPlay");
  m_play->setAutoRaise(true);
  m_play->setFocusPolicy(Qt::NoFocus);
  m_scrub->setObjectName("view3dScrub");
  m_scrub->setRange(0, kSteps);
  m_scrub->setFocusPolicy(Qt::NoFocus);
  m_scrub->setToolTip(tr("Drag through one period of the motion"));
  m_time->setObjectName("view3dTime");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 10, 6);
  row->addWidget(m_play);
  row->addWidget(m_scrub, 1);
  row->addWidget(m_time);

  connect(m_play, &QToolButton::clicked, playback, &Playback::toggle);
  connect(m_scrub, &QSlider::sliderPressed, playback, [playback] { playback->setPlaying(false); });
  connect(m_scrub, &QSlider::valueChanged, playback,
          [this, playback](int step) { playback->setTime(span() * step / kSteps); });
  connect(playback, &Playback::timeChanged, this, &PlaybackBar::showTime);
  connect(playback, &Playback::playingChanged, this, &PlaybackBar::refresh);
  refresh();
}

double PlaybackBar::span() const {
  return m_playback->period() > 0 ? m_playback->period() : kSpanWithoutPeriod;
}

void PlaybackBar::setDark(bool dark) {
  QPalette palette = m_time->palette();
  palette.setColor(QPalette::WindowText, dark ? QColor(0x98, 0xA1, 0xAE) : QColor(0x6B, 0x73, 0x80));
  m_time->setPalette(palette);
  palette = m_play->palette();
  palette.setColor(QPalette::ButtonText, dark ? QColor(0x6C, 0x9B, 0xFF) : QColor(0x2F, 0x6F, 0xED));
  m_play->setPalette(palette);
}

void PlaybackBar::refresh() {
  m_play->setText(m_playback->isPlaying() ? QStringLiteral("⏸") : QStringLiteral("▶"));
  m_play->setToolTip(m_playback->isPlaying() ? tr("Pause (Space)") : tr("Play (Space)"));
  showTime();
}

void PlaybackBar::showTime() {
  const double time = m_playback->time();
  const QSignalBlocker quiet(m_scrub);
  m_scrub->setValue(
      static_cast<int>(std::lround(kSteps * (time - span() * std::floor(time / span())) / span())));
  m_time->setText(m_playback->period() > 0 ? tr("%1 s / %2 s").arg(seconds(time), seconds(span()))
                                           : tr("%1 s").arg(seconds(time)));
}

}  // namespace geargraph
