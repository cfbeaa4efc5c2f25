#include "ui/theme/frozen_column.h"

#include <QAbstractItemModel>
#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QStyledItemDelegate>

namespace geargraph {
namespace {

/// Paints as the table's delegate does, which a view may not share: editors are those of the table alone.
class PaintingDelegate final : public QStyledItemDelegate {
 public:
  PaintingDelegate(QAbstractItemDelegate* of, QObject* parent) : QStyledItemDelegate(parent), m_of(of) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    m_of->paint(painter, option, index);
  }
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return m_of->sizeHint(option, index);
  }
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override {
    return m_of->helpEvent(event, view, option, index);
  }

 private:
  QAbstractItemDelegate* m_of;
};

}  // namespace

FrozenColumn::FrozenColumn(QTableView* table, QHeaderView* heads) : QTableView(table), m_table(table) {
  if (heads != nullptr) setHorizontalHeader(heads);
  setModel(table->model());
  setItemDelegate(new PaintingDelegate(table->itemDelegate(), this));
  setSelectionModel(table->selectionModel());
  setSelectionBehavior(table->selectionBehavior());
  setSelectionMode(table->selectionMode());
  setEditTriggers(NoEditTriggers);
  setShowGrid(table->showGrid());
  setWordWrap(table->wordWrap());
  setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::NoFrame);
  setMouseTracking(true);
  setContextMenuPolicy(table->contextMenuPolicy());
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(table->verticalScrollMode());
  verticalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setHighlightSections(false);
  table->installEventFilter(this);
  follow();
  hide();
}

void FrozenColumn::follow() {
  connect(this, &QTableView::clicked, m_table, &QTableView::clicked);
  connect(this, &QTableView::entered, m_table, &QTableView::entered);
  connect(this, &QTableView::doubleClicked, m_table, [this](const QModelIndex& index) {
    const bool isEditable =
        m_table->editTriggers().testFlag(DoubleClicked) && (index.flags() & Qt::ItemIsEditable) != 0;
    if (!isEditable) return;
    m_table->scrollTo(index);  // from beneath this column
    m_table->edit(index);
  });
  connect(this, &QWidget::customContextMenuRequested, m_table, &QWidget::customContextMenuRequested);
  connect(m_table->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(),
          &QScrollBar::setValue);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, m_table->verticalScrollBar(),
          &QScrollBar::setValue);
  connect(m_table->horizontalScrollBar(), &QScrollBar::valueChanged, this, &FrozenColumn::place);
  connect(m_table->horizontalScrollBar(), &QScrollBar::rangeChanged, this, &FrozenColumn::place);
  connect(m_table->horizontalHeader(), &QHeaderView::sectionResized, this, &FrozenColumn::place);
  connect(m_table->horizontalHeader(), &QHeaderView::geometriesChanged, this, &FrozenColumn::place);
  connect(m_table->model(), &QAbstractItemModel::modelReset, this, &FrozenColumn::place);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &FrozenColumn::revealCurrent);
}

/// It is in sight only where the table's own first column is not, or not whole.
void FrozenColumn::place() {
  const bool isNeeded = m_table->horizontalScrollBar()->value() > 0 && m_table->model()->columnCount() > 1;
  if (!isNeeded) return hide();
  setAccessibleName(m_table->accessibleName());
  for (int column = 1; column < m_table->model()->columnCount(); ++column) setColumnHidden(column, true);
  const int width = m_table->columnWidth(0);
  setColumnHidden(0, false);
  setColumnWidth(0, width);
  verticalHeader()->setMinimumSectionSize(m_table->verticalHeader()->minimumSectionSize());
  verticalHeader()->setDefaultSectionSize(m_table->verticalHeader()->defaultSectionSize());
  horizontalHeader()->setFixedHeight(m_table->horizontalHeader()->height());
  const QRect inside = m_table->viewport()->geometry();
  const int left = m_table->isRightToLeft() ? inside.right() + 1 - width : inside.left();
  setGeometry(left, inside.top() - m_table->horizontalHeader()->height(), width,
              inside.height() + m_table->horizontalHeader()->height());
  verticalScrollBar()->setValue(m_table->verticalScrollBar()->value());
  show();
  raise();
}

/// A cell that keys have gone to is not left beneath the column.
void FrozenColumn::revealCurrent(const QModelIndex& current) {
  if (!isVisible() || !current.isValid() || current.column() == 0) return;
  const QRect cell = m_table->visualRect(current);
  const int hidden = m_table->isRightToLeft() ? cell.right() - (m_table->viewport()->width() - width())
                                              : width() - cell.left();
  if (hidden <= 0 || hidden > cell.width() + width()) return;
  QScrollBar* bar = m_table->horizontalScrollBar();
  bar->setValue(bar->value() - hidden);
}

bool FrozenColumn::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (watched == m_table && (type == QEvent::Resize || type == QEvent::LayoutRequest)) place();
  return QTableView::eventFilter(watched, event);
}

bool FrozenColumn::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::Leave) emit left();
  return QTableView::viewportEvent(event);
}

}  // namespace geargraph

#include "moc_frozen_column.cpp"
