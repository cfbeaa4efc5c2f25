#include "ui/help/search_popup.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kRowHeight = 26;
constexpr int kPopupMargin = 12;
constexpr int kKindGap = 14;

/// As wide as the longest word for a kind, in any language and type.
int kindWidth(const QFontMetrics& metrics) {
  int width = 0;
  for (const QString& kind : SearchModel::kinds()) width = std::max(width, metrics.horizontalAdvance(kind));
  return width + kKindGap;
}

/// The kind, the title, and at the right the shortcut or the place; grey where it is not possible now.
class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme theme = themeOf(option.palette);
    painter->save();
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->fillRect(option.rect, qColor(ColorRole::halo, theme));
    }
    QRect room = option.rect.adjusted(kPopupMargin, 0, -kPopupMargin, 0);
    const QColor secondary = qColor(ColorRole::secondary, theme);
    QFont small = option.font;
    small.setPixelSize(smallPixels());
    painter->setFont(small);
    painter->setPen(secondary);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, index.data(SearchModel::KindRole).toString());
    const QString side = index.data(SearchModel::SideRole).toString();
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, side);
    room.adjust(kindWidth(QFontMetrics(small)), 0, -QFontMetrics(small).horizontalAdvance(side) - 14, 0);
    painter->setFont(option.font);
    const bool possible = index.data(SearchModel::EnabledRole).toBool();
    painter->setPen(possible ? qColor(ColorRole::ink, theme) : secondary);
    const QString title =
        QFontMetrics(option.font).elidedText(index.data().toString(), Qt::ElideRight, room.width());
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, title);
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& /*option*/,
                               const QModelIndex& /*index*/) const override {
    return {200, scaledPixels(kRowHeight)};
  }
};

QLabel* makeLabel(const char* look, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setProperty("look", look);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

SearchPopup::SearchPopup(SearchModel* model, QWidget* window)
    : QFrame(window),
      m_model(model),
      m_list(new QListView(this)),
      m_pages(new QStackedWidget(this)),
      m_empty(makeLabel("empty", this)),
      m_definition(new QLabel(this)),
      m_detail(makeLabel("hint", this)) {
  setProperty("look", "card");
  setObjectName(QStringLiteral("searchPopup"));
  m_list->setModel(model);
  m_list->setObjectName(QStringLiteral("searchResults"));
  m_list->setItemDelegate(new EntryDelegate(m_list));
  m_list->setUniformItemSizes(true);
  m_list->setFocusPolicy(Qt::NoFocus);
  m_list->setMouseTracking(true);
  m_list->setFrameShape(QFrame::NoFrame);
  m_definition->setObjectName(QStringLiteral("searchDefinition"));
  m_definition->setWordWrap(true);
  m_definition->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_definition->setContentsMargins(kPopupMargin, 6, kPopupMargin, 6);
  m_detail->setObjectName(QStringLiteral("searchDetail"));
  m_detail->setContentsMargins(kPopupMargin, 4, kPopupMargin, 4);
  m_detail->setMinimumHeight(2 * kRowHeight - 8);
  m_detail->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_pages->addWidget(m_list);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_definition);
  auto* rule = new QFrame(this);
  rule->setProperty("look", "rule");
  rule->setFixedHeight(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(1, 5, 1, 3);
  layout->setSpacing(2);
  layout->addWidget(m_pages, 1);
  layout->addWidget(rule);
  layout->addWidget(m_detail);

  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    updateDetail();
    emit currentChanged(currentRow());
  });
  connect(m_list, &QListView::clicked, this, [this](const QModelIndex& index) { emit chosen(index.row()); });
  hide();
}

int SearchPopup::currentRow() const {
  return m_list->currentIndex().isValid() ? m_list->currentIndex().row() : -1;
}

void SearchPopup::setCurrent(int row) {
  m_list->setCurrentIndex(m_model->index(row, 0));
}

void SearchPopup::moveCurrent(int rows) {
  if (m_model->rowCount() > 0) setCurrent(std::clamp(currentRow() + rows, 0, m_model->rowCount() - 1));
}

void SearchPopup::showList(const QString& whyEmpty) {
  m_empty->setText(whyEmpty);
  m_pages->setCurrentIndex(m_model->rowCount() > 0 ? 0 : 1);
  setCurrent(0);
  updateDetail();
}

void SearchPopup::showDefinition(Term term) {
  const Definition& definition = definitionOf(term);
  const auto shown = [](std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).toHtmlEscaped();
  };
  QString text = QStringLiteral("<h3>%1 &nbsp; %2</h3><p>%3</p>")
                     .arg(shown(translated(definition.name)), shown(definition.symbol),
                          shown(translated(definition.text)));
  if (definition.equation != PaperEquation::none)
    text += tr("<p>Equation (%1) of the paper.</p>").arg(numberOf(definition.equation));
  m_definition->setText(text);
  m_pages->setCurrentWidget(m_definition);
  m_detail->setText(tr("F1 shows it with a picture and its lesson. Type to search on; Esc closes."));
}

int SearchPopup::heightForResults(int most) const {
  constexpr int kMinRows = 4;
  const int rows = std::max(m_model->rowCount(), kMinRows);
  return std::min(most, rows * scaledPixels(kRowHeight) + m_detail->minimumHeight() + 22);
}

bool SearchPopup::isDefinition() const {
  return m_pages->currentWidget() == m_definition;
}

void SearchPopup::updateDetail() {
  m_detail->setText(m_list->currentIndex().data(SearchModel::DetailRole).toString());
}

}  // namespace geargraph

#include "moc_search_popup.cpp"
