#include "ui/mainwindow/notice_bar.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"
#include "ui/theme/laid_out_at_once.h"

namespace geargraph {
namespace {
constexpr int kIcon = 16;
}

NoticeBar::NoticeBar(QWidget* parent) : QToolBar(tr("Notices"), parent) {
  setObjectName(QStringLiteral("noticeBar"));
  setProperty("look", "banner");
  setMovable(false);
  toggleViewAction()->setVisible(false);
  auto* strip = new QWidget(this);
  m_layout = new QHBoxLayout(strip);
  m_layout->setContentsMargins(6, 3, 6, 3);
  m_layout->setSpacing(8);
  m_icon = new QLabel(strip);
  m_text = new QLabel(strip);
  m_text->setObjectName(QStringLiteral("noticeText"));
  m_text->setWordWrap(true);
  // Two lines, whatever the width: a label that wraps would ask for the height of its narrowest form.
  m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_text->setTextFormat(Qt::PlainText);
  m_count = new QLabel(strip);
  m_count->setProperty("look", "hint");
  m_layout->addWidget(m_icon);
  m_layout->addWidget(m_text, 1);
  m_layout->addWidget(m_count);
  addWidget(strip);
  m_text->installEventFilter(this);
  fitText();
  renew();
}

/// In the type that there is now: it grows in presentations.
void NoticeBar::fitText() {
  const int height = 2 * m_text->fontMetrics().lineSpacing() + 2;
  if (m_text->minimumHeight() != height) m_text->setFixedHeight(height);
}

bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
  const bool isOther = event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (watched == m_text && isOther) fitText();
  return QToolBar::eventFilter(watched, event);
}

void NoticeBar::post(Notice notice) {
  const auto same = std::find_if(m_notices.begin(), m_notices.end(),
                                 [&](const Notice& each) { return each.key == notice.key; });
  if (notice.isRequired) {
    if (same != m_notices.end()) m_notices.erase(same);
    m_notices.insert(m_notices.begin(), std::move(notice));
  } else if (notice.isNews) {
    if (same != m_notices.end()) m_notices.erase(same);
    const auto place =
        std::find_if(m_notices.begin(), m_notices.end(), [](const Notice& each) { return !each.isRequired; });
    m_notices.insert(place, std::move(notice));
  } else if (same == m_notices.end()) {
    m_notices.push_back(std::move(notice));
  } else {
    *same = std::move(notice);
  }
  renew();
}

void NoticeBar::setText(const QString& key, const QString& text) {
  for (Notice& notice : m_notices) {
    if (notice.key == key) notice.text = text;
  }
  if (m_notices.empty() || m_notices.front().key != key) return;
  m_text->setText(text);
  m_text->setToolTip(text);
}

void NoticeBar::withdraw(const QString& key) {
  std::erase_if(m_notices, [&](const Notice& each) { return each.key == key; });
  renew();
}

void NoticeBar::renew() {
  // A button may be what called us.
  for (QWidget* button : std::exchange(m_buttons, {})) removeFrom(*m_layout, button);
  setVisible(!m_notices.empty());
  if (m_notices.empty()) return;
  const Notice& notice = m_notices.front();
  m_text->setText(notice.text);
  m_text->setToolTip(notice.text);
  m_count->setText(m_notices.size() > 1 ? tr("1 of %1").arg(m_notices.size()) : QString());
  for (const Notice::Answer& answer : notice.answers) {
    auto* button = new QPushButton(answer.text, m_text->parentWidget());
    button->setToolTip(answer.tip);
    connect(button, &QPushButton::clicked, this, [this, key = notice.key, run = answer.run] {
      withdraw(key);
      if (run) run();
    });
    m_layout->addWidget(button);
    button->show();
    m_buttons << button;
  }
  updateIcon();
}

void NoticeBar::updateIcon() {
  if (m_notices.empty()) return;
  const Severity severity = m_notices.front().severity;
  m_icon->setPixmap(iconPixmap(severityIconName(severity), severityRole(severity), themeOf(palette()), kIcon,
                               devicePixelRatioF()));
}

void NoticeBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) updateIcon();
}

}  // namespace geargraph

#include "moc_notice_bar.cpp"
