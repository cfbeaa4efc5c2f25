#include "ui/forces/forces_caption.h"

#include <QStringList>

#include "core/foundations/base/wording.h"
#include "ui/forces/forces_panel.h"
#include "ui/models/term_tips.h"

namespace geargraph::inline forces {
namespace {

constexpr std::size_t kMostNamed = 8;

/// The labels of what is shared in unknown parts.
struct Shared {
  std::vector<std::string> meshes;
  std::vector<std::string> joints;
};

Shared sharedOf(const Mechanism& mechanism, const StaticsReport& report) {
  Shared shared;
  for (std::size_t mesh = 0; mesh < report.forces.meshes.size(); ++mesh) {
    const int position = static_cast<int>(mesh);
    if (!report.forces.meshes[mesh].isDetermined || !report.solution().isDetermined(position))
      shared.meshes.push_back(std::to_string(mechanism.meshLabel(position)));
  }
  for (std::size_t joint = 0; joint < report.forces.bearings.size(); ++joint)
    if (!report.forces.bearings[joint].isDetermined)
      shared.joints.push_back(std::to_string(mechanism.jointLabel(static_cast<int>(joint))));
  return shared;
}

QString namesOf(const std::vector<std::string>& labels) {
  return shownText(listed(labels, kMostNamed));
}

}  // namespace

QString forcesCaption(const ForcesPtr& forces) {
  if (!forces || !forces->report || !forces->report->problem.hasLoads())
    return ForcesPanel::tr("No forces without loads: add one in Forces.");
  const StaticsReport& report = *forces->report;
  if (!report.isSolved || !report.lossless.isBalanced())
    return ForcesPanel::tr("No forces: the loads are not in balance. Forces names what is missing.");
  if (report.forces.bearings.empty())
    return ForcesPanel::tr("Forces need a unit of length whose size is known.");
  const Shared shared = sharedOf(*forces->solved->mechanism, report);
  if (shared.meshes.empty() && shared.joints.empty()) return {};
  if (shared.joints.empty())
    return ForcesPanel::tr(
               "Not drawn, as shared in unknown parts: forces at meshes %1. Choose Share by stiffness in "
               "Forces to find them.")
        .arg(namesOf(shared.meshes));
  if (shared.meshes.empty())
    return ForcesPanel::tr(
               "Not drawn, as shared in unknown parts: reactions in joints %1. Choose Share by stiffness in "
               "Forces to find them.")
        .arg(namesOf(shared.joints));
  return ForcesPanel::tr(
             "Not drawn, as shared in unknown parts: forces at meshes %1, reactions in joints %2. Choose "
             "Share by stiffness in Forces to find them.")
      .arg(namesOf(shared.meshes), namesOf(shared.joints));
}

}  // namespace geargraph::inline forces
