#include "ui/panels/results_panel.h"

#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "ui/panels/results_delegate.h"
#include "ui/panels/term_tips.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kRowsMeasured = 200;  // for the widths of columns; what is farther down may be elided

}  // namespace

ResultsPanel::ResultsPanel(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_selection(selection),
      m_model(new ResultsModel(this)),
      m_table(new QTableView(this)),
      m_symbols(new QToolButton(this)),
      m_pages(new QStackedWidget(this)),
      m_empty(new QLabel(this)),
      m_note(new QLabel(this)),
      m_verdict(new QLabel(this)) {
  makeTable();
  m_empty->setProperty("look", "empty");
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setObjectName(QStringLiteral("noResults"));
  m_pages->addWidget(m_table);
  m_pages->addWidget(m_empty);
  m_note->setProperty("look", "hint");
  m_note->setWordWrap(true);
  m_note->setContentsMargins(16, 0, 16, 0);
  m_verdict->setObjectName(QStringLiteral("verdict"));
  m_verdict->setWordWrap(true);
  m_symbols->setProperty("look", "flat");
  m_symbols->setToolTip(tr("Coefficients as formulas in the gear ratios, or as fractions"));
  connect(m_symbols, &QToolButton::clicked, this, [this] {
    m_model->setSymbolic(!m_model->isSymbolic());
    renew();
  });

  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(16, 0, 16, 0);
  foot->addWidget(m_verdict, 1);
  foot->addWidget(m_symbols);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 10);
  layout->setSpacing(6);
  layout->addWidget(m_note);
  layout->addWidget(m_pages, 1);
  layout->addLayout(foot);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  renew();
}

void ResultsPanel::makeTable() {
  m_table->setModel(m_model);
  m_table->setObjectName(QStringLiteral("resultsTable"));
  m_table->setItemDelegate(new ResultsDelegate(m_selection, m_table));
  auto* header = new ResultsHeader(m_table);
  m_table->setHorizontalHeader(header);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(25);
  m_table->setShowGrid(false);
  m_table->setMouseTracking(true);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->setFrameShape(QFrame::NoFrame);
  m_table->setContentsMargins(8, 0, 8, 0);
  m_table->viewport()->installEventFilter(this);
  connect(m_table, &QTableView::entered, this, &ResultsPanel::hoverRow);
  connect(m_table, &QTableView::clicked, this,
          [this](const QModelIndex& index) { m_selection->select({m_model->outputAt(index.row())}); });
  const auto repaint = [this] { m_table->viewport()->update(); };
  connect(m_selection, &Selection::hoverChanged, m_table, repaint);
  connect(m_selection, &Selection::selectionChanged, m_table, repaint);
}

void ResultsPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_snapshot = snapshot;
  m_model->setSnapshot(snapshot);
  renew();
}

void ResultsPanel::hoverRow(const QModelIndex& index) {
  const int input = index.column() - 1;
  const ElementId joint = m_model->outputAt(index.row());
  std::set<ElementId> elements{joint, m_model->linkOf(joint)};
  if (input >= 0 && input < m_model->inputCount()) elements.insert(m_model->inputAt(input));
  m_selection->hover(std::move(elements));
}

void ResultsPanel::renew() {
  const bool solved = m_model->columnCount() > 0;
  m_empty->setText(whyNone());
  m_pages->setCurrentIndex(solved && m_model->rowCount() > 0 ? 0 : 1);
  m_symbols->setVisible(m_model->hasSymbols());
  m_symbols->setText(m_model->isSymbolic() ? tr("fractions") : tr("formulas"));
  QString note;
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (solved && matroid != nullptr && !matroid->inputsGiven && m_model->inputCount() > 0) {
    QStringList joints;
    for (int i = 0; i < m_model->inputCount(); ++i)
      joints << m_model->headerData(i + 1, Qt::Horizontal).toString();
    note = tr("No joint is driven, so %1 stands for the inputs, at 1 rad/s each.")
               .arg(joints.size() == 1 ? tr("joint %1").arg(joints.first())
                                       : tr("the set of joints %1").arg(joints.join(QStringLiteral(", "))));
  }
  m_note->setText(note);
  m_note->setVisible(!note.isEmpty());
  fitColumns();
  paintVerdict();
}

void ResultsPanel::fitColumns() {
  const int columns = m_model->columnCount();
  if (columns == 0) return;
  const auto* delegate = static_cast<const ResultsDelegate*>(m_table->itemDelegate());
  const int rows = std::min(m_model->rowCount(), kRowsMeasured);
  for (int column = 0; column < columns; ++column) {
    int width = 64;
    for (int row = 0; row < rows; ++row) {
      width = std::max(width, delegate->widthOf(m_model->index(row, column), m_table->font()));
    }
    m_table->horizontalHeader()->resizeSection(column, std::min(width, 420));
  }
  m_table->horizontalHeader()->setStretchLastSection(true);
}

QString ResultsPanel::verdict() const {
  return m_verdict->text();
}

void ResultsPanel::paintVerdict() {
  const auto& solved = m_snapshot ? m_snapshot->solved : SolvedKinematicsPtr();
  ColorRole role = ColorRole::secondary;
  QString text;
  if (solved && solved->agreement) {
    const Agreement& agreement = *solved->agreement;
    role = agreement.equal ? ColorRole::fine : ColorRole::error;
    const auto count = m_model->rowCount();
    text = agreement.equal
               ? (count == 1 ? tr("Matroid method = T–T graph method, exactly")
                             : tr("Matroid method = T–T graph method, exactly, for all %1 joints").arg(count))
               : tr("The two methods differ at %1 joints. Please report this document.")
                     .arg(agreement.joints.size());
  } else if (m_snapshot && m_model->rowCount() > 0 && !m_snapshot->isComplete) {
    text = tr("Solving exactly, by both methods …");
  }
  const Theme theme = themeOf(palette());
  QColor ground = qColor(role, theme);
  ground.setAlphaF(0.10F);
  QColor border = qColor(role, theme);
  border.setAlphaF(0.45F);
  m_verdict->setText(text);
  m_verdict->setVisible(!text.isEmpty());
  m_verdict->setStyleSheet(
      QStringLiteral("QLabel { color: %1; background: %2; border: 1px solid %3; "
                     "border-radius: 5px; padding: 5px 12px; }")
          .arg(qColor(role, theme).name(), ground.name(QColor::HexArgb), border.name(QColor::HexArgb)));
}

QString ResultsPanel::whyNone() const {
  if (!m_snapshot) return tr("The results appear as soon as the mechanism is analysed.");
  for (const Diagnostic& diagnostic : m_snapshot->diagnostics) {
    if (diagnostic.severity() == Severity::error) return shownText(diagnostic.message);
  }
  if (m_snapshot->mechanism->t() == 0) return tr("Rates appear when the first turning joint is drawn.");
  return tr("Every joint is an input: there is nothing left to solve for.");
}

bool ResultsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) m_selection->unhover();
  return QWidget::eventFilter(watched, event);
}

void ResultsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && m_snapshot) paintVerdict();
}

}  // namespace geargraph
