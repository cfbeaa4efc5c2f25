#include "ui/panels/results_panel.h"

#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "core/theory/matroid/input_roles.h"
#include "ui/models/term_tips.h"
#include "ui/panels/results_delegate.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/looks.h"

namespace geargraph {
namespace {

constexpr int kRowHeight = 23;
constexpr int kPatience = 300;      // ms: sooner, the verdict would blink at every step of a drag
constexpr int kRowsMeasured = 200;  // for the widths of columns; what is farther down may be elided
constexpr int kLeastWidth = 64;     // px, of a column
constexpr int kMaxNamed = 12;       // inputs in the note: wrapping thousands of labels takes seconds
constexpr int kMaxWidth = 420;

}  // namespace

ResultsPanel::ResultsPanel(Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_selection(selection),
      m_model(new ResultsModel(this)),
      m_table(new QTableView(this)),
      m_linkModel(new LinkSpeedsModel(this)),
      m_links(new QTableView(this)),
      m_frame(new QToolButton(this)),
      m_unit(new QToolButton(this)),
      m_motors(new QToolButton(this)),
      m_symbols(new QToolButton(this)),
      m_pages(new QStackedWidget(this)),
      m_empty(emptyLabel(this)),
      m_note(new QLabel(this)),
      m_ratio(new QLabel(this)),
      m_verdict(new QLabel(this)) {
  makeTable();
  makeLinkTable();
  m_empty->setObjectName(QStringLiteral("noResults"));
  m_pages->addWidget(m_table);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_links);
  m_note->setObjectName(QStringLiteral("inputsNote"));
  m_note->setProperty("look", "hint");
  m_note->setWordWrap(true);
  m_note->setContentsMargins(16, 0, 16, 0);
  m_ratio->setObjectName(QStringLiteral("ratio"));
  m_ratio->setAccessibleName(tr("Ratio"));
  m_ratio->setWordWrap(true);
  m_ratio->setContentsMargins(16, 0, 16, 0);
  m_ratio->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_ratio->setToolTip(
      tr("Speed of the only input over that of an output. Select a joint or a link to see its ratio."));
  connect(m_selection, &Selection::selectionChanged, this, &ResultsPanel::updateRatio);
  m_verdict->setObjectName(QStringLiteral("verdict"));
  m_verdict->setProperty("look", "verdict");
  m_verdict->setWordWrap(true);
  m_patience.setSingleShot(true);
  m_patience.setInterval(kPatience);
  connect(&m_patience, &QTimer::timeout, this, &ResultsPanel::renew);
  m_symbols->setObjectName(QStringLiteral("formulas"));
  m_symbols->setProperty("look", "control");
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
  layout->setContentsMargins(0, 0, 0, 8);
  layout->setSpacing(4);
  layout->addLayout(makeStrip());
  layout->addWidget(m_note);
  layout->addWidget(m_pages, 1);
  layout->addWidget(m_ratio);
  layout->addLayout(foot);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  renew();
}

void ResultsPanel::makeTable() {
  // Mathematics is read so in every language.
  for (QTableView* table : {m_table, m_links}) table->setLayoutDirection(Qt::LeftToRight);
  m_table->setModel(m_model);
  m_table->setObjectName(QStringLiteral("resultsTable"));
  m_table->setAccessibleName(tr("Results"));
  m_table->setTabKeyNavigation(false);
  m_table->setItemDelegate(new ResultsDelegate(m_selection, m_table));
  auto* header = new ResultsHeader(m_table);
  m_table->setHorizontalHeader(header);
  header->setMinimumSectionSize(kLeastWidth);  // else Qt asks the style, for every column
  header->setDefaultSectionSize(kLeastWidth);  // so that only columns that were measured are resized
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setMinimumSectionSize(kRowHeight);  // else Qt asks the style, for every row
  m_table->verticalHeader()->setDefaultSectionSize(scaledPixels(kRowHeight));
  m_table->setShowGrid(false);
  m_table->setMouseTracking(true);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_table->setFrameShape(QFrame::NoFrame);
  m_table->setContentsMargins(8, 0, 8, 0);
  m_table->viewport()->installEventFilter(this);
  m_table->installEventFilter(this);
  connect(m_table->horizontalScrollBar(), &QScrollBar::valueChanged, this, &ResultsPanel::fitColumns);
  connect(header, &ResultsHeader::sectionHovered, this, &ResultsPanel::hoverHead);
  connect(m_table, &QTableView::entered, this, &ResultsPanel::hoverRow);
  connect(m_table, &QTableView::clicked, this,
          [this](const QModelIndex& index) { m_selection->select({m_model->outputAt(index.row())}); });
  m_table->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_table, &QWidget::customContextMenuRequested, this, [this](QPoint at) {
    const QModelIndex index = m_table->indexAt(at);
    if (index.isValid()) {
      emit menuWanted(m_model->outputAt(index.row()), m_table->viewport()->mapToGlobal(at));
    }
  });
  connect(m_model, &QAbstractItemModel::modelReset, this, [this] { m_fitted.clear(); });
  const auto repaint = [this] { m_table->viewport()->update(); };
  connect(m_selection, &Selection::hoverChanged, m_table, repaint);
  connect(m_selection, &Selection::selectionChanged, m_table, repaint);
}

void ResultsPanel::makeLinkTable() {
  m_links->setModel(m_linkModel);
  m_links->setObjectName(QStringLiteral("linkSpeeds"));
  m_links->verticalHeader()->hide();
  m_links->verticalHeader()->setMinimumSectionSize(kRowHeight);
  m_links->verticalHeader()->setDefaultSectionSize(scaledPixels(kRowHeight));
  m_links->setShowGrid(false);
  constexpr int kRowsMeasured = 40;  // for the widths of columns
  m_links->horizontalHeader()->setResizeContentsPrecision(kRowsMeasured);
  m_links->setMouseTracking(true);
  m_links->setSelectionMode(QAbstractItemView::NoSelection);
  m_links->setFrameShape(QFrame::NoFrame);
  m_links->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_links->setItemDelegate(new LinkSpeedsDelegate(m_selection, m_links));
  m_links->horizontalHeader()->setHighlightSections(false);
  m_links->horizontalHeader()->setFixedHeight(scaledPixels(kRowHeight + 1));
  m_links->viewport()->installEventFilter(this);
  connect(m_links, &QTableView::entered, this,
          [this](const QModelIndex& index) { m_selection->hover(m_linkModel->linkAt(index.row())); });
  connect(m_links, &QTableView::clicked, this,
          [this](const QModelIndex& index) { m_selection->select({m_linkModel->linkAt(index.row())}); });
  const auto repaint = [this] { m_links->viewport()->update(); };
  connect(m_selection, &Selection::hoverChanged, m_links, repaint);
  connect(m_selection, &Selection::selectionChanged, m_links, repaint);
}

/// The head of an input lights up what it commands.
void ResultsPanel::hoverHead(int section) {
  const int input = section - 1;
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (input < 0 || input >= m_model->inputCount() || matroid->solution->matrix.empty()) {
    m_selection->unhover();
    return;
  }
  const int joint = matroid->solution->inputs[static_cast<std::size_t>(input)];
  std::set<ElementId> elements{m_model->inputAt(input)};
  for (const int commanded : commandedBy(*matroid->solution, joint))
    elements.insert(m_snapshot->graph->edgeId(commanded));
  m_selection->hover(std::move(elements));
}

void ResultsPanel::setSnapshot(const SnapshotPtr& snapshot) {
  const bool wasComplete = m_snapshot && m_snapshot->isComplete;
  m_snapshot = snapshot;
  m_names.setSnapshot(snapshot);
  if (!snapshot || snapshot->isComplete) {
    m_patience.stop();
  } else if (wasComplete) {
    m_patience.start();
  }
  m_model->setSnapshot(snapshot);
  if (m_absolute) m_linkModel->setSnapshot(snapshot);
  showUnit();
  renew();
}

void ResultsPanel::setAwake(bool awake) {
  m_isAwake = awake;
  if (awake && m_isBehind) renew();
}

/// The results of the first step of an analysis are there, and those of the second will be in a moment: what
/// only they can tell stays as it is.
bool ResultsPanel::isWaiting() const {
  return m_snapshot && !m_snapshot->isComplete && m_patience.isActive();
}

void ResultsPanel::hoverRow(const QModelIndex& index) {
  const int input = index.column() - 1;
  const ElementId joint = m_model->outputAt(index.row());
  std::set<ElementId> elements{joint, m_model->linkAt(index.row())};
  if (input >= 0 && input < m_model->inputCount()) elements.insert(m_model->inputAt(input));
  m_selection->hover(std::move(elements));
}

void ResultsPanel::renew() {
  m_isBehind = !m_isAwake;
  if (m_isBehind) return;
  m_measured.clear();  // before what is shown below resizes the table
  const bool solved = m_model->columnCount() > 0;
  m_empty->setText(unavailableReason());
  const bool hasLinks = m_absolute && m_linkModel->rowCount() > 0;
  m_pages->setCurrentIndex(hasLinks ? 2 : (solved && m_model->rowCount() > 0 ? 0 : 1));
  if (hasLinks) {
    m_links->resizeColumnsToContents();
    m_links->horizontalHeader()->setStretchLastSection(false);
  }
  if (!isWaiting() || m_absolute) m_symbols->setVisible(m_model->hasSymbols() && !m_absolute);
  m_symbols->setText(m_model->isSymbolic() ? tr("fractions") : tr("formulas"));
  updateNote();
  updateRatio();
  fitColumns();
  paintVerdict();
}

void ResultsPanel::updateNote() {
  QString note;
  const MatroidAnalysis* matroid = m_snapshot ? m_snapshot->matroid() : nullptr;
  if (m_model->columnCount() > 0 && matroid != nullptr && !matroid->inputsGiven &&
      m_model->inputCount() > 0) {
    QStringList joints;
    for (int i = 0; i < std::min(m_model->inputCount(), kMaxNamed); ++i)
      joints << m_model->headerData(i + 1, Qt::Horizontal).toString();
    if (m_model->inputCount() > kMaxNamed) joints << tr("… (%1 in all)").arg(m_model->inputCount());
    const QString set = joints.size() == 1
                            ? tr("joint %1").arg(joints.first())
                            : tr("the set of joints %1").arg(joints.join(QStringLiteral(", ")));
    note = hasSlides(*m_snapshot->mechanism)
               ? tr("No joint is driven: %1 as input, at 1 rad/s or %2 each.")
                     .arg(set, QStringLiteral("1 ") + unitOfRate(*m_snapshot->mechanism, true))
               : tr("No joint is driven: %1 as input, at 1 rad/s each.").arg(set);
  }
  m_note->setText(note);
  m_note->setVisible(!note.isEmpty());
}

int ResultsPanel::ratioRow() const {
  for (int row = 0; row < m_model->rowCount(); ++row) {
    const bool isChosen =
        m_selection->isSelected(m_model->outputAt(row)) || m_selection->isSelected(m_model->linkAt(row));
    if (isChosen && !m_model->ratioText(row).isEmpty()) return row;
  }
  return m_model->ratioRow();
}

void ResultsPanel::updateRatio() {
  const QString ratio = m_model->ratioText(ratioRow());
  const QString text = ratio.isEmpty() ? QString() : tr("Ratio %1").arg(ratio);
  if (text != m_ratio->text()) m_ratio->setText(text);
  m_ratio->setVisible(!text.isEmpty());
}

int ResultsPanel::widthOfColumn(int column) const {
  const auto* delegate = static_cast<const ResultsDelegate*>(m_table->itemDelegate());
  const int rows = std::min(m_model->rowCount(), kRowsMeasured);
  int width = kLeastWidth;
  for (int row = 0; row < rows; ++row) {
    const QModelIndex cell = m_model->index(row, column);
    if (cell.data(ResultsModel::ZeroRole).toBool()) continue;  // most of a large matrix, and narrow
    width = std::max(width, delegate->widthOf(cell, m_table->font()));
  }
  return std::min(width, kMaxWidth);
}

/// Hundreds of inputs make as many columns: those that are far to the left or right are measured when they
/// are scrolled to.
void ResultsPanel::fitColumns() {
  const int columns = m_model->columnCount();
  if (columns == 0) return;
  m_measured.resize(static_cast<std::size_t>(columns), 0);
  const int width = m_table->viewport()->width();
  const int left = m_table->horizontalScrollBar()->value() - width;
  const int right = m_table->horizontalScrollBar()->value() + 2 * width;
  int all = 0;
  std::vector<int> widths;
  for (int column = 0; column < columns; ++column) {
    int& measured = m_measured[static_cast<std::size_t>(column)];
    const bool isLast = column == columns - 1;
    const bool isNear = all <= right && all + std::max(measured, kLeastWidth) >= left;
    if (measured == 0 && (isNear || isLast)) measured = widthOfColumn(column);
    all += widths.emplace_back(std::max(measured, kLeastWidth));
  }
  if (all > width) all -= narrowed(widths.front(), all - width);
  widths.push_back(m_table->viewport()->width());
  if (widths == m_fitted) return;  // every section that is resized paints the table again
  m_fitted = widths;               // before sections move, which scrolls
  for (int column = 0; column < columns; ++column)
    m_table->horizontalHeader()->resizeSection(column, widths[static_cast<std::size_t>(column)]);
  // Long formulas push what is looked for out of sight: then it stands before them.
  QHeaderView* header = m_table->horizontalHeader();
  const int now = columns - 1;
  const int wanted = all > m_table->viewport()->width() ? std::min(1, now) : now;
  if (header->visualIndex(now) != wanted) header->moveSection(header->visualIndex(now), wanted);
  m_table->horizontalHeader()->setStretchLastSection(true);
}

/// Makes the first column narrower, by up to `wanted` px: names of links are shortened so that all columns of
/// coefficients are in sight. Returns by how much.
int ResultsPanel::narrowed(int& first, int wanted) const {
  int least = kLeastWidth;
  for (int row = 0; row < std::min(m_model->rowCount(), kRowsMeasured); ++row)
    least = std::max(least, ResultsDelegate::leastWidthOf(m_model->index(row, 0), m_table->font()));
  const int by = std::clamp(wanted, 0, std::max(0, first - least));
  first -= by;
  return by;
}

int ResultsPanel::columnsFitted() const {
  return static_cast<int>(
      std::count_if(m_measured.begin(), m_measured.end(), [](int width) { return width > 0; }));
}

QString ResultsPanel::verdict() const {
  const auto now = verdictNow();
  return now ? now->first : m_verdict->text();
}

std::optional<std::pair<QString, ColorRole>> ResultsPanel::verdictNow() const {
  const auto& solved = m_snapshot ? m_snapshot->solved : SolvedKinematicsPtr();
  const int count = m_model->rowCount();
  if (solved && solved->agreement && count > 0) {
    const Agreement& agreement = *solved->agreement;
    if (!agreement.equal) {
      return std::pair(agreement.joints.size() == 1
                           ? tr("The two methods differ at one joint. Please report this document.")
                           : tr("The two methods differ at %1 joints. Please report this document.")
                                 .arg(agreement.joints.size()),
                       ColorRole::error);
    }
    return std::pair(count == 1
                         ? tr("Matroid method = T–T graph method, exactly")
                         : tr("Matroid method = T–T graph method, exactly, for all %1 joints").arg(count),
                     ColorRole::fine);
  }
  const bool isUnderWay = m_snapshot && count > 0 && !m_snapshot->isComplete;
  if (isUnderWay && isWaiting()) return std::nullopt;
  return std::pair(isUnderWay ? tr("Solving exactly, by both methods …") : QString(), ColorRole::secondary);
}

void ResultsPanel::paintVerdict() {
  const auto now = verdictNow();
  if (!now) return;
  const auto& [text, role] = *now;
  m_verdict->setText(text);
  m_verdict->setVisible(!text.isEmpty());
  setInk(*m_verdict, role);
}

QString ResultsPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

QString ResultsPanel::unavailableReason() const {
  if (!m_snapshot) return tr("The results appear as soon as the mechanism is analysed.");
  for (const Diagnostic& diagnostic : m_snapshot->diagnostics) {
    if (diagnostic.severity() == Severity::error) return shownText(diagnostic.message);
  }
  if (m_snapshot->mechanism->t() == 0) return tr("Rates appear when the first turning joint is drawn.");
  return tr("Every joint is an input: there is nothing left to solve for.");
}

bool ResultsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) m_selection->unhover();
  if (event->type() == QEvent::Resize && watched == m_table->viewport()) fitColumns();
  if (event->type() == QEvent::FontChange && watched == m_table) typeChanged();
  return QWidget::eventFilter(watched, event);
}

void ResultsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) typeChanged();
}

/// The panel and its table get another font one after the other: while it is in sight, what is measured waits
/// for a turn of its own.
void ResultsPanel::typeChanged() {
  if (!isVisible()) return fitToType();
  m_typeTurn.request();
}

/// Setting a height goes through thousands of rows.
void ResultsPanel::fitToType() {
  std::pair type(m_table->font(), scaledPixels(kRowHeight));
  if (type == m_type) return;
  m_type = std::move(type);
  for (QTableView* table : {m_table, m_links}) table->verticalHeader()->setDefaultSectionSize(m_type.second);
  m_links->horizontalHeader()->setFixedHeight(scaledPixels(kRowHeight + 1));
  m_measured.clear();
  fitColumns();
}

}  // namespace geargraph

#include "moc_results_panel.cpp"
