#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/foundations/base/disjoint_sets.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/face_gear.h"
#include "core/machine/teeth/involute.h"
#include "core/machine/teeth/tooth_pair.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/cut_limits.h"
#include "core/machine/train/train_wheels.h"
#include "core/machine/train/wheel_backlash.h"

namespace geargraph {
namespace {

constexpr double kDefaultSpurFace = 8;      // modules
constexpr double kDefaultCrossedFace = 10;  // modules: contact runs along the face
constexpr double kMaxBevelFace = 10;        // modules

/// Wheels that mesh with each other on parallel axes, so that one module is theirs.
DisjointSets wheelsOfOneModule(const TrainWheels& train) {
  DisjointSets groups(train.wheels.size());
  for (const TrainPair& pair : train.pairs) {
    if (hasParallelAxes(pair.kind)) groups.join(pair.tail, pair.head);
  }
  return groups;
}

/// Coordinates come in decimals. What differs by less than they say is taken for equal, so that the planets
/// of a set are one solid and pairs at their standard distance have no shift.
double rounded(double value, double step) {
  return std::round(value / step) * step + 0.0;  // no -0
}
constexpr double kShapeModuleStep = 1e-6;  // of the first digit
constexpr double kShiftStep = 1e-4;        // modules; a backlash of 0.00007 modules
constexpr double kAngleStep = 1e-7;

int teethSum(const TrainPair& pair, const TrainWheels& train) {
  const int tail = train.wheels[static_cast<std::size_t>(pair.tail)].spec.teeth;
  const int head = train.wheels[static_cast<std::size_t>(pair.head)].spec.teeth;
  return distanceTeeth(pair.kind, tail, head);
}

/// The module of each group of wheels in mesh: the first that a mesh states, else the least that distances
/// make.
void setModules(const Mechanism& mechanism, TrainWheels& train) {
  DisjointSets groups = wheelsOfOneModule(train);
  std::vector<double> module(train.wheels.size(), 0);
  std::vector<char> isStated(train.wheels.size(), 0);
  for (const TrainPair& pair : train.pairs) {
    if (!hasParallelAxes(pair.kind)) continue;
    const std::size_t group = groups.root(static_cast<std::size_t>(pair.tail));
    if (isStated[group] != 0) continue;
    double& least = module[group];
    if (const std::optional<Number>& stated = mechanism.gearMeshes[pair.mesh].module) {
      least = stated->value() / std::cos(train.wheels[pair.tail].spec.helixAngle);
      isStated[group] = 1;
      continue;
    }
    const double wanted = 2 * pair.distance / teethSum(pair, train);
    if (least == 0 || wanted < least) least = wanted;
  }
  for (const GearOrdinal w : train.wheels.ordinals()) {
    GearSpec& spec = train.wheels[w].spec;
    const std::size_t group = groups.root(static_cast<std::size_t>(w));
    if (module[group] > 0) spec.module = module[group];  // else it has its module already: bevels, pulleys
    if (!isConical(spec) && isStated[group] != 0) continue;
    spec.module = rounded(spec.module, kShapeModuleStep * std::pow(10, std::floor(std::log10(spec.module))));
    spec.coneAngle = rounded(spec.coneAngle, kAngleStep);
  }
}

/// Wheels in equal circumstances: same teeth and kind, same stated shift, and meshes that want the same sum
/// of shifts with partners in equal circumstances. How often counts nothing, so that the shifts of a sun and
/// its planets do not depend on the number of planets. Beyond some rounds of comparison, which only long
/// chains take, each wheel is its own class.
std::vector<std::size_t> equalWheels(const TrainWheels& train, const std::vector<double>& wanted,
                                     const std::vector<bool>& fixed) {
  const std::size_t count = train.wheels.size();
  std::vector<std::size_t> classOf(count);
  const auto classify = [&](const auto& keyOf) {
    std::map<decltype(keyOf(std::size_t{0})), std::size_t> classes;
    for (std::size_t w = 0; w < count; ++w)
      classOf[w] = classes.try_emplace(keyOf(w), classes.size()).first->second;
    return classes.size();
  };
  std::size_t classes = classify([&](std::size_t w) {
    const GearSpec& spec = train.wheels[w].spec;
    return std::tuple(spec.kind, spec.teeth, spec.module, bool{fixed[w]}, fixed[w] ? spec.profileShift : 0.0);
  });
  constexpr int kMaxRounds = 50;
  std::size_t before = 0;
  for (int round = 0; classes != before && round < kMaxRounds; ++round) {
    before = classes;
    std::vector<std::set<std::pair<std::size_t, double>>> partners(count);
    for (std::size_t p = 0; p < train.pairs.size(); ++p) {
      const auto tail = static_cast<std::size_t>(train.pairs[p].tail);
      const auto head = static_cast<std::size_t>(train.pairs[p].head);
      partners[tail].emplace(classOf[head], wanted[p]);
      partners[head].emplace(classOf[tail], wanted[p]);
    }
    const std::vector<std::size_t> last = classOf;
    classes = classify([&](std::size_t w) { return std::pair(last[w], partners[w]); });
  }
  if (classes != before) std::iota(classOf.begin(), classOf.end(), std::size_t{0});
  return classOf;
}

/// A mesh between wheels in certain circumstances, all of which share one shift.
struct ShiftEquation {
  std::size_t tail = 0;
  std::size_t head = 0;  ///< classes of wheels
  double tailSign = 1;
  double headSign = 1;
  double wanted = 0;
  friend auto operator<=>(const ShiftEquation&, const ShiftEquation&) = default;
};

/// Hands what is missing to the wheels whose shift is not the document's, half each, until nothing is: the
/// smallest shifts that fit, because every step is the shortest one.
class ShiftSolver {
 public:
  ShiftSolver(const TrainWheels& train, const std::vector<bool>& fixed) {
    std::vector<double> wanted;
    for (const TrainPair& pair : train.pairs) {
      const GearSpec& spec = train.wheels[pair.tail].spec;
      wanted.push_back(
          hasParallelAxes(pair.kind)
              ? rounded(shiftSumFor(teethSum(pair, train), pair.distance / spec.module, spec.pressureAngle),
                        kShiftStep)
              : 0);
    }
    m_classOf = equalWheels(train, wanted, fixed);
    m_shifts.resize(train.wheels.size(), 0);
    m_isFixed.resize(train.wheels.size(), false);
    for (std::size_t w = 0; w < m_classOf.size(); ++w) {
      m_isFixed[m_classOf[w]] = fixed[w];
      m_shifts[m_classOf[w]] = train.wheels[w].spec.profileShift;
    }
    std::set<ShiftEquation> known;
    for (std::size_t p = 0; p < train.pairs.size(); ++p) {
      if (!hasParallelAxes(train.pairs[p].kind)) continue;
      const ShiftEquation equation = equationOf(train, train.pairs[p], wanted[p]);
      if (known.insert(equation).second) m_equations.push_back(equation);
    }
  }

  void solve(const std::stop_token& stop) {
    for (int sweep = 0; sweep < 500 && !stop.stop_requested(); ++sweep) {
      double worst = 0;
      for (const ShiftEquation& equation : m_equations) worst = std::max(worst, correct(equation));
      if (worst < 1e-13) break;
    }
  }

  [[nodiscard]] double shiftOf(GearOrdinal wheel) const {
    return rounded(m_shifts[m_classOf[static_cast<std::size_t>(wheel)]], 1e-9);
  }

 private:
  /// The sum of the shifts of an external pair; ring less pinion of an internal one.
  [[nodiscard]] ShiftEquation equationOf(const TrainWheels& train, const TrainPair& pair,
                                         double wanted) const {
    const auto sign = [&](GearOrdinal wheel) -> double {
      return hasRing(pair.kind) && !isRing(train.wheels[wheel].spec) ? -1 : 1;
    };
    return {m_classOf[static_cast<std::size_t>(pair.tail)], m_classOf[static_cast<std::size_t>(pair.head)],
            sign(pair.tail), sign(pair.head), wanted};
  }

  /// Takes the shortest step that satisfies the equation; returns how much was missing.
  double correct(const ShiftEquation& equation) {
    const auto [tail, head, tailSign, headSign, wanted] = equation;
    const double missing = wanted - tailSign * m_shifts[tail] - headSign * m_shifts[head];
    const int free = (m_isFixed[tail] ? 0 : 1) + (m_isFixed[head] ? 0 : 1);
    if (free == 0) return 0;
    if (tail == head) {  // the sum is twice the one shift
      m_shifts[tail] += missing / 2;
      return std::abs(missing);
    }
    if (!m_isFixed[tail]) m_shifts[tail] += tailSign * missing / free;
    if (!m_isFixed[head]) m_shifts[head] += headSign * missing / free;
    return std::abs(missing);
  }

  std::vector<std::size_t> m_classOf;  ///< by wheel
  std::vector<double> m_shifts;        ///< by class
  std::vector<bool> m_isFixed;         ///< by class: stated in the document
  std::vector<ShiftEquation> m_equations;
};

void setShifts(TrainWheels& train, const std::vector<bool>& fixed, const std::stop_token& stop) {
  ShiftSolver solver(train, fixed);
  solver.solve(stop);
  for (const GearOrdinal wheel : train.wheels.ordinals())
    train.wheels[wheel].spec.profileShift = solver.shiftOf(wheel);
}

/// A bevel pair's shifts cancel out, so that the pitch cones stay the working cones.
void balanceBevelShifts(TrainWheels& train, const std::vector<bool>& fixed) {
  for (const TrainPair& pair : train.pairs) {
    if (!hasIntersectingAxes(pair.kind)) continue;
    const auto a = static_cast<std::size_t>(pair.tail);
    const auto b = static_cast<std::size_t>(pair.head);
    if (fixed[a] && !fixed[b]) train.wheels[b].spec.profileShift = -train.wheels[a].spec.profileShift;
    if (fixed[b] && !fixed[a]) train.wheels[a].spec.profileShift = -train.wheels[b].spec.profileShift;
  }
}

double defaultFace(const GearSpec& spec, MeshKind kind) {
  if (const auto own = wheelKind(spec.kind).usualFace) return own(spec);
  if (hasSkewAxes(kind) && !isConical(spec)) return kDefaultCrossedFace * normalModule(spec);
  if (!isConical(spec)) return kDefaultSpurFace * normalModule(spec);
  return std::min(coneDistance(spec) / 3, kMaxBevelFace * spec.module);
}

/// What the meshes of a wheel cover of its axis, from its origin.
struct BlockedPlane {
  double low = 0;
  double high = 0;
};

/// A pinion covers the teeth of its face gear, which lie on one side of the pitch point for the most part.
BlockedPlane besideFace(const TrainWheel& gear, const TrainWheel& pinion, const Eigen::Vector3d& pitchPoint,
                        double face) {
  const double inner = faceInner(gear.spec) - pitchRadius(gear.spec);
  const bool isOutward = (pitchPoint - gear.origin).dot(pinion.axis) > 0;
  if (isOutward) return {inner, inner + face};
  return {-inner - face, -inner};
}

void setFaces(const Mechanism& mechanism, TrainWheels& train) {
  ByGear<BlockedPlane> covers(train.wheels.size());
  for (TrainPair& pair : train.pairs) {
    std::optional<Number> stated = mechanism.gearMeshes[pair.mesh].faceWidth;
    if (!stated && mechanism.gearDefaults) stated = mechanism.gearDefaults->faceWidth;
    pair.openFace = !stated || stated->value() <= 0;
    const bool hasFace = pairKind(pair.kind).hasFace;
    const GearOrdinal faceGear = isFaceGear(train.wheels[pair.tail].spec) ? pair.tail : pair.head;
    for (const GearOrdinal w : {pair.tail, pair.head}) {
      const TrainWheel& wheel = train.wheels[static_cast<std::size_t>(w)];
      const TrainWheel& leading = hasFace ? train.wheels[faceGear] : wheel;
      double face = stated && stated->value() > 0 ? stated->value() : defaultFace(leading.spec, pair.kind);
      if (hasFace) face = std::min(face, usualFaceGearFace(leading.spec));
      if (isConical(wheel.spec)) face = std::min(face, 0.6 * coneDistance(wheel.spec));
      const auto mesh = std::find(wheel.meshes.begin(), wheel.meshes.end(), pair.mesh);
      const double plane = wheel.planes[static_cast<std::size_t>(mesh - wheel.meshes.begin())];
      BlockedPlane& cover = covers[w];
      const BlockedPlane own = hasFace && w != faceGear ? besideFace(leading, wheel, pair.pitchPoint, face)
                                                        : BlockedPlane{-face / 2, face / 2};
      cover.low = std::min(cover.low, plane + own.low);
      cover.high = std::max(cover.high, plane + own.high);
    }
  }
  for (const GearOrdinal w : covers.ordinals()) {
    TrainWheel& wheel = train.wheels[w];
    wheel.spec.faceWidth = covers[w].high - covers[w].low;
    const double middle = (covers[w].low + covers[w].high) / 2;
    if (middle == 0) continue;
    wheel.origin += middle * wheel.axis;
    for (double& plane : wheel.planes) plane -= middle;
  }
}

/// Clearance at the roots of shifted pairs; rings' tips off the pinions' fillets.
void setTips(TrainWheels& train) {
  const auto lower = [](GearSpec& spec, double tip) {
    const double now = nominalTipRadius(spec) / spec.module;
    if (isRing(spec) ? tip > now : tip < now) spec.tipRadius = tip;
  };
  for (const TrainPair& pair : train.pairs) {
    GearSpec& tail = train.wheels[static_cast<std::size_t>(pair.tail)].spec;
    GearSpec& head = train.wheels[static_cast<std::size_t>(pair.head)].spec;
    if (!isBesideEachOther(pair.kind)) continue;
    const double k = tipShortening(tail, head, pair.distance / tail.module);
    if (k > -1e-9) continue;
    for (GearSpec* spec : {&tail, &head})
      lower(*spec, spec->teeth / 2.0 + spec->addendum + spec->profileShift + k);
  }
  for (const TrainPair& pair : train.pairs) {
    if (!hasRing(pair.kind)) continue;
    GearSpec& tail = train.wheels[static_cast<std::size_t>(pair.tail)].spec;
    GearSpec& head = train.wheels[static_cast<std::size_t>(pair.head)].spec;
    GearSpec& ring = isRing(tail) ? tail : head;
    const GearSpec& pinion = isRing(tail) ? head : tail;
    if (specDiagnostics(pinion).empty()) lower(ring, leastRingTip(pinion, ring, pair.distance / ring.module));
  }
}

/// The normal pressure angle of a wheel's teeth, of the first of its meshes that states one.
const Number* statedAngle(const Mechanism& mechanism, const TrainWheel& wheel) {
  for (const MeshOrdinal mesh : wheel.meshes) {
    if (const std::optional<Number>& angle = mechanism.gearMeshes[mesh].pressureAngle) return &*angle;
  }
  const std::optional<GearDefaults>& defaults = mechanism.gearDefaults;
  return defaults && defaults->pressureAngle ? &*defaults->pressureAngle : nullptr;
}

/// The measures of the normal section that the document states for its teeth.
void setSection(const Mechanism& mechanism, TrainWheel& wheel) {
  if (const Number* const angle = statedAngle(mechanism, wheel))
    wheel.spec.pressureAngle = angle->value() * std::numbers::pi / 180;
  wheel.spec.backlashAllowance = backlashOf(mechanism, wheel.id).toDouble() / 2;
}

void lean(TrainWheel& wheel) {
  if (const double helix = std::exchange(wheel.spec.helixAngle, 0); helix != 0)
    wheel.spec = wheelKind(wheel.spec.kind).withHelix(wheel.spec, helix);
}

}  // namespace

double fewestTeethUncut(const Mechanism& mechanism, const TrainWheel& wheel) {
  TrainWheel cut = wheel;
  setSection(mechanism, cut);
  lean(cut);
  return fewestTeethWithoutUndercut(cut.spec);
}

void shapeWheels(const Mechanism& mechanism, TrainWheels& train, const std::stop_token& stop) {
  std::vector<bool> fixed;
  for (TrainWheel& wheel : train.wheels) {
    const Wheel* drawn = wheel.id ? mechanism.find(*wheel.id) : nullptr;
    setSection(mechanism, wheel);
    if (drawn != nullptr && drawn->bore) wheel.spec.bore = drawn->bore->value();
    fixed.push_back(drawn != nullptr && drawn->profileShift.has_value());
    if (fixed.back()) wheel.spec.profileShift = drawn->profileShift->value();
    wheel.spec.body = GearBody::dressed;
    lean(wheel);
  }
  setModules(mechanism, train);
  setShifts(train, fixed, stop);
  balanceBevelShifts(train, fixed);
  setFaces(mechanism, train);
  setTips(train);
}

}  // namespace geargraph
