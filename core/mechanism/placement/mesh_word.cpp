#include "core/mechanism/placement/mesh_word.h"

#include <algorithm>
#include <string>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

std::string wordText(const Mechanism& mechanism, const AxisGroups& classes,
                     const std::vector<AxisGroupOrdinal>& word) {
  std::string text;
  for (const AxisGroupOrdinal letter : word) {
    text += (text.empty() ? "" : "|") + mechanism.axes[classes.classes[letter].axis].id.text();
  }
  return text;
}

/// The class that two links share, -1 where there is none. @pre the links differ
AxisGroupOrdinal sharedClass(const AxisGroups& classes, LinkOrdinal a, LinkOrdinal b) {
  const AxisGroupOrdinal ofA = classes.classOfLink(a);
  const AxisGroupOrdinal ofB = classes.classOfLink(b);
  if (ofA == ofB || (ofA >= 0 && classes.classes[ofA].rootLink == b)) return ofA;
  return ofB >= 0 && classes.classes[ofB].rootLink == a ? ofB : AxisGroupOrdinal(-1);
}

/// The two classes of a proper word share one link only, the carrier, which is the root link of one of them:
/// of the tail's or of the head's.
std::optional<MeshAxisPath> properWord(const AxisGroups& classes, LinkOrdinal tail, LinkOrdinal head) {
  const AxisGroupOrdinal ofTail = classes.classOfLink(tail);
  const AxisGroupOrdinal ofHead = classes.classOfLink(head);
  const auto rootOf = [&](AxisGroupOrdinal axisGroup) {
    return axisGroup < 0 ? LinkOrdinal(-1) : classes.classes[axisGroup].rootLink;
  };
  const auto canCarry = [&](LinkOrdinal link) { return link >= 0 && link != tail && link != head; };
  if (const LinkOrdinal carrier = rootOf(ofTail); canCarry(carrier)) {
    const AxisGroupOrdinal shared = sharedClass(classes, head, carrier);
    if (shared >= 0 && shared != ofTail) return MeshAxisPath{ofTail, shared, carrier};
  }
  if (const LinkOrdinal carrier = rootOf(ofHead); canCarry(carrier)) {
    const AxisGroupOrdinal shared = sharedClass(classes, tail, carrier);
    if (shared >= 0 && shared != ofHead) return MeshAxisPath{shared, ofHead, carrier};
  }
  return std::nullopt;
}

}  // namespace

void AxisGroupPath::climb(const AxisGroups& classes, LinkOrdinal& link, std::vector<AxisGroupOrdinal>& word,
                          std::vector<LinkOrdinal>& links) {
  const AxisGroupOrdinal at = classes.classOfLink(link);
  word.push_back(at);
  link = classes.classes[at].rootLink;
  links.push_back(link);
}

void AxisGroupPath::walk(const AxisGroups& classes, LinkOrdinal tail, LinkOrdinal head) {
  const auto depthOf = [&](LinkOrdinal link) {
    const AxisGroupOrdinal at = classes.classOfLink(link);
    return at < 0 ? -1 : classes.classes[at].depth;
  };
  m_classes.clear();
  m_changes.clear();
  m_headClasses.clear();
  m_headChanges.clear();
  LinkOrdinal a = tail;
  LinkOrdinal b = head;
  while (a != b) {
    if (classes.classOfLink(a) == classes.classOfLink(b)) {  // they meet along one axis
      m_classes.push_back(classes.classOfLink(a));
      m_changes.push_back(b);
      break;
    }
    const int depthA = depthOf(a);
    const int depthB = depthOf(b);
    if (depthA >= depthB) climb(classes, a, m_classes, m_changes);
    if (depthB >= depthA) climb(classes, b, m_headClasses, m_headChanges);
  }
  // So far m_changes[i] is the link behind class i; the head's climb has the link before each of its classes.
  m_classes.insert(m_classes.end(), m_headClasses.rbegin(), m_headClasses.rend());
  if (m_headChanges.size() > 1)
    m_changes.insert(m_changes.end(), m_headChanges.rbegin() + 1, m_headChanges.rend());
}

std::optional<MeshAxisPath> meshWord(const Mechanism& mechanism, const AxisGroups& classes,
                                     const JointTree& tree, MeshOrdinal mesh, AxisGroupPath& path,
                                     Diagnostics& diagnostics) {
  const auto [tail, head] = tree.meshes[mesh];
  if (const auto proper = properWord(classes, tail, head)) return proper;
  path.walk(classes, tail, head);
  Diagnostic diagnostic;
  const GearMesh& element = mechanism.gearMeshes[mesh];
  diagnostic.elements = {element.id, element.tail, element.head};
  const std::string label = std::to_string(mechanism.meshLabel(mesh));
  const std::string pair = std::to_string(tail) + ", " + std::to_string(head);
  const std::string word = wordText(mechanism, classes, path.classes());
  if (path.classes().size() < 2) {
    diagnostic.code = Code::coaxialMesh;
    diagnostic.message = translated(
        "Mesh %1 (%2) joins two gears on the same axis %3: coaxial gears cannot mesh. Move one of them "
        "to another axis, or delete the mesh.",
        {label, pair, word});
  } else {
    diagnostic.code = Code::noTransferVertex;
    diagnostic.message = translated(
        "Mesh %1 (%2) has no carrier: the path between its gears changes axis more than once, %3. One "
        "link must carry both axes, so that their distance is constant.",
        {label, pair, word});
  }
  diagnostics.push_back(std::move(diagnostic));
  return std::nullopt;
}

}  // namespace geargraph
