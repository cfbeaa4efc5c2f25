#include "ui/forces/forces_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "core/mechanism/model/load_edits.h"
#include "ui/forces/duality_line.h"
#include "ui/forces/efficiency_card.h"
#include "ui/forces/efficiency_page.h"
#include "ui/forces/efficiency_view.h"
#include "ui/forces/explanation_label.h"
#include "ui/forces/force_table_model.h"
#include "ui/forces/linked_table.h"
#include "ui/forces/loads_list.h"
#include "ui/forces/question_bar.h"
#include "ui/forces/totals_strip.h"
#include "ui/forces/why_page.h"
#include "ui/models/term_tips.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/looks.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kLeastTable = 40;  ///< px of height: a low panel with large type has no more
constexpr int kLowPanel = 260;   ///< px of height
constexpr int kLoadsPart = 3;    ///< loads take at most this part of the height

}  // namespace

ForcesPanel::ForcesPanel(Document* document, Selection* selection, ForcesService* service, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_service(service),
      m_model(new ForceTableModel(this)),
      m_questions(new QuestionBar(this)),
      m_table(new LinkedTable(m_model, selection, this)),
      m_pages(new QStackedWidget(this)),
      m_efficiency(new EfficiencyView(document, this)),
      m_empty(emptyLabel(this)),
      m_remark(new QLabel(this)) {
  makeQuestions();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_questions);
  layout->addWidget(makeControls());
  layout->addWidget(m_loads);
  layout->addWidget(m_pages, 1);
  m_remark->setObjectName(QStringLiteral("forcesRemark"));
  m_remark->setWordWrap(true);
  m_remark->setTextFormat(Qt::PlainText);
  m_remark->setContentsMargins(12, 0, 10, 2);
  layout->addWidget(m_remark);
  m_table->setObjectName(QStringLiteral("forceTable"));
  m_table->setAccessibleName(tr("Forces"));
  auto* tablePage = new QWidget(this);
  auto* tableLayout = new QVBoxLayout(tablePage);
  tableLayout->setContentsMargins(8, 0, 0, 0);  // as far in as the controls above
  tableLayout->addWidget(m_table);
  m_tablePage = tablePage;
  m_pages->addWidget(m_tablePage);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_efficiency);
  m_pages->addWidget(m_why);
  m_pages->setMinimumHeight(kLeastTable);
  connect(&m_efficiency->plots(), &EfficiencyPage::tableChanged, this, &ForcesPanel::showPage);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  m_service->onAnswer(this, [this](const ForcesPtr&) { showForces(); });
  connect(m_service, &ForcesService::failed, this, [this](const QString& why) {
    m_empty->setText(tr("The torques could not be worked out: %1").arg(why));
    m_pages->setCurrentWidget(m_empty);
  });
  updateStates(*document->mechanism());
  present(ForceView::needs);
}

ForcesPanel::~ForcesPanel() = default;

void ForcesPanel::makeQuestions() {
  connect(m_questions, &QuestionBar::asked, this, &ForcesPanel::ask);
  m_states = new QComboBox(this);
  m_states->setObjectName(QStringLiteral("forcesState"));
  m_states->setAccessibleName(tr("State"));
  m_states->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_states->setToolTip(tr("The state whose brakes and clutches are engaged"));
  connect(m_states, &QComboBox::activated, this, [this](int at) { showState(at - 1); });
  m_copy =
      controlButton(QStringLiteral("copyForces"), tr("Copy"), tr("Copy the table for a spreadsheet"), this);
  connect(m_copy, &QToolButton::clicked, this, &ForcesPanel::copy);
  m_export = controlButton(QStringLiteral("exportForces"), tr("CSV…"),
                           tr("Export the table with its units to a CSV file"), this);
  connect(m_export, &QToolButton::clicked, this, &ForcesPanel::wantExport);
  for (QWidget* control :
       {static_cast<QWidget*>(m_states), static_cast<QWidget*>(m_copy), static_cast<QWidget*>(m_export)})
    m_questions->addControl(control);
}

/// The views of the question, and what belongs to it alone.
QWidget* ForcesPanel::makeControls() {
  auto* row = new QWidget(this);
  auto* flow = new FlowLayout(row);
  flow->setContentsMargins(12, 2, 10, 2);
  flow->setSpacing(4);
  m_chips = new QButtonGroup(this);
  for (const ForceViewEntry& entry : forceViewEntries()) {
    if (entry.title.isEmpty()) continue;  // the only view of its question
    auto* chip = new QToolButton(row);
    chip->setText(entry.title);
    chip->setObjectName(QStringLiteral("chip.") + entry.name);
    chip->setToolTip(entry.tip);
    chip->setCheckable(true);
    chip->setProperty("look", "chip");
    m_chips->addButton(chip, static_cast<int>(entry.view));
    flow->addWidget(chip);
  }
  connect(m_chips, &QButtonGroup::idClicked, this, [this](int id) { showView(static_cast<ForceView>(id)); });
  m_loads = new LoadsList(m_document, m_selection, *flow, row);
  m_totals = std::make_unique<TotalsStrip>(*flow, row);
  m_why = new WhyPage(m_selection, *flow, row);
  makeShare(row);
  flow->addWidget(m_share);
  return row;
}

void ForcesPanel::makeShare(QWidget* parent) {
  m_share = controlButton(QStringLiteral("shareByStiffness"), tr("Share by stiffness"),
                          tr("Meshes that share a load in unknown parts: assume that all teeth are equally "
                             "stiff, without clearance, on rigid bodies"),
                          parent);
  m_share->setCheckable(true);
  connect(m_share, &QToolButton::clicked, this, [this](bool isOn) {
    const auto sharing = isOn ? std::optional(LoadSharing::stiffness) : std::nullopt;
    m_document->apply(
        {tr("Set load sharing"),
         [sharing](const Mechanism& before) -> Expected<Mechanism> { return withSharing(before, sharing); },
         0});
  });
}

void ForcesPanel::setSnapshot(const SnapshotPtr& snapshot) {
  updateStates(*snapshot->mechanism);
  askService();
}

void ForcesPanel::setAwake(bool awake) {
  m_isAwake = awake;
  m_service->setWatched(this, awake);
  m_why->setAwake(m_isAwake && m_view == ForceView::why);
}

/// "As engaged", then those of the document; the one that was chosen stays by its name.
void ForcesPanel::updateStates(const Mechanism& mechanism) {
  QStringList names{tr("as engaged")};
  for (const ShiftState& state : mechanism.states) names += tr("state %1").arg(shownText(state.name));
  QStringList there;
  for (int i = 0; i < m_states->count(); ++i) there += m_states->itemText(i);
  if (names != there) {
    const QString chosen = m_states->currentText();
    m_states->clear();
    m_states->addItems(names);
    const auto at = names.indexOf(chosen);
    m_states->setCurrentIndex(at > 0 ? static_cast<int>(at) : 0);
    m_states->setVisible(names.size() > 1);
  }
  chooseUsualView(mechanism);
  showControls();
}

/// Of a gearbox in which nothing is engaged, the torques in its states answer what is needed.
void ForcesPanel::chooseUsualView(const Mechanism& mechanism) {
  if (m_isViewChosen && isPossible(m_lastViews[ForceQuestion::need])) return;
  m_isViewChosen = false;
  const bool isForStates = !mechanism.states.empty() && mechanism.engaged.empty() &&
                           mechanism.loads.empty() && m_states->currentIndex() <= 0;
  const ForceView usual = isForStates ? ForceView::states : ForceView::needs;
  m_lastViews[ForceQuestion::need] = usual;
  if (questionOf(m_view) == ForceQuestion::need && m_view != usual) present(usual);
}

bool ForcesPanel::isPossible(ForceView view) const {
  const Mechanism& mechanism = *m_document->mechanism();
  if (view == ForceView::couplings) return !mechanism.couplings.empty();
  return view != ForceView::states || !mechanism.states.empty();
}

void ForcesPanel::askService() {
  const ForcesQuestion question{std::max(m_states->currentIndex(), 0) - 1, {}};
  if (question != m_service->question()) m_service->ask(question);
}

void ForcesPanel::ask(ForceQuestion question) {
  const auto last = m_lastViews.find(question);
  if (last != m_lastViews.end() && isPossible(last->second)) return present(last->second);
  const std::vector<ForceViewEntry> views = forceViewEntries();
  present(std::find_if(views.begin(), views.end(), [question](const ForceViewEntry& each) {
            return each.question == question;
          })->view);
}

void ForcesPanel::showView(ForceView view) {
  if (questionOf(view) == ForceQuestion::need) m_isViewChosen = true;
  present(view);
}

void ForcesPanel::present(ForceView view) {
  m_view = view;
  m_lastViews[questionOf(view)] = view;
  m_questions->choose(questionOf(view));
  if (QAbstractButton* chip = m_chips->button(static_cast<int>(view)); chip != nullptr)
    chip->setChecked(true);
  showControls();
  m_why->setAwake(m_isAwake && view == ForceView::why);
  showForces();
}

void ForcesPanel::showControls() {
  const ForceQuestion question = questionOf(m_view);
  for (QAbstractButton* chip : m_chips->buttons()) {
    const auto view = static_cast<ForceView>(m_chips->id(chip));
    chip->setVisible(questionOf(view) == question && isPossible(view));
  }
  m_loads->setShown(question == ForceQuestion::need);
  m_totals->setVisible(question == ForceQuestion::flow && m_view != ForceView::efficiency);
  m_why->setShown(question == ForceQuestion::why);
}

bool ForcesPanel::isUpToDate() const {
  return m_service->isComplete() && (m_view != ForceView::efficiency || m_efficiency->isUpToDate());
}

void ForcesPanel::showState(int state) {
  if (state + 1 >= m_states->count()) return;
  m_states->setCurrentIndex(state + 1);
  if (state >= 0 && m_view == ForceView::states) present(ForceView::needs);  // the one that was asked for
  askService();
}

void ForcesPanel::showForces() {
  m_model->show(forces(), kindOf(m_view).value_or(m_model->kind()));
  m_efficiency->show(forces());
  m_totals->show(forces());
  m_why->show(forces());
  showPage();
  showShare();
  showRemark();
  m_table->selectRowOfSelection();
}

/// The view, or why there is nothing in it.
void ForcesPanel::showPage() {
  const bool isPlot = m_view == ForceView::efficiency;
  const QString why = isPlot ? QString() : whyEmpty();
  m_empty->setText(why);
  m_pages->setCurrentWidget(isPlot                     ? static_cast<QWidget*>(m_efficiency)
                            : !why.isEmpty()           ? static_cast<QWidget*>(m_empty)
                            : m_view == ForceView::why ? static_cast<QWidget*>(m_why)
                                                       : m_tablePage);
  const QString none = isPlot ? m_efficiency->plots().emptyText() : why;
  for (QToolButton* button : {m_copy, m_export})
    button->setEnabled(none.isEmpty() && m_view != ForceView::why);
  if (m_pages->currentWidget() == m_tablePage)
    m_table->fitColumns([this](int column) { return showsColumn(m_view, column); });
}

QString ForcesPanel::whyEmpty() const {
  const ForcesPtr& shown = forces();
  if (!shown) return tr("Torques and forces appear here as soon as the mechanism is analysed.");
  if (!shown->report) {
    for (const Diagnostic& diagnostic : shown->snapshot->diagnostics)
      if (diagnostic.severity() == Severity::error) return shownText(diagnostic.message);
    return tr("Draw turning joints and gear meshes: their torques appear here.");
  }
  const StaticsReport& report = *shown->report;
  if (m_view == ForceView::why && report.isSolved) return {};
  if (m_view == ForceView::losses && report.isAnswered() && !report.flow)
    return tr("Without a motion there is no power.");
  if (m_model->rowCount() > 0 && m_view != ForceView::why) return {};
  if (!report.isSolved || !report.lossless.isBalanced())
    return tr("There is no equilibrium: the reason is below.");
  if (!report.isAnswered()) return tr("With these losses no torques are known: the reason is below.");
  switch (m_view) {
    case ForceView::needs:
      return tr("No load acts and nothing is held: add a load.");
    case ForceView::couplings:
      return tr("No brake or clutch is engaged: engage one in Gearbox, or choose a state.");
    case ForceView::bearings:
      return tr("Forces need a unit of length whose size is known.");
    case ForceView::powers:
      return report.flow ? tr("No power flows.") : tr("Without a motion there is no power.");
    case ForceView::circulations:
      return report.circulations
                 ? tr("No power circulates.")
                 : tr("Loops are found where every link but the planets turns on the ground.");
    default:
      return tr("There is nothing to show.");
  }
}

EfficiencyPage& ForcesPanel::plots() {
  return m_efficiency->plots();
}

EfficiencyCard& ForcesPanel::efficiency() {
  return m_efficiency->card();
}

DualityLine& ForcesPanel::dualityLine() {
  return m_why->dualityLine();
}

QString ForcesPanel::remark() const {
  return m_remark->text();
}

QString ForcesPanel::explanation() const {
  return m_why->explanation().text();
}

QString ForcesPanel::emptyText() const {
  return m_pages->currentWidget() == m_empty ? m_empty->text() : QString();
}

QString ForcesPanel::total(const QString& name) const {
  const auto* label = findChild<QLabel*>(QStringLiteral("total.") + name);
  return label == nullptr ? QString() : label->text();
}

void ForcesPanel::showShare() {
  const bool isAsked = m_document->mechanism()->sharing == LoadSharing::stiffness;
  const ForcesPtr& shown = forces();
  const StaticsReport* report = shown && shown->report ? &*shown->report : nullptr;
  const ForceQuestion question = questionOf(m_view);
  const bool isOfLoads = question == ForceQuestion::need || question == ForceQuestion::parts;
  m_share->setChecked(isAsked);
  m_share->setVisible(isOfLoads && report != nullptr && report->isSolved &&
                      (isAsked || report->lossless.indeterminate() > 0));
}

/// The gravest diagnostic; all of them are its tooltip. The table of states is under torques of its own.
void ForcesPanel::showRemark() {
  const ForcesPtr& shown = forces();
  if (m_view == ForceView::states && m_model->table() != nullptr) {
    const QString note = shownText(m_model->table()->note);
    m_remark->setVisible(!note.isEmpty());
    m_remark->setText(note);
    m_remark->setToolTip({});
    return setInk(*m_remark, ColorRole::secondary);
  }
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

/// A long list of loads scrolls, and leaves the table its room.
void ForcesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_loads->setRoom(height() / kLoadsPart, height() < scaledPixels(kLowPanel));
}

std::optional<ValueTable> ForcesPanel::shownTable() const {
  if (m_view == ForceView::efficiency) return m_efficiency->plots().table();
  const ForceTable* const table = kindOf(m_view) ? m_model->table() : nullptr;
  return table == nullptr ? std::nullopt : std::optional<ValueTable>(*table);
}

void ForcesPanel::wantExport() {
  const std::optional<ValueTable> table = shownTable();
  if (!table) return;
  TextSink sink;
  writeForceCsv(sink, *table);
  const QString name = m_view == ForceView::efficiency ? QStringLiteral("efficiency")
                                                       : shownText(forceTableCommandName(m_model->kind()));
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
