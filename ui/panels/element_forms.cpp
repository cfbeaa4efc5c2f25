#include "ui/panels/element_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/geometry_edits/written_numbers.h"
#include "core/mechanism/model/batch_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/mesh_word.h"
#include "core/mechanism/placement/tolerance.h"
#include "ui/document/typed_length.h"
#include "ui/models/term_tips.h"
#include "ui/panels/link_parts.h"
#include "ui/panels/note_form.h"
#include "ui/panels/number_field.h"
#include "ui/panels/parts_forms.h"
#include "ui/panels/teeth_slider.h"

namespace geargraph {
namespace {

/// Which axes a kind of mesh needs.
QString axesTip(MeshKind kind) {
  if (slides(kind)) {
    return pairKind(kind).hasTeeth
               ? QCoreApplication::translate("MeshForm",
                                             "One of its links turns, the other one slides across that axis.")
               : QCoreApplication::translate("MeshForm",
                                             "One of its links turns, the other one slides along that axis.");
  }
  if (pairKind(kind).hasFace) {
    return QCoreApplication::translate(
        "MeshForm", "Axes that meet at right angles. The gear with fewer teeth is the pinion.");
  }
  if (pairKind(kind).isOffset) {
    return QCoreApplication::translate(
        "MeshForm", "Axes that cross at right angles without meeting, or at any angle with a pitch point.");
  }
  if (hasSkewAxes(kind)) {
    return pairKind(kind).isThreaded
               ? QCoreApplication::translate("MeshForm",
                                             "Axes that cross at right angles without meeting. The gear with "
                                             "fewer teeth is the worm: they are its starts.")
               : QCoreApplication::translate("MeshForm", "Axes that cross without meeting.");
  }
  if (hasIntersectingAxes(kind)) return QCoreApplication::translate("MeshForm", "Axes that meet.");
  return QCoreApplication::translate("MeshForm", "Parallel axes.");
}

/// The value that all elements share, or nothing.
template <class Element, class Get>
auto shared(const std::vector<const Element*>& elements, Get get)
    -> std::optional<std::decay_t<decltype(get(*elements.front()))>> {
  const auto first = get(*elements.front());
  for (const Element* element : elements) {
    if (!(get(*element) == first)) return std::nullopt;
  }
  return first;
}

/// Shows a text that is not being typed just now.
void showText(QLineEdit* field, const QString& text) {
  if (field->text() != text) field->setText(text);
}

std::optional<Number> wholeNumber(const std::optional<int>& value) {
  if (!value) return std::nullopt;
  return Number(*value);
}

ElementId itself(const ElementIndex&, const ElementId& element) {
  return element;
}
ElementId axisOf(const ElementIndex& index, const ElementId& joint) {
  return index.find(JointId(joint.id))->axis;
}
ElementId tailOf(const ElementIndex& index, const ElementId& mesh) {
  return index.find(MeshId(mesh.id))->tail;
}
ElementId headOf(const ElementIndex& index, const ElementId& mesh) {
  return index.find(MeshId(mesh.id))->head;
}

QString limitTip(bool slides, bool isLow) {
  if (slides) {
    return isLow ? PropertyForm::tr(
                       "The joint slides back no farther than this from the reference pose: 0 or "
                       "less. Empty: no limit.")
                 : PropertyForm::tr(
                       "The joint slides on no farther than this from the reference pose: 0 or "
                       "more. Empty: no limit.");
  }
  return isLow ? PropertyForm::tr(
                     "The joint turns back no farther than this from the reference pose, in "
                     "degrees: 0 or less. Empty: no limit.")
               : PropertyForm::tr(
                     "The joint turns on no farther than this from the reference pose, in "
                     "degrees: 0 or more. Empty: no limit.");
}

/// Why a pair of this kind does not fit between lines of which these slide; empty: it fits.
QString slideObjection(MeshKind kind, bool tailSlides, bool headSlides, bool areAlong) {
  const bool isThread = !pairKind(kind).hasTeeth;
  if (!slides(kind)) {
    return tailSlides || headSlides
               ? PropertyForm::tr("One of its links slides: a rack or a screw fits, or turning joints.")
               : QString();
  }
  if (tailSlides && headSlides)
    return PropertyForm::tr("Both of its links slide, and one of them has to turn.");
  if (!tailSlides && !headSlides) {
    return PropertyForm::tr(
        "Both of its links turn, and one of them has to slide. The form of a joint makes it a sliding one.");
  }
  if (isThread == areAlong) return {};
  return isThread ? PropertyForm::tr("It does not slide along the axis of the link that turns: a rack fits.")
                  : PropertyForm::tr("It slides along the axis of the link that turns: a screw fits.");
}

const NumberTriple kOrigin{Number(0), Number(0), Number(0)};
const NumberTriple kUpwards{Number(0), Number(0), Number(1)};

QString pinTeethTip() {
  return PropertyForm::tr("All gears on this link keep their teeth while other things change.");
}

}  // namespace

DocumentForm::DocumentForm(Document* document)
    : PropertyForm(document, {}), m_owner(document), m_name(new QLineEdit(this)) {
  setTitle(tr("Document"));
  m_name->setObjectName(QStringLiteral("documentName"));
  m_name->setMaxLength(kMaxTyped);
  m_nameGesture = document->newGesture();
  addRow(tr("Name"), Term::label, m_name);
  addNote(tr("Select a link, a joint or a mesh to see and change what belongs to it."));
  connect(m_name, &QLineEdit::textEdited, this, &DocumentForm::setDocumentName);
}

void DocumentForm::setDocumentName(const QString& name) {
  m_owner->apply({tr("Rename document"),
                  [text = name.toStdString()](const Mechanism& before) -> Expected<Mechanism> {
                    Mechanism next = before;
                    next.name = text;
                    return next;
                  },
                  m_nameGesture});
}

void DocumentForm::refresh() {
  showText(m_name, shownText(mechanism().name));
}

LinkForm::LinkForm(Document* document, std::vector<ElementId> links)
    : PropertyForm(document, std::move(links)),
      m_pin(makePin(tr("Pin the teeth of its gears"), pinTeethTip(), itself)) {
  m_pin->setObjectName(QStringLiteral("pinTeeth"));
  if (elements().size() > 1) {
    addButtons({m_pin});
    addNote(tr("Delete removes them with their joints and meshes."));
    return;
  }
  m_name = new QLineEdit(this);
  m_name->setObjectName(QStringLiteral("linkName"));
  m_name->setMaxLength(kMaxTyped);
  m_name->setAccessibleName(tr("Name of the link"));
  addRow(tr("Name"), Term::link, m_name);
  newGesture();
  connect(m_name, &QLineEdit::textEdited, this, [this](const QString& name) {
    apply(tr("Rename link"), [text = name.toStdString()](Mechanism before, const ElementId& link) {
      return withName(std::move(before), link, text);
    });
  });
  connect(m_name, &QLineEdit::editingFinished, this, &LinkForm::newGesture);
  m_joints = addParts(tr("Joints"), Term::turningJoint);
  m_gears = addParts(tr("Gears"), Term::teeth);
  m_couplings = addParts(tr("Couplings"), Term::link);
  m_couplings->setToolTip(tr("Brakes and clutches of this link"));
  m_ground = new QPushButton(tr("Make ground"), this);
  m_ground->setObjectName(QStringLiteral("makeGround"));
  connect(m_ground, &QPushButton::clicked, this, [this] {
    newGesture();
    apply(tr("Make ground"), [](Mechanism before, const ElementId& link) {
      return withGround(std::move(before), LinkId(link.id));
    });
  });
  addButtons({m_ground});
  addButtons({m_pin});
}

void LinkForm::refresh() {
  showPin(*m_pin, itself);
  if (elements().size() > 1) return setTitle(tr("%1 links").arg(elements().size()));
  const ElementId link = elements().front();
  const bool isGround = mechanism().links.front().id == LinkId(link.id);
  setTitle(isGround ? tr("Link 0, the ground") : tr("Link %1").arg(label(link)));
  showText(m_name, shownText(mechanism().find(LinkId(link.id))->name));
  const LinkParts parts = partsOf(mechanism(), index(), LinkId(link.id));
  showParts(*m_joints, parts.joints);
  showParts(*m_gears, parts.gears);
  showParts(*m_couplings, parts.couplings);
  m_ground->setEnabled(!isGround);
  m_ground->setToolTip(isGround
                           ? tr("This link is the ground already.")
                           : tr("Makes this link the ground: it becomes 0, and the other labels follow."));
}

JointForm::JointForm(Document* document, std::vector<ElementId> joints)
    : PropertyForm(document, std::move(joints)),
      m_jointKind(new QComboBox(this)),
      m_axis(new QComboBox(this)),
      m_point(new TripleField(QStringLiteral("axisPoint"))),
      m_direction(new TripleField(QStringLiteral("axisDirection"))),
      m_offset(makeNumber(QStringLiteral("offset"))),
      m_low(makeNumber(QStringLiteral("lowLimit"))),
      m_high(makeNumber(QStringLiteral("highLimit"))),
      m_pin(makePin(tr("Pin the axis"), tr("The axis keeps its place while other things change."), axisOf)) {
  m_pin->setObjectName(QStringLiteral("pinAxis"));
  m_axis->setObjectName(QStringLiteral("axis"));
  // Else the width of every axis' name is measured whenever a joint is selected.
  m_axis->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_axis->setMinimumContentsLength(8);
  m_offset->setEmptyText(tr("several"));
  addKind();
  addRow(tr("Axis"), Term::axis, m_axis);
  addRow(tr("Point"), Term::axisPoint, m_point);
  addRow(tr("Direction"), Term::axisDirection, m_direction);
  addRow(tr("Offset"), Term::offset, m_offset);
  addLimits();
  auto* flip = new QPushButton(tr("Flip"), this);
  flip->setToolTip(tr("Exchange tail and head: the arrow turns round, and the speed changes its sign."));
  addButtons({flip, makeLayButton(), m_pin});

  connect(flip, &QPushButton::clicked, this, [this] {
    newGesture();
    applyAtOnce(tr("Flip joint"),
                [arrows = elements()](const Mechanism& before) { return withAllFlipped(before, arrows); });
  });
  connect(m_axis, &QComboBox::activated, this, &JointForm::chooseAxis);
  connect(m_offset, &NumberField::edited, this, [this](const std::optional<Number>& offset) {
    if (!offset) return;
    apply(tr("Move bearing"), [number = *offset](Mechanism before, const ElementId& joint) {
      return withOffset(std::move(before), JointId(joint.id), number);
    });
  });
  for (TripleField* field : {m_point, m_direction}) {
    connect(field, &TripleField::editingStarted, this, &JointForm::newGesture);
    connect(field, &TripleField::wrongChanged, this, &JointForm::showWrong);
    connect(field, &TripleField::edited, this,
            [this, ofPoint = field == m_point](int index, const std::optional<Number>& number) {
              placeAxes(index, number, ofPoint);
            });
  }
}

void JointForm::placeAxes(int index, const std::optional<Number>& number, bool ofPoint) {
  applyFitted(ofPoint ? tr("Move axis") : tr("Turn axis"),
              [index, number, ofPoint](const PlacedMechanism& before,
                                       const ElementId& joint) -> Expected<PlacedMechanism> {
                const AxisId id = before.mechanism().find(JointId(joint.id))->axis;
                const Axis axis = *before.mechanism().find(id);
                if (!ofPoint) {
                  const auto direction = withComponent(axis.direction, index, number, kUpwards);
                  if (direction == axis.direction) return before;  // by another joint about this axis
                  return unplaced(withAxisPlaced(before, id, axis.point, direction));
                }
                const auto point = withComponent(axis.point, index, number, kOrigin);
                if (point == axis.point) return before;
                if (point && axis.point) return withAxisMoved(before, id, *point);
                return unplaced(withAxisPlaced(before, id, point, axis.direction));
              });
}

std::vector<const TurningJoint*> JointForm::joints() const {
  std::vector<const TurningJoint*> found;
  for (const ElementId& element : elements()) found.push_back(index().find(JointId(element.id)));
  return found;
}

void JointForm::fillAxes() {
  QStringList ids;
  for (const Axis& axis : mechanism().axes) ids << shownText(axis.id.text());
  ids << tr("new axis");
  QStringList shown;
  for (int i = 0; i < m_axis->count(); ++i) shown << m_axis->itemText(i);
  if (shown == ids) return;
  m_axis->clear();
  m_axis->addItems(ids);
}

void JointForm::refresh() {
  const auto all = joints();
  const ElementId first = elements().front();
  const auto kind = shared(all, [](const TurningJoint& joint) { return joint.kind; });
  const bool allSlide = kind == JointKind::sliding;
  const QString one = allSlide ? tr("Sliding joint %1: %2 → %3") : tr("Turning joint %1: %2 → %3");
  const QString several = !kind      ? tr("%1 joints")
                          : allSlide ? tr("%1 sliding joints")
                                     : tr("%1 turning joints");
  setTitle(all.size() > 1 ? several.arg(all.size())
                          : one.arg(label(first), label(all.front()->tail), label(all.front()->head)));
  m_jointKind->setCurrentIndex(!kind ? -1 : (allSlide ? 1 : 0));
  refreshAxes(all);
  const QString unit = QString::fromStdString(mechanism().unit);
  setRowShown(m_limits, kind.has_value(), allSlide ? tr("Limits, %1").arg(unit) : tr("Limits, deg"));
  for (NumberField* field : {m_low, m_high})
    field->setLengthUnit(allSlide ? std::optional(mechanism().unit) : std::nullopt);
  m_offset->setLengthUnit(mechanism().unit);
  m_offset->setNumber(shared(all, [](const TurningJoint& joint) { return joint.offset; }));
  showLimit(*m_low, shared(all, [](const TurningJoint& joint) { return joint.limits.low; }));
  showLimit(*m_high, shared(all, [](const TurningJoint& joint) { return joint.limits.high; }));
  const bool isLow = true;
  for (const auto& [field, ofLow] : {std::pair(m_low, isLow), std::pair(m_high, !isLow)}) {
    if (!field->property("wrong").toBool()) field->setToolTip(limitTip(allSlide, ofLow));
  }
}

void JointForm::refreshAxes(const std::vector<const TurningJoint*>& all) {
  const QSignalBlocker quiet(m_axis);
  fillAxes();
  const auto axis = shared(all, [](const TurningJoint& joint) { return joint.axis; });
  m_axis->setPlaceholderText(tr("several"));
  m_axis->setCurrentIndex(axis ? m_axis->findText(shownText(axis->text())) : -1);
  m_point->setLengthUnit(mechanism().unit);
  TripleField::Triples points;
  TripleField::Triples directions;
  for (const TurningJoint* joint : all) {
    const Axis& placed = *index().find(joint->axis);
    points.push_back(placed.point);
    directions.push_back(placed.direction);
  }
  m_point->setTriples(points);
  m_direction->setTriples(directions);
  showPin(*m_pin, axisOf);
  const QString why = m_pin->isChecked() ? tr("The axis is pinned.") : QString();
  for (TripleField* field : {m_point, m_direction}) {
    field->setEnabled(why.isEmpty());
    field->setToolTip(why);
  }
}

MeshForm::MeshForm(Document* document, std::vector<ElementId> meshes)
    : PropertyForm(document, std::move(meshes)),
      m_tailTeeth(makeNumber(QStringLiteral("tailTeeth"))),
      m_headTeeth(makeNumber(QStringLiteral("headTeeth"))),
      m_tailSlider(new TeethSlider(this)),
      m_headSlider(new TeethSlider(this)),
      m_kind(new QComboBox(this)),
      m_module(makeNumber(QStringLiteral("module"))),
      m_helixRow(new QWidget(this)),
      m_helix(makeNumber(QStringLiteral("helixAngle"))),
      m_hand(new QComboBox(this)),
      m_herringbone(new QCheckBox(tr("herringbone"), this)),
      m_crossed(new QCheckBox(tr("The strands cross"), this)),
      m_pitchPoint(new TripleField(QStringLiteral("pitchPoint"))),
      m_ratio(new QLabel(this)),
      m_pinTail(makePin(tr("tail"), pinTeethTip(), tailOf)),
      m_pinHead(makePin(tr("head"), pinTeethTip(), headOf)),
      m_pinModule(makePin(tr("module"), tr("The mesh keeps its module while other things change."), itself)),
      m_tooMany(new QLabel(this)) {
  m_pinTail->setObjectName(QStringLiteral("pinTail"));
  m_pinHead->setObjectName(QStringLiteral("pinHead"));
  m_pinModule->setObjectName(QStringLiteral("pinModule"));
  m_tooMany->setProperty("look", "hint");
  m_tooMany->setWordWrap(true);
  m_tooMany->setText(tr("This train has more than %1 meshes: axes and other wheels do not follow a change of "
                        "teeth by themselves.")
                         .arg(kMaxFittedMeshes));
  m_kind->setObjectName(QStringLiteral("meshKind"));
  m_kind->addItem(tr("from the geometry"));
  for (const MeshKind kind : meshKinds()) {
    m_kind->addItem(QString::fromStdString(kindWord(kind)));
    m_kind->setItemData(m_kind->count() - 1, axesTip(kind), Qt::ToolTipRole);
  }
  const bool one = elements().size() == 1;
  const GearMesh& first = *this->meshes().front();
  addTeethRow(one ? tr("Teeth of gear %1").arg(label(first.tail)) : tr("Teeth, tail"), m_tailTeeth,
              m_tailSlider);
  addTeethRow(one ? tr("Teeth of gear %1").arg(label(first.head)) : tr("Teeth, head"), m_headTeeth,
              m_headSlider);
  addRow(tr("Ratio"), Term::gearRatio, m_ratio);
  addRow(tr("Module"), Term::module, m_module);
  addRow(tr("Kind"), Term::meshKind, m_kind);
  addHelixRow();
  addRow(tr("Pitch point"), Term::pitchPoint, m_pitchPoint);
  if (one) {
    m_pinTail->setText(tr("gear %1").arg(label(first.tail)));
    m_pinHead->setText(tr("gear %1").arg(label(first.head)));
  }
  addButtons({m_pinTail, m_pinHead, m_pinModule}, tr("Pinned"));
  auto* flip = new QPushButton(tr("Flip"), this);
  flip->setToolTip(tr("Exchange tail and head with their teeth: the arrow turns round."));
  addButtons({flip});
  addWide(m_tooMany);

  connectTeeth();
  connectHelix();
  m_module->setEmptyText(tr("several"));
  m_module->setStep(Rational(1, 4));
  connect(m_module, &NumberField::edited, this, [this](const std::optional<Number>& number) {
    if (!number) return;
    applyFitted(tr("Change module"),
                [module = number->exact()](const PlacedMechanism& before, const ElementId& mesh) {
                  return withModule(before, MeshId(mesh.id), module);
                });
  });
  connect(m_kind, &QComboBox::activated, this, [this](int index) {
    newGesture();
    applyFitted(tr("Change kind"),
                [index](const PlacedMechanism& before, const ElementId& id) -> Expected<PlacedMechanism> {
                  const MeshId mesh(id.id);
                  if (index <= 0) return unplaced(withMeshKind(before, mesh, std::nullopt));
                  return withKindFitted(before, mesh, meshKinds()[static_cast<std::size_t>(index) - 1]);
                });
  });
  connect(m_pitchPoint, &TripleField::editingStarted, this, &MeshForm::newGesture);
  connect(m_pitchPoint, &TripleField::wrongChanged, this, &MeshForm::showWrong);
  connect(m_pitchPoint, &TripleField::edited, this, [this](int index, const std::optional<Number>& number) {
    apply(tr("Move pitch point"), [index, number](Mechanism before, const ElementId& id) {
      const std::optional<NumberTriple> now = before.find(MeshId(id.id))->pitchPoint;
      return withPitchPoint(std::move(before), MeshId(id.id), withComponent(now, index, number, kOrigin));
    });
  });
  connect(flip, &QPushButton::clicked, this, [this] {
    newGesture();
    applyAtOnce(tr("Flip mesh"),
                [arrows = elements()](const Mechanism& before) { return withAllFlipped(before, arrows); });
  });
}

std::vector<const GearMesh*> MeshForm::meshes() const {
  std::vector<const GearMesh*> found;
  for (const ElementId& element : elements()) found.push_back(index().find(MeshId(element.id)));
  return found;
}

void MeshForm::refresh() {
  m_tooMany->setVisible(mechanism().c() > kMaxFittedMeshes);
  showPin(*m_pinTail, tailOf);
  showPin(*m_pinHead, headOf);
  const auto all = meshes();
  const GearMesh& first = *all.front();
  setTitle(
      all.size() > 1
          ? tr("%1 gear meshes").arg(all.size())
          : tr("Gear mesh %1: %2 → %3").arg(label(elements().front()), label(first.tail), label(first.head)));
  const auto tail = shared(all, [](const GearMesh& mesh) { return mesh.tailTeeth; });
  const auto head = shared(all, [](const GearMesh& mesh) { return mesh.headTeeth; });
  m_tailTeeth->setNumber(wholeNumber(tail));
  m_headTeeth->setNumber(wholeNumber(head));
  m_tailSlider->showTeeth(tail);
  m_headSlider->showTeeth(head);
  const auto ratio =
      shared(all, [](const GearMesh& mesh) { return Rational(mesh.tailTeeth, mesh.headTeeth); });
  m_ratio->setText(ratio ? shownText(ratio->toString()) : tr("several"));
  const auto kind = shared(all, [](const GearMesh& mesh) { return mesh.kind; });
  const QSignalBlocker quiet(m_kind);
  m_kind->setPlaceholderText(tr("several"));
  m_kind->setCurrentIndex(!kind ? -1 : (*kind ? static_cast<int>(**kind) + 1 : 0));
  refreshKinds();
  refreshGeometry(all);
  refreshHelix(all);
}

void MeshForm::refreshKinds() {
  auto* const items = qobject_cast<QStandardItemModel*>(m_kind->model());
  const auto all = meshes();
  QStringList objections(m_kind->count());
  const bool isSmall = mechanism().c() <= kMaxFittedMeshes;
  if (all.size() == 1 && isSmall && placed().placement().tree && placed().placement().classes) {
    const Placement& placement = placed().placement();
    const auto mesh = static_cast<std::size_t>(all.front() - mechanism().gearMeshes.data());
    const DigraphEdge& ends = placement.tree->meshes[mesh];
    AxisGroupPath path;
    path.walk(*placement.classes, ends.tail, ends.head);
    if (path.classes().size() >= 2) {
      const AxisGroupOrdinal tail = path.classes().front();
      const AxisGroupOrdinal head = path.classes().back();
      const auto isSlide = [&](AxisGroupOrdinal of) {
        return placement.classes->classes[static_cast<std::size_t>(of)].kind == JointKind::sliding;
      };
      const bool areAlong =
          areParallel(placement.lineOfClass(tail).direction, placement.lineOfClass(head).direction);
      for (int i = 1; i < m_kind->count(); ++i) {
        const MeshKind kind = meshKinds()[static_cast<std::size_t>(i) - 1];
        objections[i] = slideObjection(kind, isSlide(tail), isSlide(head), areAlong);
      }
    }
  }
  for (int i = 1; i < m_kind->count(); ++i) {
    QStandardItem* const item = items->item(i);
    if (item->isEnabled() != objections[i].isEmpty()) item->setEnabled(objections[i].isEmpty());
    const QString tip =
        objections[i].isEmpty() ? axesTip(meshKinds()[static_cast<std::size_t>(i) - 1]) : objections[i];
    if (item->toolTip() != tip) item->setToolTip(tip);
  }
}

void MeshForm::refreshGeometry(const std::vector<const GearMesh*>& meshes) {
  m_module->setLengthUnit(mechanism().unit);
  std::vector<std::optional<Rational>> modules(meshes.size());
  if (mechanism().c() <= kMaxFittedMeshes) {
    const Placement& placement = placed().placement();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const auto position = static_cast<int>(meshes[i] - mechanism().gearMeshes.data());
      if (const auto module = moduleOf(mechanism(), placement, position)) modules[i] = plainDecimal(*module);
    }
  }
  const bool same =
      std::all_of(modules.begin(), modules.end(), [&](const auto& each) { return each == modules[0]; });
  m_module->setNumber(same && modules[0] ? std::optional(Number(*modules[0])) : std::nullopt);
  showPin(*m_pinModule, itself);
  const bool isPlaced =
      std::all_of(modules.begin(), modules.end(), [](const auto& each) { return each.has_value(); });
  const QString pinned = m_pinModule->isChecked() ? tr("The module is pinned.") : QString();
  const QString why = m_tooMany->isVisibleTo(this) ? m_tooMany->text()
                      : isPlaced                   ? pinned
                                                   : tr("The gears have no places yet: see Problems.");
  m_module->setEnabled(why.isEmpty());
  m_module->setToolTip(why);
  m_pitchPoint->setEnabled(pinned.isEmpty());
  m_pitchPoint->setToolTip(pinned);
  m_pitchPoint->setLengthUnit(mechanism().unit);
  TripleField::Triples points;
  for (const GearMesh* mesh : meshes) points.push_back(mesh->pitchPoint);
  m_pitchPoint->setTriples(points);
}

MixedForm::MixedForm(Document* document, std::vector<ElementId> elements, bool areOfOneKind)
    : PropertyForm(document, std::move(elements)) {
  setTitle(tr("%1 elements").arg(this->elements().size()));
  addNote(areOfOneKind
              ? tr("They have no properties that could be changed together.")
              : tr("They are of several kinds. Select elements of one kind to change them together."));
}

PropertyForm* makePropertyForm(Document* document, const std::set<ElementId>& selected) {
  std::vector<ElementId> elements;
  for (const ElementId& element : selected) {
    if (document->elements().contains(element)) elements.push_back(element);
  }
  if (elements.empty()) return new DocumentForm(document);
  const ElementKind kind = elements.front().kind;
  const bool oneKind = std::all_of(elements.begin(), elements.end(),
                                   [kind](const ElementId& element) { return element.kind == kind; });
  if (oneKind && kind == ElementKind::link) return new LinkForm(document, std::move(elements));
  if (oneKind && kind == ElementKind::turningJoint) return new JointForm(document, std::move(elements));
  if (oneKind && kind == ElementKind::gearMesh) return new MeshForm(document, std::move(elements));
  if (elements.size() == 1 && kind == ElementKind::axis) return new AxisForm(document, elements.front());
  if (elements.size() == 1 && kind == ElementKind::coupling)
    return new CouplingForm(document, elements.front());
  if (oneKind && kind == ElementKind::note) return new NoteForm(document, std::move(elements));
  return new MixedForm(document, std::move(elements), oneKind);
}

}  // namespace geargraph

#include "moc_element_forms.cpp"
