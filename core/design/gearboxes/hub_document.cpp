#include "core/design/gearboxes/hub_document.h"

#include <algorithm>

#include "core/design/synthesis/set_sketch.h"
#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr int kHubSetDistance = 90;  // along the axis, mm
constexpr int kStepDistance = 22;
constexpr int kHubFaceWidth = 14;

/// What a set does in a gear.
struct HubUse {
  int sun = -1;  ///< held; -1: passed through
  bool isIncrease = false;
};

/// The ways of the sets to make a ratio: the one that holds the fewest suns.
std::vector<HubUse> usesOf(const HubCandidate& candidate, const Rational& ratio) {
  std::vector<HubUse> best;
  std::size_t fewest = candidate.sets.size() + 1;
  std::vector<HubUse> uses(candidate.sets.size());
  const auto choose = [&](const auto& self, std::size_t set, const Rational& product,
                          std::size_t held) -> void {
    if (held >= fewest) return;
    if (set == uses.size()) {
      if (product != ratio) return;
      best = uses;
      fewest = held;
      return;
    }
    uses[set] = {};
    self(self, set + 1, product, held);
    const HubSet& own = candidate.sets[set];
    for (std::size_t sun = 0; sun < own.suns.size(); ++sun) {
      const Rational reduction = own.reduction(sun);
      for (const bool isIncrease : {false, true}) {
        if ((isIncrease ? own.suns[sun].increase : own.suns[sun].reduction) < 0) continue;
        uses[set] = {static_cast<int>(sun), isIncrease};
        self(self, set + 1, product * (isIncrease ? reduction.inverse() : reduction), held + 1);
      }
    }
    uses[set] = {};
  };
  choose(choose, 0, Rational(1), 0);
  GEARGRAPH_REQUIRE(fewest <= candidate.sets.size());
  return best;
}

/// The links and couplings of one set.
struct DrawnHubSet {
  bool isExchanged = false;  ///< ring and carrier change places: some gears reduce, others increase
  int ring = 0;
  int carrier = 0;
  std::vector<std::string> brakes;  ///< by sun
  std::string pass;                 ///< the clutch of ring and carrier; empty if no gear needs it
  /// For a set in which ring and carrier are exchanged.
  std::string driverRing, driverCarrier, carrierDriven, ringDriven;
};

class HubSketch {
 public:
  explicit HubSketch(const HubCandidate& candidate)
      : m_candidate(candidate), m_sketch(translated("Hub gear")) {
    for (const Rational& ratio : candidate.ratios) m_uses.push_back(usesOf(candidate, ratio));
  }

  Mechanism build() && {
    m_sketch.axis("a", {Number(0), Number(0), Number(0)}, {Number(0), Number(0), Number(1)});
    int driver = shaft(translated("driver"), -kHubSetDistance / 2);
    const int first = driver;
    for (std::size_t set = 0; set < m_candidate.sets.size(); ++set) {
      const bool isLast = set + 1 == m_candidate.sets.size();
      const int driven =
          shaft(isLast ? translated("hub shell") : translated("shaft %1", {std::to_string(set + 1)}),
                levelOf(set) + kHubSetDistance / 2);
      addSet(set, driver, driven);
      driver = driven;
    }
    for (std::size_t gear = 0; gear < m_uses.size(); ++gear)
      m_sketch.state(std::to_string(gear + 1), engagedIn(gear), first, driver);
    for (const std::string& each : engagedIn(0)) m_sketch.engage(each);
    m_sketch.input(first, Number(1));
    Mechanism mechanism = std::move(m_sketch).build();
    mechanism.notes = notes();
    return mechanism;
  }

 private:
  [[nodiscard]] static int levelOf(std::size_t set) { return static_cast<int>(set) * kHubSetDistance; }

  int shaft(std::string name, int bearing) {
    const int made = m_sketch.link(0, "a", std::move(name));
    m_sketch.bearing(made, bearing);
    return made;
  }

  std::string nextLetter() { return {static_cast<char>('A' + m_couplings++)}; }

  std::string clutch(int a, int b) {
    std::string letter = nextLetter();
    m_sketch.clutch(letter, a, b);
    return letter;
  }

  void addSet(std::size_t position, int driver, int driven) {
    const HubSet& set = m_candidate.sets[position];
    const auto isUsed = [&](const auto& asks) {
      return std::any_of(m_uses.begin(), m_uses.end(),
                         [&](const auto& uses) { return asks(uses[position]); });
    };
    const bool reduces = isUsed([](const HubUse& use) { return use.sun >= 0 && !use.isIncrease; });
    const bool increases = isUsed([](const HubUse& use) { return use.sun >= 0 && use.isIncrease; });
    DrawnHubSet& drawn = m_drawn.emplace_back();
    drawn.isExchanged = reduces && increases;
    const std::string number = std::to_string(position + 1);
    if (drawn.isExchanged) {
      drawn.ring = shaft(translated("ring %1", {number}), levelOf(position) - 20);
      drawn.carrier = shaft(translated("carrier %1", {number}), levelOf(position) + 15);
    } else {
      drawn.ring = increases ? driven : driver;
      drawn.carrier = increases ? driver : driven;
    }
    addWheels(position, set, drawn);
    if (drawn.isExchanged) {
      drawn.driverRing = clutch(driver, drawn.ring);
      drawn.driverCarrier = clutch(driver, drawn.carrier);
      drawn.carrierDriven = clutch(drawn.carrier, driven);
      drawn.ringDriven = clutch(drawn.ring, driven);
    } else if (isUsed([](const HubUse& use) { return use.sun < 0; })) {
      drawn.pass = clutch(drawn.ring, drawn.carrier);
    }
  }

  void addWheels(std::size_t position, const HubSet& set, DrawnHubSet& drawn) {
    const std::string number = std::to_string(position + 1);
    const int level = levelOf(position);
    const int centre = set.suns.front().teeth + set.suns.front().planet;  // mm: half modules of 1
    std::vector<int> suns;
    for (std::size_t sun = 0; sun < set.suns.size(); ++sun) {
      const std::string name = set.suns.size() > 1 ? number + "." + std::to_string(sun + 1) : number;
      suns.push_back(shaft(translated("sun %1", {name}), level + static_cast<int>(sun) * kStepDistance - 10));
      drawn.brakes.push_back(nextLetter());
      m_sketch.brake(drawn.brakes.back(), suns.back());
    }
    const std::string axis = "p" + number;
    m_sketch.axis(axis, {Number(centre), Number(0), Number(level)}, {Number(0), Number(0), Number(1)});
    const int planet = m_sketch.link(drawn.carrier, axis, translated("planet %1", {number}));
    for (std::size_t sun = 0; sun < set.suns.size(); ++sun) {
      const HubSun& own = set.suns[sun];
      const WheelId step = m_sketch.wheel("step-" + number + "-" + std::to_string(sun + 1), planet);
      const int at = level + static_cast<int>(sun) * kStepDistance;
      GearMesh& outer = m_sketch.mesh(suns[sun], planet, own.teeth, own.planet, MeshKind::external);
      outer.headWheel = step;
      place(outer, Rational(centre) * Rational(own.teeth, own.teeth + own.planet), at);
      if (sun > 0) continue;
      GearMesh& inner = m_sketch.mesh(planet, drawn.ring, own.planet, set.ring, MeshKind::internal);
      inner.tailWheel = step;
      place(inner, Rational(centre) * Rational(set.ring, set.ring - own.planet), at);
    }
  }

  static void place(GearMesh& mesh, const Rational& radius, int level) {
    mesh.faceWidth = Number(kHubFaceWidth);
    mesh.pitchPoint = NumberTriple{Number(radius), Number(0), Number(level)};
  }

  [[nodiscard]] std::vector<std::string> engagedIn(std::size_t gear) const {
    std::vector<std::string> engaged;
    for (std::size_t set = 0; set < m_drawn.size(); ++set) {
      const DrawnHubSet& drawn = m_drawn[set];
      const HubUse& use = m_uses[gear][set];
      if (use.sun >= 0) engaged.push_back(drawn.brakes[static_cast<std::size_t>(use.sun)]);
      if (drawn.isExchanged) {
        const bool carrierDrives = use.sun >= 0 && use.isIncrease;
        engaged.push_back(carrierDrives ? drawn.driverCarrier : drawn.driverRing);
        engaged.push_back(carrierDrives ? drawn.ringDriven : drawn.carrierDriven);
        if (use.sun < 0) engaged.push_back(drawn.driverCarrier);
      } else if (use.sun < 0) {
        engaged.push_back(drawn.pass);
      }
    }
    return engaged;
  }

  [[nodiscard]] std::string notes() const {
    std::string planets;
    for (const HubSet& set : m_candidate.sets) {
      planets += planets.empty() ? "" : "; ";
      for (std::size_t i = 0; i < set.planets.size(); ++i)
        planets += (i == 0 ? "" : ", ") + std::to_string(set.planets[i]);
      if (set.planets.empty()) planets += translated("none");
    }
    return translated(
        "Found from the ratios of a hub gear. One planet of each set is drawn; numbers of equal planets that "
        "go "
        "in: %1.",
        {planets});
  }

  const HubCandidate& m_candidate;
  SetSketch m_sketch;
  std::vector<std::vector<HubUse>> m_uses;  ///< by gear and set
  std::vector<DrawnHubSet> m_drawn;
  int m_couplings = 0;
};

}  // namespace

Mechanism hubDocument(const HubCandidate& candidate) {
  return HubSketch(candidate).build();
}

}  // namespace geargraph
