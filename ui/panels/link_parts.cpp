#include "ui/panels/link_parts.h"

#include <QCoreApplication>
#include <QStringList>
#include <QUrl>
#include <algorithm>

#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

struct PartTexts {
  Q_DECLARE_TR_FUNCTIONS(LinkParts)
};

/// Texts of elements, of which no more than are read are made.
class PartList {
 public:
  explicit PartList(const ElementIndex& index) : m_index(index) {}

  template <class Text>
  void add(Text text) {
    if (++m_count <= LinkParts::kMaxListed) m_texts += text();
  }
  [[nodiscard]] QString linkTo(const ElementId& element, const QString& prefix = {}) const {
    const QString label = shownText(m_index.labelOf(element).value_or(element.id.text()));
    return QStringLiteral("<a href=\"%1\">%2%3</a>")
        .arg(addressOf(element).toHtmlEscaped(), prefix, label.toHtmlEscaped());
  }
  [[nodiscard]] QString text() const {
    QStringList texts = m_texts;
    if (m_count > LinkParts::kMaxListed)
      texts += PartTexts::tr("and %1 more").arg(m_count - LinkParts::kMaxListed);
    return texts.join(QStringLiteral("<br>"));
  }

 private:
  const ElementIndex& m_index;
  QStringList m_texts;
  int m_count = 0;
};

}  // namespace

LinkParts partsOf(const Mechanism& mechanism, const ElementIndex& index, const LinkId& link) {
  PartList joints(index), gears(index), couplings(index);
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.tail != link && joint.head != link) continue;
    joints.add([&] {
      return PartTexts::tr("%1 with %2, axis %3")
          .arg(joints.linkTo(joint.id),
               joints.linkTo(joint.tail == link ? joint.head : joint.tail, PartTexts::tr("link ")),
               shownText(joint.axis.text()).toHtmlEscaped());
    });
  }
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    if (mesh.tail != link && mesh.head != link) continue;
    const bool isTail = mesh.tail == link;
    gears.add([&] {
      return PartTexts::tr("%1 teeth in mesh %2 with %3")
          .arg(isTail ? mesh.tailTeeth : mesh.headTeeth)
          .arg(gears.linkTo(mesh.id), gears.linkTo(isTail ? mesh.head : mesh.tail, PartTexts::tr("link ")));
    });
  }
  for (const ShiftElement& coupling : mechanism.couplings) {
    if (std::find(coupling.links.begin(), coupling.links.end(), link) == coupling.links.end()) continue;
    couplings.add([&] {
      const bool isBrake = coupling.kind == ShiftElementKind::brake;
      QString text =
          couplings.linkTo(coupling.id, isBrake ? PartTexts::tr("brake ") : PartTexts::tr("clutch "));
      for (const LinkId& other : coupling.links) {
        if (other != link)
          text = PartTexts::tr("%1 with %2").arg(text, couplings.linkTo(other, PartTexts::tr("link ")));
      }
      return text;
    });
  }
  return {joints.text(), gears.text(), couplings.text()};
}

QString jointsOn(const Mechanism& mechanism, const ElementIndex& index, const AxisId& axis) {
  PartList joints(index);
  for (const TurningJoint& joint : mechanism.turningJoints) {
    if (joint.axis != axis) continue;
    joints.add([&] {
      return QStringLiteral("%1: %2 → %3")
          .arg(joints.linkTo(joint.id), joints.linkTo(joint.tail), joints.linkTo(joint.head));
    });
  }
  return joints.text();
}

QString linksOf(const ShiftElement& coupling, const ElementIndex& index) {
  PartList links(index);
  for (const LinkId& link : coupling.links) links.add([&] { return links.linkTo(link); });
  return links.text();
}

QString addressOf(const ElementId& element) {
  return QStringLiteral("%1:%2")
      .arg(static_cast<int>(element.kind))
      .arg(QString::fromLatin1(QUrl::toPercentEncoding(shownText(element.id.text()))));
}

ElementId elementAt(const QString& address) {
  const QString id = QUrl::fromPercentEncoding(address.section(QLatin1Char(':'), 1).toLatin1());
  return {static_cast<ElementKind>(address.section(QLatin1Char(':'), 0, 0).toInt()),
          InternedString(id.toStdString())};
}

}  // namespace geargraph
