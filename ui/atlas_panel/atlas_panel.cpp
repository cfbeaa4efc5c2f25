#include "ui/atlas_panel/atlas_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "ui/atlas_panel/atlas_counts.h"
#include "ui/atlas_panel/chain_card.h"
#include "ui/atlas_panel/chain_grid.h"
#include "ui/atlas_panel/filter_chips.h"
#include "ui/atlas_panel/train_details.h"
#include "ui/theme/theme_colors.h"
#include "ui/workbench/views.h"

namespace geargraph {
namespace {

constexpr int kFilterWidth = 190;
constexpr int kCardWidth = 250;
constexpr int kUsualLinks = 5;  ///< shown while the train is in no atlas

/// Scrolls up and down only, and is never narrower than its content, so that no row is cut off.
class ScrolledColumn final : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

  /// QScrollArea filters the events of its content: the layout of that has changed.
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
      setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    return QScrollArea::eventFilter(watched, event);
  }
};

QScrollArea* scrolled(QWidget* content, QWidget* parent) {
  auto* area = new ScrolledColumn(parent);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  content->setBackgroundRole(QPalette::Base);
  content->setAutoFillBackground(true);
  area->setWidget(content);
  return area;
}

}  // namespace

AtlasPanel::AtlasPanel(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_identification(new IdentificationService(this)),
      m_details(new ChainDetailsService(this)),
      m_documents(new ChainDocumentService(this)),
      m_previews(new ChainPreviewService(this)),
      m_choices(new TrainChoicesService(this)),
      m_comparisons(new ComparisonService(this)),
      m_model(new ChainListModel(this)),
      m_grid(new ChainGrid(m_model, this)),
      m_card(new ChainCard(this)) {
  auto* columns = new QSplitter(this);
  columns->setChildrenCollapsible(false);
  columns->addWidget(scrolled(makeFilters(), columns));
  columns->addWidget(makeMiddle());
  columns->addWidget(scrolled(m_card, columns));
  columns->setStretchFactor(1, 1);
  columns->setSizes({scaledPixels(kFilterWidth), scaledPixels(3 * kFilterWidth), scaledPixels(kCardWidth)});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(columns);

  connect(document, &Document::changed, this, [this] {
    if (m_isAwake) request();
  });
  connect(document, &Document::replaced, this, [this] {
    m_followsTrain = true;
    followTrain();
  });
  m_identification->onAnswer(this, [this](const TrainAnswerPtr& train) { onTrain(train); });
  m_details->onAnswer(this, [this](const ChainDetailsPtr& details) {
    if (details->chain == m_card->chain()) m_card->setChain(details->chain, details);
    emitSettledIfIdle();
  });
  m_documents->onAnswer(this, [this](const MechanismPtr& made) {
    m_card->setOpening(false);
    emit documentWanted(made);
    emitSettledIfIdle();
  });
  connect(m_documents, &ServiceSignals::failed, this, [this] { m_card->setOpening(false); });
  connect(m_grid, &ChainGrid::chosen, this, &AtlasPanel::onChosen);
  connect(m_grid, &ChainGrid::openWanted, this, &AtlasPanel::openChosen);
  connect(m_grid, &ChainGrid::findWanted, m_find, [this] { m_find->setFocus(Qt::ShortcutFocusReason); });
  connect(m_model, &ChainListModel::drawn, this, &AtlasPanel::emitSettledIfIdle);
  connect(m_card, &ChainCard::chainWanted, this, [this](const ChainNumber& number) {
    m_followsTrain = false;
    showChain(number);
  });
  connect(m_card, &ChainCard::openWanted, this, &AtlasPanel::openChosen);
  connect(m_card, &ChainCard::showWanted, this, &AtlasPanel::showInTrain);
  m_previews->onAnswer(this, [this](const ChainPreviewPtr& preview) {
    m_card->setPreview(preview);
    emitSettledIfIdle();
  });
  connect(m_card, &ChainCard::previewWanted, this,
          [this](const ChainPreviewRequest& request) { m_previews->request(request); });
  connectTrainDetails();
  setFocusProxy(m_grid);
}

void AtlasPanel::connectTrainDetails() {
  TrainDetails* const details = &m_card->trainDetails();
  connect(details, &TrainDetails::choicesWanted, this,
          [this] { m_choices->request(m_identification->answer()); });
  connect(details, &TrainDetails::comparisonWanted, this, [this](const QString& path) {
    m_comparisons->request({m_identification->answer(), QFile::encodeName(path).toStdString()});
  });
  m_choices->onAnswer(this, [this, details](const TrainChoicesPtr& choices) {
    details->setChoices(choices);
    emitSettledIfIdle();
  });
  m_comparisons->onAnswer(this, [this, details](const TrainComparisonPtr& comparison) {
    details->setComparison(comparison);
    emitSettledIfIdle();
  });
}

QWidget* AtlasPanel::makeFilters() {
  auto* filters = new QWidget(this);
  m_links = new FilterChips(QStringLiteral("links"), tr("Links"), filters);
  m_dof = new FilterChips(QStringLiteral("dof"), tr("Freedom, one link held"), filters);
  m_dof->setText(0, tr("none"));
  m_axes = new FilterChips(QStringLiteral("axes"), tr("Axes"), filters);
  m_whole = new QCheckBox(filters);
  m_whole->setObjectName(QStringLiteral("nonfractionated"));
  m_whole->setToolTip(tr("No link parts the chain in two, and every link is in a gear pair"));
  m_sameEquations = new QCheckBox(filters);
  m_sameEquations->setObjectName(QStringLiteral("sameEquations"));
  m_sameEquations->setToolTip(tr("Chains with the same equations of speeds differ in their shafts only"));
  auto* locked = new QLabel(filters);
  locked->setObjectName(QStringLiteral("cannotTurn"));
  locked->setWordWrap(true);
  locked->setText(QStringLiteral("<a href=\"locked\">%1</a>").arg(tr("Trains that cannot turn, and why")));

  m_filterLayout = new QVBoxLayout(filters);
  m_filterLayout->setContentsMargins(10, 8, 6, 8);
  m_filterLayout->setSpacing(8);
  for (QWidget* each :
       std::initializer_list<QWidget*>{m_links, m_dof, m_axes, m_whole, m_sameEquations, locked})
    m_filterLayout->addWidget(each);
  m_filterLayout->addStretch(1);

  for (const FilterChips* chips : {m_links, m_dof, m_axes})
    connect(chips, &FilterChips::changed, this, &AtlasPanel::onFilterChanged);
  for (const QCheckBox* box : {m_whole, m_sameEquations})
    connect(box, &QCheckBox::clicked, this, &AtlasPanel::onFilterChanged);
  connect(locked, &QLabel::linkActivated, this, &AtlasPanel::showTrainsThatCannotTurn);
  return filters;
}

QWidget* AtlasPanel::makeMiddle() {
  auto* middle = new QWidget(this);
  middle->setBackgroundRole(QPalette::Base);
  middle->setAutoFillBackground(true);
  m_count = new QLabel(middle);
  m_count->setObjectName(QStringLiteral("count"));
  m_count->setProperty("look", "title");
  m_count->setWordWrap(true);
  m_find = new QLineEdit(middle);
  m_find->setObjectName(QStringLiteral("findChain"));
  m_find->setPlaceholderText(tr("Number, as 6-1.5"));
  m_find->setAccessibleName(tr("Number of a chain"));
  m_find->setClearButtonEnabled(true);
  m_find->setFixedWidth(scaledPixels(150));
  auto* source = new QLabel(countsSource(), middle);
  source->setObjectName(QStringLiteral("source"));
  source->setProperty("look", "hint");
  source->setWordWrap(true);
  auto* what = new QLabel(middle);
  what->setObjectName(QStringLiteral("whatIsCounted"));
  what->setText(QStringLiteral("<a href=\"definition\">%1</a>").arg(tr("What is counted?")));
  m_definition = new QLabel(countsDefinition(), middle);
  m_definition->setObjectName(QStringLiteral("definition"));
  m_definition->setWordWrap(true);
  m_definition->hide();

  auto* head = new QHBoxLayout;
  head->addWidget(m_count, 1);
  head->addWidget(m_find);
  auto* below = new QHBoxLayout;
  below->addWidget(source, 1);
  below->addWidget(what, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(8, 8, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addLayout(below);
  layout->addWidget(m_definition);
  layout->addWidget(m_grid, 1);

  connect(what, &QLabel::linkActivated, this, [this] { m_definition->setVisible(m_definition->isHidden()); });
  connect(m_find, &QLineEdit::returnPressed, this, &AtlasPanel::find);
  return middle;
}

// --- the train --------------------------------------------------------------------------------------------

void AtlasPanel::setAwake(bool awake) {
  m_isAwake = awake;
  if (awake) request();
}

void AtlasPanel::request() {
  m_identification->request(m_document->placed());
}

bool AtlasPanel::isSettled() const {
  if (!m_isAwake) return true;
  return m_identification->isComplete() && m_details->isComplete() && m_documents->isComplete() &&
         m_previews->isComplete() && m_choices->isComplete() && m_comparisons->isComplete() &&
         !m_model->isDrawing();
}

void AtlasPanel::emitSettledIfIdle() {
  if (isSettled()) emit settled();
}

void AtlasPanel::onTrain(const TrainAnswerPtr& train) {
  if (!m_catalogue) takeCatalogue(train->catalogue);
  m_card->setTrain(train);
  std::set<const AtlasChain*> own;
  std::optional<ChainNumber> equations;
  if (train->identity) {
    for (const IdentifiedChain& part : train->identity->parts) {
      if (part.displacement) own.insert(m_catalogue->atlas().find(*part.displacement));
      if (part.rotation && !equations) equations = part.rotation;
    }
  }
  m_model->setOwn(std::move(own));
  if (!m_filter.equations) {
    m_equations = equations;
    updateEquations();
  }
  followTrain();
  emitSettledIfIdle();
}

void AtlasPanel::takeCatalogue(const std::shared_ptr<const ChainCatalogue>& catalogue) {
  m_catalogue = catalogue;
  auto* heading = new QLabel(tr("Chains with 1 freedom"), this);
  heading->setProperty("look", "hint");
  const int end = m_filterLayout->count() - 1;  // before the stretch
  m_filterLayout->insertWidget(end, heading);
  m_filterLayout->insertWidget(end + 1, countsTable(*catalogue, this));
  m_filter = {.links = kUsualLinks, .dof = 1};
  renew();
}

/// Shows the chain of the train, the first that is in the atlas, unless the user has chosen one.
void AtlasPanel::followTrain() {
  const TrainAnswerPtr& train = m_identification->answer();
  if (!m_followsTrain || !m_catalogue || !train) return;
  if (train->identity) {
    for (const IdentifiedChain& part : train->identity->parts) {
      if (!part.displacement) continue;
      showChain(*part.displacement);
      return;
    }
  }
  if (m_grid->current() == nullptr && !m_model->chains().empty()) {
    m_isShowing = true;
    m_grid->setCurrent(m_model->chains().front());
    m_isShowing = false;
  }
}

void AtlasPanel::showInTrain(const std::set<ElementId>& elements) {
  m_selection->select(elements);
}

// --- filters ----------------------------------------------------------------------------------------------

void AtlasPanel::onFilterChanged() {
  m_followsTrain = false;
  ChainFilter filter{.links = m_links->choice(),
                     .dof = m_dof->choice(),
                     .axes = m_axes->choice(),
                     .isNonfractionatedOnly = m_whole->isChecked()};
  if (m_sameEquations->isChecked()) filter.equations = m_equations;
  setFilter(filter);
}

void AtlasPanel::setFilter(const ChainFilter& filter) {
  m_filter = filter;
  if (filter.equations) m_equations = filter.equations;
  if (m_catalogue) renew();
}

void AtlasPanel::showTrainsThatCannotTurn() {
  m_followsTrain = false;
  setFilter({.dof = 0});
}

/// A chain that is still in the list stays the chosen one.
void AtlasPanel::renew() {
  const AtlasChain* const chosen = m_card->chain();
  m_links->setChoice(m_filter.links);
  m_dof->setChoice(m_filter.dof);
  m_axes->setChoice(m_filter.axes);
  m_whole->setChecked(m_filter.isNonfractionatedOnly);
  const FilterCounts counts = m_catalogue->counts(m_filter);
  m_links->setCounts(counts.links);
  m_dof->setCounts(counts.dof);
  m_axes->setCounts(counts.axes);
  m_whole->setText(tr("nonfractionated (%1)").arg(locale().toString(counts.nonfractionated)));
  updateEquations();
  m_count->setText(tr("%1 of %2 chains; equations: %3")
                       .arg(locale().toString(counts.all),
                            locale().toString(static_cast<int>(m_catalogue->atlas().chains().size())),
                            locale().toString(counts.rotations)));
  m_isShowing = true;
  m_model->setChains(m_catalogue->chosen(m_filter));
  if (m_model->indexOf(chosen).isValid()) {
    m_grid->setCurrent(chosen);
  } else if (!m_model->chains().empty()) {
    m_grid->setCurrent(m_model->chains().front());
  }
  m_isShowing = false;
}

void AtlasPanel::updateEquations() {
  m_sameEquations->setVisible(m_equations.has_value());
  if (!m_equations) return;
  m_sameEquations->setText(tr("equations of %1 only").arg(QString::fromStdString(m_equations->toString())));
  m_sameEquations->setChecked(m_filter.equations.has_value());
}

// --- chains -----------------------------------------------------------------------------------------------

void AtlasPanel::onChosen(const AtlasChain* chain) {
  if (!m_isShowing) m_followsTrain = false;
  if (chain == m_card->chain()) return;
  m_card->setChain(chain, nullptr);
  m_details->request(chain);
}

bool AtlasPanel::showChain(const ChainNumber& number) {
  if (!m_catalogue) return false;
  const auto group = m_catalogue->atlas().group(number);
  const AtlasChain* chain = nullptr;
  if (number.displacement > 0) {
    chain = m_catalogue->atlas().find(number);
  } else if (!group.empty()) {
    chain = &group.front();
  }
  if (chain == nullptr) return false;
  if (!m_model->indexOf(chain).isValid()) setFilter({.links = number.links, .dof = number.dof});
  m_isShowing = true;
  m_grid->setCurrent(chain);
  m_isShowing = false;
  return true;
}

void AtlasPanel::find() {
  const QString text = m_find->text().trimmed();
  const auto number = ChainNumber::fromText(text.toStdString());
  m_followsTrain = false;
  if (!number || !showChain(*number)) return emit rejected(tr("The atlas has no chain %1.").arg(text));
  if (number->displacement == 0) setFilter({.links = number->links, .dof = number->dof, .equations = number});
  m_grid->setFocus(Qt::OtherFocusReason);
}

void AtlasPanel::openChosen() {
  if (m_card->chain() == nullptr) return;
  m_card->setOpening(true);
  m_documents->request(m_card->chain());
}

ViewEntry atlasView() {
  return {
      .id = QStringLiteral("atlas"),
      .title = AtlasPanel::tr("Atlas"),
      .tip = AtlasPanel::tr(
          "All geared kinematic chains up to 7 links, and which of them your train is. Arrow keys walk, "
          "Enter opens one as a document, / finds a number."),
      .purpose = AtlasPanel::tr("Geared kinematic chains, filtered and counted, and which your train is."),
      .helpPage = QStringLiteral("gearboxes#the-atlas-of-chains"),
      .searchWords = QStringLiteral("chains identify isomorphism enumerate rotation displacement graph"),
      .place = ViewPlace::drawings,
      .holdsAnswers = false,
      .make = [](Views& views, QWidget* parent) -> ResultsView* {
        auto* panel = new AtlasPanel(views.document(), views.selection(), parent);
        QObject::connect(panel, &AtlasPanel::settled, &views, &Views::settled);
        QObject::connect(panel, &AtlasPanel::rejected, &views, &Views::rejected);
        QObject::connect(panel, &AtlasPanel::documentWanted, &views, &Views::documentWanted);
        return panel;
      }};
}

}  // namespace geargraph

#include "moc_atlas_panel.cpp"
