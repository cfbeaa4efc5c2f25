#include "ui/forces/question_bar.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QToolButton>
#include <algorithm>

namespace geargraph {

QuestionBar::QuestionBar(QWidget* parent)
    : QWidget(parent),
      m_row(new QWidget(this)),
      m_buttons(new QButtonGroup(this)),
      m_list(new QComboBox(this)),
      m_controls(new QWidget(this)),
      m_layout(new QHBoxLayout(this)) {
  setObjectName(QStringLiteral("forceQuestions"));
  auto* row = new QHBoxLayout(m_row);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  m_list->setObjectName(QStringLiteral("forceQuestion"));
  m_list->setAccessibleName(tr("Question"));
  m_list->setToolTip(tr("What is asked about the torques"));
  for (const QuestionEntry& entry : questionEntries()) {
    auto* button = new QToolButton(m_row);
    button->setText(entry.title);
    button->setObjectName(QStringLiteral("question.") + entry.name);
    button->setToolTip(entry.tip);
    button->setCheckable(true);
    button->setProperty("look", "chip");
    m_buttons->addButton(button, static_cast<int>(entry.question));
    row->addWidget(button);
    m_list->addItem(entry.title, static_cast<int>(entry.question));
    m_list->setItemData(m_list->count() - 1, entry.tip, Qt::ToolTipRole);
  }
  auto* controls = new QHBoxLayout(m_controls);
  controls->setContentsMargins(0, 0, 0, 0);
  controls->setSpacing(4);
  m_layout->setContentsMargins(12, 6, 10, 2);
  m_layout->setSpacing(6);
  m_layout->addWidget(m_row);
  m_layout->addWidget(m_list);
  m_layout->addStretch(1);
  m_layout->addWidget(m_controls);
  m_list->hide();
  connect(m_buttons, &QButtonGroup::idClicked, this,
          [this](int id) { emit asked(static_cast<ForceQuestion>(id)); });
  connect(m_list, &QComboBox::activated, this,
          [this] { emit asked(static_cast<ForceQuestion>(m_list->currentData().toInt())); });
  choose(ForceQuestion::need);
}

void QuestionBar::addControl(QWidget* control) {
  m_controls->layout()->addWidget(control);
}

void QuestionBar::choose(ForceQuestion question) {
  const int id = static_cast<int>(question);
  m_buttons->button(id)->setChecked(true);
  m_list->setCurrentIndex(m_list->findData(id));
}

ForceQuestion QuestionBar::chosen() const {
  return static_cast<ForceQuestion>(m_buttons->checkedId());
}

bool QuestionBar::isFolded() const {
  return !m_list->isHidden();
}

int QuestionBar::widthBeside(const QWidget& questions) const {
  const QMargins margins = m_layout->contentsMargins();
  return margins.left() + questions.sizeHint().width() + 2 * m_layout->spacing() +
         m_controls->sizeHint().width() + margins.right();
}

/// That of the list, or of the controls below it.
QSize QuestionBar::minimumSizeHint() const {
  const QMargins margins = m_layout->contentsMargins();
  const int wider = std::max(m_list->sizeHint().width(), m_controls->sizeHint().width());
  return {margins.left() + wider + margins.right(), m_layout->minimumSize().height()};
}

void QuestionBar::fold() {
  const bool isNarrow = widthBeside(*m_row) > width();
  const bool isBelow = widthBeside(*m_list) > width();
  m_layout->setDirection(isBelow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  if (isNarrow == isFolded()) return;
  const QWidget* focus = QApplication::focusWidget();
  const bool hadFocus = focus != nullptr && (m_row->isAncestorOf(focus) || focus == m_list);
  m_row->setVisible(!isNarrow);
  m_list->setVisible(isNarrow);
  if (hadFocus) (isNarrow ? static_cast<QWidget*>(m_list) : m_buttons->checkedButton())->setFocus();
}

void QuestionBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fold();
}

/// Another font, or a control that appears, changes what has room.
bool QuestionBar::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) fold();
  return QWidget::event(event);
}

}  // namespace geargraph

#include "moc_question_bar.cpp"
