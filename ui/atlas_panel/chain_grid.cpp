#include "ui/atlas_panel/chain_grid.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QPointer>
#include <QStyledItemDelegate>
#include <QThreadPool>
#include <algorithm>

#include "core/presentation/diagrams/chain_drawing.h"
#include "ui/atlas_panel/chain_picture.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr QSize kCell{96, 112};
constexpr int kCellGap = 3;
constexpr int kNumberHeight = 24;

QImage chainImage(const Chain& chain, Theme theme, qreal ratio) {
  QImage image(ChainListModel::kPicture * ratio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  paintChain(painter, chainDrawing(chain), QRectF(QPointF(0, 0), QSizeF(ChainListModel::kPicture)), theme);
  return image;
}

/// A cell: picture and number on a card; the chain of the train says so below its number.
class ChainCell final : public QStyledItemDelegate {
 public:
  ChainCell(ChainListModel* model, QWidget* view) : QStyledItemDelegate(view), m_model(model), m_view(view) {}

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& /*option*/,
                               const QModelIndex& /*index*/) const override {
    return {scaledPixels(kCell.width()), scaledPixels(kCell.height())};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const AtlasChain* chain = m_model->chainAt(index);
    const Theme theme = themeOf(m_view->palette());
    const bool isChosen = (option.state & QStyle::State_Selected) != 0;
    const bool isOwn = m_model->isOwn(chain);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect card = option.rect.adjusted(kCellGap, kCellGap, -kCellGap, -kCellGap);
    const bool isMarked = isChosen || isOwn;
    painter->setPen(
        QPen(qColor(isMarked ? ColorRole::accent : ColorRole::hairline, theme), isChosen ? 2 : 1));
    painter->setBrush(isChosen ? chosenColor(theme) : qColor(ColorRole::sheet, theme));
    painter->drawRoundedRect(QRectF(card).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);

    const int foot = scaledPixels(kNumberHeight);
    const QRect room = card.adjusted(0, 3, 0, -foot);
    const QImage picture = m_model->picture(chain, theme, painter->device()->devicePixelRatioF());
    if (!picture.isNull()) {
      QRect place(QPoint(0, 0), ChainListModel::kPicture);
      place.moveCenter(room.center());
      painter->drawImage(place, picture);
    }
    QFont font = option.font;
    font.setBold(isMarked);
    painter->setFont(font);
    painter->setPen(qColor(isMarked ? ColorRole::accent : ColorRole::ink, theme));
    painter->drawText(QRect(card.left(), card.bottom() - foot, card.width(), foot), Qt::AlignCenter,
                      index.data(Qt::DisplayRole).toString());
    painter->restore();
  }

 private:
  ChainListModel* m_model;
  QWidget* m_view;
};

}  // namespace

// --- the list ---------------------------------------------------------------------------------------------

void ChainListModel::setChains(std::vector<const AtlasChain*> chains) {
  if (chains == m_chains) return;
  beginResetModel();
  m_chains = std::move(chains);
  endResetModel();
}

const AtlasChain* ChainListModel::chainAt(const QModelIndex& index) const {
  return index.isValid() ? m_chains[static_cast<std::size_t>(index.row())] : nullptr;
}

QModelIndex ChainListModel::indexOf(const AtlasChain* chain) const {
  const auto found = std::find(m_chains.begin(), m_chains.end(), chain);
  return found == m_chains.end() ? QModelIndex() : index(static_cast<int>(found - m_chains.begin()));
}

void ChainListModel::setOwn(std::set<const AtlasChain*> own) {
  if (own == m_own) return;
  m_own = std::move(own);
  if (!m_chains.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

QImage ChainListModel::picture(const AtlasChain* chain, Theme theme, qreal devicePixelRatio) {
  const Look look{theme, devicePixelRatio};
  if (!(look == m_look)) {
    m_look = look;
    m_pictures.clear();
    m_waiting.clear();
  }
  if (const auto found = m_pictures.find(chain); found != m_pictures.end()) return found->second;
  if (!m_waiting.insert(chain).second) return {};
  QThreadPool::globalInstance()->start([self = QPointer<ChainListModel>(this), chain, look] {
    const QImage image = chainImage(chain->chain, look.theme, look.ratio);
    QMetaObject::invokeMethod(qApp, [self, chain, look, image] {
      if (self) self->take(chain, look, image);
    });
  });
  return {};
}

void ChainListModel::take(const AtlasChain* chain, const Look& look, const QImage& image) {
  if (!(look == m_look)) return;  // another theme meanwhile
  m_pictures[chain] = image;
  m_waiting.erase(chain);
  if (const QModelIndex place = indexOf(chain); place.isValid()) emit dataChanged(place, place);
  if (m_waiting.empty()) emit drawn();
}

int ChainListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_chains.size());
}

QVariant ChainListModel::data(const QModelIndex& index, int role) const {
  const AtlasChain* chain = chainAt(index);
  if (chain == nullptr) return {};
  const QString number = QString::fromStdString(chain->number.toString());
  if (role == Qt::DisplayRole) return number;
  if (role == Qt::AccessibleTextRole) return isOwn(chain) ? tr("%1, of your train").arg(number) : number;
  if (role == Qt::ToolTipRole) {
    return tr("%1\naxes: %2\ngear pairs / carrier: %3")
        .arg(number, QString::fromStdString(axesText(chain->chain)),
             QString::fromStdString(meshesText(chain->chain)));
  }
  return {};
}

// --- the cells --------------------------------------------------------------------------------------------

ChainGrid::ChainGrid(ChainListModel* model, QWidget* parent) : QListView(parent), m_chains(model) {
  setObjectName(QStringLiteral("chains"));
  setAccessibleName(tr("Chains"));
  setModel(model);
  setItemDelegate(new ChainCell(model, this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  connect(this, &QListView::doubleClicked, this,
          [this](const QModelIndex& index) { emit openWanted(m_chains->chainAt(index)); });
}

const AtlasChain* ChainGrid::current() const {
  return m_chains->chainAt(currentIndex());
}

void ChainGrid::setCurrent(const AtlasChain* chain) {
  const QModelIndex place = m_chains->indexOf(chain);
  if (!place.isValid()) return;
  setCurrentIndex(place);
  scrollTo(place);
}

void ChainGrid::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QListView::currentChanged(current, previous);
  if (current.isValid()) emit chosen(m_chains->chainAt(current));
}

void ChainGrid::keyPressEvent(QKeyEvent* event) {
  const bool opens = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (opens && current() != nullptr) {
    emit openWanted(current());
  } else if (event->text() == QLatin1String("/")) {
    emit findWanted();
  } else {
    QListView::keyPressEvent(event);
  }
}

}  // namespace geargraph

#include "moc_chain_grid.cpp"
