#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/mass_edits.h"
#include "tests/soak/edit_kind.h"
#include "ui/canvas/element_commands.h"

namespace geargraph::soak {
namespace {

using Random = RandomArguments;

decltype(Load::action) loadAction(Random& random) {
  switch (random.below(3)) {
    case 0:
      return JointTorque{random.joint(), random.number()};
    case 1:
      return LinkTorque{random.link(), random.maybe(random.axis()), random.number()};
    default:
      return LinkForce{random.link(), random.triple(), random.triple()};
  }
}

std::optional<std::vector<HoldingTorque>> balances(Random& random) {
  if (random.oneIn(3)) return std::nullopt;
  std::vector<HoldingTorque> found(static_cast<std::size_t>(random.below(3)));
  for (HoldingTorque& balance : found) {
    if (random.oneIn(2)) {
      balance.at = random.joint();
    } else {
      balance.at = HoldingTorque::OnLink{random.link(), random.maybe(random.axis())};
    }
  }
  return found;
}

/// Half of them are masses of a body: small products beside equal moments.
LinkMass mass(Random& random) {
  LinkMass mass{random.number(), random.maybe(random.triple()), {}};
  if (random.oneIn(2)) return mass;
  mass.inertia = InertiaNumbers{1, 1, 1, 0, 0, random.oneIn(2) ? Number(0) : random.number()};
  return mass;
}

/// An edit of one of the loads; none where there are none.
template <class EditAt>
Reduce ofALoad(Random& random, EditAt edit) {
  const auto count = static_cast<int>(random.mechanism().loads.size());
  if (count == 0) return {};
  return [edit, load = random.below(count)](const Mechanism& before) { return edit(before, load); };
}

}  // namespace

std::vector<EditKind> forceEdits() {
  return {
      kind<withLoad>(
          "withLoad",
          [](Random& r) {
            return std::tuple{Load{LoadId(r.oneIn(2) ? r.id() : std::string()), loadAction(r), {}}};
          }),
      {"withLoadAction",
       [](Random& r) -> Reduce {
         return ofALoad(r, [action = loadAction(r)](const Mechanism& before, int load) {
           return withLoadAction(before, load, action);
         });
       }},
      {"withoutLoad",
       [](Random& r) -> Reduce {
         return ofALoad(r, [](const Mechanism& before, int load) { return withoutLoad(before, load); });
       }},
      kind<withTorque>(
          "withTorque",
          [](Random& r) {
            return std::tuple{r.oneIn(2) ? ElementId(r.joint()) : ElementId(r.link()), r.number()};
          }),
      kind<withBalances>("withBalances", [](Random& r) { return std::tuple{balances(r)}; }),
      kind<withMeshLosses>("withMeshLosses",
                           [](Random& r) {
                             return std::tuple{r.mesh(), r.maybe(r.number()), r.maybe(r.number())};
                           }),
      kind<withDefaultLosses>("withDefaultLosses",
                              [](Random& r) {
                                return std::tuple{r.maybe(r.number()), r.maybe(r.number())};
                              }),
      kind<withLinkMass>("withLinkMass",
                         [](Random& r) {
                           return std::tuple{r.link(), r.maybe(mass(r))};
                         }),
      kind<withDensity>(
          "withDensity", [](Random& r) { return std::tuple{r.maybe(r.number())}; }, 1),
      kind<withGravity>(
          "withGravity", [](Random& r) { return std::tuple{r.maybe(r.triple())}; }, 1),
  };
}

}  // namespace geargraph::soak
