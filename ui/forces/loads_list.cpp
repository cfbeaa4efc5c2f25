#include "ui/forces/loads_list.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/mechanism/model/load_edits.h"
#include "ui/models/term_tips.h"
#include "ui/panels/number_field.h"
#include "ui/theme/control_button.h"
#include "ui/theme/flow_layout.h"
#include "ui/theme/laid_out_at_once.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

/// More rows than these are not listed: each is a handful of widgets.
constexpr std::size_t kMaxRows = 100;
/// Most joints or links of a menu.
constexpr std::size_t kMaxPlaces = 40;
constexpr int kFieldWidth = 80;

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

LoadsList::LoadsList(Document* document, Selection* selection, QLayout& controls, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_view(new QScrollArea(this)),
      m_list(new QWidget(m_view)),
      m_empty(new QLabel(tr("No load acts yet. Select a joint or a link, then + Load."), m_list)),
      m_more(new QLabel(m_list)) {
  setObjectName(QStringLiteral("loads"));
  for (QLabel* label : {m_empty, m_more}) {
    label->setProperty("look", "hint");
    label->setWordWrap(true);
  }
  auto* flow = new FlowLayout(m_list);
  flow->setContentsMargins(12, 0, 10, 2);
  flow->setSpacing(6);
  flow->addWidget(m_empty);
  flow->addWidget(m_more);
  m_view->setWidget(m_list);
  m_view->setWidgetResizable(true);
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_view->setFocusPolicy(Qt::NoFocus);  // what is in it has
  m_list->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view);
  makeControls(controls, parent);
  connect(document, &Document::changed, this, &LoadsList::renew);
  renew();
}

void LoadsList::makeControls(QLayout& controls, QWidget* parent) {
  m_fold = controlButton(QStringLiteral("foldLoads"), tr("Loads"),
                         tr("Show or hide the loads that act on the train"), parent);
  connect(m_fold, &QToolButton::clicked, this, [this] {
    m_isFoldChosen = true;
    setOpen(!m_isOpen);
  });
  m_add = controlButton(QStringLiteral("addLoad"), tr("+ Load"),
                        tr("A torque of 1 N m on the selected joint or link, or choose one"), parent);
  connect(m_add, &QToolButton::clicked, this, &LoadsList::addLoad);
  m_balances = controlButton(QStringLiteral("balances"), tr("Found at ▾"), {}, parent);
  m_balances->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_balances);
  m_balances->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    fillBalances(*menu);
  });
  m_unit = new QComboBox(parent);
  m_unit->setObjectName(QStringLiteral("loadUnit"));
  m_unit->setAccessibleName(tr("Unit of the loads"));
  m_unit->addItems({tr("N m"), tr("N mm"), tr("kN m")});
  m_unit->setToolTip(tr("The unit of the torques in this list; the document keeps N m"));
  connect(m_unit, &QComboBox::currentIndexChanged, this, [this] { showNumbers(); });
  for (QWidget* control : {static_cast<QWidget*>(m_fold), static_cast<QWidget*>(m_add),
                           static_cast<QWidget*>(m_balances), static_cast<QWidget*>(m_unit)})
    controls.addWidget(control);
}

void LoadsList::setShown(bool isShown) {
  m_isShown = isShown;
  showFold();
}

void LoadsList::setRoom(int height, bool isLittle) {
  m_room = height;
  if (!m_isFoldChosen) setOpen(!isLittle);
  fitHeight();
}

void LoadsList::setOpen(bool isOpen) {
  m_isOpen = isOpen;
  showFold();
}

void LoadsList::showFold() {
  const auto count = m_document->mechanism()->loads.size();
  const QString title = count == 0 ? tr("Loads") : tr("Loads: %1").arg(count);
  m_fold->setText((m_isOpen ? QStringLiteral("▾ ") : QStringLiteral("▸ ")) + title);
  m_fold->setAccessibleName(title);
  m_fold->setVisible(m_isShown);
  for (QWidget* widget : {static_cast<QWidget*>(m_add), static_cast<QWidget*>(m_balances),
                          static_cast<QWidget*>(m_unit), static_cast<QWidget*>(this)})
    widget->setVisible(m_isShown && m_isOpen);
}

/// As high as its lines, but no higher than its room.
void LoadsList::fitHeight() {
  const int lines = m_list->layout()->heightForWidth(m_view->viewport()->width());
  m_view->setFixedHeight(std::min(lines, m_room));
}

/// Larger type needs wider fields.
void LoadsList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  for (const Row& row : m_rows)
    for (NumberField* field : row.fields) field->setFixedWidth(scaledPixels(kFieldWidth));
}

void LoadsList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitHeight();
}

Rational LoadsList::newtonMetres() const {
  const Rational factors[] = {Rational(1), Rational(1, 1000), Rational(1000)};
  return factors[m_unit->currentIndex()];
}

QString LoadsList::nameOf(const ElementId& element) const {
  const ElementIndex& index = m_document->elements();
  const QString label = shownText(index.labelOf(element).value_or(element.id.text()));
  const bool isLink = element.kind == ElementKind::link;
  const Link* link = isLink ? index.find(LinkId(element.id)) : nullptr;
  if (const TurningJoint* joint = isLink ? nullptr : index.find(JointId(element.id)); joint != nullptr)
    link = index.find(joint->head);
  const QString text = (isLink ? tr("link %1") : tr("joint %1")).arg(label);
  const QString name = link == nullptr ? QString() : shownText(link->name);
  return name.isEmpty() || name == label ? text : tr("%1 (%2)").arg(text, name);
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
  showPlaces();
  showFold();
  m_add->setEnabled(mechanism.n() > 0);
  m_balances->setEnabled(mechanism.t() > 0);
  m_empty->setVisible(mechanism.loads.empty());
  m_more->setVisible(mechanism.loads.size() > kMaxRows);
  m_more->setText(tr("%1 of %2 loads are listed").arg(m_rows.size()).arg(mechanism.loads.size()));
  fitHeight();
}

/// Where torques are found that hold the loads, by its name.
void LoadsList::showPlaces() {
  const std::optional<std::vector<HoldingTorque>>& balances = m_document->mechanism()->balances;
  QStringList names;
  if (balances) {
    for (const HoldingTorque& each : *balances) {
      if (const auto* joint = std::get_if<JointId>(&each.at)) names += nameOf(*joint);
      if (const auto* onLink = std::get_if<HoldingTorque::OnLink>(&each.at)) names += nameOf(onLink->link);
    }
  }
  constexpr qsizetype kMaxLetters = 28;
  QString text = tr("Found at ▾");
  if (names.size() == 1 && names.front().size() <= kMaxLetters) text = tr("Found at %1 ▾").arg(names.front());
  if (names.size() > 1) text = tr("Found at %1 places ▾").arg(names.size());
  m_balances->setText(text);
  QString tip =
      tr("Balances: where torques are found that hold the loads. By itself the program "
         "takes the inputs that bear no load of their own.");
  constexpr qsizetype kMaxNames = 20;
  if (!names.empty()) tip += QLatin1Char('\n') + names.mid(0, kMaxNames).join(QStringLiteral(", "));
  m_balances->setToolTip(tip);
}

void LoadsList::showRows() {
  for (const Row& row : std::exchange(m_rows, {})) removeFrom(*m_list->layout(), row.box);
  const std::size_t count = std::min(kMaxRows, m_document->mechanism()->loads.size());
  const LaidOutAtOnce added(m_list);
  for (std::size_t load = 0; load < count; ++load) m_rows.push_back(makeRow(static_cast<int>(load)));
}

LoadsList::Row LoadsList::makeRow(int load) {
  const Load& shown = m_document->mechanism()->loads[static_cast<std::size_t>(load)];
  Row row;
  row.box = new QWidget(m_list);
  auto* line = new QHBoxLayout(row.box);
  line->setContentsMargins(0, 0, 8, 0);
  line->setSpacing(4);
  auto* title = new QLabel(titleOf(shown), row.box);
  title->setTextFormat(Qt::PlainText);
  title->setToolTip(tipOf(shown));
  line->addWidget(title);
  for (std::size_t component = 0; component < (isForce(shown) ? 3U : 1U); ++component) {
    NumberField* field = makeField(load, component);
    field->setAccessibleName(title->text());
    row.fields.push_back(field);
    line->addWidget(field);
  }
  QToolButton* gone =
      controlButton(QStringLiteral("removeLoad"), QStringLiteral("×"), tr("Remove this load"), row.box);
  gone->setAccessibleName(gone->toolTip());
  gone->setAccessibleDescription(title->text());
  connect(gone, &QToolButton::clicked, this, [this, load] { remove(load); });
  line->addWidget(gone);
  const ElementId element = elementOf(shown);
  row.box->setProperty("isJoint", element.kind == ElementKind::turningJoint);
  row.box->setProperty("element", QString::fromStdString(element.id.text()));
  row.box->installEventFilter(this);
  m_list->layout()->addWidget(row.box);
  return row;
}

NumberField* LoadsList::makeField(int load, std::size_t component) {
  auto* field = new NumberField(this);
  field->setObjectName(QStringLiteral("load.%1.%2").arg(load).arg(component));
  field->setFixedWidth(scaledPixels(kFieldWidth));
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
  if (watched == m_list) {
    if (event->type() == QEvent::LayoutRequest) fitHeight();
  } else if (event->type() == QEvent::Enter) {
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
