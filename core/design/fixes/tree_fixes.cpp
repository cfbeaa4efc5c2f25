#include <algorithm>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

/// One link of every part that hangs loose: the first of each in the document's order. Tying it ties the
/// part.
std::vector<LinkId> looseParts(const Mechanism& mechanism) {
  const PositionIndex<LinkTag> links(mechanism.links);
  DisjointSets tied(mechanism.links.size());
  for (const TurningJoint& joint : mechanism.turningJoints)
    tied.join(links.positionOf(joint.tail), links.positionOf(joint.head));
  std::vector<LinkId> parts;
  // A part is named by its first link; that of the ground hangs on it.
  for (std::size_t link = 1; link < mechanism.links.size(); ++link)
    if (tied.root(link) == link) parts.push_back(mechanism.links[link].id);
  return parts;
}

Expected<Mechanism> withLinksTied(Mechanism mechanism, const std::vector<LinkId>& links) {
  const LinkId ground = mechanism.links.front().id;
  for (const LinkId link : links) {
    Expected<Mechanism> tied = withTurningJoint(std::move(mechanism), ground, link);
    if (!tied) return tied.error();
    mechanism = std::move(tied).value();
  }
  return mechanism;
}

std::vector<Fix> connectionFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  constexpr std::size_t kMaxNamed = 4;
  const Mechanism& mechanism = *snapshot.mechanism;
  const std::vector<LinkId> parts = looseParts(mechanism);
  if (parts.empty()) return {};
  std::string names;
  for (std::size_t i = 0; i < parts.size() && i < kMaxNamed; ++i) {
    names += (i == 0 ? "" : ", ") + labelOf(mechanism, parts[i]).value_or("");
  }
  if (parts.size() > kMaxNamed) names += ", ...";
  const bool one = parts.size() == 1;
  std::vector<Fix> fixes;
  fixes.push_back({one ? translated("Tie link %1 to the ground", {names})
                       : translated("Tie links %1 to the ground", {names}),
                   [parts](const Mechanism& before) { return withLinksTied(before, parts); }});
  const std::vector<ElementId> loose = diagnostic.elements;
  fixes.push_back({loose.size() == 1 ? translated("Delete %1", {wordFor(mechanism, loose.front())})
                                     : translated("Delete the loose links"),
                   [loose](const Mechanism& before) { return withoutElements(before, loose); }});
  return fixes;
}

/// The joint that was drawn last first; then those that share an axis with another one of the loop: two
/// bearings of one shaft.
std::vector<Fix> loopFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const auto axisOf = [&](const ElementId& joint) { return mechanism.find(JointId(joint.id))->axis; };
  std::vector<Fix> fixes;
  std::vector<Fix> others;
  for (std::size_t i = 0; i < diagnostic.elements.size(); ++i) {
    const ElementId& joint = diagnostic.elements[i];
    const auto sharers =
        std::count_if(diagnostic.elements.begin(), diagnostic.elements.end(),
                      [&](const ElementId& other) { return axisOf(other) == axisOf(joint); });
    const bool second = sharers > 1;
    Fix fix = removalOf(
        snapshot, joint,
        second ? translated(", a second bearing on axis %1", {axisOf(joint).text()}) : std::string());
    (i == 0 || second ? fixes : others).push_back(std::move(fix));
  }
  std::move(others.begin(), others.end(), std::back_inserter(fixes));
  return fixes;
}

/// The coupling that closes a linkage or ties links on different axes: no turning joint is to blame.
std::vector<Fix> linkageFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  std::vector<Fix> fixes;
  for (const ElementId& element : diagnostic.elements) {
    if (element.kind == ElementKind::coupling) fixes.push_back(removalOf(snapshot, element));
  }
  return fixes;
}

}  // namespace

std::vector<Fix> treeFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  if (diagnostic.code == Code::disconnected) return connectionFixes(diagnostic, snapshot);
  if (diagnostic.detail == Detail::couplingLinkage || diagnostic.detail == Detail::clutchAxes)
    return linkageFixes(diagnostic, snapshot);
  return loopFixes(diagnostic, snapshot);
}

}  // namespace geargraph
