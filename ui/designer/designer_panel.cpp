#include "ui/designer/designer_panel.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <utility>

#include "ui/designer/hit_card.h"
#include "ui/designer/hits_table.h"
#include "ui/designer/wish_form.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/theme_colors.h"

namespace geargraph::inline designer {
namespace {

constexpr int kBarDelay = 200;  // ms: shorter searches show no bar
constexpr int kBarSteps = 1000;
constexpr QSize kRoom{940, 400};  // px: in a smaller panel it scrolls

QString counted(std::int64_t number) {
  return QLocale().toString(static_cast<qlonglong>(number));
}

}  // namespace

DesignerPanel::DesignerPanel(QWidget* parent)
    : QWidget(parent), m_service(new DesignService(this)), m_details(new HitService(this)) {
  setObjectName(QStringLiteral("designer"));
  m_service->onAnswer(this, [this](const DesignProgress& progress) { onProgress(progress); });
  connect(m_service, &ServiceSignals::failed, this, &DesignerPanel::onFailed);
  m_details->onAnswer(this, [this](const HitDetailPtr& detail) {
    if (m_card == nullptr) return;
    m_card->setDetail(detail);
    if (m_toOpen && m_card->detail() && m_toOpen == m_hits->chosen()) onOpen();
  });
}

void DesignerPanel::prepare() {
  if (m_form != nullptr) return;
  auto* room = new QWidget;
  room->setMinimumSize(kRoom);
  auto* left = new QWidget(room);
  auto* leftColumn = new QVBoxLayout(left);
  leftColumn->setContentsMargins(0, 0, 0, 8);
  m_form = new WishForm;
  auto* scroll = new QScrollArea(left);
  scroll->setObjectName(QStringLiteral("wishScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(m_form);
  m_search = new QPushButton(tr("Search"), left);
  m_search->setObjectName(QStringLiteral("searchGearboxes"));
  m_earlier = new QLabel(tr("The list is of the earlier wish until you search again."), left);
  m_earlier->setProperty("look", "hint");
  m_earlier->setWordWrap(true);
  m_earlier->hide();
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 0, 12, 0);
  foot->addWidget(m_earlier);
  foot->addWidget(m_search);
  leftColumn->addWidget(scroll, 1);
  leftColumn->addLayout(foot);
  m_card = new HitCard(room);
  auto* splitter = new QSplitter(Qt::Horizontal, room);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(left);
  splitter->addWidget(makeMiddle());
  splitter->addWidget(m_card);
  left->setMinimumWidth(scaledPixels(250));
  m_card->setMinimumWidth(scaledPixels(290));
  splitter->setStretchFactor(0, 0);
  splitter->setStretchFactor(1, 3);
  splitter->setStretchFactor(2, 2);
  splitter->setSizes({scaledPixels(270), scaledPixels(540), scaledPixels(430)});
  auto* roomLayout = new QVBoxLayout(room);
  roomLayout->setContentsMargins(0, 0, 0, 0);
  roomLayout->addWidget(splitter);
  auto* around = new QScrollArea(this);
  around->setFrameShape(QFrame::NoFrame);
  around->setWidgetResizable(true);
  around->setWidget(room);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(around);
  connect(m_search, &QPushButton::clicked, this, &DesignerPanel::search);
  connect(m_form, &WishForm::changed, this, &DesignerPanel::onWishEdited);
  connect(m_hits, &HitsTable::chosenChanged, this, &DesignerPanel::onChosen);
  connect(m_hits, &HitsTable::openWanted, this, &DesignerPanel::onOpen);
  connect(m_card, &HitCard::openWanted, this, &DesignerPanel::onOpen);
  setPhase(Phase::idle);
}

QWidget* DesignerPanel::makeMiddle() {
  auto* middle = new QWidget;
  m_title = new QLabel(middle);
  m_title->setObjectName(QStringLiteral("designTitle"));
  m_title->setProperty("look", "title");
  m_title->setWordWrap(true);
  m_pause = new QPushButton(middle);
  m_pause->setObjectName(QStringLiteral("pauseSearch"));
  connect(m_pause, &QPushButton::clicked, this, [this] { isSearching() ? pause() : goOn(); });
  m_bar = new QProgressBar(middle);
  m_bar->setObjectName(QStringLiteral("searchProgress"));
  m_bar->setTextVisible(false);
  m_bar->setFixedHeight(scaledPixels(6));
  m_bar->hide();
  m_barSoon = new QTimer(this);
  m_barSoon->setSingleShot(true);
  m_barSoon->setInterval(kBarDelay);
  connect(m_barSoon, &QTimer::timeout, m_bar, [this] { m_bar->setVisible(isSearching()); });
  m_count = new QLabel(middle);
  m_count->setObjectName(QStringLiteral("designCount"));
  m_sampled = new QLabel(middle);
  m_sampled->setObjectName(QStringLiteral("designSampled"));
  m_sampled->setProperty("look", "hint");
  m_sampled->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_hits = new HitsTable(middle);
  m_empty = emptyLabel(middle);
  m_empty->setObjectName(QStringLiteral("designEmpty"));
  m_empty->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  connect(m_empty, &QLabel::linkActivated, this, [this] {
    m_form->setExample();
    m_search->setFocus();
  });
  m_pages = new QStackedWidget(middle);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_hits);
  auto* head = new QHBoxLayout;
  head->addWidget(m_title, 1);
  head->addWidget(m_pause);
  auto* counts = new QHBoxLayout;
  counts->addWidget(m_count, 1);
  counts->addWidget(m_sampled);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(12, 8, 12, 4);
  top->addLayout(head);
  top->addWidget(m_bar);
  top->addLayout(counts);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(m_pages, 1);
  return middle;
}

void DesignerPanel::showEvent(QShowEvent* event) {
  prepare();
  QWidget::showEvent(event);
}

void DesignerPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isSearching()) return pause();
  QWidget::keyPressEvent(event);
}

void DesignerPanel::search() {
  prepare();
  auto wish = m_form->wish();
  if (!wish) return;
  m_service->cancel();
  m_wish = std::make_shared<const GearboxWish>(*std::move(wish));
  m_layouts = m_total = 0;
  m_isProof = m_isEarlier = false;
  m_toOpen = nullptr;
  m_hits->startAnew(m_wish);
  m_service->request({m_wish, 0});
  setPhase(Phase::searching);
}

void DesignerPanel::pause() {
  if (!isSearching()) return;
  m_service->cancel();
  setPhase(Phase::paused);
}

void DesignerPanel::goOn() {
  if (m_phase != Phase::paused) return;
  m_service->request({m_wish, m_layouts});
  setPhase(Phase::searching);
}

void DesignerPanel::onProgress(const DesignProgress& progress) {
  m_layouts = progress.done;
  m_total = progress.total;
  m_isProof = progress.isProof;
  m_hits->add(progress.found);
  if (!progress.found.empty()) onChosen();  // its number may be another one now
  setPhase(m_service->isComplete() ? Phase::done : Phase::searching);
}

/// The window's status bar has the reason; what was found stays.
void DesignerPanel::onFailed() {
  setPhase(Phase::paused);
}

void DesignerPanel::onChosen() {
  const GearboxPtr chosen = m_hits->chosen();
  m_card->setHit(m_wish, chosen, chosen ? m_hits->hits().rowOf(chosen) + 1 : 0);
  if (std::exchange(m_asked, chosen) != chosen && chosen) m_details->request({m_wish, chosen});
}

void DesignerPanel::onOpen() {
  const GearboxPtr chosen = m_hits->chosen();
  if (!chosen) return;
  if (!m_card->detail()) {
    m_toOpen = chosen;  // when its document comes
    return;
  }
  m_toOpen = nullptr;
  emit openWanted(m_card->detail()->document);
}

void DesignerPanel::onWishEdited() {
  m_isEarlier = m_wish != nullptr;
  renewWords();
}

void DesignerPanel::setPhase(Phase phase) {
  const bool begins = phase == Phase::searching && m_phase != Phase::searching;
  m_phase = phase;
  if (begins) m_barSoon->start();
  if (phase == Phase::done || phase == Phase::idle) m_bar->hide();
  m_bar->setEnabled(phase == Phase::searching);
  m_bar->setRange(0, m_total > 0 ? kBarSteps : 0);
  if (m_total > 0) m_bar->setValue(static_cast<int>(m_layouts * kBarSteps / m_total));
  m_pause->setVisible(phase == Phase::searching || phase == Phase::paused);
  m_pause->setText(phase == Phase::paused ? tr("Go on") : tr("Pause"));
  m_pause->setToolTip(phase == Phase::paused ? QString() : tr("Keeps what was found (Esc)"));
  renewWords();
}

QString DesignerPanel::titleText() const {
  if (!m_wish) return tr("Gearboxes with the ratios you want");
  const int gears = static_cast<int>(m_wish->forward.size());
  const int sets = static_cast<int>(m_wish->limits.kinds.size());
  return (m_wish->reverse == ReverseWish::none ? tr("Gears: %1, sets: %2")
                                               : tr("Gears: %1 and reverse, sets: %2"))
      .arg(gears)
      .arg(sets);
}

QString DesignerPanel::countText() const {
  const QString found = counted(m_hits->hits().rowCount());
  switch (m_phase) {
    case Phase::idle:
      return {};
    case Phase::searching:
      if (m_total == 0) return tr("Listing layouts…");
      return tr("%1 of %2 layouts, %3 found").arg(counted(m_layouts), counted(m_total), found);
    case Phase::paused:
      if (m_total == 0) return tr("Paused");
      return tr("Paused at %1 of %2 layouts, %3 found").arg(counted(m_layouts), counted(m_total), found);
    case Phase::done:
      return tr("%1 layouts, %2 found").arg(counted(m_total), found);
  }
  return {};
}

QString DesignerPanel::sampledText() const {
  if (m_phase == Phase::idle) return {};
  return m_isProof ? tr("complete") : tr("sampled, not a proof");
}

void DesignerPanel::renewWords() {
  m_title->setText(titleText());
  m_count->setText(countText());
  m_sampled->setText(sampledText());
  m_earlier->setVisible(m_isEarlier);
  if (m_wish) {
    const bool isGrid =
        m_wish->limits.shafts - static_cast<int>(basicSets(m_wish->limits.kinds).size()) < kMaxFreedom;
    m_sampled->setToolTip(
        m_isProof
            ? tr("No layout has so many links.")
            : (isGrid ? tr("Every layout is searched, but the ratio of ring to sun at %1 values of each set "
                           "only, from which the nearest whole teeth are taken.")
                            .arg(m_wish->steps)
                      : tr("Every layout is searched, but the ratios of ring to sun at %1 points only, "
                           "from which the nearest whole teeth are taken.")
                            .arg(kSamples)));
  }
  m_pages->setCurrentWidget(m_hits->hits().rowCount() > 0 ? static_cast<QWidget*>(m_hits) : m_empty);
  switch (m_phase) {
    case Phase::idle:
      m_empty->setText(
          tr("Type ratios and choose Search.<br>Six ratios are enough: <a href=\"example\">%1</a>")
              .arg(QLatin1String(WishForm::kExampleRatios)));
      break;
    case Phase::done:
      m_empty->setText(m_isProof
                           ? tr("None: no layout of these sets has so many links.")
                           : tr("None was found. A larger tolerance, another number of links or elements, or "
                                "wider limits of ring : sun may help."));
      break;
    default:
      m_empty->setText(tr("Nothing yet."));
  }
}

}  // namespace geargraph::inline designer

#include "moc_designer_panel.cpp"
