#include "ui/panels/matrix_view.h"

#include <QContextMenuEvent>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "ui/panels/matrix_header.h"
#include "ui/panels/ratio_text.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/looks.h"

namespace geargraph {
namespace {

constexpr int kRowsMeasured = 200;  // for the widths of columns
constexpr int kColumnsMeasured = 60;
constexpr int kHeadingGap = 8;  // between the names of two columns
constexpr int kPillMargin = 7;

/// The width of an entry's text, and drawing it where there is a painter.
double putEntry(QPainter* painter, const QFont& font, const QRectF& cell, const QModelIndex& index) {
  const QString text = index.data().toString();
  if (!index.data(MatrixModel::FormulaRole).toBool()) {
    if (painter != nullptr) painter->drawText(cell, Qt::AlignCenter, text);
    return QFontMetricsF(font).horizontalAdvance(text);
  }
  const double advance = paintRatios(nullptr, font, {}, text);
  if (painter == nullptr) return advance;
  const QFontMetricsF metrics(font);
  const double base = cell.center().y() + (metrics.ascent() - metrics.descent()) / 2;
  painter->setClipRect(cell);
  paintRatios(painter, font, {std::max(cell.left() + kPillMargin, cell.center().x() - advance / 2), base},
              text);
  return advance;
}

class EntryDelegate : public QStyledItemDelegate {
 public:
  explicit EntryDelegate(MatrixView* view) : QStyledItemDelegate(view), m_view(view) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->setLayoutDirection(Qt::LeftToRight);  // a minus sign stands before its number
    const Theme theme = themeOf(option.palette);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool last = index.column() == index.model()->columnCount() - 1;
    const QRectF cell = QRectF(option.rect).adjusted(0, 0, last ? -kMatrixBracket : 0, 0);
    if (m_view->isRowHighlighted(index.row()) || m_view->isColumnTinted(index.column())) {
      QColor band = qColor(ColorRole::halo, theme);
      band.setAlphaF(0.35F);
      painter->fillRect(cell, band);
    }
    paintEntry(*painter, cell, option, index, theme);
    painter->restore();
  }

 private:
  void paintEntry(QPainter& painter, const QRectF& cell, const QStyleOptionViewItem& option,
                  const QModelIndex& index, Theme theme) const {
    const int value = index.data(MatrixModel::ValueRole).toInt();
    const double wanted =
        value == 0 ? 30 : std::max(30.0, putEntry(nullptr, option.font, {}, index) + 2 * kPillMargin);
    QRectF pill(0, 0, std::min(wanted, cell.width() - 3),
                std::min<double>(scaledPixels(21), cell.height() - 3));
    pill.moveCenter(cell.center());
    if (index.data(MatrixModel::ChangedRole).toBool()) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(qColor(ColorRole::halo, theme));
      painter.drawRoundedRect(pill.adjusted(-4, -4, 4, 4), 7, 7);
    }
    const bool isPreview = index.data(MatrixModel::PreviewRole).toBool();
    ColorRole ink = ColorRole::secondary;
    if (value != 0) {
      ink = value > 0 ? ColorRole::positiveInk : ColorRole::negativeInk;
      painter.setBrush(qColor(value > 0 ? ColorRole::positiveFill : ColorRole::negativeFill, theme));
      painter.setPen(isPreview ? QPen(qColor(ColorRole::secondary, theme), 1, Qt::DashLine)
                               : QPen(Qt::NoPen));
      painter.drawRoundedRect(pill, 5, 5);
    }
    if (m_view->underMouse() && option.state.testFlag(QStyle::State_MouseOver)) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(qColor(ColorRole::accent, theme), 1.6));
      painter.drawRoundedRect(pill, 5, 5);
    }
    if (m_view->isFramed(index.row(), index.column())) {
      painter.setBrush(value == 0 ? QBrush(qColor(ColorRole::halo, theme)) : QBrush(Qt::NoBrush));
      painter.setPen(QPen(qColor(ColorRole::accent, theme), 2));
      painter.drawRoundedRect(pill, 5, 5);
    }
    QFont font = option.font;
    font.setItalic(isPreview);
    painter.setFont(font);
    painter.setPen(qColor(ink, theme));
    const bool dot = value == 0 && m_view->zerosAsDots();
    if (dot) {
      painter.drawText(cell, Qt::AlignCenter, QStringLiteral("·"));
    } else {
      putEntry(&painter, font, cell, index);
    }
  }

  MatrixView* m_view;
};

}  // namespace

MatrixView::MatrixView(MatrixModel* model, Selection* selection, QWidget* parent)
    : QTableView(parent), m_model(model), m_selection(selection) {
  setLayoutDirection(Qt::LeftToRight);  // mathematics is, in every language
  setModel(model);
  setItemDelegate(new EntryDelegate(this));
  setShowGrid(false);
  setMouseTracking(true);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::StrongFocus);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setCornerButtonEnabled(false);
  setFrameShape(QFrame::NoFrame);
  setProperty("look", "entries");
  applyLook(*this);  // before it is shown, because its cells are measured
  setUpHeaders();

  m_rest.setSingleShot(true);
  m_rest.setInterval(kRestMilliseconds);
  connect(&m_rest, &QTimer::timeout, this, [this] { emit restedOn(m_under); });
  connect(model, &MatrixModel::matrixChanged, this, &MatrixView::fitSections);
  connect(model, &MatrixModel::matrixChanged, this, &MatrixView::placeFrame);
  connect(selection, &Selection::hoverChanged, this, &MatrixView::repaintHighlighted);
  connect(selection, &Selection::selectionChanged, this, &MatrixView::repaintHighlighted);
  fitSections();
}

void MatrixView::setUpHeaders() {
  auto* across = new MatrixHeader(
      Qt::Horizontal, [this](int column) { return isColumnHighlighted(column); }, this);
  auto* down = new MatrixHeader(
      Qt::Vertical, [this](int row) { return isRowHighlighted(row); }, this);
  setHorizontalHeader(across);
  setVerticalHeader(down);
  across->setDefaultSectionSize(kColumnWidth);
  down->setDefaultSectionSize(kRowHeight);
  connect(across, &MatrixHeader::sectionHovered, this, [this](int column) {
    if (column < 0 || m_model->columnElement(column).id.empty()) return m_selection->unhover();
    m_selection->hover(m_model->columnElement(column));
  });
  connect(down, &MatrixHeader::sectionHovered, this, [this](int row) {
    tellCycle(row);
    if (row < 0) return m_selection->unhover();
    m_selection->hover(m_model->elementsOfRow(row));
  });
  for (auto* header : {across, down}) {
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QWidget::customContextMenuRequested, this, [this, header](QPoint at) {
      const int section = header->logicalIndexAt(at);
      if (section < 0) return;
      const bool isColumn = header->orientation() == Qt::Horizontal;
      const ElementId element = isColumn ? m_model->columnElement(section) : m_model->rowElement(section);
      if (!element.id.empty()) emit menuWanted(element, header->viewport()->mapToGlobal(at));
    });
  }
  connect(across, &QHeaderView::sectionClicked, this, [this](int column) {
    if (!m_model->columnElement(column).id.empty()) m_selection->select({m_model->columnElement(column)});
  });
  connect(down, &QHeaderView::sectionClicked, this,
          [this](int row) { m_selection->select({m_model->rowElement(row)}); });
}

/// Cells have the size of print, or are somewhat smaller where all of the matrix then fits. The last column
/// is wider by its bracket.
void MatrixView::fitSections() {
  const int rows = m_model->rowCount();
  const int columns = m_model->columnCount();
  if (rows == 0 || columns == 0) return;
  const int widest = scaledPixels(kColumnWidth);
  const int highest = scaledPixels(kRowHeight);
  const int wide = width() - verticalHeader()->sizeHint().width() - kMatrixBracket - 2;
  const int high = height() - horizontalHeader()->sizeHint().height() - 2;
  const int cellWidth =
      wide / columns >= scaledPixels(kNarrowest) ? std::min(wide / columns, widest) : widest;
  const int cellHeight = high / rows >= scaledPixels(kLowest) ? std::min(high / rows, highest) : highest;
  verticalHeader()->setDefaultSectionSize(cellHeight);
  const std::vector<int> widths = widthsOfQuantity();
  // What most columns have, all at once: one by one thousands of them take long.
  horizontalHeader()->setDefaultSectionSize(widths.empty() ? cellWidth : widths.back());
  for (int column = 0; column < columns; ++column) {
    const int entry = widths.empty() ? cellWidth : widths[std::min(widths.size() - 1, std::size_t(column))];
    const int size = entry + (column == columns - 1 ? kMatrixBracket : 0);
    if (horizontalHeader()->sectionSize(column) != size) horizontalHeader()->resizeSection(column, size);
  }
  updateGeometries();
  viewport()->update();
}

/// By column, as wide as its entries; the last one for all columns behind. Empty for whole numbers.
std::vector<int> MatrixView::widthsOfQuantity() const {
  if (m_model->table() == nullptr || m_model->table()->integers()) return {};
  const int rows = std::min(m_model->rowCount(), kRowsMeasured);
  const int columns = std::min(m_model->columnCount(), kColumnsMeasured);
  std::vector<int> widths(static_cast<std::size_t>(columns), kNarrowest + 5);
  // Chords of the T-T graph have long names: 72''''.
  const QFontMetrics metrics(horizontalHeader()->font());
  for (int column = 0; column < columns; ++column) {
    const QString name = m_model->headerData(column, Qt::Horizontal).toString();
    int& width = widths[static_cast<std::size_t>(column)];
    width = std::max(width, metrics.horizontalAdvance(name) + kHeadingGap);
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const QModelIndex index = m_model->index(row, column);
      if (index.data(MatrixModel::ValueRole).toInt() == 0) continue;
      int& width = widths[static_cast<std::size_t>(column)];
      width = std::max(width, static_cast<int>(putEntry(nullptr, font(), {}, index)) + 2 * kPillMargin + 8);
    }
  }
  for (int& width : widths) width = std::min(width, kWidest);
  if (m_model->columnCount() > columns) widths.push_back(*std::max_element(widths.begin(), widths.end()));
  return widths;
}

void MatrixView::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  fitSections();
}

void MatrixView::setZerosAsDots(bool dots) {
  m_zerosAsDots = dots;
  viewport()->update();
}

void MatrixView::setFramed(const ElementId& mesh, const ElementId& joint) {
  m_framedMesh = mesh;
  m_framedJoint = joint;
  placeFrame();
}

void MatrixView::placeFrame() {
  const auto find = [](int count, const auto& elementAt, const ElementId& wanted) {
    for (int i = 0; i < count; ++i)
      if (elementAt(i) == wanted) return i;
    return -1;
  };
  const auto rowOf = [&](const ElementId& wanted) {
    return find(
        m_model->rowCount(), [this](int row) { return m_model->rowElement(row); }, wanted);
  };
  const auto columnOf = [&](const ElementId& wanted) {
    return find(
        m_model->columnCount(), [this](int column) { return m_model->columnElement(column); }, wanted);
  };
  m_framedRow = m_framedColumn = -1;
  if (!m_framedMesh.id.empty() && m_model->isThere()) {
    m_framedRow = rowOf(m_framedMesh);
    if (m_framedRow >= 0) {
      m_framedColumn = columnOf(m_framedJoint);
    } else if ((m_framedColumn = columnOf(m_framedMesh)) >= 0) {
      m_framedRow = rowOf(m_framedJoint);
    }
    if (m_framedRow < 0 || m_framedColumn < 0) m_framedRow = m_framedColumn = -1;
    frameTheChordThatCounts();
  }
  viewport()->update();
}

/// A mesh has two chords in the T-T graph, one after the other; a joint is in the circuit of one at most.
void MatrixView::frameTheChordThatCounts() {
  if (m_framedRow < 0) return;
  const auto isZero = [this] {
    return m_model->index(m_framedRow, m_framedColumn).data(MatrixModel::ValueRole).toInt() == 0;
  };
  if (!isZero()) return;
  const bool byRows = m_model->rowElement(m_framedRow) == m_framedMesh;
  int& place = byRows ? m_framedRow : m_framedColumn;
  const int count = byRows ? m_model->rowCount() : m_model->columnCount();
  if (place + 1 >= count) return;
  const ElementId next = byRows ? m_model->rowElement(place + 1) : m_model->columnElement(place + 1);
  if (next != m_framedMesh) return;
  ++place;
  if (isZero()) --place;
}

bool MatrixView::showFramed() {
  if (m_framedRow < 0) return false;
  const QModelIndex index = m_model->index(m_framedRow, m_framedColumn);
  setCurrentIndex(index);
  scrollTo(index);
  emit restedOn(index);
  return true;
}

bool MatrixView::isRowHighlighted(int row) const {
  return m_model->isThere() && m_highlighted.contains(m_model->rowElement(row));
}

bool MatrixView::isColumnHighlighted(int column) const {
  return m_model->isThere() && m_highlighted.contains(m_model->columnElement(column));
}

bool MatrixView::isColumnTinted(int column) const {
  return m_highlighted.size() == 1 && isColumnHighlighted(column);
}

void MatrixView::repaintHighlighted() {
  // What is under the mouse takes precedence, so that a selection does not blur what is pointed at.
  const auto& highlighted = m_selection->hovered().empty() ? m_selection->selected() : m_selection->hovered();
  m_highlighted = {highlighted.begin(), highlighted.end()};
  viewport()->update();
  horizontalHeader()->viewport()->update();
  verticalHeader()->viewport()->update();
}

void MatrixView::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  const int rows = m_model->rowCount();
  const int columns = m_model->columnCount();
  if (rows == 0 || columns == 0) return;
  QPainter painter(viewport());
  const Theme theme = themeOf(palette());
  const int top = rowViewportPosition(0);
  const int bottom = rowViewportPosition(rows - 1) + rowHeight(rows - 1);
  painter.setPen(QPen(qColor(ColorRole::ink, theme), 2));
  const int right = columnViewportPosition(columns - 1) + columnWidth(columns - 1) - 5;
  paintBracket(painter, right, top + 1, bottom - 1, -7);
  const int parted = m_model->partition();
  if (parted <= 0 || parted >= columns) return;
  painter.setPen(QPen(qColor(ColorRole::secondary, theme), 1.4, Qt::DashLine));
  const int x = columnViewportPosition(parted);
  painter.drawLine(x, top + 3, x, bottom - 3);
}

void MatrixView::hoverCell(const QModelIndex& index) {
  if (index == m_under) return;
  m_under = index;
  emit restedOn({});
  if (!index.isValid()) {
    m_rest.stop();
    tellCycle(-1);
    emit entryHovered({}, {});
    m_selection->unhover();
    return;
  }
  m_rest.start();
  tellCycle(index.row());
  emit entryHovered(m_model->rowElement(index.row()), m_model->columnElement(index.column()));
  m_selection->hover(m_model->elementsOfCell(index.row(), index.column()));
}

void MatrixView::tellCycle(int row) {
  const bool cycles = m_model->result().rowsAreCycles;
  emit cycleHovered(cycles && row >= 0 ? MeshId(m_model->rowElement(row).id) : MeshId());
}

void MatrixView::mouseMoveEvent(QMouseEvent* event) {
  QTableView::mouseMoveEvent(event);
  hoverCell(indexAt(event->pos()));
}

void MatrixView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QModelIndex index = indexAt(event->pos());
  if (!index.isValid()) return m_selection->clear();
  std::set<ElementId> elements{m_model->rowElement(index.row()), m_model->columnElement(index.column())};
  std::erase_if(elements, [](const ElementId& element) { return element.id.empty(); });
  m_selection->select(std::move(elements));
}

void MatrixView::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  if (index.isValid()) emit menuWanted(m_model->rowElement(index.row()), event->globalPos());
}

void MatrixView::leaveEvent(QEvent* event) {
  QTableView::leaveEvent(event);
  hoverCell({});
}

void MatrixView::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) viewport()->update();
  if (event->type() == QEvent::FontChange) fitSections();
}

}  // namespace geargraph

#include "moc_matrix_view.cpp"
