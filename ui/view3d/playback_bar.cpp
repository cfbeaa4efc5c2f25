#include "ui/view3d/playback_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/models/printed_number.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kSteps = 2000;
constexpr double kSpanWithoutPeriod = 60;  // s
constexpr double kMaxTenths = 99.9;        // s: longer times are told in seconds

/// `span`: of the times that are shown; short ones are told in milliseconds.
QString seconds(double value, double span) {
  constexpr double kShort = 0.5;
  const int digits = span < kShort ? 3 : value < kMaxTenths + 0.05 ? 1 : 0;
  return printedNumber(value, digits, 'f');
}

/// "1/4×", "2×"; backwards with a minus.
QString speedText(double speed) {
  const double size = std::abs(speed);
  const QString number = size < 1 && std::round(1 / size) == 1 / size ? QStringLiteral("1/%1").arg(1 / size)
                                                                      : printedNumber(size, 3);
  return (speed < 0 ? QStringLiteral("−") : QString()) + number + QStringLiteral("×");
}

}  // namespace

PlaybackBar::PlaybackBar(Playback* playback, QWidget* parent)
    : QWidget(parent),
      m_playback(playback),
      m_scrub(new QSlider(Qt::Horizontal, this)),
      m_time(new QLabel(this)) {
  QToolButton* back = addButton("view3dStepBack", QStringLiteral("‹"), tr("One step back (,)"));
  m_play = addButton("view3dPlay", {}, {});
  QToolButton* on = addButton("view3dStep", QStringLiteral("›"), tr("One step on (.)"));
  m_speed = addButton("view3dSpeed", {}, tr("Speed and direction"));
  makeSpeedMenu();
  m_scrub->setObjectName("view3dScrub");
  m_scrub->setRange(0, kSteps);
  m_scrub->setFocusPolicy(Qt::TabFocus);
  m_time->setObjectName("view3dTime");
  m_time->setProperty("look", "hint");
  m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_endTrajectory = addButton("view3dEndTrajectory", tr("Torques ×"),
                              tr("The motion that the torques of Dynamics cause is shown. Click to let the "
                                 "inputs run at their speeds again"));
  connect(m_endTrajectory, &QToolButton::clicked, this, &PlaybackBar::trajectoryEnded);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 6, 6);
  row->setSpacing(2);
  for (QWidget* button : {back, m_play, on}) row->addWidget(button);
  row->addWidget(m_endTrajectory);
  row->addWidget(m_scrub, 1);
  row->addSpacing(6);
  row->addWidget(m_time);
  row->addWidget(m_speed);

  connect(m_play, &QToolButton::clicked, playback, &Playback::toggle);
  connect(back, &QToolButton::clicked, playback, [playback] { playback->step(-1); });
  connect(on, &QToolButton::clicked, playback, [playback] { playback->step(+1); });
  connect(m_scrub, &QSlider::sliderPressed, playback, [playback] { playback->setPlaying(false); });
  connect(m_scrub, &QSlider::valueChanged, playback,
          [this, playback](int step) { playback->setTime(start() + span() * step / kSteps); });
  connect(playback, &Playback::timeChanged, this, &PlaybackBar::showTime);
  connect(playback, &Playback::playingChanged, this, &PlaybackBar::refresh);
  connect(playback, &Playback::rangeChanged, this, &PlaybackBar::refresh);
  connect(playback, &Playback::speedChanged, this, &PlaybackBar::showSpeed);
  setAlongTrajectory(false);
  showSpeed();
}

QToolButton* PlaybackBar::addButton(const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

void PlaybackBar::makeSpeedMenu() {
  auto* menu = new QMenu(m_speed);
  for (const int halvings : {4, 3, 2, 1, 0, -1, -2, -3}) {
    const double speed = std::ldexp(1, -halvings);
    menu->addAction(speedText(speed), m_playback,
                    [this, speed] { m_playback->setSpeed(std::copysign(speed, m_playback->speed())); });
  }
  menu->addSeparator();
  QAction* backwards =
      menu->addAction(tr("Backwards"), m_playback, [this] { m_playback->setSpeed(-m_playback->speed()); });
  backwards->setObjectName("view3dBackwards");
  backwards->setCheckable(true);
  connect(menu, &QMenu::aboutToShow, backwards,
          [this, backwards] { backwards->setChecked(m_playback->speed() < 0); });
  m_speed->setMenu(menu);
  m_speed->setPopupMode(QToolButton::InstantPopup);
}

void PlaybackBar::showSpeed() {
  m_speed->setText(speedText(m_playback->speed()));
}

double PlaybackBar::span() const {
  const double round = m_playback->period() > 0 ? m_playback->period() : kSpanWithoutPeriod;
  const double limited = m_playback->to() - m_playback->from();
  return std::isfinite(limited) && limited > 0 ? limited : round;
}

double PlaybackBar::start() const {
  if (std::isfinite(m_playback->from())) return m_playback->from();
  return std::isfinite(m_playback->to()) ? m_playback->to() - span() : 0;
}

void PlaybackBar::setAlongTrajectory(bool along) {
  m_endTrajectory->setVisible(along);
  m_scrub->setToolTip(along ? tr("Drag through the motion that the torques cause")
                            : tr("Drag through one period of the motion"));
  refresh();
}

void PlaybackBar::setDark(bool dark) {
  m_dark = dark;
  refresh();
}

// Another icon is set where it is another: the bar lies on the picture, which is painted with it.
void PlaybackBar::refresh() {
  const bool hasContrast = themeOf(palette()) == Theme::highContrast;
  const std::pair wanted(m_playback->isPlaying(), hasContrast ? Theme::highContrast
                                                  : m_dark    ? Theme::dark
                                                              : Theme::light);
  if (m_icon != wanted) {
    m_icon = wanted;
    m_play->setIcon(icon(wanted.first ? QStringLiteral("pause") : QStringLiteral("play"), ColorRole::accent,
                         wanted.second));
    m_play->setToolTip(wanted.first ? tr("Pause (Space)") : tr("Play (Space)"));
  }
  showTime();
}

void PlaybackBar::showTime() {
  const double time = m_playback->time();
  const QSignalBlocker quiet(m_scrub);
  const double rounds = (time - start()) / span();
  const double place = m_playback->isLimited() ? rounds : rounds - std::floor(rounds);
  m_scrub->setValue(static_cast<int>(std::lround(kSteps * place)));
  // Of a fixed size, that grows with what it has to show: else every tick would lay out the window anew.
  const QString longest = timeText(std::min(m_playback->isLimited() ? start() : span(), kMaxTenths));
  const bool isOther = std::exchange(m_longest, longest) != longest;
  QSize room = m_time->minimumSize();
  if (isOther) {
    m_time->setText(longest);
    room = m_time->sizeHint();
  }
  m_time->setText(timeText(time));
  const QSize wanted = room.expandedTo(m_time->sizeHint());
  if (m_time->minimumSize() != wanted) m_time->setFixedSize(wanted);
}

QString PlaybackBar::timeText(double time) const {
  if (m_playback->isLimited()) {
    const QString low = seconds(start(), span());
    return tr("%1 s (%2 … %3)").arg(seconds(time, span()), low, seconds(start() + span(), span()));
  }
  const QString now = seconds(time, span());
  return m_playback->period() > 0 ? tr("%1 s / %2 s").arg(now, seconds(span(), span())) : tr("%1 s").arg(now);
}

void PlaybackBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange && event->type() != QEvent::StyleChange) return;
  m_longest.clear();
  showTime();
}

}  // namespace geargraph

#include "moc_playback_bar.cpp"
