#include "ui/forces/forces_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFrame>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "ui/forces/duality_line.h"
#include "ui/forces/efficiency_card.h"
#include "ui/forces/efficiency_page.h"
#include "ui/forces/explanation_label.h"
#include "ui/forces/force_table_model.h"
#include "ui/forces/linked_table.h"
#include "ui/forces/loads_list.h"
#include "ui/models/term_tips.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/looks.h"
#include "ui/theme/sideways_scroll.h"

namespace geargraph {
namespace {

QString tipOf(ForceTableKind kind) {
  switch (kind) {
    case ForceTableKind::joints:
      return ForcesPanel::tr("Torque, rate and power in every turning joint, and of what acts on links");
    case ForceTableKind::couplings:
      return ForcesPanel::tr("Torques of the brakes and clutches that are engaged");
    case ForceTableKind::meshes:
      return ForcesPanel::tr(
          "Torques on the gears of every mesh, tooth forces, and the power that it passes");
    case ForceTableKind::bearings:
      return ForcesPanel::tr("What holds each link in its turning joint: force and moment");
    case ForceTableKind::powers:
      return ForcesPanel::tr("What every element delivers to each of its links, seen from the ground");
    case ForceTableKind::circulations:
      return ForcesPanel::tr("Power that goes round in loops, beside what goes through the train");
    case ForceTableKind::states:
      return ForcesPanel::tr("Torques of the couplings and efficiency in every state of the gearbox");
  }
  return {};
}

constexpr int kPlotsChip = 1000;  ///< beyond all kinds of tables
constexpr int kCardWidth = 216;
constexpr int kRoomForCard = 1080;  ///< px at which the card of the efficiency has a column of its own

/// Every kind, in the order of the chips.
std::vector<ForceTableKind> kindsOfChips() {
  std::vector<ForceTableKind> kinds = allForceTableKinds();
  kinds.push_back(ForceTableKind::states);
  return kinds;
}

}  // namespace

ForcesPanel::ForcesPanel(Document* document, Selection* selection, ForcesService* service, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_service(service),
      m_model(new ForceTableModel(this)),
      m_loads(new LoadsList(document, selection, this)),
      m_table(new LinkedTable(m_model, selection, this)),
      m_pages(new QStackedWidget(this)),
      m_plots(new EfficiencyPage(this)),
      m_card(new EfficiencyCard(document, this)),
      m_empty(emptyLabel(this)),
      m_remark(new QLabel(this)),
      m_explanation(new ExplanationLabel(selection, this)) {
  m_remark->setObjectName(QStringLiteral("forcesRemark"));
  m_remark->setWordWrap(true);
  m_remark->setTextFormat(Qt::PlainText);
  m_remark->setContentsMargins(12, 2, 12, 4);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(new SidewaysScroll(makeBar(), this));
  layout->addWidget(makeMiddle(), 1);
  layout->addWidget(new SidewaysScroll(makeTotals(), this));
  m_duality = new DualityLine(selection, this);
  m_dualityStrip = new SidewaysScroll(m_duality, this);
  m_dualityStrip->setVisible(false);
  connect(m_duality, &DualityLine::filled, this, [this](bool filled) {
    m_isDualityFilled = filled;
    showDuality();
  });
  // A table of few rows leaves room for what is below it.
  m_pages->setMinimumHeight(scaledPixels(100));
  layout->addWidget(m_dualityStrip);
  // What is shared, and beside it what decides the shares.
  auto* remark = new QHBoxLayout;
  remark->setContentsMargins(0, 0, 10, 0);
  remark->addWidget(m_remark, 1);
  remark->addStretch();  // where there is no remark
  remark->addWidget(makeShareButton(), 0, Qt::AlignVCenter);
  layout->addLayout(remark);
  layout->addWidget(m_explanation);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  m_service->onAnswer(this, [this](const ForcesPtr&) { showForces(); });
  connect(m_service, &ForcesService::failed, this, [this](const QString& why) {
    m_empty->setText(tr("The torques could not be worked out: %1").arg(why));
    m_pages->setCurrentWidget(m_empty);
  });
  showForces();
}

QWidget* ForcesPanel::makeBar() {
  auto* bar = new QWidget(this);
  auto* layout = new QHBoxLayout(bar);
  layout->setContentsMargins(12, 6, 10, 2);
  layout->setSpacing(4);
  m_chips = new QButtonGroup(this);
  const auto addChip = [&](const QString& text, const QString& name, const QString& tip, int id) {
    auto* chip = new QToolButton(bar);
    chip->setText(text);
    chip->setObjectName(QStringLiteral("chip.") + name);
    chip->setToolTip(tip);
    chip->setCheckable(true);
    chip->setProperty("look", "chip");
    m_chips->addButton(chip, id);
    layout->addWidget(chip);
  };
  for (const ForceTableKind kind : kindsOfChips())
    addChip(shownText(forceTableTitle(kind)), shownText(forceTableCommandName(kind)), tipOf(kind),
            static_cast<int>(kind));
  addChip(tr("Plots"), QStringLiteral("plots"),
          tr("Efficiency and torques over the ratio of two speeds, or over the efficiency of the meshes"),
          kPlotsChip);
  m_chips->button(static_cast<int>(ForceTableKind::joints))->setChecked(true);
  connect(m_chips, &QButtonGroup::idClicked, this,
          [this](int id) { id == kPlotsChip ? showPlots() : showTable(static_cast<ForceTableKind>(id)); });
  layout->addStretch(1);
  m_states = new QComboBox(bar);
  m_states->setObjectName(QStringLiteral("forcesState"));
  m_states->setToolTip(tr("The state whose brakes and clutches are engaged"));
  connect(m_states, &QComboBox::activated, this, [this] { ask(); });
  layout->addWidget(m_states);
  m_copy =
      controlButton(QStringLiteral("copyForces"), tr("Copy"), tr("Copy the table for a spreadsheet"), bar);
  connect(m_copy, &QToolButton::clicked, this, &ForcesPanel::copy);
  layout->addWidget(m_copy);
  m_export = controlButton(QStringLiteral("exportForces"), tr("CSV…"),
                           tr("Export the table with its units to a CSV file"), bar);
  connect(m_export, &QToolButton::clicked, this, &ForcesPanel::wantExport);
  layout->addWidget(m_export);
  return bar;
}

QWidget* ForcesPanel::makeMiddle() {
  m_table->setObjectName(QStringLiteral("forceTable"));
  m_table->setAccessibleName(tr("Forces"));
  m_pages->addWidget(m_table);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_plots);
  connect(m_plots, &EfficiencyPage::tableChanged, this, [this] { showPage(); });

  m_side = new QWidget(this);
  auto* column = new QVBoxLayout(m_side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(m_loads);
  column->addStretch(1);
  m_side->installEventFilter(this);
  m_sideView = new QScrollArea(this);
  m_sideView->setWidget(m_side);
  auto* middle = new QWidget(this);
  // The card is higher than the panel need be.
  m_cardView = new QScrollArea(middle);
  m_cardView->setWidget(m_card);
  m_cardView->setMinimumWidth(scaledPixels(kCardWidth));
  for (QScrollArea* view : {m_sideView, m_cardView}) {
    view->setFrameShape(QFrame::NoFrame);
    view->setWidgetResizable(true);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setFocusPolicy(Qt::NoFocus);  // what is in it has
  }
  auto* row = new QHBoxLayout(middle);
  row->setContentsMargins(0, 0, 10, 0);
  row->setSpacing(6);
  row->addWidget(m_sideView);
  row->addWidget(m_pages, 1);
  row->addWidget(m_cardView);
  return middle;
}

void ForcesPanel::setSnapshot(const SnapshotPtr& snapshot) {
  updateStates(*snapshot->mechanism);
  ask();
}

void ForcesPanel::setAwake(bool awake) {
  m_service->setWatched(this, awake);
  m_explanation->setAwake(awake);
}

/// "As engaged", then those of the document; the one that was chosen stays by its name.
void ForcesPanel::updateStates(const Mechanism& mechanism) {
  QStringList names{tr("as engaged")};
  for (const ShiftState& state : mechanism.states) names += tr("state %1").arg(shownText(state.name));
  const bool hasCouplings = !mechanism.couplings.empty();
  m_chips->button(static_cast<int>(ForceTableKind::couplings))->setVisible(hasCouplings);
  if (!hasCouplings && m_model->kind() == ForceTableKind::couplings) showTable(ForceTableKind::joints);
  QStringList there;
  for (int i = 0; i < m_states->count(); ++i) there += m_states->itemText(i);
  if (names == there) return;
  const QString chosen = m_states->currentText();
  m_states->clear();
  m_states->addItems(names);
  const auto at = names.indexOf(chosen);
  m_states->setCurrentIndex(at > 0 ? static_cast<int>(at) : 0);
  const bool hasStates = names.size() > 1;
  m_states->setVisible(hasStates);
  m_chips->button(static_cast<int>(ForceTableKind::states))->setVisible(hasStates);
  if (!hasStates && m_model->kind() == ForceTableKind::states) showTable(ForceTableKind::joints);
}

void ForcesPanel::ask() {
  const ForcesQuestion question{std::max(m_states->currentIndex(), 0) - 1, {}};
  if (question != m_service->question()) m_service->ask(question);
}

void ForcesPanel::showTable(ForceTableKind kind) {
  m_chips->button(static_cast<int>(kind))->setChecked(true);
  m_model->show(forces(), kind);
  showForces();
}

void ForcesPanel::showPlots() {
  m_chips->button(kPlotsChip)->setChecked(true);
  showForces();
}

bool ForcesPanel::showsPlots() const {
  return m_chips->checkedId() == kPlotsChip;
}

bool ForcesPanel::isUpToDate() const {
  return m_service->isComplete() && m_card->isUpToDate() && (!showsPlots() || m_plots->isUpToDate());
}

void ForcesPanel::showState(int state) {
  if (state + 1 >= m_states->count()) return;
  m_states->setCurrentIndex(state + 1);
  ask();
}

void ForcesPanel::showForces() {
  m_model->show(forces(), m_model->kind());
  m_plots->show(forces());
  m_card->show(forces());
  showPage();
  showTotals();
  showRemark();
  m_table->selectRowOfSelection();
  m_duality->show(forces());
  m_explanation->show(forces());
}

/// The table, the plots, or why there is neither.
void ForcesPanel::showPage() {
  const bool plots = showsPlots();
  const QString why = plots ? QString() : whyEmpty();
  m_empty->setText(why);
  m_pages->setCurrentWidget(plots           ? static_cast<QWidget*>(m_plots)
                            : why.isEmpty() ? static_cast<QWidget*>(m_table)
                                            : m_empty);
  const QString none = plots ? m_plots->emptyText() : why;
  showDuality();
  for (QToolButton* button : {m_copy, m_export}) button->setEnabled(none.isEmpty());
  if (!plots && why.isEmpty()) m_table->resizeColumnsToContents();
}

/// Plots need the room, and show no entry that is shared.
void ForcesPanel::showDuality() {
  m_dualityStrip->setVisible(m_isDualityFilled && m_pages->currentWidget() != m_plots);
}

QString ForcesPanel::whyEmpty() const {
  const ForcesPtr& shown = forces();
  if (!shown) return tr("Torques and forces appear here as soon as the mechanism is analysed.");
  if (m_model->rowCount() > 0) return {};
  if (!shown->report) {
    for (const Diagnostic& diagnostic : shown->snapshot->diagnostics)
      if (diagnostic.severity() == Severity::error) return shownText(diagnostic.message);
    return tr("Draw turning joints and gear meshes: their torques appear here.");
  }
  const StaticsReport& report = *shown->report;
  if (!report.isSolved || !report.lossless.isBalanced())
    return tr("There is no equilibrium: the reason is below.");
  if (!report.isAnswered()) return tr("With these losses no torques are known: the reason is below.");
  switch (m_model->kind()) {
    case ForceTableKind::couplings:
      return tr("No brake or clutch is engaged: engage one in Gearbox, or choose a state.");
    case ForceTableKind::bearings:
      return tr("Forces need a unit of length whose size is known.");
    case ForceTableKind::powers:
      return report.flow ? tr("No power flows.") : tr("Without a motion there is no power.");
    case ForceTableKind::circulations:
      return report.circulations
                 ? tr("No power circulates.")
                 : tr("Loops are found where every link but the planets turns on the ground.");
    default:
      return tr("There is nothing to show.");
  }
}

QString ForcesPanel::remark() const {
  return m_remark->text();
}

/// The gravest diagnostic; all of them are its tooltip.
void ForcesPanel::showRemark() {
  const ForcesPtr& shown = forces();
  const Diagnostic* gravest = nullptr;
  QStringList all;
  if (shown && shown->report) {
    for (const Diagnostic& each : shown->report->diagnostics) {
      // The panel offers the efficiency of meshes that state none.
      if (each.code == Code::noEfficiency) continue;
      all += shownText(each.message);
      if (gravest == nullptr || each.severity() < gravest->severity()) gravest = &each;
    }
  }
  m_remark->setVisible(gravest != nullptr);
  m_remark->setText(gravest == nullptr ? QString() : shownText(gravest->message));
  m_remark->setToolTip(all.size() > 1 ? all.join(QStringLiteral("\n")) : QString());
  if (gravest == nullptr) return;
  const ColorRole role = gravest->severity() == Severity::error     ? ColorRole::error
                         : gravest->severity() == Severity::warning ? ColorRole::warning
                                                                    : ColorRole::secondary;
  setInk(*m_remark, role);
}

QString ForcesPanel::explanation() const {
  return m_explanation->text();
}

/// As wide as the rows of the loads, and the card, need.
void ForcesPanel::fitSide() {
  const int width = m_side->minimumSizeHint().width() + m_sideView->verticalScrollBar()->sizeHint().width();
  m_sideView->setFixedWidth(std::max(width, scaledPixels(236)));
}

/// The table comes first: where three columns do not fit, the card goes below the loads.
void ForcesPanel::placeCard() {
  const bool isBeside = width() >= scaledPixels(kRoomForCard);
  if (isBeside == (m_cardView->widget() == m_card)) return;
  if (isBeside) {
    m_side->layout()->removeWidget(m_card);
    m_cardView->setWidget(m_card);
  } else {
    m_cardView->takeWidget();
    static_cast<QVBoxLayout*>(m_side->layout())->insertWidget(1, m_card);  // below the loads
  }
  m_card->setVisible(true);
  m_cardView->setVisible(isBeside);
  fitSide();
}

QSize ForcesPanel::minimumSizeHint() const {
  const QSize wanted = QWidget::minimumSizeHint();
  const bool isBeside = m_cardView->widget() == m_card;
  return {isBeside ? wanted.width() - m_cardView->minimumWidth() : wanted.width(), wanted.height()};
}

void ForcesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeCard();
}

bool ForcesPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_side && event->type() == QEvent::LayoutRequest) fitSide();
  return QWidget::eventFilter(watched, event);
}

std::optional<ValueTable> ForcesPanel::shownTable() const {
  if (showsPlots()) return m_plots->table();
  const ForceTable* const table = m_model->table();
  return table == nullptr ? std::nullopt : std::optional<ValueTable>(*table);
}

void ForcesPanel::wantExport() {
  const std::optional<ValueTable> table = shownTable();
  if (!table) return;
  TextSink sink;
  writeForceCsv(sink, *table);
  const QString name =
      showsPlots() ? QStringLiteral("efficiency") : shownText(forceTableCommandName(m_model->kind()));
  emit exportWanted(name + QStringLiteral(".csv"), QString::fromStdString(sink.text()));
}

void ForcesPanel::copy() {
  const std::optional<ValueTable> table = shownTable();
  if (!table) return;
  TextSink sink;
  CsvOptions options;
  options.separator = '\t';
  writeForceCsv(sink, *table, options);
  QApplication::clipboard()->setText(QString::fromStdString(sink.text()));
}

}  // namespace geargraph

#include "moc_forces_panel.cpp"
