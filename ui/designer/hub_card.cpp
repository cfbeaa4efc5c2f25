#include "ui/designer/hub_card.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>

#include "core/design/gearboxes/hub_json.h"
#include "ui/canvas/drawing_preview.h"
#include "ui/designer/hub_words.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

HubCard::HubCard(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_drawing(new DrawingPreview(this)),
      m_shared(new QLabel(this)),
      m_open(new QPushButton(tr("Open as document"), this)) {
  m_title->setProperty("look", "title");
  m_title->setObjectName(QStringLiteral("hubTitle"));
  m_drawing->setObjectName(QStringLiteral("hubDrawing"));
  m_drawing->setAccessibleName(tr("Schematic of the candidate"));
  m_shared->setObjectName(QStringLiteral("hubShared"));
  m_shared->setWordWrap(true);
  m_open->setObjectName(QStringLiteral("openHub"));
  m_open->setToolTip(tr("Opens this candidate with a state for each gear, in a new window (Return)"));
  auto* room = new QWidget;
  auto* content = new QVBoxLayout(room);
  content->setContentsMargins(12, 8, 12, 4);
  content->addWidget(m_title);
  content->addWidget(m_drawing, 1);
  content->addWidget(m_shared);
  content->addWidget(makeQuestion());
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(room);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 10);
  layout->addWidget(scroll, 1);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(12, 0, 12, 0);
  foot->addWidget(m_open);
  layout->addLayout(foot);
  connect(m_open, &QPushButton::clicked, this, &HubCard::openWanted);
  setSearch(nullptr);
  setNumber(0);
}

QWidget* HubCard::makeQuestion() {
  auto* box = new QFrame;
  box->setProperty("look", "card");
  box->setObjectName(QStringLiteral("hubQuestion"));
  m_box = box;
  m_heading = new QLabel(box);
  m_heading->setProperty("look", "title");
  m_heading->setWordWrap(true);
  m_questions = new QComboBox(box);
  m_questions->setObjectName(QStringLiteral("hubQuestions"));
  m_questions->setAccessibleName(tr("What can be counted or measured"));
  m_questions->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_ask = new QLabel(box);
  m_ask->setObjectName(QStringLiteral("hubAsk"));
  m_ask->setWordWrap(true);
  m_answers = new QWidget(box);
  auto* answers = new QGridLayout(m_answers);
  answers->setContentsMargins(0, 0, 0, 0);
  m_other = new QLineEdit(box);
  m_other->setObjectName(QStringLiteral("hubOtherAnswer"));
  m_other->setPlaceholderText(tr("another number"));
  m_other->setAccessibleName(tr("Another answer"));
  auto* column = new QVBoxLayout(box);
  column->addWidget(m_heading);
  column->addWidget(m_questions);
  column->addWidget(m_ask);
  column->addWidget(m_answers);
  column->addWidget(m_other);
  connect(m_questions, &QComboBox::currentIndexChanged, this, &HubCard::updateQuestion);
  connect(m_other, &QLineEdit::returnPressed, this, [this] {
    const QString answer = m_other->text().trimmed();
    if (const HubQuestion* asked = question(); asked != nullptr && !answer.isEmpty())
      emit answered(HubQuestion(*asked), answer);
  });
  return box;
}

void HubCard::setSearch(const HubSearchPtr& search) {
  m_search = search;
  const bool hasQuestions = search && !search->questions.empty();
  m_box->setVisible(hasQuestions);
  QStringList shared;
  if (search && search->assembled.size() > 1) {
    for (const auto& [name, teeth] : sharedWheels(*search))
      shared << QStringLiteral("%1: %2").arg(hubWheelWords(QString::fromStdString(name))).arg(teeth);
  }
  QStringList words;
  if (!shared.empty()) words << tr("All candidates share: %1.").arg(shared.join(QStringLiteral(", ")));
  if (search) {
    for (const auto& group : inseparable(*search)) {
      QStringList numbers;
      for (const std::size_t each : group) numbers << QString::number(each + 1);
      words << tr("Candidates %1 have the same ratios: no turning tells them apart.")
                   .arg(numbers.join(QStringLiteral(", ")));
    }
  }
  if (search && search->assembled.size() == 1) words << tr("This is it, within your limits.");
  m_shared->setText(words.join('\n'));
  {
    const QSignalBlocker blocker(m_questions);
    m_questions->clear();
    for (std::size_t i = 0; hasQuestions && i < search->questions.size(); ++i) {
      const HubQuestion& each = search->questions[i];
      const QString name = QString::fromStdString(each.name);
      m_questions->addItem((each.isCount ? tr("count %1: leaves %2 at most").arg(hubWheelWords(name))
                                         : tr("turn %1: leaves %2 at most").arg(hubGearWords(name)))
                               .arg(each.leaves));
    }
  }
  if (hasQuestions)
    m_heading->setText(search->questions.front().leaves == 1 ? tr("One measurement decides")
                                                             : tr("No single measurement decides"));
  updateQuestion();
}

const HubQuestion* HubCard::question() const {
  const int at = m_questions->currentIndex();
  return m_search && at >= 0 ? &m_search->questions[static_cast<std::size_t>(at)] : nullptr;
}

void HubCard::updateQuestion() {
  auto* grid = static_cast<QGridLayout*>(m_answers->layout());
  while (const QLayoutItem* item = grid->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  m_other->clear();
  const HubQuestion* const asked = question();
  if (asked == nullptr) return;
  const QString name = QString::fromStdString(asked->name);
  m_ask->setText(asked->isCount ? tr("Count the teeth of %1. You counted").arg(hubWheelWords(name))
                                : tr("Turn the input %1 times in %2. The output turned, in degrees,")
                                      .arg(kMeasuredTurns)
                                      .arg(hubGearWords(name)));
  constexpr int kInRow = 3;
  int place = 0;
  for (const auto& [answer, left] : leftBy(*asked)) {
    const QString text = QString::fromStdString(answer);
    auto* button = new QPushButton(text.isEmpty() ? tr("no such wheel") : text, m_answers);
    button->setObjectName(QStringLiteral("answer.") + text);
    button->setToolTip(tr("leaves %1").arg(left.size()));
    connect(button, &QPushButton::clicked, this,
            [this, asked = *asked, text] { emit answered(asked, text); });
    grid->addWidget(button, place / kInRow, place % kInRow);
    ++place;
  }
}

void HubCard::setNumber(int number) {
  m_title->setText(number > 0 ? tr("Candidate %1").arg(number) : tr("Choose a candidate of the list."));
  m_open->setEnabled(number > 0);
  m_drawing->setVisible(number > 0);
  if (number == 0) m_drawing->setDrawing({});
}

void HubCard::setDetail(const HubDetailPtr& detail) {
  m_drawing->setDrawing(detail ? detail->schematic : DisplayList());
}

}  // namespace geargraph

#include "moc_hub_card.cpp"
