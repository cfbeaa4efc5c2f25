#include "ui/panels/gearbox_panel.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/states/state_edits.h"
#include "core/theory/statics/shift_statics.h"
#include "ui/models/printed_number.h"
#include "ui/models/term_tips.h"
#include "ui/panels/compare_states.h"
#include "ui/panels/drive_torque_strip.h"
#include "ui/panels/engagement_edits.h"
#include "ui/panels/states_table.h"
#include "ui/theme/application_theme.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/looks.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxListedLinks = 200;  // a menu of thousands takes half a second, and nobody reads it

/// The end of the links that a menu lists.
std::size_t listedLinks(const Mechanism& mechanism) {
  return std::min(mechanism.links.size(), kMaxListedLinks + 1);
}

/// Says how the links are chosen that the menu does not list.
void sayUnlisted(QMenu& menu, const Mechanism& mechanism) {
  const std::size_t count = mechanism.links.size() - listedLinks(mechanism);
  if (count == 0) return;
  menu.addAction(GearboxPanel::tr("%1 more: select links in a drawing first").arg(count))->setEnabled(false);
}

/// Is there a torque that statics does not decide?
bool isAnyShared(const ValueTable& torques) {
  const auto end = static_cast<std::ptrdiff_t>(torques.columns.size()) -
                   static_cast<std::ptrdiff_t>(ShiftColumn::count) +
                   static_cast<std::ptrdiff_t>(ShiftColumn::found) + 1;
  return std::any_of(torques.rows.begin(), torques.rows.end(), [end](const ForceRow& row) {
    return std::any_of(row.cells.begin() + 1, row.cells.begin() + end,
                       [](const ForceCell& cell) { return !cell.number && !cell.text.empty(); });
  });
}

}  // namespace

GearboxPanel::GearboxPanel(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_model(new StatesModel(this)),
      m_table(new StatesTable(m_model, this)),
      m_brake(makeButton("addBrake", tr("+ Brake"),
                         tr("Hold a link against the ground: the selected one, or choose"))),
      m_clutch(makeButton("addClutch", tr("+ Clutch"),
                          tr("Make two links turn as one: the two selected, or choose"))),
      m_state(makeButton("addState", tr("+ State"), tr("A new row: what is engaged together"))),
      m_compare(makeButton("compareStates", tr("Compare states"),
                           tr("Two states side by side: ratios, torques, efficiencies, speeds"))),
      m_export(
          makeButton("exportStates", tr("CSV…"),
                     tr("Export the table with drive, driven, what is engaged and steps to a CSV file"))),
      m_release(makeButton("releaseAll", tr("Release all"),
                           tr("Release every brake and clutch; the motion goes on (Ctrl+B)"))),
      m_torque(new DriveTorqueStrip(document, this)),
      m_pages(new QStackedWidget(this)),
      m_empty(emptyLabel(this)),
      m_comparison(new CompareStates(m_model, this)),
      m_remark(new QLabel(this)) {
  m_empty->setText(
      tr("A gearbox has brakes, which hold a link, and clutches, which make two links turn as one. Select a "
         "link "
         "and add a brake, or two links and add a clutch; then add states that engage them."));
  m_pages->addWidget(m_table);
  m_pages->addWidget(m_empty);
  m_pages->addWidget(m_comparison);
  m_remark->setObjectName(QStringLiteral("remark"));
  m_remark->setWordWrap(true);
  m_remark->setContentsMargins(16, 4, 16, 0);

  m_compare->setCheckable(true);
  auto* row = new QWidget(this);
  auto* buttons = new FlowLayout(row);
  buttons->setContentsMargins(12, 6, 12, 0);
  buttons->setSpacing(6);
  for (QToolButton* button : {m_brake, m_clutch, m_state, m_compare, m_export, m_release})
    buttons->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 8);
  layout->setSpacing(2);
  layout->addWidget(row);
  layout->addWidget(m_torque);
  layout->addWidget(m_pages, 1);
  layout->addWidget(m_remark);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);

  connect(m_brake, &QToolButton::clicked, this, &GearboxPanel::addBrake);
  connect(m_clutch, &QToolButton::clicked, this, &GearboxPanel::addClutch);
  connect(m_state, &QToolButton::clicked, this, &GearboxPanel::addState);
  connect(m_release, &QToolButton::clicked, this, &GearboxPanel::releaseAll);
  connect(m_compare, &QToolButton::toggled, this, &GearboxPanel::setComparing);
  connect(m_export, &QToolButton::clicked, this, &GearboxPanel::wantExport);
  connect(document, &Document::changed, this, &GearboxPanel::renew);
  wireTable();
  renew();
}

QToolButton* GearboxPanel::makeButton(const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setProperty("look", "control");
  return button;
}

/// What the torques in the table are under.
QString GearboxPanel::torqueRemark() const {
  const std::optional<Rational> torque = driveTorqueOf(*m_document->mechanism(), 0);
  const QString under = torque ? tr("Torques in N m, for %1 N m at the drive.").arg(printedFraction(*torque))
                               : tr("Torques in N m, under the loads of the document.");
  const QString note = shownText(m_model->torques()->note);
  return note.isEmpty() ? under : under + QLatin1Char(' ') + note;
}

void GearboxPanel::wireTable() {
  m_table->setObjectName(QStringLiteral("shiftTable"));
  m_table->setAccessibleName(tr("Shift table"));
  m_table->setTabKeyNavigation(false);
  connect(m_table, &StatesTable::clicked, this, &GearboxPanel::onClick);
  connect(m_table, &StatesTable::entered, this, &GearboxPanel::hoverCell);
  connect(m_table, &StatesTable::entered, this,
          [this](const QModelIndex& index) { emit stateHovered(index.row()); });
  connect(m_table, &StatesTable::left, this, [this] {
    m_selection->unhover();
    emit stateHovered(-1);
  });
  connect(m_table, &StatesTable::customContextMenuRequested, this, &GearboxPanel::rowMenu);
  connect(m_model, &StatesModel::renamed, this, [this](int row, const QString& name) {
    apply(tr("Rename state"), [row, name = name.toStdString()](const Mechanism& before) {
      return withStateRenamed(before, row, name);
    });
  });
  StatesHeader& heads = m_table->heads();
  connect(&heads, &StatesHeader::customContextMenuRequested, this, &GearboxPanel::headMenu);
  connect(&heads, &StatesHeader::sectionPressed, this, [this](int section) {
    const int coupling = m_model->couplingAt(section);
    if (coupling < 0) return;
    const auto& links = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].links;
    m_selection->select({links.begin(), links.end()});
  });
  connect(&heads, &StatesHeader::sectionClicked, this, [this](int section) {
    if (const int coupling = m_model->couplingAt(section); coupling >= 0) toggleCoupling(coupling);
  });
  connect(&heads, &StatesHeader::renamed, this, [this](int section, const QString& name) {
    const int coupling = m_model->couplingAt(section);
    if (coupling < 0) return;
    apply(tr("Rename coupling"),
          [id = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].id,
           name = name.toStdString()](const Mechanism& before) {
            return withCouplingRenamed(before, id, name);
          });
  });
}

void GearboxPanel::apply(const QString& text, Reduce reduce) {
  m_document->apply({text, std::move(reduce), 0});
}

void GearboxPanel::setSnapshot(const SnapshotPtr& snapshot) {
  m_model->setSnapshot(snapshot);
  paintRemark();
}

void GearboxPanel::setAwake(bool awake) {
  m_isAwake = awake;
  updateTorqueRequest();
}

void GearboxPanel::setTorques(const std::shared_ptr<const ForceTable>& torques,
                              const MechanismPtr& mechanism) {
  m_model->setTorques(torques, mechanism);
  const ForceTable* const shown = m_model->torques();
  m_torque->showSpread(shown == nullptr ? std::nullopt : spreadOf(*shown));
  m_torque->showSharing(shown != nullptr && isAnyShared(*shown));
  updateButtons();
  paintRemark();
}

void GearboxPanel::setComparing(bool isComparing) {
  m_compare->setChecked(isComparing);
  if (isComparing) {
    const int engaged = std::max(engagedState(*m_document->mechanism()), 0);
    const int states = m_model->rowCount();
    m_comparison->compare(engaged, engaged + 1 < states ? engaged + 1 : engaged - 1);
  }
  renew();
}

/// Two states at least are compared; only torques that are known are exported.
void GearboxPanel::updateButtons() {
  const MechanismPtr& mechanism = m_document->mechanism();
  const bool isComparable = mechanism->states.size() > 1;
  m_compare->setVisible(isComparable);
  if (!isComparable) m_compare->setChecked(false);
  m_export->setVisible(!mechanism->states.empty());
  m_export->setEnabled(m_model->torques() != nullptr);
  m_release->setVisible(!mechanism->couplings.empty());
  m_release->setEnabled(!mechanism->engaged.empty());
}

/// Nothing is solved for a document without states, or out of sight.
void GearboxPanel::updateTorqueRequest() {
  const Mechanism& mechanism = *m_document->mechanism();
  const bool wants = m_isAwake && !mechanism.states.empty() && !mechanism.couplings.empty();
  if (wants == m_wantsTorques) return;
  m_wantsTorques = wants;
  emit torquesWanted(wants);
}

void GearboxPanel::renew() {
  const MechanismPtr& mechanism = m_document->mechanism();
  m_model->setMechanism(mechanism);
  const int states = static_cast<int>(mechanism->states.size());
  if (m_shownState >= states) m_shownState = -1;
  updateTorqueRequest();  // it may be answered at once, which paints the remark
  updateButtons();
  const bool isEmpty = mechanism->couplings.empty() && states == 0;
  m_pages->setCurrentWidget(isEmpty                  ? static_cast<QWidget*>(m_empty)
                            : m_compare->isChecked() ? static_cast<QWidget*>(m_comparison)
                                                     : m_table);
  const bool moves = mechanism->n() > 0;
  m_brake->setEnabled(moves);
  m_clutch->setEnabled(mechanism->n() > 1);
  m_state->setEnabled(moves);
  paintRemark();
}

QString GearboxPanel::remark() const {
  return m_remark->text();
}

/// The diagnostic of the state that was clicked last, else the first there is, else what can be done.
void GearboxPanel::paintRemark() {
  const auto diagnosticOf = [&](int row) -> const Diagnostic* {
    const StateSolution* solution = row < 0 ? nullptr : m_model->solutionAt(row);
    return solution == nullptr || solution->diagnostics.empty() ? nullptr : &solution->diagnostics.front();
  };
  const Diagnostic* diagnostic = diagnosticOf(m_shownState);
  for (int row = 0; row < m_model->rowCount() && diagnostic == nullptr; ++row) {
    diagnostic = diagnosticOf(row);
    if (diagnostic != nullptr && diagnostic->severity() == Severity::info) diagnostic = nullptr;
  }
  QString text;
  ColorRole role = ColorRole::secondary;
  const bool asks =
      m_shownState >= 0 && diagnosticOf(m_shownState) == nullptr && m_model->lacksLinks(m_shownState);
  if (asks) {
    text = tr("State %1 has no ratio yet: click “choose…” in its row and name its input and output links.")
               .arg(m_model->index(m_shownState, 0).data().toString());
  } else if (diagnostic != nullptr) {
    text = shownText(diagnostic->message);
    role = diagnostic->severity() == Severity::error     ? ColorRole::error
           : diagnostic->severity() == Severity::warning ? ColorRole::warning
                                                         : ColorRole::secondary;
  } else if (m_model->rowCount() > 0) {
    text = tr(
        "Click a state to engage it, a letter to engage or release one coupling, a dot to change a state.");
    if (m_model->torques() != nullptr) text += QLatin1Char(' ') + torqueRemark();
  } else if (m_model->couplingCount() > 0) {
    text = tr("Click a letter to engage or release; add a state, then click its dots.");
  }
  m_remark->setText(text);
  m_remark->setVisible(!text.isEmpty());
  setInk(*m_remark, role);
}

std::vector<LinkId> GearboxPanel::selectedLinks() const {
  std::vector<LinkId> links;
  for (const ElementId& element : m_selection->selected()) {
    if (element.kind == ElementKind::link) links.emplace_back(element.id);
  }
  return links;
}

/// The moving links by label, with their names.
void GearboxPanel::chooseLink(QMenu& menu, const std::function<void(LinkId)>& chosen,
                              std::optional<LinkId> without) {
  const Mechanism& mechanism = *m_document->mechanism();
  for (std::size_t i = 1; i < listedLinks(mechanism); ++i) {
    const Link& link = mechanism.links[i];
    if (link.id == without) continue;
    const QString name = shownText(link.name);
    const QString text = name.isEmpty() ? tr("Link %1").arg(i) : tr("Link %1, %2").arg(i).arg(name);
    QAction* action = menu.addAction(text, this, [chosen, id = link.id] { chosen(id); });
    connect(action, &QAction::hovered, this, [this, id = link.id] { m_selection->hover(ElementId(id)); });
  }
  sayUnlisted(menu, mechanism);
}

void GearboxPanel::addBrake() {
  const auto add = [this](LinkId link) {
    apply(tr("Add brake"), [link](const Mechanism& before) { return withBrake(before, link); });
  };
  const std::vector<LinkId> links = selectedLinks();
  if (links.size() == 1) return add(links[0]);
  QMenu menu(this);
  chooseLink(menu, add);
  menu.exec(m_brake->mapToGlobal(QPoint(0, m_brake->height())));
  m_selection->unhover();
}

void GearboxPanel::addClutch() {
  const auto add = [this](LinkId one, LinkId other) {
    apply(tr("Add clutch"), [one, other](const Mechanism& before) { return withClutch(before, one, other); });
  };
  const std::vector<LinkId> links = selectedLinks();
  if (links.size() == 2) return add(links[0], links[1]);
  QMenu menu(this);
  const Mechanism& mechanism = *m_document->mechanism();
  for (std::size_t i = 1; i < listedLinks(mechanism); ++i) {
    const LinkId one = mechanism.links[i].id;
    QMenu* others = menu.addMenu(tr("Link %1 with").arg(i));
    connect(others, &QMenu::aboutToShow, this, [this, others, one, add] {
      if (others->isEmpty())
        chooseLink(
            *others, [one, add](LinkId other) { add(one, other); }, one);
    });
  }
  sayUnlisted(menu, mechanism);
  menu.exec(m_clutch->mapToGlobal(QPoint(0, m_clutch->height())));
  m_selection->unhover();
}

void GearboxPanel::addState() {
  apply(tr("Add state"), [](const Mechanism& before) { return withState(before); });
}

void GearboxPanel::engage(int state) {
  m_shownState = state;
  paintRemark();
  apply(tr("Engage state %1").arg(m_model->index(state, 0).data().toString()),
        [state](const Mechanism& before) { return withStateEngaged(before, state); });
}

void GearboxPanel::toggleCoupling(int coupling) {
  const ShiftElementId id = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].id;
  const bool engaged = !m_model->isEngagedNow(coupling);
  apply((engaged ? tr("Engage %1") : tr("Release %1")).arg(shownText(id.text())),
        [id, engaged](const Mechanism& before) { return withCouplingEngaged(before, id, engaged); });
}

void GearboxPanel::releaseAll() {
  m_document->apply(releaseAllEdit());
}

/// What is engaged follows where it is the state that changes.
void GearboxPanel::toggleDot(int state, int coupling, bool engaged) {
  m_shownState = state;
  const ShiftElementId id = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].id;
  apply((engaged ? tr("Put %1 into the state") : tr("Take %1 out of the state")).arg(shownText(id.text())),
        [=](const Mechanism& before) {
          Expected<Mechanism> changed = withEngaged(before, state, id, engaged);
          const bool isNow = engagedState(before) == state;
          return changed && isNow ? withStateEngaged(*std::move(changed), state) : changed;
        });
}

void GearboxPanel::onClick(const QModelIndex& index) {
  const int row = index.row();
  const int coupling = m_model->couplingAt(index.column());
  if (coupling >= 0) {
    toggleDot(row, coupling, !index.data(StatesModel::EngagedRole).toBool());
    return;
  }
  const QPoint at = m_table->viewport()->mapToGlobal(m_table->visualRect(index).bottomLeft());
  if (index.column() > 0 && m_model->lacksLinks(row)) {
    askLinks(row, at, m_document->newGesture());
  } else if (m_model->isTail(index.column(), StatesModel::Tail::links)) {
    chooseLinks(row, at);
  } else {
    engage(row);
  }
}

/// Asks for the input link, then for the output link, of this state and of all others without one: one step.
void GearboxPanel::askLinks(int state, const QPoint& at, quint64 gesture) {
  const ShiftState& asked = m_document->mechanism()->states[static_cast<std::size_t>(state)];
  const bool forInput = !asked.drive;
  if (!forInput && asked.driven) return;
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("askLinks"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addSection(
      (forInput ? tr("Which link is the input of state %1?") : tr("Which link is the output of state %1?"))
          .arg(shownText(asked.name)));
  const auto take = [=, this](LinkId link) {
    const auto edit = [=](const Mechanism& before) {
      Expected<Mechanism> after = before;
      for (int each = 0; after && each < static_cast<int>(before.states.size()); ++each) {
        const ShiftState& now = before.states[static_cast<std::size_t>(each)];
        if (forInput ? !now.drive : !now.driven)
          after =
              forInput ? withDrive(*std::move(after), each, link) : withDriven(*std::move(after), each, link);
      }
      return after;
    };
    if (m_document->apply({tr("Choose input and output"), edit, gesture})) askLinks(state, at, gesture);
  };
  chooseLink(*menu, take, forInput ? asked.driven : asked.drive);
  connect(menu, &QMenu::aboutToHide, this, [this] { m_selection->unhover(); });
  menu->popup(at);
}

void GearboxPanel::chooseLinks(int state, const QPoint& at) {
  QMenu menu(this);
  struct End {
    QString title;
    Expected<Mechanism> (*edit)(Mechanism, int, LinkId);
  };
  const auto fill = [&](const QString& title, int of, const End& end) {
    chooseLink(*menu.addMenu(title), [this, of, end](LinkId link) {
      apply(end.title, [of, end, link](const Mechanism& before) { return end.edit(before, of, link); });
    });
  };
  const End drive{tr("Choose drive"), &withDrive};
  const End driven{tr("Choose driven"), &withDriven};
  fill(tr("Drive"), state, drive);
  fill(tr("Driven"), state, driven);
  menu.addSeparator();
  fill(tr("Drive of all states"), -1, drive);
  fill(tr("Driven of all states"), -1, driven);
  menu.exec(at);
  m_selection->unhover();
}

void GearboxPanel::rowMenu(const QPoint& at) {
  const QModelIndex index = m_table->indexAt(at);
  if (!index.isValid()) return;
  const int row = index.row();
  QMenu menu(this);
  menu.addAction(tr("Engage"), this, [this, row] { engage(row); });
  menu.addAction(tr("Rename"), this, [this, row] { m_table->edit(m_model->index(row, 0)); });
  menu.addAction(tr("Choose input and output…"), this, [this, row, place = QCursor::pos()] {
    if (m_model->lacksLinks(row)) return askLinks(row, place, m_document->newGesture());
    chooseLinks(row, place);
  });
  menu.addSeparator();
  menu.addAction(tr("Delete"), this, [this, row] {
    apply(tr("Delete state"), [row](const Mechanism& before) { return withoutState(before, row); });
  });
  addTableActions(menu);
  menu.exec(m_table->viewport()->mapToGlobal(at));
}

void GearboxPanel::addTableActions(QMenu& menu) {
  menu.addSeparator();
  menu.addAction(tr("Copy table"), this, &GearboxPanel::copy)->setEnabled(m_model->torques() != nullptr);
  menu.addAction(tr("Export table as CSV…"), this, &GearboxPanel::wantExport)
      ->setEnabled(m_model->torques() != nullptr);
}

void GearboxPanel::copy() {
  if (m_model->torques() == nullptr) return;
  TextSink sink;
  CsvOptions options;
  options.separator = '\t';
  writeForceCsv(sink, shiftSheet(*m_document->mechanism(), *m_model->torques()), options);
  QGuiApplication::clipboard()->setText(QString::fromStdString(sink.text()));
}

void GearboxPanel::wantExport() {
  if (m_model->torques() == nullptr) return;
  TextSink sink;
  writeForceCsv(sink, shiftSheet(*m_document->mechanism(), *m_model->torques()));
  emit exportWanted(shownText(forceTableCommandName(ForceTableKind::states)) + QStringLiteral(".csv"),
                    QString::fromStdString(sink.text()));
}

void GearboxPanel::headMenu(const QPoint& at) {
  const int section = m_table->heads().logicalIndexAt(at);
  const int coupling = m_model->couplingAt(section);
  if (coupling < 0) return;
  QMenu menu(this);
  menu.addAction(m_model->isEngagedNow(coupling) ? tr("Release") : tr("Engage"), this,
                 [this, coupling] { toggleCoupling(coupling); });
  menu.addAction(tr("Rename"), this, [this, section] { m_table->heads().rename(section); });
  menu.addSeparator();
  menu.addAction(tr("Delete"), this,
                 [this, id = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].id] {
                   apply(tr("Delete coupling"), [id](const Mechanism& before) -> Expected<Mechanism> {
                     const std::vector<ElementId> gone{id};
                     Expected<Mechanism> released = withCouplingEngaged(before, id, false);
                     return released ? withoutElements(*std::move(released), gone) : released;
                   });
                 });
  menu.exec(m_table->heads().mapToGlobal(at));
}

void GearboxPanel::showLookedAt(int state) {
  m_table->setLookedAt(state);
}

void GearboxPanel::hoverCell(const QModelIndex& index) {
  const int coupling = m_model->couplingAt(index.column());
  if (coupling >= 0) return hoverCoupling(coupling);
  const ShiftState& state = m_document->mechanism()->states[static_cast<std::size_t>(index.row())];
  std::set<ElementId> elements;
  for (const auto& end : {state.drive, state.driven}) {
    if (end) elements.insert(*end);
  }
  m_selection->hover(std::move(elements));
}

void GearboxPanel::hoverCoupling(int coupling) {
  const auto& links = m_document->mechanism()->couplings[static_cast<std::size_t>(coupling)].links;
  m_selection->hover(std::set<ElementId>(links.begin(), links.end()));
}

}  // namespace geargraph

#include "moc_gearbox_panel.cpp"
