#include <cmath>
#include <cstdio>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/tooth_pair.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"

namespace geargraph {
namespace {

/// How far a ring's tip may be lowered before it is worth a word, in modules.
constexpr double kNoticedShortening = 0.3;
/// Fewer pairs in contact than this at a time: the drive is rough, or interrupted (README.md, section 5).
constexpr double kLeastContactRatio = 1.1;
/// Diagnostics ask for the ends of the flanks only, which do not depend on the tolerance.
constexpr double kDiagnosticTolerance = 0.2;

std::vector<ElementId> blamed(const Mechanism& mechanism, const TrainGear& gear) {
  std::vector<ElementId> elements;
  for (const MeshOrdinal mesh : gear.meshes) elements.emplace_back(mechanism.gearMeshes[mesh].id);
  elements.emplace_back(mechanism.links[gear.link].id);
  if (gear.wheel) elements.emplace_back(*gear.wheel);
  return elements;
}

class ToothFinder {
 public:
  ToothFinder(const Mechanism& mechanism, const GearTrain& train, const std::stop_token& stop)
      : m_mechanism(mechanism), m_train(train) {
    for (const TrainGear& gear : train.gears) {
      if (stop.stop_requested()) return;
      addGear(gear);
    }
    for (const TrainMesh& mesh : train.meshes) addMesh(mesh);
  }

  Diagnostics found;

 private:
  void add(Detail detail, std::string message, std::vector<ElementId> elements) {
    found.push_back(makeDiagnostic(detail, std::move(message), std::move(elements)));
  }
  void addGear(const TrainGear& gear);
  void addMesh(const TrainMesh& mesh);
  void addRing(const GearSpec& pinion, const GearSpec& ring, double distance, const ElementId& mesh);
  void addContact(double ratio, const std::string& pair, const ElementId& mesh);
  void addFace(const GearSpec& spec, const std::string& pair, const ElementId& mesh);
  [[nodiscard]] double distanceOf(const TrainGear& a, const TrainGear& b) const {
    const Eigen::Vector3d axis = a.pose.linear().col(2);
    return (a.pose.translation() - b.pose.translation()).cross(axis).norm() / a.spec.module;
  }

  const Mechanism& m_mechanism;
  const GearTrain& m_train;
  std::vector<std::optional<HalfTooth>> m_teeth;  ///< by gear; none where no tooth can be made
};

void ToothFinder::addGear(const TrainGear& gear) {
  const GearSpec& spec = gear.spec;
  const std::string teeth = std::to_string(spec.teeth);
  const Diagnostics impossible = specDiagnostics(spec);
  if (!impossible.empty()) {
    m_teeth.emplace_back();
    add(Detail::noToothForm,
        translated("Gear %1 (%2 teeth) has no solid: %3", {gear.name, teeth, impossible.front().message}),
        blamed(m_mechanism, gear));
    return;
  }
  if (!isToothed(spec)) {
    m_teeth.emplace_back();
    if (wheelKind(spec.kind).isStandIn) {
      Diagnostic standIn;
      standIn.code = Code::standIn;
      standIn.elements = blamed(m_mechanism, gear);
      standIn.message = translated(
          "Gear %1 (%2 teeth) is drawn as its pitch cone: the teeth of hypoid gears are not made here. "
          "Motion, "
          "torques and forces are those of the teeth.",
          {gear.name, teeth});
      found.push_back(std::move(standIn));
    }
    return;
  }
  m_teeth.emplace_back(toothOf(spec, kDiagnosticTolerance));
  const HalfTooth& tooth = *m_teeth.back();
  if (tooth.undercut) {
    Diagnostic undercut;
    undercut.code = Code::undercut;
    undercut.elements = blamed(m_mechanism, gear);
    undercut.message = translated(
        "Gear %1 (%2 teeth) is undercut: at a profile shift of %3 a rack needs %4 teeth or more. Use more "
        "teeth, or "
        "a shift of at least %5.",
        {gear.name, teeth, fixedText(normalShift(spec), 2), fixedText(fewestTeethWithoutUndercut(spec), 1),
         fixedText(leastShiftWithoutUndercut(spec) / std::cos(spec.helixAngle), 2)});
    found.push_back(std::move(undercut));
  }
  if (tooth.shortened) {
    add(Detail::pointedTeeth,
        translated("Gear %1 (%2 teeth) would have pointed teeth: its tips were lowered to keep a land of %3 "
                   "modules. Use a smaller profile shift than %4.",
                   {gear.name, teeth, fixedText(kNarrowestLand, 1), fixedText(normalShift(spec), 2)}),
        blamed(m_mechanism, gear));
  }
}

void ToothFinder::addMesh(const TrainMesh& mesh) {
  const auto t = static_cast<std::size_t>(mesh.tailGear);
  const auto h = static_cast<std::size_t>(mesh.headGear);
  if (!m_teeth[t] || !m_teeth[h]) return;
  const TrainGear& tail = m_train.gears[t];
  const TrainGear& head = m_train.gears[h];
  const ElementId id = m_mechanism.gearMeshes[mesh.mesh].id;
  const std::string pair = translated("Mesh %1, %2 and %3 teeth",
                                      {std::to_string(m_mechanism.meshLabel(mesh.mesh)),
                                       std::to_string(tail.spec.teeth), std::to_string(head.spec.teeth)});
  // Gears on skew axes touch in a point that runs along the teeth: no ratio of a plane is theirs.
  if (hasSkewAxes(saidKind(m_mechanism.gearMeshes[mesh.mesh]))) return;
  if (isFaceGear(tail.spec) || isFaceGear(head.spec)) {
    const auto face = isFaceGear(tail.spec) ? t : h, pinion = isFaceGear(tail.spec) ? h : t;
    addContact(contactRatio(m_train.gears[face].spec, *m_teeth[face], m_train.gears[pinion].spec,
                            *m_teeth[pinion], 0),
               pair, id);
    return;
  }
  const double distance = distanceOf(tail, head);
  addContact(contactRatio(tail.spec, *m_teeth[t], head.spec, *m_teeth[h], distance), pair, id);
  if (isConical(tail.spec)) {
    addFace(tail.spec, pair, id);
  } else if (isRing(tail.spec)) {
    addRing(head.spec, tail.spec, distance, id);
  } else if (isRing(head.spec)) {
    addRing(tail.spec, head.spec, distance, id);
  }
}

void ToothFinder::addContact(double ratio, const std::string& pair, const ElementId& mesh) {
  if (ratio >= kLeastContactRatio) return;
  const std::string reached = fixedText(std::max(ratio, 0.0), 2);
  const std::string wanted = fixedText(kLeastContactRatio, 1);
  add(Detail::contactRatio,
      ratio < 1
          ? translated("%1: a contact ratio of %2, one pair of teeth lets go before the next takes over. Use "
                       "more teeth, or profile shifts that leave longer flanks, for %3 or more.",
                       {pair, reached, wanted})
          : translated("%1: a contact ratio of %2, that leaves nothing for errors of the teeth. Use more "
                       "teeth, or profile shifts that leave longer flanks, for %3 or more.",
                       {pair, reached, wanted}),
      {mesh});
}

void ToothFinder::addFace(const GearSpec& spec, const std::string& pair, const ElementId& mesh) {
  const double most = coneDistance(spec) / 3;
  if (spec.faceWidth <= most * (1 + 1e-6)) return;
  add(Detail::faceTooWide,
      translated(
          "%1: a face width of %2 is more than a third of the cone distance, so that the small ends of the "
          "teeth are too weak to bear load. Use %3 or less.",
          {pair, fixedText(spec.faceWidth, 1), fixedText(most, 1)}),
      {mesh});
}

void ToothFinder::addRing(const GearSpec& pinion, const GearSpec& ring, double distance,
                          const ElementId& mesh) {
  const std::string teeth = std::to_string(pinion.teeth);
  const std::string around = std::to_string(ring.teeth);
  const double margin = trochoidMargin(pinion, ring, distance);
  if (margin < 0) {
    add(Detail::tipInterference,
        translated("%1 teeth in a ring of %2: their tips collide outside of the mesh, by %3 modules. Use a "
                   "difference of more teeth, or a larger profile shift of the ring.",
                   {teeth, around, fixedText(-margin * ring.teeth / 2, 3)}),
        {mesh});
  }
  const double standard = ring.teeth / 2.0 - ring.addendum + ring.profileShift;
  if (ring.tipRadius > standard + kNoticedShortening) {
    add(Detail::ringTipsLowered,
        translated(
            "%1 teeth in a ring of %2: the ring's tips would interfere with the pinion's fillets and were "
            "lowered by %3 modules. Use a pinion of more teeth, or with a larger profile shift.",
            {teeth, around, fixedText(ring.tipRadius - standard, 2)}),
        {mesh});
  }
}

}  // namespace

std::string fixedText(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return localizedNumber(text);
}

Diagnostics toothDiagnostics(const Mechanism& mechanism, const GearTrain& train,
                             const std::stop_token& stop) {
  return ToothFinder(mechanism, train, stop).found;
}

}  // namespace geargraph
