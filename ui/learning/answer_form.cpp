#include "ui/learning/answer_form.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRadioButton>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/teaching/lessons/prepared_step.h"
#include "ui/document/typed_length.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kTableWidth = 300;  ///< px for all columns
constexpr int kWidestCell = 46;
constexpr int kNarrowestCell = 25;
constexpr std::size_t kMaxRows = 6;  ///< of the options of the only field
constexpr std::size_t kMaxInListLength =
    12;  ///< letters of an option that stands in a list; longer ones are rows

/// The same order for everyone, in which the right option is not always the first.
std::vector<std::size_t> shuffled(const std::vector<std::string>& options) {
  const auto hash = [&](std::size_t option) {
    std::uint32_t value = 2166136261U;  // FNV-1a
    for (const char c : options[option]) value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
    return value;
  };
  std::vector<std::size_t> order(options.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return hash(a) < hash(b); });
  return order;
}

bool isWordy(const AnswerField& field) {
  return std::any_of(field.options.begin(), field.options.end(),
                     [](const std::string& option) { return option.size() > kMaxInListLength; });
}

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

AnswerForm::AnswerForm(Selection* selection, QWidget* parent) : QWidget(parent), m_selection(selection) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  connect(m_selection, &Selection::selectionChanged, this, &AnswerForm::takeSelection);
}

void AnswerForm::clear() {
  delete m_page;
  m_page = nullptr;
  m_picked = nullptr;
  m_fields.clear();
  m_pickable.clear();
}

void AnswerForm::setQuestion(const Question& question, const MechanismPtr& mechanism) {
  clear();
  m_question = question;
  m_mechanism = mechanism;
  m_fields.resize(question.fields.size());
  m_page = new QWidget(this);
  auto* grid = new QGridLayout(m_page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  question.table.columns.empty() ? addList(grid) : addTable(grid);
  layout()->addWidget(m_page);
  m_page->show();  // at once, so that a field can take the focus
}

void AnswerForm::addTable(QGridLayout* grid) {
  const AnswerTable& table = m_question.table;
  const int columns = static_cast<int>(table.columns.size());
  const int width =
      std::clamp(kTableWidth / columns - grid->horizontalSpacing() / 2, kNarrowestCell, kWidestCell);
  grid->setHorizontalSpacing(columns > 8 ? 1 : 3);
  const auto heading = [&](const std::string& text, int row, int column) {
    auto* label = new QLabel(shown(text), m_page);
    label->setProperty("look", "hint");
    label->setAlignment(row == 0 ? Qt::AlignCenter : Qt::AlignVCenter | Qt::AlignRight);
    grid->addWidget(label, row, column);
  };
  for (int column = 0; column < columns; ++column)
    heading(translated(table.columns[static_cast<std::size_t>(column)]), 0, column + 1);
  std::size_t field = 0;
  for (int row = 0; row < static_cast<int>(table.rows.size()); ++row) {
    heading(table.rows[static_cast<std::size_t>(row)], row + 1, 0);
    for (int column = 0; column < columns; ++column, ++field) {
      QLineEdit* cell = makeLine(m_question.fields[field], true);
      cell->setFixedWidth(scaledPixels(width));
      m_fields[field].line = cell;
      grid->addWidget(cell, row + 1, column + 1);
    }
  }
  grid->setColumnStretch(columns + 1, 1);
}

void AnswerForm::addList(QGridLayout* grid) {
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    const AnswerField& field = m_question.fields[i];
    const int row = static_cast<int>(i);
    QWidget* made = makeField(field, m_fields[i]);
    if (m_fields[i].choices != nullptr || (field.kind == FieldKind::set && m_fields.size() == 1)) {
      grid->addWidget(made, row, 0, 1, 2);
      continue;
    }
    auto* label = new QLabel(shown(field.shownName()), m_page);
    label->setWordWrap(true);
    label->setBuddy(made);
    grid->addWidget(label, row, 0);
    grid->addWidget(made, row, 1);
  }
  grid->setColumnStretch(0, 1);
}

QLineEdit* AnswerForm::makeLine(const AnswerField& field, bool isCell) {
  auto* line = new QLineEdit(m_page);
  line->setMaxLength(kMaxTyped);
  line->setObjectName(QStringLiteral("answer.") + shown(field.name));
  line->setAccessibleName(shown(field.shownName()));
  if (isCell) {
    line->setAlignment(Qt::AlignCenter);
    line->setProperty("look", "cell");
    line->setToolTip(shown(field.shownName()));
  }
  line->installEventFilter(this);
  connect(line, &QLineEdit::textEdited, this, &AnswerForm::edited);
  connect(line, &QLineEdit::returnPressed, this, &AnswerForm::submitted);
  return line;
}

QWidget* AnswerForm::makeField(const AnswerField& field, Field& made) {
  const bool isAlone = m_fields.size() == 1 && field.options.size() <= kMaxRows;
  if (field.kind == FieldKind::choice && (isAlone || isWordy(field))) return makeChoices(field, made);
  if (field.kind == FieldKind::choice) {
    made.list = new QComboBox(m_page);
    made.list->setObjectName(QStringLiteral("answer.") + shown(field.name));
    made.list->setAccessibleName(shown(field.shownName()));
    made.list->addItem(QString());
    for (const std::string& option : field.options) made.list->addItem(shown(option));
    made.list->installEventFilter(this);
    connect(made.list, &QComboBox::activated, this, &AnswerForm::edited);
    return made.list;
  }
  made.line = makeLine(field, false);
  if (field.kind == FieldKind::set) {
    made.line->setPlaceholderText(tr("Select in the drawing, or type: 8, 10"));
    for (const std::string& option : field.options)
      m_pickable.push_back(elementLabelled(*m_mechanism, option));
    m_picked = made.line;
  } else {
    made.line->setFixedWidth(scaledPixels(110));
    made.line->setToolTip(tr("A whole number, a fraction such as −2/3, or a decimal"));
  }
  return made.line;
}

/// Options that are sentences, one below the other.
QWidget* AnswerForm::makeChoices(const AnswerField& field, Field& made) {
  auto* box = new QWidget(m_page);
  auto* layout = new QGridLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setColumnStretch(1, 1);
  made.choices = new QButtonGroup(box);
  int row = 0;
  for (const std::size_t option : shuffled(field.options)) {
    auto* button = new QRadioButton(box);
    button->setObjectName(QStringLiteral("choice.%1").arg(option));
    button->setAccessibleName(shown(field.options[option]));
    button->installEventFilter(this);
    auto* label = new QLabel(shown(field.options[option]), box);
    label->setWordWrap(true);
    label->setProperty("choice", QVariant::fromValue<QObject*>(button));
    label->installEventFilter(this);
    made.choices->addButton(button, static_cast<int>(option));
    layout->addWidget(button, row, 0, Qt::AlignTop);
    layout->addWidget(label, row++, 1);
  }
  connect(made.choices, &QButtonGroup::idClicked, this, &AnswerForm::edited);
  return box;
}

std::vector<std::string> AnswerForm::answer() const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    const Field& field = m_fields[i];
    if (field.choices != nullptr) {
      const int chosen = field.choices->checkedId();
      texts.push_back(chosen < 0 ? std::string()
                                 : m_question.fields[i].options[static_cast<std::size_t>(chosen)]);
    } else if (field.list != nullptr) {
      texts.push_back(field.list->currentText().toStdString());
    } else {
      const std::string text = field.line->text().toStdString();
      // An empty cell of a matrix of whole numbers is a zero, unless the question has empty ones.
      const bool isZero =
          text.empty() && !m_question.table.columns.empty() && !m_question.fields[i].mayBeEmpty;
      texts.push_back(isZero ? "0" : text);
    }
  }
  return texts;
}

void AnswerForm::setAnswer(const std::vector<std::string>& answer) {
  for (std::size_t i = 0; i < m_fields.size() && i < answer.size(); ++i) {
    const Field& field = m_fields[i];
    const auto& options = m_question.fields[i].options;
    if (field.line != nullptr) field.line->setText(shown(answer[i]));
    if (field.list != nullptr) field.list->setCurrentText(shown(answer[i]));
    const auto option = std::find(options.begin(), options.end(), answer[i]);
    if (field.choices != nullptr && option != options.end())
      field.choices->button(static_cast<int>(option - options.begin()))->setChecked(true);
  }
}

QWidget* AnswerForm::widgetOf(std::size_t field) const {
  const Field& made = m_fields[field];
  if (made.line != nullptr) return made.line;
  if (made.list != nullptr) return made.list;
  return made.choices->checkedButton() != nullptr ? made.choices->checkedButton()
                                                  : made.choices->buttons().front();
}

void AnswerForm::setMark(std::size_t field, const char* mark) {
  QWidget* widget = widgetOf(field);
  if (widget->property("mark").toString() == QLatin1String(mark)) return;
  widget->setProperty("mark", QLatin1String(mark));
  widget->update();
}

void AnswerForm::mark(const Verdict& verdict) {
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    const bool isWrong = std::find(verdict.wrongFields.begin(), verdict.wrongFields.end(),
                                   static_cast<int>(i)) != verdict.wrongFields.end();
    const bool isKnown = verdict.isRight || !verdict.wrongFields.empty();
    setMark(i, isWrong ? "wrong" : isKnown ? "right" : "");
  }
}

void AnswerForm::unmark() {
  for (std::size_t i = 0; i < m_fields.size(); ++i) setMark(i, "");
}

void AnswerForm::focusFirst() {
  if (m_fields.empty()) return;
  std::size_t first = 0;
  for (std::size_t i = m_fields.size(); i-- > 0;) {
    if (widgetOf(i)->property("mark").toString() == QLatin1String("wrong")) first = i;
  }
  widgetOf(first)->setFocus();
  if (m_fields[first].line != nullptr) m_fields[first].line->selectAll();
}

void AnswerForm::setReadOnly(bool readOnly) {
  if (m_page != nullptr) m_page->setEnabled(!readOnly);
}

/// What is selected in a view and can be picked becomes the answer.
void AnswerForm::takeSelection() {
  if (m_picked == nullptr || !m_page->isEnabled()) return;
  QStringList labels;
  const auto& options = m_question.fields.front().options;
  for (std::size_t i = 0; i < m_pickable.size(); ++i) {
    if (m_pickable[i] && m_selection->isSelected(*m_pickable[i])) labels << shown(options[i]);
  }
  if (labels.isEmpty()) return;
  m_picked->setText(labels.join(QStringLiteral(", ")));
  emit edited();
}

bool AnswerForm::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonRelease) {
    if (auto* button = qobject_cast<QRadioButton*>(watched->property("choice").value<QObject*>())) {
      button->click();
      button->setFocus();
    }
  }
  if (event->type() == QEvent::KeyPress) {
    // Choices and lists take no notice of Return; lines of text do.
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool isChoice =
        qobject_cast<QRadioButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    if (isChoice && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      emit submitted();
      return true;
    }
  }
  if (event->type() == QEvent::FocusIn) {
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
      const auto& elements = m_question.fields[i].elements;
      if (watched == m_fields[i].line || watched == m_fields[i].list)
        m_selection->hover({elements.begin(), elements.end()});
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_answer_form.cpp"
