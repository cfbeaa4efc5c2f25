#include "ui/designer/hub_panel.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <utility>

#include "ui/designer/hub_card.h"
#include "ui/designer/hub_form.h"
#include "ui/designer/hub_lists.h"
#include "ui/designer/hub_words.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr QSize kHubRoom{900, 400};  // px: in a smaller panel it scrolls

}  // namespace

HubPanel::HubPanel(QWidget* parent)
    : QWidget(parent), m_service(new HubService(this)), m_details(new HubDetailService(this)) {
  setObjectName(QStringLiteral("hardware"));
  m_service->onAnswer(this, [this](const HubSearchPtr& search) {
    m_search = search;
    narrow();
    if (isSettled()) emit settled();
  });
  m_details->onAnswer(this, [this](const HubDetailPtr& detail) { onDetail(detail); });
}

void HubPanel::prepare() {
  if (m_form != nullptr) return;
  auto* room = new QWidget;
  room->setMinimumSize(kHubRoom);
  QWidget* const left = makeLeft();
  m_card = new HubCard(room);
  auto* splitter = new QSplitter(Qt::Horizontal, room);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(left);
  splitter->addWidget(makeMiddle());
  splitter->addWidget(m_card);
  left->setMinimumWidth(m_form->roomFor(scaledPixels(240)));
  m_card->setMinimumWidth(scaledPixels(280));
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({scaledPixels(270), scaledPixels(700), scaledPixels(380)});
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
  connect(m_find, &QPushButton::clicked, this, &HubPanel::search);
  connect(m_form, &HubForm::searchWanted, this, &HubPanel::search);
  connect(m_form, &HubForm::changed, this, [this] {
    m_isEarlier = m_search != nullptr;
    updateWords();
  });
  connect(m_table, &HubTable::chosenChanged, this, &HubPanel::onChosen);
  connect(m_table, &HubTable::openWanted, this, &HubPanel::open);
  connect(m_card, &HubCard::openWanted, this, &HubPanel::open);
  connect(m_card, &HubCard::answered, this, &HubPanel::answer);
  narrow();
}

QWidget* HubPanel::makeLeft() {
  auto* left = new QWidget;
  m_form = new HubForm;
  auto* scroll = new QScrollArea(left);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(m_form);
  m_find = new QPushButton(tr("Search"), left);
  m_find->setObjectName(QStringLiteral("searchHubs"));
  m_earlier = new QLabel(tr("The list is of the earlier wish until you search again."), left);
  m_earlier->setProperty("look", "hint");
  m_earlier->setWordWrap(true);
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(12, 0, 12, 0);
  foot->addWidget(m_earlier);
  foot->addWidget(m_find);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 8);
  column->addWidget(scroll, 1);
  column->addLayout(foot);
  return left;
}

QWidget* HubPanel::makeMiddle() {
  auto* middle = new QWidget;
  m_title = new QLabel(middle);
  m_title->setObjectName(QStringLiteral("hubCount"));
  m_title->setProperty("look", "title");
  m_title->setWordWrap(true);
  m_proof = new QLabel(middle);
  m_proof->setObjectName(QStringLiteral("hubProof"));
  m_proof->setProperty("look", "hint");
  m_proof->setWordWrap(true);
  m_products = new HubProducts(middle);
  m_chips = new QHBoxLayout;
  m_table = new HubTable(middle);
  m_empty = emptyLabel(middle);
  m_empty->setObjectName(QStringLiteral("hubEmpty"));
  m_empty->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  connect(m_empty, &QLabel::linkActivated, this, [this] {
    m_form->setExample();
    m_find->setFocus();
  });
  m_pages = new QStackedWidget(middle);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_table);
  auto* head = new QVBoxLayout;
  head->setContentsMargins(12, 8, 12, 4);
  head->addWidget(m_title);
  head->addWidget(m_proof);
  head->addWidget(m_products);
  head->addLayout(m_chips);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(head);
  column->addWidget(m_pages, 1);
  return middle;
}

void HubPanel::showEvent(QShowEvent* event) {
  prepare();
  QWidget::showEvent(event);
}

void HubPanel::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isReturn && event->modifiers() == Qt::ControlModifier) return search();
  QWidget::keyPressEvent(event);
}

bool HubPanel::isSettled() const {
  return m_service->isComplete() && m_details->isComplete();
}

void HubPanel::search() {
  prepare();
  auto wish = m_form->wish();
  if (!wish) return;
  m_isEarlier = false;
  m_answers.clear();
  m_service->request(std::make_shared<const HubWish>(*std::move(wish)));
  updateWords();
}

/// Everything that was answered, applied to what was found.
void HubPanel::narrow() {
  m_left = m_search;
  for (const auto& [question, text] : m_answers)
    m_left = std::make_shared<const HubSearch>(narrowed(*m_left, question, text.toStdString()));
  m_table->setSearch(m_left);
  m_card->setSearch(m_left);
  updateChips();
  updateWords();
}

void HubPanel::answer(const HubQuestion& question, const QString& text) {
  m_answers.emplace_back(question, text);
  narrow();
}

void HubPanel::updateChips() {
  while (const QLayoutItem* item = m_chips->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  for (std::size_t i = 0; i < m_answers.size(); ++i) {
    const auto& [question, text] = m_answers[i];
    const QString name = QString::fromStdString(question.name);
    auto* chip = new QToolButton;
    chip->setObjectName(QStringLiteral("answered.%1").arg(i));
    chip->setProperty("look", "chip");
    chip->setText((question.isCount ? hubWheelWords(name) : hubGearWords(name)) + QStringLiteral(": ") +
                  text + QStringLiteral("  ✕"));
    chip->setToolTip(tr("A click takes this answer back"));
    connect(chip, &QToolButton::clicked, this, [this, i] {
      m_answers.erase(m_answers.begin() + static_cast<std::ptrdiff_t>(i));
      narrow();
    });
    m_chips->addWidget(chip);
  }
  if (!m_answers.empty()) m_chips->addStretch(1);
}

void HubPanel::onChosen() {
  const HubCandidate* const chosen = m_table->chosen();
  m_isToOpen = false;
  m_products->setCandidate(chosen);
  m_card->setNumber(chosen != nullptr ? m_table->chosenNumber() : 0);
  if (chosen != nullptr) m_details->request(*chosen);
}

void HubPanel::onDetail(const HubDetailPtr& detail) {
  m_card->setDetail(detail);
  if (std::exchange(m_isToOpen, false)) emit openWanted(detail->document);
  if (isSettled()) emit settled();
}

void HubPanel::open() {
  if (m_table->chosen() == nullptr) return;
  m_isToOpen = !m_details->isComplete();
  if (!m_isToOpen) emit openWanted(m_details->answer()->document);
}

void HubPanel::updateWords() {
  const auto counted = [](std::int64_t number) { return QLocale().toString(static_cast<qlonglong>(number)); };
  m_earlier->setVisible(m_isEarlier);
  const bool isSearching = !m_service->isComplete();
  const std::size_t fitting = m_left ? m_left->assembled.size() + m_left->others.size() : 0;
  m_pages->setCurrentWidget(fitting > 0 ? static_cast<QWidget*>(m_table) : m_empty);
  m_title->setText(m_left ? tr("Candidates: %1, of %2 tooth sets with these ratios")
                                .arg(counted(static_cast<std::int64_t>(m_left->assembled.size())),
                                     counted(static_cast<std::int64_t>(fitting)))
                          : tr("What is inside a hub with these ratios?"));
  QStringList tried;
  if (m_search)
    for (const std::int64_t each : m_search->tried) tried << counted(each);
  m_proof->setText(
      tried.isEmpty()
          ? QString()
          : tr("All tooth sets tried: complete. By set: %1.").arg(tried.join(QStringLiteral(", "))));
  if (isSearching) return m_empty->setText(tr("Searching…"));
  if (!m_search) {
    return m_empty->setText(
        tr("Type the ratios of the maker's sheet and choose Search.<br>A hub with seven gears: "
           "<a href=\"example\">%1</a>")
            .arg(localNumbers(HubForm::kExampleRatios)));
  }
  if (!m_answers.empty())
    return m_empty->setText(
        tr("None has this number: was it counted rightly, or are the limits too narrow?"));
  m_empty->setText(
      m_search->structures == 0
          ? tr("None: some ratio is no product of the others. Are all of them rounded to the same "
               "place? More sets may explain them.")
          : tr("None: no whole teeth within the limits have these ratios. A slack of 1 to 3, or wider "
               "limits, may help."));
}

}  // namespace geargraph

#include "moc_hub_panel.cpp"
