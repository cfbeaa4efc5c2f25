#include "ui/forces/torque_rows.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "core/mechanism/model/load_edits.h"
#include "core/theory/states/state_edits.h"
#include "ui/models/minus_sign.h"
#include "ui/panels/number_field.h"
#include "ui/panels/results_delegate.h"
#include "ui/theme/control_button.h"
#include "ui/theme/laid_out_at_once.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxTorqueRows = 12;  ///< the panel Forces lists all

const Number* torqueOf(const Load& load) {
  if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) return &inJoint->torque;
  if (const auto* onLink = std::get_if<LinkTorque>(&load.action)) return &onLink->torque;
  return nullptr;
}

decltype(Load::action) withTorque(decltype(Load::action) action, const Number& torque) {
  if (auto* inJoint = std::get_if<JointTorque>(&action)) inJoint->torque = torque;
  if (auto* onLink = std::get_if<LinkTorque>(&action)) onLink->torque = torque;
  return action;
}

ElementId elementOf(const HoldingTorque& balance) {
  if (const auto* joint = std::get_if<JointId>(&balance.at)) return *joint;
  return std::get<HoldingTorque::OnLink>(balance.at).link;
}

bool isEngaged(const Mechanism& mechanism, const ElementId& coupling) {
  return std::find(mechanism.engaged.begin(), mechanism.engaged.end(), ShiftElementId(coupling.id)) !=
         mechanism.engaged.end();
}

bool isBalanced(const Mechanism& mechanism, const ElementId& element) {
  return mechanism.balances &&
         std::any_of(mechanism.balances->begin(), mechanism.balances->end(),
                     [&](const HoldingTorque& each) { return elementOf(each) == element; });
}

/// Without the balances there; where none is left the program chooses.
Expected<Mechanism> withoutBalance(const Mechanism& before, const ElementId& element) {
  std::optional<std::vector<HoldingTorque>> balances = before.balances;
  std::erase_if(*balances, [&](const HoldingTorque& each) { return elementOf(each) == element; });
  if (balances->empty()) balances.reset();
  return withBalances(before, std::move(balances));
}

}  // namespace

TorqueRows::TorqueRows(Document* document, Selection* selection, ForcesService* service, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_service(service),
      m_grid(new QGridLayout),
      m_more(new QLabel(this)) {
  setObjectName(QStringLiteral("torqueRows"));
  m_more->setProperty("look", "hint");
  m_grid->setContentsMargins(16, 0, 16, 4);
  m_grid->setHorizontalSpacing(10);
  m_grid->setVerticalSpacing(4);
  m_grid->setColumnStretch(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(m_grid);
  layout->addWidget(m_more, 0, Qt::AlignHCenter);
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  connect(document, &Document::changed, this, &TorqueRows::renew);
  service->onAnswer(this, [this](const ForcesPtr&) { renew(); });
  renew();
}

void TorqueRows::addLoads(std::vector<Content>& rows) const {
  const Mechanism& mechanism = *m_document->mechanism();
  const ElementIndex& index = m_document->elements();
  const auto label = [&](const ElementId& element) {
    return shownText(index.labelOf(element).value_or(element.id.text()));
  };
  for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
    const Load& load = mechanism.loads[i];
    const Number* const torque = torqueOf(load);
    if (torque == nullptr) continue;  // forces are in the panel Forces
    Content& row = rows.emplace_back();
    row.kind = Kind::load;
    row.load = static_cast<int>(i);
    row.torque = *torque;
    if (const auto joint = jointOf(load)) {
      const LinkId head = index.find(*joint)->head;
      row.element = *joint;
      row.link = label(head).toInt();
      row.color = mechanism.view.colorNumber(head, row.link);
      row.name = tr("T in joint %1, link %2").arg(label(*joint), label(head));
      row.tip =
          tr("A load: the torque that the joint's tail exerts on its head, link %1, about the direction "
             "of its axis.")
              .arg(label(head));
    } else {
      const LinkId link = *linkOf(load);
      row.element = link;
      row.link = label(link).toInt();
      row.color = mechanism.view.colorNumber(link, row.link);
      row.name = tr("T on link %1").arg(label(link));
      row.tip = tr("A load: a torque from outside on the link; the ground takes the reaction.");
    }
  }
}

/// What the newest answer found, while it is about this document.
void TorqueRows::addFound(std::vector<Content>& rows) const {
  const ForcesPtr& forces = m_service->answer();
  if (!forces || !forces->report || forces->snapshot->mechanism != m_document->mechanism()) return;
  const StaticsReport& report = *forces->report;
  if (!report.isAnswered()) return;
  const StaticsSolution& solution = report.solution();
  const auto meshes = static_cast<std::size_t>(forces->solved->mechanism->c());
  for (std::size_t part = 0; part < report.held.size(); ++part) {
    if (!report.held[part].isMain) continue;
    const auto unknown = meshes + part;
    rows.push_back(contentOf(report.held[part], solution.values[unknown],
                             solution.isDetermined(static_cast<int>(unknown))));
  }
}

TorqueRows::Content TorqueRows::contentOf(const HeldPart& part, const Real& torque, bool isKnown) const {
  const Forces& forces = *m_service->answer();
  const Mechanism& mechanism = *forces.solved->mechanism;
  const auto linkLabel = [&](const LinkId& id) {
    return shownText(m_document->elements().labelOf(id).value_or(id.text()));
  };
  Content row;
  const QString number = isKnown ? withMinusSign(shownNumber(torque.number())) : QString();
  if (isKnown && torque.isExact()) row.exact = withMinusSign(shownReal(torque));
  if (part.coupling >= 0) {
    const ShiftElement& coupling = mechanism.couplings[static_cast<std::size_t>(part.coupling)];
    const QString name = shownText(coupling.id.text());
    const QString first = linkLabel(coupling.links.front());
    const bool isBrake = coupling.kind == ShiftElementKind::brake;
    row.kind = Kind::held;
    row.element = coupling.id;
    row.isOwn = isEngaged(*m_document->mechanism(), row.element);
    row.link = first.toInt();
    row.color = mechanism.view.colorNumber(coupling.links.front(), row.link);
    row.name =
        isBrake
            ? tr("link %1, held by brake %2").arg(first, name)
            : tr("links %1 and %2, joined by clutch %3").arg(first, linkLabel(coupling.links.back()), name);
    row.value = isKnown ? tr("carries %1 N m").arg(number) : tr("shares its load in unknown parts");
    row.tip = isBrake
                  ? tr("The torque of the brake on link %1, about its first axis on the way to the "
                       "ground. At rest it passes no power.")
                        .arg(first)
                  : tr("The torque of the clutch on link %1; the other link has the reaction.").arg(first);
    return row;
  }
  const TorquePlace& place = forces.report->problem.balances[static_cast<std::size_t>(part.balance)];
  row.value = isKnown ? tr("%1 N m, found").arg(number) : tr("shared in unknown parts");
  if (place.inJoint()) {
    const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(place.joint)];
    row.element = joint.id;
    row.link = linkLabel(joint.head).toInt();
    row.color = mechanism.view.colorNumber(joint.head, row.link);
    row.name = tr("T in joint %1, link %2").arg(mechanism.jointLabel(place.joint)).arg(row.link);
    row.tip =
        tr("Found: the torque that holds the loads here, of the joint's tail on its head, link %1, about "
           "the direction of its axis.")
            .arg(row.link);
  } else {
    row.element = mechanism.links[static_cast<std::size_t>(place.link)].id;
    row.link = mechanism.linkLabel(place.link);
    row.color = mechanism.colorNumber(place.link);
    row.name = tr("T on link %1").arg(row.link);
    row.tip = tr("Found: the torque from outside on the link that holds the loads.");
  }
  row.isOwn = isBalanced(*m_document->mechanism(), row.element);
  return row;
}

std::vector<TorqueRows::Content> TorqueRows::contents() const {
  std::vector<Content> rows;
  if (m_document->mechanism()->loads.empty()) return rows;
  addLoads(rows);
  addFound(rows);
  return rows;
}

void TorqueRows::renew() {
  std::vector<Content> wanted = contents();
  const std::size_t all = wanted.size();
  if (wanted.size() > kMaxTorqueRows) wanted.resize(kMaxTorqueRows);
  const bool isSame =
      std::equal(m_rows.begin(), m_rows.end(), wanted.begin(), wanted.end(),
                 [](const Row& row, const Content& content) { return row.content.hasSameRow(content); });
  // While the torques are solved anew the former ones stay, not to flicker.
  const ForcesPtr& answer = m_service->answer();
  const bool isWaiting = !wanted.empty() && answer && answer->snapshot->mechanism != m_document->mechanism();
  if (!isSame && isWaiting && wanted.size() < m_rows.size() &&
      std::equal(wanted.begin(), wanted.end(), m_rows.begin(),
                 [](const Content& content, const Row& row) { return row.content.hasSameRow(content); })) {
    for (std::size_t i = 0; i < wanted.size(); ++i) showNumber(m_rows[i], wanted[i]);
    return;
  }
  if (!isSame) clear();
  for (std::size_t i = m_rows.size(); i < wanted.size(); ++i)
    m_rows.push_back(makeRow(wanted[i], static_cast<int>(i)));
  for (std::size_t i = 0; i < wanted.size(); ++i) showNumber(m_rows[i], wanted[i]);
  m_more->setVisible(all > kMaxTorqueRows);
  m_more->setText(tr("%1 of %2 torques are listed; all of them are in Forces").arg(kMaxTorqueRows).arg(all));
  setVisible(!wanted.empty());
}

void TorqueRows::clear() {
  for (const Row& row : std::exchange(m_rows, {})) {
    for (QWidget* widget : row.widgets) removeFrom(*m_grid, widget);
  }
}

TorqueRows::Row TorqueRows::makeRow(const Content& content, int line) {
  Row row;
  row.content = content;
  auto* dot = new QLabel(this);
  dot->setPixmap(linkDot(content.color, devicePixelRatioF()));
  dot->setAccessibleName(tr("Colour of link %1").arg(content.link));
  auto* name = new QToolButton(this);
  name->setText(content.name);
  name->setObjectName(QStringLiteral("torque.") + QString::number(line));
  name->setProperty("look", "flat");
  connect(name, &QToolButton::clicked, this,
          [this, element = content.element] { m_selection->select({element}); });
  row.widgets = {dot, name};
  m_grid->addWidget(dot, line, 0);
  m_grid->addWidget(name, line, 1, Qt::AlignLeft);
  if (content.kind == Kind::load) {
    row.field = makeField(content);
    auto* unit = new QLabel(tr("N m"), this);
    unit->setProperty("look", "hint");
    QToolButton* gone = controlButton(QStringLiteral("removeTorque.%1").arg(line), QStringLiteral("×"),
                                      tr("Remove this load"), this);
    connect(gone, &QToolButton::clicked, this, [this, load = content.load] {
      m_selection->unhover();
      m_document->apply(
          {tr("Remove load"), [load](const Mechanism& before) { return withoutLoad(before, load); }, 0});
    });
    row.widgets.insert(row.widgets.end(), {row.field, unit, gone});
    m_grid->addWidget(row.field, line, 2, Qt::AlignRight);
    m_grid->addWidget(unit, line, 3);
    m_grid->addWidget(gone, line, 4);
  } else {
    row.value = new QLabel(this);
    row.value->setObjectName(QStringLiteral("torqueValue.%1").arg(line));
    row.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row.widgets.push_back(row.value);
    // Below the unit and the cross of a load: the columns stay as narrow as they are.
    m_grid->addWidget(row.value, line, 2, 1, content.isOwn ? 1 : 3, Qt::AlignRight);
    if (content.isOwn) {
      QWidget* letGo = makeLetGo(content, line);
      row.widgets.push_back(letGo);
      m_grid->addWidget(letGo, line, 3, 1, 2, Qt::AlignRight);
    }
  }
  for (QWidget* widget : row.widgets) {
    if (widget->toolTip().isEmpty()) widget->setToolTip(content.tip);
    widget->installEventFilter(this);
  }
  return row;
}

/// Of a coupling: releases it. Of a balance: what holds the loads is not sought there any more.
QWidget* TorqueRows::makeLetGo(const Content& content, int line) {
  const bool isCoupling = content.kind == Kind::held;
  QToolButton* button = controlButton(
      QStringLiteral("letGo.%1").arg(line), tr("Let go"),
      isCoupling ? tr("Release %1; the motion goes on").arg(shownText(content.element.id.text()))
                 : tr("Find no torque here any more; without any such place the inputs hold the loads"),
      this);
  button->setAccessibleDescription(content.name);
  connect(button, &QToolButton::clicked, this, [this, element = content.element, isCoupling] {
    m_selection->unhover();
    if (isCoupling) {
      m_document->apply({tr("Release %1").arg(shownText(element.id.text())),
                         [element](const Mechanism& before) {
                           return withCouplingEngaged(before, ShiftElementId(element.id), false);
                         },
                         0});
      return;
    }
    m_document->apply({tr("Remove balance"),
                       [element](const Mechanism& before) { return withoutBalance(before, element); }, 0});
  });
  return button;
}

QWidget* TorqueRows::makeField(const Content& content) {
  auto* field = new NumberField(this);
  field->setObjectName(QStringLiteral("torqueOfLoad.%1").arg(content.load));
  field->setAccessibleName(content.name);
  field->setFixedWidth(96);
  field->setAlignment(Qt::AlignCenter);
  field->setQuantity(Quantity::torque);
  connect(field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(field, &NumberField::edited, this,
          [this, load = content.load](const std::optional<Number>& torque) {
            if (!torque) return;
            m_document->apply({tr("Set load"),
                               [load, torque](const Mechanism& before) {
                                 const auto& action = before.loads[static_cast<std::size_t>(load)].action;
                                 return withLoadAction(before, load, withTorque(action, *torque));
                               },
                               m_gesture});
          });
  return field;
}

void TorqueRows::showNumber(Row& row, const Content& content) {
  row.content = content;
  if (row.field != nullptr) {
    static_cast<NumberField*>(row.field)->setNumber(content.torque);
    return;
  }
  row.value->setText(content.value);
  row.value->setToolTip(content.exact.isEmpty()
                            ? content.tip
                            : content.tip + QLatin1Char('\n') + tr("Exactly %1").arg(content.exact));
}

bool TorqueRows::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) {
    for (const Row& row : m_rows)
      if (std::find(row.widgets.begin(), row.widgets.end(), watched) != row.widgets.end())
        m_selection->hover(row.content.element);
  } else if (event->type() == QEvent::Leave) {
    m_selection->unhover();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_torque_rows.cpp"
