#include "ui/panels/states_table.h"

#include <QEvent>
#include <QLineEdit>
#include <QPainter>
#include <QShortcut>
#include <numeric>

#include "ui/document/typed_length.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/frozen_column.h"

namespace geargraph {
namespace {

constexpr int kMargin = 16;      // at the left and right edge of the table
constexpr double kDotRoom = 18;  // left of a torque
constexpr int kHeadHeight = 42;
constexpr int kNameBand = 18;  // of a coupling's name, above what it holds
constexpr int kStateHeight = 24;

void paintDot(QPainter& painter, const QPointF& centre, bool engaged, Theme theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (engaged) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(qColor(ColorRole::ink, theme));
    painter.drawEllipse(centre, 6, 6);
  } else {
    painter.setPen(QPen(qColor(ColorRole::secondary, theme), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, 2, 2);
  }
}

int advanceOf(const QFont& font, const QString& text) {
  return QFontMetrics(font).horizontalAdvance(text);
}

/// A triangle before the name of the state that is engaged.
void paintRunning(QPainter& painter, const QPointF& at, Theme theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(qColor(ColorRole::accent, theme));
  painter.drawPolygon(QPolygonF{at + QPointF(0, -5), at + QPointF(8, 0), at + QPointF(0, 5)});
}

/// The table itself, or that of its column that stays.
const StatesTable* tableAround(const QWidget* view) {
  if (const auto* table = qobject_cast<const StatesTable*>(view)) return table;
  return view == nullptr ? nullptr : qobject_cast<const StatesTable*>(view->parentWidget());
}

}  // namespace

void StatesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  painter->setLayoutDirection(Qt::LeftToRight);  // a minus sign stands before its number
  const auto* model = static_cast<const StatesModel*>(index.model());
  const Theme theme = themeOf(option.palette);
  const QRectF cell(option.rect);
  const bool running = index.data(StatesModel::RunningRole).toBool();
  painter->save();
  if (running) {
    QColor band = qColor(ColorRole::halo, theme);
    band.setAlphaF(0.45F);
    painter->fillRect(option.rect, band);
  }
  if (const StatesTable* table = tableAround(option.widget);
      table != nullptr && table->lookedAt() == index.row()) {
    constexpr int kEdge = 2;
    painter->fillRect(QRect(option.rect.left(), option.rect.bottom() + 1 - kEdge, option.rect.width(), kEdge),
                      qColor(ColorRole::accent, theme));
  }
  painter->setPen(qColor(ColorRole::ink, theme));
  QFont font = option.font;
  const QString text = index.data().toString();
  if (index.column() == 0) {
    if (running) paintRunning(*painter, {cell.left() + 6, cell.center().y()}, theme);
    font.setBold(true);
    painter->setFont(font);
    painter->setPen(qColor(running ? ColorRole::accent : ColorRole::ink, theme));
    painter->drawText(cell.adjusted(kMargin + 4, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
  } else if (model->couplingAt(index.column()) >= 0) {
    const bool showsTorque = !text.isEmpty();
    const QPointF centre(!showsTorque ? cell.center().x() : cell.left() + kDotRoom / 2, cell.center().y());
    paintDot(*painter, centre, index.data(StatesModel::EngagedRole).toBool(), theme);
    if (showsTorque) {
      painter->setFont(font);
      painter->setPen(qColor(ColorRole::ink, theme));
      painter->drawText(cell.adjusted(kDotRoom, 0, -4, 0), Qt::AlignRight | Qt::AlignVCenter, text);
    }
  } else {
    const bool remark = index.data(StatesModel::RemarkRole).toBool();
    if (remark) painter->setPen(qColor(text.size() > 1 ? ColorRole::warning : ColorRole::secondary, theme));
    const bool circulates = model->isTail(index.column(), StatesModel::Tail::circulating) && text.size() > 1;
    if (circulates) painter->setPen(qColor(ColorRole::warning, theme));
    if (model->isTail(index.column(), StatesModel::Tail::ratio) && !remark) font.setBold(true);
    if (model->isTail(index.column(), StatesModel::Tail::links)) {
      const bool asks = model->lacksLinks(index.row());
      painter->setPen(qColor(asks ? ColorRole::accent : ColorRole::secondary, theme));
    }
    painter->setFont(font);
    const bool last = index.column() == model->columnCount() - 1;
    painter->drawText(cell.adjusted(0, 0, last ? -kMargin : -6, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  }
  painter->restore();
}

StatesHeader::StatesHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setSectionResizeMode(QHeaderView::Fixed);
  setHighlightSections(false);
  setSectionsClickable(true);
  fitHeight();
}

void StatesHeader::fitHeight() {
  setFixedHeight(scaledPixels(kHeadHeight));
}

/// An editor above the heading: Enter or losing the focus accepts the name; Esc cancels, and so do other
/// columns.
void StatesHeader::rename(int section) {
  auto* editor = new QLineEdit(model()->headerData(section, Qt::Horizontal).toString(), viewport());
  editor->setMaxLength(kMaxTyped);
  editor->setGeometry(sectionViewportPosition(section), 2, std::max(sectionSize(section), 56), 26);
  editor->selectAll();
  editor->show();
  editor->setFocus();
  const auto finish = [editor] {
    editor->setProperty("done", true);
    editor->deleteLater();
  };
  connect(model(), &QAbstractItemModel::modelReset, editor, finish);
  connect(new QShortcut(Qt::Key_Escape, editor, {}, {}, Qt::WidgetShortcut), &QShortcut::activated, editor,
          finish);
  connect(editor, &QLineEdit::editingFinished, this, [this, editor, section, finish] {
    if (editor->property("done").toBool()) return;  // Return and the loss of focus both end it
    finish();
    emit renamed(section, editor->text());
  });
}

void StatesHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const Theme theme = themeOf(palette());
  const auto* states = static_cast<const StatesModel*>(model());
  const QString text = states->headerData(section, Qt::Horizontal).toString();
  const int band = scaledPixels(kNameBand);
  painter->save();
  if (states->couplingAt(section) >= 0) {
    QFont bold = font();
    bold.setBold(true);
    painter->setFont(bold);
    const bool engaged = states->headerData(section, Qt::Horizontal, StatesModel::EngagedRole).toBool();
    if (engaged) {
      const int half = std::max(20, advanceOf(bold, text) + 12) / 2;
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setPen(Qt::NoPen);
      painter->setBrush(qColor(ColorRole::ink, theme));
      painter->drawRoundedRect(QRect(rect.center().x() - half, rect.top() + 4, 2 * half, band), band / 2.0,
                               band / 2.0);
    }
    painter->setPen(qColor(engaged ? ColorRole::sheet : ColorRole::ink, theme));
    painter->drawText(QRect(rect.left(), rect.top() + 4, rect.width(), band), Qt::AlignCenter, text);
    QFont small = font();
    small.setPixelSize(smallPixels() - 1);
    painter->setFont(small);
    painter->setPen(qColor(ColorRole::secondary, theme));
    painter->drawText(rect.adjusted(0, band + 3, 0, -3), Qt::AlignCenter,
                      states->headerData(section, Qt::Horizontal, StatesModel::HoldsRole).toString());
  } else {
    painter->setPen(qColor(ColorRole::secondary, theme));
    const bool last = section == states->columnCount() - 1;
    const Qt::Alignment side = section == 0 ? Qt::AlignLeft : Qt::AlignRight;
    painter->drawText(rect.adjusted(section == 0 ? kMargin + 4 : 0, band + 3, last ? -kMargin : -6, -3),
                      side | Qt::AlignVCenter, text);
  }
  painter->restore();
}

StatesTable::StatesTable(StatesModel* model, QWidget* parent)
    : QTableView(parent),
      m_model(model),
      m_heads(new StatesHeader(this)),
      m_firstHead(new StatesHeader(this)),
      m_first(nullptr) {
  setHorizontalHeader(m_heads);
  setModel(model);
  setItemDelegate(new StatesDelegate(this));
  verticalHeader()->hide();
  setShowGrid(false);
  setMouseTracking(true);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setContextMenuPolicy(Qt::CustomContextMenu);
  m_heads->setContextMenuPolicy(Qt::CustomContextMenu);
  auto* first = new FrozenColumn(this, m_firstHead);
  m_first = first;
  connect(first, &FrozenColumn::left, this, &StatesTable::left);
  fitHeights();
  connect(model, &QAbstractItemModel::modelReset, this, &StatesTable::fitColumns);
  connect(model, &StatesModel::computed, this, &StatesTable::fitColumns);
}

void StatesTable::fitHeights() {
  for (StatesHeader* heads : {m_heads, m_firstHead}) heads->fitHeight();
  verticalHeader()->setDefaultSectionSize(scaledPixels(kStateHeight));
}

/// Larger type needs higher rows and wider columns.
void StatesTable::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  if (event->type() != QEvent::FontChange || m_first == nullptr) return;
  fitHeights();
  fitColumns();
}

int StatesTable::advance(Face face, const QString& text) const {
  constexpr int kMaxKept = 4096;
  if (m_measured != font() || m_advances.size() > kMaxKept) m_advances.clear();
  m_measured = font();
  const QPair key(static_cast<int>(face), text);
  const auto known = m_advances.constFind(key);
  if (known != m_advances.constEnd()) return *known;
  QFont own = font();
  if (face == Face::bold) own.setBold(true);
  if (face == Face::small) own.setPixelSize(smallPixels() - 1);
  return *m_advances.insert(key, QFontMetrics(own).horizontalAdvance(text));
}

int StatesTable::widthOf(int column) const {
  constexpr int kRowsMeasured = 200;
  const auto head = [&](int role) { return m_model->headerData(column, Qt::Horizontal, role).toString(); };
  if (m_model->couplingAt(column) >= 0) {
    int torque = 0;
    for (int row = 0; row < std::min(m_model->rowCount(), kRowsMeasured); ++row) {
      const QString text = m_model->index(row, column).data().toString();
      if (!text.isEmpty())
        torque = std::max(torque, static_cast<int>(kDotRoom) + 8 + advance(Face::plain, text));
    }
    return std::max({36, torque, 10 + advance(Face::bold, head(Qt::DisplayRole)),
                     8 + advance(Face::small, head(StatesModel::HoldsRole))});
  }
  const bool isBold = column == 0 || m_model->isTail(column, StatesModel::Tail::ratio);
  int width = advance(Face::plain, head(Qt::DisplayRole));
  for (int row = 0; row < std::min(m_model->rowCount(), kRowsMeasured); ++row) {
    width = std::max(
        width, advance(isBold ? Face::bold : Face::plain, m_model->index(row, column).data().toString()));
  }
  const bool atEdge = column == 0 || column == m_model->columnCount() - 1;
  return std::min(width + 12 + (atEdge ? kMargin : 0), scaledPixels(220));
}

std::vector<int> StatesTable::widthsNow() const {
  std::vector<int> widths;
  for (int column = 0; column < m_model->columnCount(); ++column) widths.push_back(widthOf(column));
  return widths;
}

// A section is given its size once, and only another one: every change paints all that is right of it.
void StatesTable::fitColumns() {
  std::vector<int> widths = widthsNow();
  const int rest = viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0);
  // What is left over parts the numbers from the dots.
  if (rest > 0 && !widths.empty()) widths[static_cast<std::size_t>(m_model->couplingCount()) + 1] += rest;
  for (int column = 0; column < m_model->columnCount(); ++column) {
    const int width = widths[static_cast<std::size_t>(column)];
    if (m_heads->sectionSize(column) != width) m_heads->resizeSection(column, width);
  }
}

void StatesTable::setLookedAt(int row) {
  if (row == m_lookedAt) return;
  m_lookedAt = row;
  if (row >= 0 && row < m_model->rowCount()) scrollTo(m_model->index(row, 0));
  viewport()->update();
  m_first->viewport()->update();
}

void StatesTable::leaveEvent(QEvent* event) {
  QTableView::leaveEvent(event);
  emit left();
}

void StatesTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  fitColumns();
}

}  // namespace geargraph

#include "moc_states_table.cpp"
