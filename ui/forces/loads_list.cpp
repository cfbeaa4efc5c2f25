#include "ui/forces/loads_list.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/mechanism/model/load_edits.h"
#include "ui/models/term_tips.h"
#include "ui/panels/number_field.h"
#include "ui/theme/control_button.h"
#include "ui/theme/empty_label.h"
#include "ui/theme/laid_out_at_once.h"

namespace geargraph {
namespace {

/// More rows than these are not listed: each is a handful of widgets.
constexpr std::size_t kMaxRows = 100;
/// Most joints or links of a menu.
constexpr std::size_t kMaxPlaces = 40;

/// The size of a load, or a component of a force.
const Number& sizeOf(const Load& load, std::size_t component) {
  if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) return inJoint->torque;
  if (const auto* onLink = std::get_if<LinkTorque>(&load.action)) return onLink->torque;
  return std::get<LinkForce>(load.action).force[component];
}

bool isForce(const Load& load) {
  return std::holds_alternative<LinkForce>(load.action);
}

}  // namespace

LoadsList::LoadsList(Document* document, Selection* selection, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_list(new QWidget(this)),
      m_grid(new QGridLayout(m_list)),
      m_empty(emptyLabel(this)),
      m_more(new QLabel(this)) {
  m_empty->setText(tr("No load acts yet. Select a joint or a link, then + Load."));
  m_more->setProperty("look", "hint");
  m_grid->setContentsMargins(12, 0, 8, 0);
  m_grid->setHorizontalSpacing(6);
  m_grid->setVerticalSpacing(2);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 4);
  layout->setSpacing(4);
  layout->addWidget(makeHead());
  layout->addWidget(m_list);
  layout->addWidget(m_empty);
  layout->addWidget(m_more);
  layout->addStretch(1);
  connect(document, &Document::changed, this, &LoadsList::renew);
  renew();
}

QWidget* LoadsList::makeHead() {
  auto* head = new QWidget(this);
  auto* layout = new QHBoxLayout(head);
  layout->setContentsMargins(12, 4, 8, 0);
  layout->setSpacing(4);
  m_add = controlButton(QStringLiteral("addLoad"), tr("+ Load"),
                        tr("A torque of 1 N m on the selected joint or link, or choose one"), head);
  connect(m_add, &QToolButton::clicked, this, &LoadsList::addLoad);
  m_balances =
      controlButton(QStringLiteral("balances"), tr("Found at ▾"),
                    tr("Balances: where torques are found that hold the loads. By itself the program "
                       "takes the inputs that bear no load of their own."),
                    head);
  m_balances->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_balances);
  m_balances->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    fillBalances(*menu);
  });
  m_unit = new QComboBox(head);
  m_unit->setObjectName(QStringLiteral("loadUnit"));
  m_unit->addItems({tr("N m"), tr("N mm"), tr("kN m")});
  m_unit->setToolTip(tr("The unit of the torques in this list; the document keeps N m"));
  connect(m_unit, &QComboBox::currentIndexChanged, this, [this] { showNumbers(); });
  layout->addWidget(m_add);
  layout->addWidget(m_balances);
  layout->addStretch(1);
  layout->addWidget(m_unit);
  return head;
}

Rational LoadsList::newtonMetres() const {
  const Rational factors[] = {Rational(1), Rational(1, 1000), Rational(1000)};
  return factors[m_unit->currentIndex()];
}

QString LoadsList::nameOf(const ElementId& element) const {
  const QString label = shownText(m_document->elements().labelOf(element).value_or(element.id.text()));
  return element.kind == ElementKind::link ? tr("link %1").arg(label) : tr("joint %1").arg(label);
}

ElementId LoadsList::elementOf(const Load& load) const {
  if (const auto joint = jointOf(load)) return *joint;
  return *linkOf(load);
}

QString LoadsList::titleOf(const Load& load) const {
  const QString name = nameOf(elementOf(load));
  if (isForce(load)) return tr("F on %1").arg(name);
  const auto* onLink = std::get_if<LinkTorque>(&load.action);
  if (onLink == nullptr) return tr("T in %1").arg(name);
  return onLink->axis ? tr("T on %1 about %2").arg(name, shownText(onLink->axis->text()))
                      : tr("T on %1").arg(name);
}

QString LoadsList::tipOf(const Load& load) const {
  if (const auto* force = std::get_if<LinkForce>(&load.action)) {
    QStringList place;
    for (const Number& number : force->point) place += shownText(number.text());
    return tr("A force from outside on the link, N, in the base frame, at (%1) of the reference pose.")
        .arg(place.join(QStringLiteral(", ")));
  }
  if (jointOf(load))
    return tr(
        "A torque that the joint's tail exerts on its head, about the direction of its axis; the head "
        "exerts the opposite one on the tail.");
  return tr(
      "A torque from outside on the link; the ground takes the reaction. Without an axis it is about the "
      "link's first axis on the way to the ground.");
}

void LoadsList::renew() {
  const Mechanism& mechanism = *m_document->mechanism();
  QStringList titles;
  for (const Load& load : mechanism.loads) {
    if (static_cast<std::size_t>(titles.size()) >= kMaxRows) break;
    titles += titleOf(load);
  }
  if (titles != m_shown) showRows();
  m_shown = titles;
  showNumbers();
  m_add->setEnabled(mechanism.n() > 0);
  m_balances->setEnabled(mechanism.t() > 0);
  m_empty->setVisible(mechanism.loads.empty());
  m_more->setVisible(mechanism.loads.size() > kMaxRows);
  m_more->setText(tr("%1 of %2 loads are listed").arg(m_rows.size()).arg(mechanism.loads.size()));
}

void LoadsList::showRows() {
  for (const Row& row : std::exchange(m_rows, {})) {
    for (QWidget* widget : row.widgets) removeFrom(*m_grid, widget);
  }
  const std::size_t count = std::min(kMaxRows, m_document->mechanism()->loads.size());
  {
    const LaidOutAtOnce added(m_list);
    for (std::size_t load = 0; load < count; ++load)
      m_rows.push_back(makeRow(static_cast<int>(load), static_cast<int>(load)));
  }
  m_list->setVisible(count > 0);
}

LoadsList::Row LoadsList::makeRow(int load, int line) {
  const Load& shown = m_document->mechanism()->loads[static_cast<std::size_t>(load)];
  Row row;
  auto* title = new QLabel(titleOf(shown), this);
  title->setTextFormat(Qt::PlainText);
  title->setToolTip(tipOf(shown));
  row.widgets.push_back(title);
  m_grid->addWidget(title, line, 0);
  for (std::size_t component = 0; component < (isForce(shown) ? 3U : 1U); ++component) {
    NumberField* field = makeField(load, component);
    row.fields.push_back(field);
    row.widgets.push_back(field);
    m_grid->addWidget(field, line, 1 + static_cast<int>(component), 1, isForce(shown) ? 1 : 3);
  }
  QToolButton* gone =
      controlButton(QStringLiteral("removeLoad"), QStringLiteral("×"), tr("Remove this load"), this);
  connect(gone, &QToolButton::clicked, this, [this, load] { remove(load); });
  row.widgets.push_back(gone);
  m_grid->addWidget(gone, line, 4);
  const ElementId element = elementOf(shown);
  for (QWidget* widget : row.widgets) {
    widget->setProperty("isJoint", element.kind == ElementKind::turningJoint);
    widget->setProperty("element", QString::fromStdString(element.id.text()));
    widget->installEventFilter(this);
  }
  return row;
}

NumberField* LoadsList::makeField(int load, std::size_t component) {
  auto* field = new NumberField(this);
  field->setObjectName(QStringLiteral("load.%1.%2").arg(load).arg(component));
  field->setMinimumWidth(64);
  field->setAlignment(Qt::AlignRight);
  connect(field, &NumberField::editingStarted, this, [this] { m_gesture = m_document->newGesture(); });
  connect(field, &NumberField::edited, this, [this, load, component](const std::optional<Number>& size) {
    if (size) setSize(load, component, *size);
  });
  return field;
}

void LoadsList::showNumbers() {
  const std::vector<Load>& loads = m_document->mechanism()->loads;
  for (std::size_t row = 0; row < m_rows.size() && row < loads.size(); ++row) {
    for (std::size_t component = 0; component < m_rows[row].fields.size(); ++component) {
      const Number& size = sizeOf(loads[row], component);
      const bool asWritten = isForce(loads[row]) || m_unit->currentIndex() == 0;
      if (isForce(loads[row])) {
        m_rows[row].fields[component]->setQuantity(Quantity::force);
      } else {
        m_rows[row].fields[component]->setQuantity(Quantity::torque, newtonMetres());
      }
      m_rows[row].fields[component]->setNumber(asWritten ? size : Number(size.exact() / newtonMetres()));
    }
  }
}

void LoadsList::setSize(int load, std::size_t component, const Number& size) {
  const std::vector<Load>& loads = m_document->mechanism()->loads;
  if (static_cast<std::size_t>(load) >= loads.size()) return;
  auto action = loads[static_cast<std::size_t>(load)].action;
  if (auto* force = std::get_if<LinkForce>(&action)) {
    force->force[component] = size;
  } else {
    const Number torque = m_unit->currentIndex() == 0 ? size : Number(size.exact() * newtonMetres());
    if (auto* inJoint = std::get_if<JointTorque>(&action)) inJoint->torque = torque;
    if (auto* onLink = std::get_if<LinkTorque>(&action)) onLink->torque = torque;
  }
  m_document->apply({tr("Set load"),
                     [load, action](const Mechanism& before) { return withLoadAction(before, load, action); },
                     m_gesture});
}

void LoadsList::remove(int load) {
  if (static_cast<std::size_t>(load) >= m_document->mechanism()->loads.size()) return;
  m_document->apply(
      {tr("Remove load"), [load](const Mechanism& before) { return withoutLoad(before, load); }, 0});
}

void LoadsList::addLoad() {
  const std::set<ElementId>& selected = m_selection->selected();
  if (selected.size() == 1) {
    const ElementId& only = *selected.begin();
    const bool isGround =
        only.kind == ElementKind::link && ElementId(m_document->mechanism()->links.front().id) == only;
    if (only.kind == ElementKind::turningJoint || (only.kind == ElementKind::link && !isGround))
      return addOn(only);
  }
  QMenu menu(this);
  fillPlaces(menu);
  menu.exec(m_add->mapToGlobal(QPoint(0, m_add->height())));
  m_selection->unhover();
}

void LoadsList::addOn(const ElementId& element) {
  Load load;
  if (element.kind == ElementKind::turningJoint) {
    load.action = JointTorque{JointId(element.id), Number(1)};
  } else {
    load.action = LinkTorque{LinkId(element.id), {}, Number(1)};
  }
  m_document->apply({tr("Add load"), [load](const Mechanism& before) { return withLoad(before, load); }, 0});
}

void LoadsList::fillPlaces(QMenu& menu) {
  const Mechanism& mechanism = *m_document->mechanism();
  const auto add = [&](QMenu& to, const ElementId& element, const QString& text) {
    QAction* action = to.addAction(text, this, [this, element] { addOn(element); });
    connect(action, &QAction::hovered, this, [this, element] { m_selection->hover(element); });
  };
  QMenu* joints = menu.addMenu(tr("Torque in a joint"));
  for (std::size_t i = 0; i < mechanism.turningJoints.size() && i < kMaxPlaces; ++i) {
    const ElementId joint = mechanism.turningJoints[i].id;
    add(*joints, joint, nameOf(joint));
  }
  QMenu* links = menu.addMenu(tr("Torque on a link"));
  for (std::size_t i = 1; i < mechanism.links.size() && i <= kMaxPlaces; ++i) {
    const ElementId link = mechanism.links[i].id;
    add(*links, link, nameOf(link));
  }
}

void LoadsList::fillBalances(QMenu& menu) {
  const Mechanism& mechanism = *m_document->mechanism();
  QAction* automatic = menu.addAction(tr("Inputs without a load"), this,
                                      [this] { balance(std::nullopt, tr("Choose balances")); });
  automatic->setCheckable(true);
  automatic->setChecked(!mechanism.balances.has_value());
  menu.addSeparator();
  for (std::size_t i = 0; i < mechanism.turningJoints.size() && i < kMaxPlaces; ++i) {
    const JointId joint = mechanism.turningJoints[i].id;
    std::vector<HoldingTorque> now = mechanism.balances.value_or(std::vector<HoldingTorque>());
    const auto at = std::find_if(now.begin(), now.end(), [&](const HoldingTorque& each) {
      return each.at == HoldingTorque{joint}.at;
    });
    const bool isThere = at != now.end();
    if (isThere) {
      now.erase(at);
    } else {
      now.push_back(HoldingTorque{joint});
    }
    QAction* action =
        menu.addAction(nameOf(joint), this, [this, now] { balance(now, tr("Choose balances")); });
    action->setCheckable(true);
    action->setChecked(isThere);
    connect(action, &QAction::hovered, this, [this, joint] { m_selection->hover(ElementId(joint)); });
  }
}

void LoadsList::balance(std::optional<std::vector<HoldingTorque>> balances, const QString& text) {
  m_document->apply(
      {text,
       [balances = std::move(balances)](const Mechanism& before) { return withBalances(before, balances); },
       0});
}

bool LoadsList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) {
    const std::string id = watched->property("element").toString().toStdString();
    m_selection->hover(watched->property("isJoint").toBool() ? ElementId(JointId(id))
                                                             : ElementId(LinkId(id)));
  } else if (event->type() == QEvent::Leave) {
    m_selection->unhover();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace geargraph

#include "moc_loads_list.cpp"
