#include "core/mechanism/placement/mesh_word.h"

#include <algorithm>
#include <string>

#include "core/foundations/base/words.h"

namespace geargraph::inline placement {
namespace {

std::string wordText(const Mechanism& mechanism, const AxisClasses& classes,
                     const std::vector<ClassOrdinal>& word) {
  std::string text;
  for (const ClassOrdinal letter : word) {
    text += (text.empty() ? "" : "|") + mechanism.axes[classes.classes[letter].axis].id.text();
  }
  return text;
}

/// The class that two links share, -1 where there is none. @pre the links differ
ClassOrdinal sharedClass(const AxisClasses& classes, LinkOrdinal a, LinkOrdinal b) {
  const ClassOrdinal ofA = classes.classOfLink(a);
  const ClassOrdinal ofB = classes.classOfLink(b);
  if (ofA == ofB || (ofA >= 0 && classes.classes[ofA].rootLink == b)) return ofA;
  return ofB >= 0 && classes.classes[ofB].rootLink == a ? ofB : ClassOrdinal(-1);
}

/// The two classes of a proper word share one link only, the carrier, which is the root link of one of them:
/// of the tail's or of the head's.
std::optional<MeshWord> properWord(const AxisClasses& classes, LinkOrdinal tail, LinkOrdinal head) {
  const ClassOrdinal ofTail = classes.classOfLink(tail);
  const ClassOrdinal ofHead = classes.classOfLink(head);
  const auto rootOf = [&](ClassOrdinal axisClass) {
    return axisClass < 0 ? LinkOrdinal(-1) : classes.classes[axisClass].rootLink;
  };
  const auto canCarry = [&](LinkOrdinal link) { return link >= 0 && link != tail && link != head; };
  if (const LinkOrdinal carrier = rootOf(ofTail); canCarry(carrier)) {
    const ClassOrdinal shared = sharedClass(classes, head, carrier);
    if (shared >= 0 && shared != ofTail) return MeshWord{ofTail, shared, carrier};
  }
  if (const LinkOrdinal carrier = rootOf(ofHead); canCarry(carrier)) {
    const ClassOrdinal shared = sharedClass(classes, tail, carrier);
    if (shared >= 0 && shared != ofHead) return MeshWord{shared, ofHead, carrier};
  }
  return std::nullopt;
}

}  // namespace

void ClassPath::climb(const AxisClasses& classes, LinkOrdinal& link, std::vector<ClassOrdinal>& word,
                      std::vector<LinkOrdinal>& links) {
  const ClassOrdinal at = classes.classOfLink(link);
  word.push_back(at);
  link = classes.classes[at].rootLink;
  links.push_back(link);
}

void ClassPath::walk(const AxisClasses& classes, LinkOrdinal tail, LinkOrdinal head) {
  const auto depthOf = [&](LinkOrdinal link) {
    const ClassOrdinal at = classes.classOfLink(link);
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

std::optional<MeshWord> meshWord(const Mechanism& mechanism, const AxisClasses& classes,
                                 const JointTree& tree, MeshOrdinal mesh, ClassPath& path,
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

}  // namespace geargraph::inline placement
