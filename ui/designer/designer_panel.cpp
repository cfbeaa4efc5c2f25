#include "ui/designer/designer_panel.h"

#include <QBoxLayout>
#include <QFile>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <algorithm>

#include "core/foundations/files/file.h"
#include "ui/designer/filter_bar.h"
#include "ui/designer/hit_card.h"
#include "ui/designer/hits_table.h"
#include "ui/designer/wish_form.h"
#include "ui/models/term_tips.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kBarDelay = 200;  // ms: shorter searches show no bar
constexpr int kBarSteps = 1000;
constexpr QSize kRoom{940, 400};  // px: in a smaller panel it scrolls

QString countedHits(std::int64_t number) {
  return QLocale().toString(static_cast<qlonglong>(number));
}

}  // namespace

DesignerPanel::DesignerPanel(QWidget* parent)
    : QWidget(parent), m_service(new DesignService(this)), m_detailService(new HitService(this)) {
  setObjectName(QStringLiteral("designer"));
  m_service->onAnswer(this, [this](const DesignProgress& progress) { onProgress(progress); });
  connect(m_service, &ServiceSignals::failed, this, &DesignerPanel::onFailed);
  m_detailService->onAnswer(this, [this](const HitDetailPtr& detail) { onDetail(detail); });
}

void DesignerPanel::prepare() {
  if (m_form != nullptr) return;
  auto* room = new QWidget;
  room->setMinimumSize(kRoom);
  QWidget* const left = makeLeft();
  m_card = new HitCard(room);
  auto* splitter = new QSplitter(Qt::Horizontal, room);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(left);
  splitter->addWidget(makeMiddle());
  splitter->addWidget(m_card);
  left->setMinimumWidth(m_form->roomFor(scaledPixels(250)));
  m_card->setMinimumWidth(scaledPixels(290));
  splitter->setStretchFactor(0, 0);
  splitter->setStretchFactor(1, 3);
  splitter->setStretchFactor(2, 1);
  splitter->setSizes({scaledPixels(270), scaledPixels(690), scaledPixels(400)});
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
  setFocusProxy(m_form);
  connect(m_form, &WishForm::changed, this, &DesignerPanel::onWishEdited);
  connect(m_form, &WishForm::searchWanted, this, &DesignerPanel::search);
  connect(m_hits, &HitsTable::chosenChanged, this, &DesignerPanel::showHits);
  connect(&m_hits->hits(), &HitsModel::tickedChanged, this, &DesignerPanel::showHits);
  connect(m_hits, &HitsTable::openWanted, this, [this] { open(m_hits->chosen()); });
  connect(m_hits, &HitsTable::filterWanted, m_filters, &FilterBar::openMenu);
  connect(m_hits, &HitsTable::picturesDrawn, this, &DesignerPanel::settled);
  connect(m_card, &HitCard::openWanted, this, &DesignerPanel::open);
  connect(m_card, &HitCard::variantWanted, this, &DesignerPanel::addVariant);
  setPhase(Phase::idle);
}

QWidget* DesignerPanel::makeLeft() {
  auto* left = new QWidget;
  m_form = new WishForm;
  auto* scroll = new QScrollArea(left);
  scroll->setObjectName(QStringLiteral("wishScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(m_form);
  m_search = new QPushButton(tr("Search"), left);
  m_search->setObjectName(QStringLiteral("searchGearboxes"));
  m_search->setToolTip(tr("Searches for gearboxes with these ratios (Ctrl+Return)"));
  auto* save = new QPushButton(tr("Save wish…"), left);
  save->setObjectName(QStringLiteral("saveWish"));
  save->setToolTip(
      tr("Writes the wish as a file for geargraph-cli gearbox, which searches on many machines"));
  m_earlier = new QLabel(tr("The list is of the earlier wish until you search again."), left);
  m_earlier->setProperty("look", "hint");
  m_earlier->setWordWrap(true);
  m_earlier->hide();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(save, 1);
  buttons->addWidget(m_search, 1);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 0, 12, 0);
  foot->addWidget(m_earlier);
  foot->addLayout(buttons);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 8);
  column->addWidget(scroll, 1);
  column->addLayout(foot);
  connect(m_search, &QPushButton::clicked, this, &DesignerPanel::search);
  connect(save, &QPushButton::clicked, this, &DesignerPanel::chooseWishFile);
  return left;
}

QWidget* DesignerPanel::makeHead() {
  auto* head = new QWidget;
  m_title = new QLabel(head);
  m_title->setObjectName(QStringLiteral("designTitle"));
  m_title->setProperty("look", "title");
  m_title->setWordWrap(true);
  m_pause = new QPushButton(head);
  m_pause->setObjectName(QStringLiteral("pauseSearch"));
  connect(m_pause, &QPushButton::clicked, this, [this] { isSearching() ? pause() : goOn(); });
  m_bar = new QProgressBar(head);
  m_bar->setObjectName(QStringLiteral("searchProgress"));
  m_bar->setTextVisible(false);
  m_bar->setFixedHeight(scaledPixels(6));
  m_bar->hide();
  m_barSoon = new QTimer(this);
  m_barSoon->setSingleShot(true);
  m_barSoon->setInterval(kBarDelay);
  connect(m_barSoon, &QTimer::timeout, m_bar, [this] { m_bar->setVisible(isSearching()); });
  m_count = new QLabel(head);
  m_count->setObjectName(QStringLiteral("designCount"));
  m_sampled = new QLabel(head);
  m_sampled->setObjectName(QStringLiteral("designSampled"));
  m_sampled->setProperty("look", "hint");
  m_sampled->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* first = new QHBoxLayout;
  first->addWidget(m_title, 1);
  first->addWidget(m_pause);
  auto* counts = new QHBoxLayout;
  counts->addWidget(m_count, 1);
  counts->addWidget(m_sampled);
  auto* column = new QVBoxLayout(head);
  column->setContentsMargins(12, 8, 12, 4);
  column->addLayout(first);
  column->addWidget(m_bar);
  column->addLayout(counts);
  return head;
}

QWidget* DesignerPanel::makeMiddle() {
  auto* middle = new QWidget;
  m_hits = new HitsTable(middle);
  m_filters = new FilterBar(&m_hits->hits(), &m_hits->shown(), middle);
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
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeHead());
  column->addWidget(m_filters);
  column->addWidget(m_pages, 1);
  return middle;
}

void DesignerPanel::showEvent(QShowEvent* event) {
  prepare();
  QWidget::showEvent(event);
}

void DesignerPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isSearching()) return pause();
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && event->modifiers() == Qt::ControlModifier) return search();
  QWidget::keyPressEvent(event);
}

void DesignerPanel::search() {
  prepare();
  auto wish = m_form->wish();
  if (!wish) return;
  m_service->cancel();
  m_detailService->cancel();
  m_wish = std::make_shared<const GearboxWish>(*std::move(wish));
  m_layouts = m_total = m_layoutsAtStart = 0;
  m_judged = {};
  m_isProof = m_isEarlier = false;
  m_toOpen = nullptr;
  m_details.clear();
  m_asked.clear();
  m_hits->startAnew(m_wish);
  m_service->request({m_wish, 0});
  m_clock.start();
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
  m_layoutsAtStart = m_layouts;
  m_clock.start();
  setPhase(Phase::searching);
}

bool DesignerPanel::isSettled() const {
  return m_service->isComplete() && m_detailService->isComplete() &&
         (m_hits == nullptr || !m_hits->pictures().isDrawing());
}

void DesignerPanel::onProgress(const DesignProgress& progress) {
  m_layouts = progress.done;
  m_total = progress.total;
  m_isProof = progress.isProof;
  m_judged += progress.judged;
  m_hits->add(progress.found);
  if (!progress.found.empty()) showHits();  // its number may be another one now
  setPhase(m_service->isComplete() ? Phase::done : Phase::searching);
  takeKeysToList();
  if (isSettled()) emit settled();
}

/// Who searched from the form by keys goes on in the list, unless the wish is being changed again.
void DesignerPanel::takeKeysToList() {
  const bool isInForm = m_form->isAncestorOf(window()->focusWidget());
  if (m_phase == Phase::done && !m_isEarlier && isInForm && m_hits->hits().rowCount() > 0)
    m_hits->setFocus(Qt::OtherFocusReason);
}

/// The window's status bar has the reason; what was found stays.
void DesignerPanel::onFailed() {
  setPhase(Phase::paused);
}

void DesignerPanel::onDetail(const HitDetailPtr& detail) {
  m_details[detail->asked] = detail;
  std::erase(m_asked, detail->asked);
  m_card->setDetail(detail);
  if (m_toOpen == detail->asked) open(detail->asked);
  if (isSettled()) emit settled();
}

HitDetailPtr DesignerPanel::detailOf(const GearboxPtr& gearbox) const {
  const auto found = m_details.find(gearbox);
  return found == m_details.end() ? nullptr : found->second;
}

/// Two that are ticked, or the chosen one, beside the one that is ticked.
void DesignerPanel::showHits() {
  std::vector<GearboxPtr> shown = m_hits->hits().ticked();
  const GearboxPtr chosen = m_hits->chosen();
  const bool isNew = chosen && std::find(shown.begin(), shown.end(), chosen) == shown.end();
  if (isNew && shown.size() < HitsModel::kMaxTicked) shown.push_back(chosen);
  std::vector<NumberedHit> numbered;
  for (const GearboxPtr& each : shown) numbered.push_back({each, m_hits->hits().rowOf(each) + 1});
  std::sort(numbered.begin(), numbered.end(),
            [](const NumberedHit& a, const NumberedHit& b) { return a.number < b.number; });
  m_card->setHits(m_wish, numbered);
  std::vector<GearboxPtr> missing;
  for (const GearboxPtr& each : shown) {
    const HitDetailPtr known = detailOf(each);
    known ? m_card->setDetail(known) : missing.push_back(each);
  }
  if (missing.empty() || missing == m_asked) return;
  m_asked = missing;
  m_detailService->request({m_wish, missing});
}

void DesignerPanel::open(const GearboxPtr& gearbox) {
  if (!gearbox) return;
  const HitDetailPtr detail = detailOf(gearbox);
  m_toOpen = detail ? nullptr : gearbox;
  if (detail) return emit openWanted(std::make_shared<const Mechanism>(detail->document));
  if (std::find(m_asked.begin(), m_asked.end(), gearbox) != m_asked.end()) return;  // it is coming
  m_asked = {gearbox};
  m_detailService->request({m_wish, m_asked});
}

/// The variant becomes a gearbox of the list, and is shown beside what it is a variant of.
void DesignerPanel::addVariant(const GearboxPtr& gearbox, const GearboxPtr& variant) {
  GearboxPtr added;
  for (const GearboxPtr& each : m_hits->hits().all())
    if (each->layout == variant->layout && each->elements == variant->elements &&
        each->teeth == variant->teeth)
      added = each;
  if (!added) {
    Gearbox complete = *variant;
    if (checkByDocument(*m_wish, complete, true) != GearboxCheck::right)
      return emit rejected(tr("This variant exceeds a limit of the wish."));
    added = std::make_shared<const Gearbox>(std::move(complete));
    m_hits->add({added});
  }
  m_hits->hits().setTicked(gearbox, true);
  m_hits->hits().setTicked(added, true);
  m_hits->choose(added);
}

void DesignerPanel::chooseWishFile() {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save wish"), QStringLiteral("gearbox-wish.json"), tr("JSON files (*.json);;All files (*)"));
  if (!path.isEmpty()) saveWish(path);
}

void DesignerPanel::saveWish(const QString& path) {
  if (const auto error = writeFile(QFile::encodeName(path).toStdString(), m_form->json() + '\n'))
    emit rejected(shownText(error->message));
}

void DesignerPanel::onWishEdited() {
  m_isEarlier = m_wish != nullptr;
  updateWords();
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
  updateWords();
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
  const QString found = countedHits(m_hits->hits().rowCount());
  switch (m_phase) {
    case Phase::idle:
      return {};
    case Phase::searching:
      if (m_total == 0) return tr("Listing layouts…");
      return tr("%1 of %2 layouts, %3 found").arg(countedHits(m_layouts), countedHits(m_total), found) +
             remainingText();
    case Phase::paused:
      if (m_total == 0) return tr("Paused");
      return tr("Paused at %1 of %2 layouts, %3 found")
          .arg(countedHits(m_layouts), countedHits(m_total), found);
    case Phase::done:
      return tr("%1 layouts, %2 found").arg(countedHits(m_total), found);
  }
  return {};
}

/// Once some layouts have shown how long they take.
QString DesignerPanel::remainingText() const {
  constexpr std::int64_t kLeastTime = 3000;  // ms
  const std::int64_t done = m_layouts - m_layoutsAtStart;
  if (done <= 0 || m_clock.elapsed() < kLeastTime) return {};
  const std::int64_t seconds = m_clock.elapsed() * (m_total - m_layouts) / done / 1000;
  constexpr std::int64_t kMinute = 60;
  return seconds < kMinute ? tr(", about %1 s to go").arg(seconds + 1)
                           : tr(", about %1 min to go").arg((seconds + kMinute - 1) / kMinute);
}

QString DesignerPanel::sampledText() const {
  if (m_phase == Phase::idle) return {};
  return m_isProof ? tr("complete") : tr("sampled, not a proof");
}

QString DesignerPanel::sampledReason() const {
  if (m_isProof) return tr("No layout has so many links.");
  const bool isGrid =
      m_wish->limits.shafts - static_cast<int>(basicSets(m_wish->limits.kinds).size()) < kMaxFreedom;
  return isGrid ? tr("Every layout is searched, but the ratio of ring to sun at %1 values of each set "
                     "only, from which the nearest whole teeth are taken.")
                      .arg(m_wish->steps)
                : tr("Every layout is searched, but the ratios of ring to sun at %1 points only, "
                     "from which the nearest whole teeth are taken.")
                      .arg(kSamples);
}

/// Where the candidates ended says what to change.
QString DesignerPanel::emptyListText() const {
  if (m_isProof) return tr("None: no layout of these sets has so many links.");
  if (m_judged.candidates == 0) {
    return tr(
        "None was found: no layout comes near these ratios.<br>More elements, another number of links, "
        "another set, or wider limits of ring : sun may help.");
  }
  if (m_judged.teeth == 0) {
    return tr("None was found: %1 shift tables come near these ratios, but no whole teeth do.<br>A larger "
              "tolerance, or rings with more teeth may help.")
        .arg(countedHits(m_judged.candidates));
  }
  if (m_judged.elements == 0) {
    return tr("None was found: %1 gearboxes have these ratios, but not so many brakes and clutches.")
        .arg(countedHits(m_judged.teeth));
  }
  return tr("None was found: %1 gearboxes have these ratios, but are beyond the limits at the end of the "
            "wish.")
      .arg(countedHits(m_judged.elements));
}

void DesignerPanel::updateWords() {
  m_title->setText(titleText());
  m_count->setText(countText());
  m_sampled->setText(sampledText());
  m_earlier->setVisible(m_isEarlier);
  if (m_wish) m_sampled->setToolTip(sampledReason());
  m_filters->setVisible(m_hits->hits().rowCount() > 0);
  m_pages->setCurrentWidget(m_hits->hits().rowCount() > 0 ? static_cast<QWidget*>(m_hits) : m_empty);
  switch (m_phase) {
    case Phase::idle:
      m_empty->setText(
          tr("Type ratios and choose Search.<br>Six ratios are enough: <a href=\"example\">%1</a>")
              .arg(localNumbers(WishForm::kExampleRatios)));
      break;
    case Phase::done:
      m_empty->setText(emptyListText());
      break;
    default:
      m_empty->setText(tr("Nothing yet."));
  }
}

}  // namespace geargraph

#include "moc_designer_panel.cpp"
