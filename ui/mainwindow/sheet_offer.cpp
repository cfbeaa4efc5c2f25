#include "ui/mainwindow/sheet_offer.h"

#include <QBoxLayout>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <array>

#include "core/mechanism/model/edits.h"
#include "ui/canvas/thumbnail.h"
#include "ui/panels/insert_set_dialog.h"
#include "ui/panels/set_preview.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/icons.h"

namespace geargraph {
namespace {

constexpr QSize kCardPicture(66, 48);
constexpr int kCardColumns = 4;
/// The kinds that are most asked for; all others are in the dialog.
constexpr std::array kOffered = {"planetary", "differential", "reverted", "ravigneaux", "simpson", "worm"};

/// Two links and an arrow, as they are drawn by hand.
Mechanism drawnPair() {
  Mechanism pair = emptyMechanism();
  const LinkId ground = pair.links.front().id;
  pair.view.nodes[ground] = {0, 0};
  pair = withLink(std::move(pair), {84, -46}).value();
  return withTurningJoint(std::move(pair), ground, pair.links.back().id).value();
}

}  // namespace

SheetOffer::SheetOffer(QWidget* sheet) : QFrame(sheet) {
  setObjectName(QStringLiteral("sheetOffer"));
  setAccessibleName(tr("Begin"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* heading = new QLabel(tr("Draw, or insert a set"), this);
  heading->setProperty("look", "heading");
  auto* cards = new QGridLayout;
  cards->setSpacing(6);
  QToolButton* draw = addCard(
      tr("Draw"), tr("Draw links and joints by hand: the tool Link, then click on the sheet"), "offerDraw");
  connect(draw, &QToolButton::clicked, this, &SheetOffer::drawWanted);
  const std::vector<InsertableSet> kinds = insertableSets();
  for (const char* id : kOffered) {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const InsertableSet& each) {
      return QLatin1String(each.id) == QLatin1String(id);
    });
    QToolButton* card =
        addCard(kind->name, tr("Choose teeth and ratio, and insert it: %1").arg(kind->name), id);
    connect(card, &QToolButton::clicked, this, [this, id] { emit setWantedOf(QLatin1String(id)); });
  }
  m_more = addCard(tr("More sets…"),
                   tr("All sets: belts, wrists, strain wave, cycloidal and RV reducers, too"), "offerMore");
  connect(m_more, &QToolButton::clicked, this, [this] { emit setWantedOf({}); });
  for (std::size_t i = 0; i < m_cards.size(); ++i)
    cards->addWidget(m_cards[i], static_cast<int>(i) / kCardColumns, static_cast<int>(i) % kCardColumns);
  auto* foot = new QHBoxLayout;
  const auto addButton = [&](const QString& text, const char* name, auto signal) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, signal);
    foot->addWidget(button);
  };
  addButton(tr("Open an example…"), "offerExamples", &SheetOffer::examplesWanted);
  addButton(tr("Gearbox from ratios…"), "offerDesign", &SheetOffer::designWanted);
  foot->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 10, 14, 10);
  layout->addWidget(heading);
  layout->addLayout(cards);
  layout->addLayout(foot);
  sheet->installEventFilter(this);
  hide();
}

QToolButton* SheetOffer::addCard(const QString& text, const QString& tip, const char* name) {
  auto* card = new QToolButton(this);
  card->setObjectName(QLatin1String(name));
  card->setText(text);
  card->setToolTip(tip);
  card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  card->setIconSize(kCardPicture);
  card->setAutoRaise(true);
  card->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  card->setFocusPolicy(Qt::TabFocus);
  m_cards.push_back(card);
  return card;
}

void SheetOffer::setWanted(bool wanted) {
  m_isWanted = wanted;
  fitSheet();
}

void SheetOffer::fitSheet() {
  const QWidget* sheet = parentWidget();
  const QSize size = sizeHint();
  const bool fits = size.width() <= sheet->width() && size.height() <= sheet->height();
  if (fits)
    setGeometry(
        QRect(QPoint((sheet->width() - size.width()) / 2, (sheet->height() - size.height()) / 2), size));
  setVisible(m_isWanted && fits);
  if (isVisible()) raise();
}

void SheetOffer::paintCards() {
  const Theme theme = themeOf(palette());
  const double ratio = devicePixelRatioF();
  const auto drawn = digraphThumbnail(drawnPair(), theme, kCardPicture * ratio);
  if (drawn) {
    QPixmap pixmap = QPixmap::fromImage(*drawn);
    pixmap.setDevicePixelRatio(ratio);
    m_cards.front()->setIcon(pixmap);
  }
  const std::vector<InsertableSet> kinds = insertableSets();
  for (QToolButton* card : m_cards) {
    for (const InsertableSet& kind : kinds) {
      if (card->objectName() != QLatin1String(kind.id)) continue;
      if (const auto set = kind.usual())
        card->setIcon(SetPreview::picture(*set, kCardPicture, palette(), ratio));
    }
  }
  m_more->setIcon(icon(QStringLiteral("set"), ColorRole::secondary, theme));
}

bool SheetOffer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fitSheet();
  return QFrame::eventFilter(watched, event);
}

void SheetOffer::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  paintCards();
}

void SheetOffer::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && isVisible()) paintCards();
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitSheet();
}

}  // namespace geargraph

#include "moc_sheet_offer.cpp"
