#include "ui/learning/work_check_dialog.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QTextBlock>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/teaching/exercises/exercise_source.h"
#include "core/teaching/work_check/submitted_text.h"
#include "ui/document/selection.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

/// [AU] Eq. (45) as printed, with the vectors of Eq. (25).
constexpr const char* kExample =
    R"(\begin{pmatrix} \dot\theta_{10} \\ \dot\theta_{12} \\ \dot\theta_{13} \\ \dot\theta_{14} \end{pmatrix} =
\begin{bmatrix}
-i_{15} & 0 & 0 \\
-i_{16}i_{15} & -i_{16} & 0 \\
-i_{18}i_{17}i_{16}i_{15} & -i_{18}i_{17}i_{16} & -i_{18}i_{17} \\
-i_{17}i_{16}i_{15} & -i_{17}i_{16} & -i_{17}
\end{bmatrix}
\begin{pmatrix} \dot\theta_8 \\ \dot\theta_9 \\ \dot\theta_{11} \end{pmatrix}
)";

QString shownWords(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QTableWidget* makeTable(const QString& name, const QString& objectName, QWidget* parent) {
  auto* table = new QTableWidget(parent);
  table->setObjectName(objectName);
  table->setAccessibleName(name);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

QStringList textsOf(const std::vector<Heading>& headings) {
  QStringList texts;
  for (const Heading& heading : headings) texts += QString::fromStdString(heading.text);
  return texts;
}

QWidget* titled(const QString& title, QWidget* table, QWidget* parent) {
  auto* box = new QWidget(parent);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(title, box);
  label->setBuddy(table);
  layout->addWidget(label);
  layout->addWidget(table, 1);
  return box;
}

}  // namespace

WorkCheckDialog::WorkCheckDialog(Selection* selection, QWidget* parent)
    : QDialog(parent),
      m_selection(selection),
      m_service(new WorkCheckService(this)),
      m_text(new QPlainTextEdit(this)),
      m_kind(new QComboBox(this)),
      m_verdict(new QLabel(this)),
      m_notes(new QLabel(this)),
      m_yours(makeTable(tr("Your matrix"), QStringLiteral("paperYours"), this)),
      m_derived(makeTable(tr("The derived matrix, in your order"), QStringLiteral("paperDerived"), this)),
      m_differences(new QListWidget(this)) {
  setObjectName(QStringLiteral("paperCheck"));
  setWindowTitle(tr("Check my matrices"));
  m_text->setObjectName(QStringLiteral("paperText"));
  m_text->setAccessibleName(tr("Your matrix or equations"));
  m_text->setToolTip(tr("CSV, LaTeX, MATLAB, NumPy or plain text; equations, one a line"));
  m_text->setPlaceholderText(
      tr("Type or paste a matrix or equations: CSV, LaTeX, MATLAB, NumPy, plain text"));
  m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_text->setTabChangesFocus(true);
  m_kind->setObjectName(QStringLiteral("paperKind"));
  m_kind->setAccessibleName(tr("Which matrix it is"));
  m_kind->setToolTip(tr("Which matrix it is; recognised by its name, size and entries"));
  m_kind->addItem(tr("Recognise the matrix"));
  for (const PaperMatrix kind : allPaperMatrices()) {
    m_kind->addItem(shownWords(translated(paperMatrixTitle(kind))) + QLatin1Char(' ') +
                        shownWords(paperMatrixSymbol(kind)),
                    static_cast<int>(kind));
  }
  m_verdict->setObjectName(QStringLiteral("paperVerdict"));
  m_verdict->setProperty("look", "heading");
  m_verdict->setWordWrap(true);
  m_notes->setObjectName(QStringLiteral("paperNotes"));
  m_notes->setWordWrap(true);
  m_differences->setObjectName(QStringLiteral("paperDifferences"));
  m_differences->setAccessibleName(tr("What differs"));
  m_differences->setToolTip(tr("Select one to see its entries, and its elements in the drawings"));
  m_differences->setWordWrap(true);

  auto* file = new QPushButton(tr("Open a file…"), this);
  file->setToolTip(tr("Read the matrix or the equations from a text file"));
  auto* example = new QPushButton(tr("Example of the paper"), this);
  example->setObjectName(QStringLiteral("paperExample"));
  example->setToolTip(
      tr("The rows of equation (45) under the labels of equation (25), for the robot of the paper"));
  for (QPushButton* each : {file, example}) each->setAutoDefault(false);
  auto* tools = new QHBoxLayout;
  tools->addWidget(m_kind, 1);
  tools->addWidget(file);
  tools->addWidget(example);

  auto* tables = new QSplitter(this);
  tables->addWidget(titled(tr("Yours"), m_yours, this));
  tables->addWidget(titled(tr("Derived"), m_derived, this));
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(tools);
  layout->addWidget(m_text, 2);
  layout->addWidget(m_verdict);
  layout->addWidget(m_notes);
  layout->addWidget(tables, 3);
  layout->addWidget(m_differences, 2);
  resize(scaledPixels(760), scaledPixels(640));

  connect(file, &QPushButton::clicked, this, &WorkCheckDialog::askForFile);
  connect(example, &QPushButton::clicked, this, &WorkCheckDialog::showExample);
  connect(m_text, &QPlainTextEdit::textChanged, this, &WorkCheckDialog::request);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &WorkCheckDialog::request);
  connect(m_differences, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row < 0 || !m_shown) return;
    paintEntries();
    if (const auto* matrix = std::get_if<MatrixVerdict>(&*m_shown->verdict))
      return select(matrix->differences[static_cast<std::size_t>(row)].elements);
    const QVariant equation = m_differences->item(row)->data(Qt::UserRole);
    const auto& equations = std::get<std::vector<EquationVerdict>>(*m_shown->verdict);
    select(equations[equation.toUInt()].difference->elements);
  });
  for (QTableWidget* table : {m_yours, m_derived}) {
    connect(table, &QTableWidget::currentCellChanged, this, [this](int row, int column) {
      if (row < 0 || column < 0 || !m_shown) return;
      const auto at = static_cast<std::size_t>(row);
      if (const auto* matrix = std::get_if<MatrixVerdict>(&*m_shown->verdict))
        return select(matrix->entries[at][static_cast<std::size_t>(column)].elements);
      select(std::get<std::vector<EquationVerdict>>(*m_shown->verdict)[at].elements);
    });
  }
  m_service->onAnswer(this, [this](const WorkCheckAnswerPtr& answer) {
    if (!answer->verdict) return showFault(answer->faults.front());
    m_shown = answer;
    showVerdict(*answer);
  });
  clear();
}

void WorkCheckDialog::setMechanism(const MechanismPtr& mechanism) {
  if (m_mechanism == mechanism) return;
  m_mechanism = mechanism;
  request();
}

void WorkCheckDialog::askForFile() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a matrix or equations"), {},
                                   tr("Texts (*.csv *.tsv *.txt *.tex *.m *.py);;All files (*)"));
  if (!path.isEmpty()) openFile(path);
}

void WorkCheckDialog::openFile(const QString& path) {
  const auto bytes = readFile(QFile::encodeName(path).toStdString(), kLargestPaper);
  if (const auto* error = std::get_if<FileError>(&bytes))
    return setVerdict(QString::fromStdString(error->message));
  m_text->setPlainText(QString::fromStdString(std::get<std::string>(bytes)));
}

void WorkCheckDialog::showExample() {
  m_kind->setCurrentIndex(0);
  m_text->setPlainText(QString::fromLatin1(kExample));
}

void WorkCheckDialog::request() {
  const std::string text = m_text->toPlainText().toStdString();
  if (m_text->toPlainText().trimmed().isEmpty() || !m_mechanism) return clear();
  if (m_mechanism->n() > kMaxExerciseLinks) {
    m_service->cancel();
    return setVerdict(tr("Matrices of at most %1 moving links are compared.").arg(kMaxExerciseLinks));
  }
  if (text.size() > kLargestPaper) {
    m_service->cancel();
    return setVerdict(tr("This text is longer than any matrix that is compared."));
  }
  WorkCheckRequest request{m_mechanism, text, {}};
  const QVariant kind = m_kind->currentData();
  if (kind.isValid()) request.kind = static_cast<PaperMatrix>(kind.toInt());
  m_service->request(std::move(request));
}

void WorkCheckDialog::clear() {
  m_service->cancel();
  m_shown.reset();
  m_differences->clear();
  for (QTableWidget* table : {m_yours, m_derived}) {
    table->setRowCount(0);
    table->setColumnCount(0);
  }
  m_notes->clear();
  m_notes->hide();
  markLine(0);
  setVerdict(tr("Your matrix or equations against the derived ones"));
}

void WorkCheckDialog::showVerdict(const WorkCheckAnswer& answer) {
  markLine(0);
  m_differences->clear();
  if (const auto* matrix = std::get_if<MatrixVerdict>(&*answer.verdict)) return showMatrix(*matrix);
  showEquations(std::get<std::vector<EquationVerdict>>(*answer.verdict));
}

void WorkCheckDialog::showFault(const Diagnostic& fault) {
  markLine(fault.line);
  const QString message = QString::fromStdString(fault.message);
  setVerdict(fault.line > 0 ? tr("Line %1, column %2: %3").arg(fault.line).arg(fault.column).arg(message)
                            : message);
}

void WorkCheckDialog::showMatrix(const MatrixVerdict& verdict) {
  const QString name = shownWords(translated(paperMatrixTitle(verdict.kind))) + QLatin1Char(' ') +
                       shownWords(paperMatrixSymbol(verdict.kind)) + QLatin1Char(' ') +
                       shownWords(cited(paperMatrixEquation(verdict.kind)));
  switch (verdict.outcome) {
    case WorkOutcome::right:
      setVerdict(tr("✓ Right: %1").arg(name));
      break;
    case WorkOutcome::wrong:
      setVerdict(tr("✗ Not right yet: %1").arg(name));
      break;
    case WorkOutcome::ambiguous:
      setVerdict(tr("? Only labels can tell: %1").arg(name));
      break;
  }
  QStringList notes;
  for (const std::string& note : verdict.notes) notes += QString::fromStdString(note);
  m_notes->setText(notes.join(QLatin1Char('\n')));
  m_notes->setVisible(!notes.isEmpty());

  const auto height = static_cast<int>(verdict.entries.size());
  const int width = height == 0 ? 0 : static_cast<int>(verdict.entries.front().size());
  for (QTableWidget* table : {m_yours, m_derived}) {
    table->clear();
    table->setRowCount(height);
    table->setColumnCount(width);
    if (static_cast<int>(verdict.rows.size()) == height)
      table->setVerticalHeaderLabels(textsOf(verdict.rows));
    if (static_cast<int>(verdict.columns.size()) == width)
      table->setHorizontalHeaderLabels(textsOf(verdict.columns));
  }
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const ComparedEntry& entry =
          verdict.entries[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      auto* yours = new QTableWidgetItem(QString::fromStdString(entry.written.text));
      auto* derived = new QTableWidgetItem(QString::fromStdString(entry.derived));
      if (entry.differs) {
        yours->setToolTip(tr("Derived: %1").arg(derived->text()));
        derived->setToolTip(tr("Yours: %1").arg(yours->text()));
      }
      m_yours->setItem(row, column, yours);
      m_derived->setItem(row, column, derived);
    }
  }
  for (const WorkDifference& difference : verdict.differences) addDifference(difference);
  paintEntries();
}

void WorkCheckDialog::showEquations(const std::vector<EquationVerdict>& verdicts) {
  const auto wrong = std::count_if(verdicts.begin(), verdicts.end(),
                                   [](const EquationVerdict& each) { return !each.isRight; });
  setVerdict(wrong == 0 ? tr("✓ All that is written is right")
                        : tr("✗ Not right yet: %1 of %2").arg(wrong).arg(verdicts.size()));
  m_notes->hide();
  m_derived->clear();
  m_derived->setRowCount(0);
  m_derived->setColumnCount(0);
  m_yours->clear();
  m_yours->setRowCount(static_cast<int>(verdicts.size()));
  m_yours->setColumnCount(2);
  m_yours->setHorizontalHeaderLabels({tr("equation"), tr("verdict")});
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const EquationVerdict& each = verdicts[i];
    const int row = static_cast<int>(i);
    m_yours->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(each.text)));
    m_yours->setItem(row, 1, new QTableWidgetItem(each.isRight ? tr("right") : tr("wrong")));
    if (!each.difference) continue;
    addDifference(*each.difference);
    m_differences->item(m_differences->count() - 1)->setData(Qt::UserRole, static_cast<uint>(i));
  }
  paintEntries();
}

void WorkCheckDialog::addDifference(const WorkDifference& difference) {
  QString title = shownWords(translated(paperMistakeTitle(difference.name)));
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  m_differences->addItem(tr("%1: %2").arg(title, QString::fromStdString(difference.reason)));
}

/// Marks what differs; of the chosen difference in bold.
void WorkCheckDialog::paintEntries() {
  if (!m_shown) return;
  const Theme theme = themeOf(palette());
  const auto mark = [&](QTableWidgetItem* item, bool differs, bool isChosen) {
    if (item == nullptr) return;
    item->setBackground(differs ? QBrush(qColor(ColorRole::negativeFill, theme)) : QBrush());
    item->setForeground(differs ? QBrush(qColor(ColorRole::negativeInk, theme)) : QBrush());
    QFont font = m_yours->font();
    font.setBold(isChosen);
    item->setFont(font);
  };
  const auto* matrix = std::get_if<MatrixVerdict>(&*m_shown->verdict);
  if (matrix == nullptr) {
    const auto& equations = std::get<std::vector<EquationVerdict>>(*m_shown->verdict);
    for (std::size_t i = 0; i < equations.size(); ++i) {
      for (int column = 0; column < 2; ++column)
        mark(m_yours->item(static_cast<int>(i), column), !equations[i].isRight, false);
    }
    return;
  }
  const int chosen = m_differences->currentRow();
  const auto isChosen = [&](int row, int column) {
    if (chosen < 0) return false;
    const auto& places = matrix->differences[static_cast<std::size_t>(chosen)].entries;
    return std::find(places.begin(), places.end(), EntryPlace{row, column}) != places.end();
  };
  for (int row = 0; row < m_yours->rowCount(); ++row) {
    for (int column = 0; column < m_yours->columnCount(); ++column) {
      const bool differs =
          matrix->entries[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].differs;
      for (const QTableWidget* table : {m_yours, m_derived})
        mark(table->item(row, column), differs, isChosen(row, column));
    }
  }
}

void WorkCheckDialog::setVerdict(const QString& text) {
  m_verdict->setText(text);
  m_verdict->setAccessibleName(text);
}

/// Lights up a line of the text, counted from 1; none with 0.
void WorkCheckDialog::markLine(int line) {
  QList<QTextEdit::ExtraSelection> marks;
  const QTextBlock block = m_text->document()->findBlockByNumber(line - 1);
  if (line > 0 && block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    mark.format.setBackground(qColor(ColorRole::negativeFill, themeOf(palette())));
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    marks += mark;
  }
  m_text->setExtraSelections(marks);
}

void WorkCheckDialog::select(const std::vector<ElementId>& elements) {
  if (!elements.empty()) m_selection->select({elements.begin(), elements.end()});
}

void WorkCheckDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paintEntries();
}

}  // namespace geargraph

#include "moc_work_check_dialog.cpp"
