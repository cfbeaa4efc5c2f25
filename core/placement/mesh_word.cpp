#include "core/placement/mesh_word.h"

#include <algorithm>
#include <string>

namespace geargraph {
namespace {

std::string wordText(const Mechanism& mechanism, const AxisClasses& classes, const std::vector<int>& word) {
  std::string text;
  for (const int letter : word) {
    text += (text.empty() ? "" : "|") + mechanism.axes[classes.classes[letter].axis].id.text();
  }
  return text;
}

std::string name(const Mechanism& mechanism, int mesh) {
  return "Mesh " + std::to_string(mechanism.meshLabel(mesh));
}

}  // namespace

ClassPath::ClassPath(const AxisClasses& of, const JointTree& tree, int tail, int head) {
  const auto depthOf = [&](int link) {
    const int at = of.classOfLink(tree, link);
    return at < 0 ? -1 : of.classes[at].depth;
  };
  std::vector<int> headClasses;  // climbed from the head, to be reversed
  std::vector<int> headChanges;
  const auto climb = [&](int& link, std::vector<int>& word, std::vector<int>& links) {
    const int at = of.classOfLink(tree, link);
    word.push_back(at);
    link = of.classes[at].top;
    links.push_back(link);
  };
  int a = tail;
  int b = head;
  while (a != b) {
    if (of.classOfLink(tree, a) == of.classOfLink(tree, b)) {  // they meet along one axis
      classes.push_back(of.classOfLink(tree, a));
      changes.push_back(b);
      break;
    }
    const int depthA = depthOf(a);
    const int depthB = depthOf(b);
    if (depthA >= depthB) climb(a, classes, changes);
    if (depthB >= depthA) climb(b, headClasses, headChanges);
  }
  // changes[i] is the link behind classes[i] so far; the head's climb gives the link before each class.
  for (std::size_t i = headClasses.size(); i-- > 0;) classes.push_back(headClasses[i]);
  if (headChanges.size() > 1) changes.insert(changes.end(), headChanges.rbegin() + 1, headChanges.rend());
  changes.resize(classes.empty() ? 0 : classes.size() - 1);
}

std::optional<MeshWord> meshWord(const Mechanism& mechanism, const AxisClasses& classes,
                                 const JointTree& tree, int mesh, Diagnostics& diagnostics) {
  const auto [tail, head] = tree.meshes[mesh];
  const ClassPath path(classes, tree, tail, head);
  if (path.classes.size() == 2) return MeshWord{path.classes[0], path.classes[1], path.changes[0]};
  Diagnostic finding;
  const GearMesh& element = mechanism.gearMeshes[mesh];
  finding.elements = {element.id, element.tail, element.head};
  const std::string pair =
      name(mechanism, mesh) + " (" + std::to_string(tail) + ", " + std::to_string(head) + ")";
  const std::string word = wordText(mechanism, classes, path.classes);
  if (path.classes.size() < 2) {
    finding.code = Code::coaxialMesh;
    finding.message = pair + " joins two gears on the same axis " + word +
                      ": coaxial gears cannot mesh. Move one of them to another axis, or delete the mesh.";
  } else {
    finding.code = Code::noTransferVertex;
    finding.message = pair + " has no carrier: the path between its gears changes axis more than once, " +
                      word + ". One link has to carry both axes, so that their distance is constant.";
  }
  diagnostics.push_back(std::move(finding));
  return std::nullopt;
}

}  // namespace geargraph
