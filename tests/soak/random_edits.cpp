#include "tests/soak/random_edits.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <tuple>

#include "core/design/fixes/fixes.h"
#include "core/design/synthesis/bevel_sets.h"
#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/planets.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/design/synthesis/shifting_sets.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/geometry_edits/axis_choice.h"
#include "core/mechanism/geometry_edits/axis_drag.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/geometry_edits/mesh_snap.h"
#include "core/mechanism/geometry_edits/module_fit.h"
#include "core/mechanism/model/batch_edits.h"
#include "core/mechanism/model/drawn_mesh.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/notes.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/shapes.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/schematic/sheet_edits.h"
#include "core/theory/states/state_edits.h"
#include "tests/soak/edit_kind.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/canvas/drawn_joint.h"

namespace geargraph::soak {
namespace {

using Random = RandomArguments;

constexpr int kUsualTeeth = 500;  // the fixes of wheels with more take longer than all other edits together

MeshKind meshKind(Random& random) {
  return static_cast<MeshKind>(random.below(3));
}

std::vector<std::pair<LinkId, CanvasPoint>> places(Random& random) {
  std::vector<std::pair<LinkId, CanvasPoint>> moved(static_cast<std::size_t>(1 + random.below(3)));
  for (auto& [link, place] : moved) {
    link = random.link();
    place = random.place();
  }
  return moved;
}

NoteId note(Random& random) {
  return NoteId("N" + std::to_string(1 + random.below(4)));
}

std::vector<std::pair<NoteId, CanvasPoint>> notePlaces(Random& random) {
  return {{note(random), random.place()}, {note(random), random.place()}};
}

std::vector<Input> inputs(Random& random) {
  std::vector<Input> driven;
  for (const TurningJoint& joint : random.mechanism().turningJoints) {
    if (random.oneIn(3)) driven.push_back({joint.id, random.number(), {}});
  }
  return driven;
}

/// A sheet on which every axis has a line; where they lie is for the edits to cope with.
CanvasFrame sheet(Random& random) {
  CanvasFrame frame;
  frame.scale = 1 + random.below(6);
  for (const Axis& axis : random.mechanism().axes) {
    const bool upright = random.oneIn(3);
    frame.axes.push_back({axis.id, random.place(), upright ? CanvasPoint{0, 1} : CanvasPoint{1, 0}});
  }
  return frame;
}

Mechanism anySet(Random& random) {
  const PlanetaryTeeth teeth{12 + random.below(40), 10 + random.below(30)};
  switch (random.below(3)) {
    case 0:
      return planetarySet(teeth, 1 + random.below(4));
    case 1:
      return revertedTrain({17 + random.below(30), 17 + random.below(30), 17 + random.below(30), 40});
    default:
      return bevelWrist({});
  }
}

Reduce inserted(Random& random, Expected<Mechanism> set) {
  return [set = std::move(set), at = random.place()](const Mechanism& before) -> Expected<Mechanism> {
    if (!set) return set.error();
    return withInserted(before, *set, at);
  };
}

/// A fix that the problems panel would offer: of the analysis or of the teeth.
Reduce quickFix(Random& random) {
  const auto isUsual = [](const GearMesh& mesh) {
    return std::max(mesh.tailTeeth, mesh.headTeeth) <= kUsualTeeth;
  };
  const std::vector<GearMesh>& meshes = random.mechanism().gearMeshes;
  if (!std::all_of(meshes.begin(), meshes.end(), isUsual)) return {};
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(random.mechanism()));
  Diagnostics diagnostics = snapshot->diagnostics;
  if (snapshot->tree) {
    const Mechanism& mechanism = random.mechanism();
    const Diagnostics teeth = trainDiagnostics(mechanism, placementOf(mechanism));
    diagnostics.insert(diagnostics.end(), teeth.begin(), teeth.end());
  }
  if (diagnostics.empty()) return {};
  const std::vector<Fix> fixes = fixesFor(
      diagnostics[static_cast<std::size_t>(random.below(static_cast<int>(diagnostics.size())))], *snapshot);
  if (fixes.empty()) return {};
  return fixes[static_cast<std::size_t>(random.below(static_cast<int>(fixes.size())))].edit;
}

/// What the program has no form for and keeps: taken over when another program has changed the file.
Reduce reloaded(Random& random) {
  Mechanism next = random.mechanism();
  switch (random.below(7)) {
    case 0:
      next.name = random.text();
      break;
    case 1:
      next.notes = random.text();
      break;
    case 2:
      next.unit = random.oneIn(2) ? "mm" : "in";
      break;
    case 3:
      next.gearDefaults = random.maybe(
          GearDefaults{random.maybe(Number(20)), random.maybe(Number(Rational(1, 25))), {}, {}, {}, {}});
      break;
    case 4: {
      const WheelId wheel("w" + std::to_string(random.below(40)));
      const LinkId link = random.link();
      if (next.find(wheel) != nullptr || next.find(link) == nullptr) return {};
      next.wheels.push_back({wheel, link, random.maybe(Number(1)), random.maybe(Number(2)), {}, {}});
      for (GearMesh& mesh : next.gearMeshes) {
        if (mesh.tail == link && random.oneIn(2)) mesh.tailWheel = wheel;
      }
      break;
    }
    case 5:
      next.unknown = {{"foreign", "{\"a\": [" + std::to_string(random.below(100)) + ", true]}"}};
      break;
    default:
      if (next.gearMeshes.empty()) return {};
      next.gearMeshes.back().faceWidth = random.maybe(Number(1 + random.below(30)));
  }
  return [next](const Mechanism&) -> Expected<Mechanism> { return next; };
}

std::vector<LinkShape> shapes(Random& random) {
  static constexpr std::array<const char*, 4> kFiles = {"parts/arm.stl", "base.obj", "",
                                                        "parts/a b \"c\".glb"};
  std::vector<LinkShape> attached(static_cast<std::size_t>(random.below(3)));
  for (LinkShape& shape : attached) {
    shape.file = kFiles[static_cast<std::size_t>(random.below(kFiles.size()))];
    shape.position = random.maybe(random.triple());
    shape.orientation = random.maybe(random.triple());
    shape.scale = random.maybe(random.number());
  }
  return attached;
}

/// A kind of edit of states, where there are any.
template <auto function, class Draw>
EditKind ofState(std::string name, Draw draw) {
  EditKind made = kind<function>(std::move(name), draw, 6);
  made.make = [make = made.make](Random& random) -> Reduce {
    return random.mechanism().states.empty() ? Reduce() : make(random);
  };
  return made;
}

std::vector<EditKind> drawnEdits() {
  return {
      kind<withLink>(
          "withLink",
          [](Random& r) {
            return std::tuple{r.place(), r.text()};
          },
          10),
      kind<withTurningJoint>(
          "withTurningJoint",
          [](Random& r) {
            return std::tuple{r.link(), r.link(), r.oneIn(2) ? r.axis() : AxisId()};
          },
          20),
      kind<withGearMesh>("withGearMesh",
                         [](Random& r) {
                           return std::tuple{r.link(), r.link(), r.teeth(), r.teeth()};
                         }),
      kind<withDrawnJoint>(
          "withDrawnJoint",
          [](Random& r) {
            return std::tuple{r.link(), r.link()};
          },
          10),
      kind<withDrawnMesh>(
          "withDrawnMesh",
          [](Random& r) {
            return std::tuple{r.link(), r.link()};
          },
          10),
      kind<withGearAttached>("withGearAttached",
                             [](Random& r) {
                               return std::tuple{r.link(), r.link(), r.maybe(r.place())};
                             }),
      kind<withoutElements>(
          "withoutElements", [](Random& r) { return std::tuple{r.elements(3)}; }, 8),
      kind<withAllFlipped>("withAllFlipped", [](Random& r) { return std::tuple{r.elements(4)}; }),
      kind<withFlipped>("withFlipped", [](Random& r) { return std::tuple{r.element()}; }),
      kind<withName>("withName",
                     [](Random& r) {
                       const ElementId element = r.element();
                       const bool isId = element.kind != ElementKind::link;
                       return std::tuple{element, isId ? r.id() : r.text()};
                     }),
      kind<withNodesMoved>("withNodesMoved", [](Random& r) { return std::tuple{places(r)}; }),
      kind<withGround>(
          "withGround", [](Random& r) { return std::tuple{r.link()}; }, 1),
      kind<withLinksMerged>(
          "withLinksMerged",
          [](Random& r) {
            return std::tuple{r.link(), r.link()};
          },
          2),
      kind<withLinkSplit>("withLinkSplit",
                          [](Random& r) {
                            return std::tuple{r.link(), r.elements(4), r.maybe(r.place())};
                          }),
      kind<withInputs>("withInputs", [](Random& r) { return std::tuple{r.maybe(inputs(r))}; }),
      kind<withInputToggled>("withInputToggled", [](Random& r) { return std::tuple{r.joint()}; }),
      kind<withInputsToggled>("withInputsToggled",
                              [](Random& r) {
                                return std::tuple{std::set<JointId>{r.joint(), r.joint()}};
                              }),
      kind<withFragment>("withFragment",
                         [](Random& r) {
                           const std::vector<ElementId> chosen = r.elements(4);
                           return std::tuple{fragmentOf(r.mechanism(), {chosen.begin(), chosen.end()})};
                         }),
      kind<withTtNodesMoved>("withTtNodesMoved", [](Random& r) { return std::tuple{places(r)}; }),
      kind<withNote>("withNote",
                     [](Random& r) {
                       return std::tuple{r.place(), r.text()};
                     }),
      kind<withNoteText>("withNoteText",
                         [](Random& r) {
                           return std::tuple{note(r), r.text()};
                         }),
      kind<withNotesMoved>("withNotesMoved", [](Random& r) { return std::tuple{notePlaces(r)}; }),
      {"ttNodes.clear",
       [](Random&) -> Reduce {
         return [](Mechanism before) -> Expected<Mechanism> {
           before.view.ttNodes.clear();
           return before;
         };
       },
       1},
      kind<withJointLimits>(
          "withJointLimits",
          [](Random& r) {
            return std::tuple{r.joint(), JointLimits{r.maybe(r.number()), r.maybe(r.number())}};
          }),
      {"camera",
       [](Random& r) -> Reduce {
         const ViewCamera camera{{r.place().x, r.place().y, 0}, r.place().x, r.place().y / 10, 400};
         return [camera](Mechanism before) -> Expected<Mechanism> {
           before.view.camera = camera;
           return before;
         };
       },
       2},
      kind<withShapes>("withShapes",
                       [](Random& r) {
                         return std::tuple{r.link(), shapes(r)};
                       }),
      {"Reload", reloaded, 4},
  };
}

std::vector<EditKind> numberEdits() {
  return {
      kind<withTeeth>("withTeeth",
                      [](Random& r) {
                        return std::tuple{r.mesh(), r.teeth(), r.teeth()};
                      }),
      kind<withMeshKind>("withMeshKind",
                         [](Random& r) {
                           return std::tuple{r.mesh(), r.maybe(meshKind(r))};
                         }),
      kind<withPitchPoint>("withPitchPoint",
                           [](Random& r) {
                             return std::tuple{r.mesh(), r.maybe(r.triple())};
                           }),
      kind<withAxisPlaced>("withAxisPlaced",
                           [](Random& r) {
                             return std::tuple{r.axis(), r.maybe(r.triple()), r.maybe(r.triple())};
                           }),
      kind<withJointAxis>("withJointAxis",
                          [](Random& r) {
                            return std::tuple{r.joint(), r.axis()};
                          }),
      {"withNewAxis",
       [](Random& r) -> Reduce {
         if (r.mechanism().turningJoints.empty()) return {};
         const std::vector<JointId> joints{r.mechanism().turningJoints.front().id, r.joint()};
         return [joints](const Mechanism& before) { return withNewAxis(before, joints); };
       }},
      kind<withOffset>("withOffset",
                       [](Random& r) {
                         return std::tuple{r.joint(), r.number()};
                       }),
      kind<withTeethFitted>("withTeethFitted",
                            [](Random& r) {
                              return std::tuple{r.mesh(), r.teeth(), r.teeth()};
                            }),
      kind<withKindFitted>("withKindFitted",
                           [](Random& r) {
                             return std::tuple{r.mesh(), meshKind(r)};
                           }),
      kind<withBevelSideFlipped>("withBevelSideFlipped",
                                 [](Random& r) {
                                   return std::tuple{r.mesh(), r.oneIn(2)};
                                 }),
      kind<withPinned>("withPinned",
                       [](Random& r) {
                         return std::tuple{r.element(), r.oneIn(2)};
                       }),
      kind<withAllPinned>("withAllPinned",
                          [](Random& r) {
                            return std::tuple{r.elements(4), r.oneIn(2)};
                          }),
      kind<withPinMark>("withPinMark",
                        [](Random& r) {
                          return std::tuple{r.element(), r.oneIn(2)};
                        }),
      kind<withModule>("withModule",
                       [](Random& r) {
                         return std::tuple{r.mesh(), r.number().exact()};
                       }),
      kind<withMeshSnapped>("withMeshSnapped", [](Random& r) { return std::tuple{r.mesh()}; }),
      kind<withAxisMoved>("withAxisMoved",
                          [](Random& r) {
                            return std::tuple{r.axis(), r.triple()};
                          }),
      kind<withAxisChosen>("withAxisChosen",
                           [](Random& r) {
                             const AxisChoice choice{AxisChoice::Way(r.below(6)), r.axis()};
                             return std::tuple{r.axis(), choice};
                           }),
      {"withAxisReach",
       [](Random& r) -> Reduce {
         const AxisId axis = r.axis();
         if (!axisReach(r.mechanism(), axis)) return {};
         return [axis, factor = Rational(1 + r.below(40), 20)](const Mechanism& before) {
           return mechanismOf(withAxisReach(before, axis, factor));
         };
       }},
      kind<withShaftOnSheet>("withShaftOnSheet",
                             [](Random& r) {
                               return std::tuple{sheet(r), DrawnShaft{r.place(), r.place(), r.link()}};
                             }),
      kind<withMeshOnSheet>(
          "withMeshOnSheet",
          [](Random& r) {
            return std::tuple{sheet(r), DrawnMesh{r.link(), r.link(), r.place(), r.place()}};
          }),
      kind<withAxisOnSheet>("withAxisOnSheet",
                            [](Random& r) {
                              return std::tuple{sheet(r), DraggedAxis{r.axis(), r.place(), r.place()}};
                            }),
      kind<withAxisDragged>("withAxisDragged",
                            [](Random& r) {
                              const Vector3 way{r.place().x, r.place().y, r.place().x};
                              return std::tuple{r.axis(), way, r.oneIn(2)};
                            }),
      {"fixesFor", quickFix, 2},
  };
}

std::vector<ShiftElementId> someCouplings(Random& random) {
  std::vector<ShiftElementId> couplings;
  for (int i = random.below(4); i > 0; --i) couplings.push_back(random.coupling());
  return couplings;
}

std::vector<EditKind> gearboxEdits() {
  return {
      kind<withBrake>("withBrake",
                      [](Random& r) {
                        return std::tuple{r.link(), r.id()};
                      }),
      kind<withClutch>("withClutch",
                       [](Random& r) {
                         return std::tuple{r.link(), r.link(), r.id()};
                       }),
      kind<withCouplingRenamed>("withCouplingRenamed",
                                [](Random& r) {
                                  return std::tuple{r.coupling(), r.id()};
                                }),
      kind<withState>(
          "withState", [](Random&) { return std::tuple{}; }, 2),
      ofState<withoutState>("withoutState", [](Random& r) { return std::tuple{r.state()}; }),
      ofState<withStateRenamed>("withStateRenamed",
                                [](Random& r) {
                                  return std::tuple{r.state(), r.text()};
                                }),
      ofState<withEngaged>("withEngaged",
                           [](Random& r) {
                             return std::tuple{r.state(), r.coupling(), r.oneIn(2)};
                           }),
      kind<withCouplingEngaged>("withCouplingEngaged",
                                [](Random& r) {
                                  return std::tuple{r.coupling(), r.oneIn(2)};
                                }),
      kind<withCouplingsEngaged>("withCouplingsEngaged",
                                 [](Random& r) { return std::tuple{someCouplings(r)}; }),
      kind<withEngagement>("withEngagement", [](Random& r) { return std::tuple{someCouplings(r)}; }),
      ofState<withStateEngaged>("withStateEngaged", [](Random& r) { return std::tuple{r.state()}; }),
      ofState<withDrive>("withDrive",
                         [](Random& r) {
                           return std::tuple{r.state(), r.link()};
                         }),
      ofState<withDriven>("withDriven",
                          [](Random& r) {
                            return std::tuple{r.state() - 1, r.link()};
                          }),
      kind<withPlanets>(
          "withPlanets",
          [](Random& r) {
            return std::tuple{r.link(), 1 + r.below(6)};
          },
          2),
      {"withInserted", [](Random& r) { return inserted(r, anySet(r)); }, 1},
      {"planetarySet",
       [](Random& r) {
         const PlanetaryTeeth teeth{12 + r.below(40), 10 + r.below(30)};
         const int planets = 1 + r.below(5);
         if (r.oneIn(2)) return inserted(r, planetarySet(teeth, planets));
         using enum PlanetaryMember;
         const PlanetaryMember members[] = {sun, ring, carrier};
         const int drive = r.below(3);
         const PlanetaryUse use{members[drive], members[(drive + 1 + r.below(2)) % 3],
                                r.oneIn(2) ? PlanetaryHolding::brake : PlanetaryHolding::ground};
         return inserted(r, planetarySet(teeth, planets, use));
       },
       1},
      {"revertedTrain",
       [](Random& r) {
         return inserted(r, revertedTrain({17 + r.below(40), 40, 20 + r.below(9), 31}));
       },
       1},
      {"ravigneauxSet", [](Random& r) { return inserted(r, ravigneauxSet({}, 1 + r.below(4))); }, 1},
      {"simpsonSet",
       [](Random& r) {
         return inserted(r, simpsonSet({20 + r.below(20), 20}, 1 + r.below(4)));
       },
       1},
      {"bevelDifferentialSet",
       [](Random& r) { return inserted(r, bevelDifferentialSet(16 + r.below(9), 10, 1 + r.below(4))); }, 1},
      {"bevelWrist", [](Random& r) { return inserted(r, bevelWrist({20 + r.below(9)})); }, 1},
  };
}

}  // namespace

const std::vector<EditKind>& editKinds() {
  static const std::vector<EditKind> all = [] {
    std::vector<EditKind> kinds = drawnEdits();
    for (std::vector<EditKind>& more : std::array{numberEdits(), gearboxEdits(), forceEdits()}) {
      kinds.insert(kinds.end(), more.begin(), more.end());
    }
    return kinds;
  }();
  return all;
}

const EditKind& randomKind(std::mt19937_64& random) {
  static const int total = std::accumulate(editKinds().begin(), editKinds().end(), 0,
                                           [](int sum, const EditKind& each) { return sum + each.weight; });
  int at = static_cast<int>(random() % static_cast<std::uint64_t>(total));
  const auto found = std::find_if(editKinds().begin(), editKinds().end(), [&at](const EditKind& each) {
    at -= each.weight;
    return at < 0;
  });
  return *found;
}

}  // namespace geargraph::soak
