#include "core/mechanism/model/mass_edits.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/checked_edit.h"
#include "core/mechanism/model/rejections.h"

namespace geargraph {

Expected<Mechanism> withLinkMass(Mechanism mechanism, LinkId link, std::optional<LinkMass> mass) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [link](const Link& each) { return each.id == link; });
  if (found == mechanism.links.end()) return unknownElement(link);
  found->mass = mass ? SharedOptional<LinkMass>(std::move(*mass)) : SharedOptional<LinkMass>();
  const auto position = found - mechanism.links.begin();
  return checkedEdit(std::move(mechanism), "/links/" + std::to_string(position) + "/", &massDiagnostics);
}

Expected<Mechanism> withDensity(Mechanism mechanism, std::optional<Number> density) {
  mechanism.density = std::move(density);
  return checkedEdit(std::move(mechanism), "/density", &massDiagnostics);
}

Expected<Mechanism> withGravity(Mechanism mechanism, std::optional<NumberTriple> gravity) {
  mechanism.gravity = std::move(gravity);
  return checkedEdit(std::move(mechanism), "/gravity", &massDiagnostics);
}

Diagnostics massDiagnostics(const Mechanism& mechanism) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const Link& link = mechanism.links[i];
    if (!link.mass) continue;
    if (auto problem = massProblem(*link.mass)) {
      diagnostics.push_back({Code::schema,
                             std::move(problem->message),
                             {link.id},
                             "/links/" + std::to_string(i) + "/" + problem->member,
                             0,
                             0});
    }
  }
  if (mechanism.density && mechanism.density->exact().sign() <= 0)
    diagnostics.push_back(
        {Code::schema, translated("A density is above 0, in kg/m³."), {}, "/density", 0, 0});
  return diagnostics;
}

}  // namespace geargraph
