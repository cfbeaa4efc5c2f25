#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/theory/matroid/exact_solution.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/states/state_solution.h"
#include "core/theory/vibration/frequency_lines.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/matroid_fixture.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

ByJoint<Rational> frequencyRates(const Worked& worked) {
  return solveExact(worked.model, worked.analysis.choice.joints, worked.analysis.speeds)->rates;
}

std::vector<FrequencyLine> frequenciesOf(const Worked& worked, const ByJoint<Rational>& rates,
                                         LinkOrdinal reference, const FrequencyOptions& options = {}) {
  const FrequencyMotion motion{rates};
  return frequencyLines(worked.mechanism, worked.placement, worked.model, motion,
                        *shaftSpeed(worked.placement, motion, reference), options);
}

/// The ratio of the first line that fits; 0 where there is none.
template <class Fits>
Rational lineRatio(const std::vector<FrequencyLine>& lines, FrequencyKind kind, const Fits& fits) {
  for (const FrequencyLine& line : lines) {
    if (line.kind == kind && fits(line)) return line.ratio;
  }
  return 0;
}
Rational frequencyOfMesh(const std::vector<FrequencyLine>& lines, FrequencyKind kind, int mesh) {
  return lineRatio(lines, kind,
                   [&](const FrequencyLine& line) { return line.mesh && int{*line.mesh} == mesh; });
}
Rational frequencyOfLink(const std::vector<FrequencyLine>& lines, FrequencyKind kind, int link) {
  return lineRatio(lines, kind,
                   [&](const FrequencyLine& line) { return line.link && int{*line.link} == link; });
}
Rational sidebandOf(const std::vector<FrequencyLine>& lines, int mesh, int link, int order, int planets) {
  return lineRatio(lines, FrequencyKind::sideband, [&](const FrequencyLine& line) {
    return int{*line.mesh} == mesh && int{*line.link} == link && line.sideband == order &&
           line.planets == planets && line.harmonic == 1;
  });
}
bool isNearHertz(const Rational& ratio, double hertzOfReference, double published, double within) {
  return std::abs(ratio.toDouble() * hertzOfReference - published) <= within;
}

/// The main rotor gearbox of the Bell 206: bevel pinion 19 on 71, sun 27, planets 35, ring 99 in the housing.
/// Links: 1 pinion, 2 bevel gear with the sun, 3 carrier, 4.. planets.
Mechanism bell206(int planets) {
  TrainSketch train(3 + planets);
  train.axis("b", {"0", "0", "0"}, {"1", "0", "0"}).axis("a", {"0", "0", "0"});
  train.joint(0, 1, "b", "40").joint(0, 2, "a", "0").joint(0, 3, "a", "20");
  for (int i = 0; i < planets; ++i) train.joint(3, 4 + i, "p" + std::to_string(i));
  train.mesh(1, 2, 19, 71, MeshKind::bevel);
  for (int i = 0; i < planets; ++i) {
    train.mesh(2, 4 + i, 27, 35, MeshKind::external);
    train.mesh(4 + i, 0, 35, 99, MeshKind::internal);
  }
  train.inputs({{4 + planets, "1"}});
  return train.build();
}

/// NREL's 750 kW wind turbine gearbox: planetary set 21, 39, 99 with three planets, 82 on 23, 88 on 22.
/// Links: 1 sun with the gear of 82, 2 carrier (rotor), 3 intermediate, 4 high-speed shaft, 5..7 planets.
Mechanism windTurbine() {
  TrainSketch train(7);
  train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "c").joint(0, 4, "d");
  for (int i = 0; i < 3; ++i) train.joint(2, 5 + i, "p" + std::to_string(i));
  for (int i = 0; i < 3; ++i)
    train.mesh(1, 5 + i, 21, 39, MeshKind::external).mesh(5 + i, 0, 39, 99, MeshKind::internal);
  train.mesh(1, 3, 82, 23, MeshKind::external).mesh(3, 4, 88, 22, MeshKind::external);
  train.inputs({{9, "1"}});
  return train.build();
}

}  // namespace

class FrequencyLinesTest : public QObject {
  Q_OBJECT

 private slots:
  void helicopterGearboxHasThePublishedFrequencies() {
    // N. Sawalhi, Vibration Sideband Modulations and Harmonics Separation of a Planetary Helicopter Gearbox,
    // Advances in Acoustics and Vibration 2016, 9820768, Table 1: input 100 Hz, 17.45 : 1, carrier 5.73 Hz.
    for (const int planets : {3, 4}) {
      const Worked worked(bell206(planets));
      const auto lines = frequenciesOf(worked, frequencyRates(worked), 1);
      const Rational carrier = frequencyOfLink(lines, FrequencyKind::shaft, 3);
      QCOMPARE(carrier, Rational(19 * 27, 71 * 126));
      QVERIFY(isNearHertz(carrier, 100, 5.73, 0.005));
      QVERIFY(std::abs(carrier.inverse().toDouble() - 17.45) < 0.02);
      QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, 0), Rational(19));  // 1900 Hz
      // Epicyclic tooth mesh = ring teeth times carrier, of sun and ring alike.
      QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, 1), Rational(99) * carrier);
      QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, 2), Rational(99) * carrier);
      QCOMPARE(frequencyOfLink(lines, FrequencyKind::planetPass, 0), Rational(planets) * carrier);
      // The lines beside the epicyclic mesh by which the paper tells three planets from four.
      QCOMPARE(sidebandOf(lines, 2, 0, 1, planets), Rational(99 + planets) * carrier);
      QCOMPARE(sidebandOf(lines, 2, 0, -1, planets), Rational(99 - planets) * carrier);
      // 99 = 0 modulo 3: with three planets there is a line at the mesh itself; 99 + 1 = 100 = 0 modulo 4.
      QCOMPARE(sidebandOf(lines, 2, 0, 1, 0), Rational(100) * carrier);
    }
  }

  void windTurbineGearboxHasThePublishedFrequencies() {
    // Tooth counts and ratio 1 : 81.491 of NREL/TP-5000-51885, 2011; f_m = N_r f_c, planet pass n f_c, sun
    // n f_m/N_s: C. Molina Vicuna, Ingeniare 22(1), 2014, 88-98. At 1800 rpm of the high-speed shaft.
    const Worked worked(windTurbine());
    const auto lines = frequenciesOf(worked, frequencyRates(worked), 4);
    const Rational carrier = frequencyOfLink(lines, FrequencyKind::shaft, 2);
    QVERIFY(std::abs(carrier.inverse().toDouble() - 81.491) < 0.0005);
    QCOMPARE(carrier, Rational(161, 13120));
    const Rational mesh = Rational(99) * carrier;
    for (int each = 0; each < 6; ++each)
      QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, each), mesh);
    QVERIFY(isNearHertz(mesh, 30, 36.45, 0.005));
    QVERIFY(isNearHertz(frequencyOfMesh(lines, FrequencyKind::toothMesh, 6), 30, 172.5, 1e-9));
    QVERIFY(isNearHertz(frequencyOfMesh(lines, FrequencyKind::toothMesh, 7), 30, 660, 1e-9));
    QCOMPARE(frequencyOfLink(lines, FrequencyKind::planetPass, 0), Rational(3) * carrier);
    QCOMPARE(frequencyOfLink(lines, FrequencyKind::planetPass, 1), Rational(3) * mesh / Rational(21));
    // Planets on their pins.
    const auto pin = [](const FrequencyLine& line) { return int{*line.joint} == 4; };
    QCOMPARE(lineRatio(lines, FrequencyKind::joint, pin), mesh / Rational(39));
    // Three common factors of 21 and 39; 23 and 82 have none: every tooth meets every other.
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::assemblyPhase, 0), mesh / Rational(3));
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::huntingTooth, 0), mesh / Rational(273));
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::assemblyPhase, 6),
             frequencyOfMesh(lines, FrequencyKind::toothMesh, 6));
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::huntingTooth, 6),
             frequencyOfMesh(lines, FrequencyKind::toothMesh, 6) / Rational(82 * 23));
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::huntingTooth, 7), Rational(1, 4));  // 22 divides 88
  }

  void planetDrawnAloneStandsForAsManyAsSaid() {
    const Worked worked(example("planetary-ring-held"));
    const ByJoint<Rational> rates = frequencyRates(worked);
    const auto alone = frequenciesOf(worked, rates, 1);
    const Rational carrier = frequencyOfLink(alone, FrequencyKind::shaft, 2);
    QCOMPARE(carrier, Rational(2, 7));
    QCOMPARE(frequencyOfLink(alone, FrequencyKind::planetPass, 0), carrier);
    FrequencyOptions options;
    options.planets = 3;
    QCOMPARE(frequencyOfLink(frequenciesOf(worked, rates, 1, options), FrequencyKind::planetPass, 0),
             Rational(3) * carrier);
    // Several that are drawn are counted.
    const Worked three(windTurbine());
    options.planets = 7;
    QCOMPARE(frequencyOfLink(frequenciesOf(three, frequencyRates(three), 2, options),
                             FrequencyKind::planetPass, 0),
             Rational(3));
  }

  void harmonicsAndSidebandsAreAsManyAsAsked() {
    const Worked worked(example("spur-pair"));
    const ByJoint<Rational> rates = frequencyRates(worked);
    for (const int harmonics : {1, 4}) {
      for (const int sidebands : {0, 1, 3}) {
        const auto lines = frequenciesOf(worked, rates, 1, {harmonics, sidebands, 1});
        const auto count = [&](FrequencyKind kind) {
          return std::count_if(lines.begin(), lines.end(),
                               [&](const auto& each) { return each.kind == kind; });
        };
        QCOMPARE(count(FrequencyKind::toothMesh), harmonics);
        QCOMPARE(count(FrequencyKind::sideband), harmonics * sidebands * 4);
      }
    }
    const auto lines = frequenciesOf(worked, rates, 1, {3, 2, 1});
    const Rational mesh = frequencyOfMesh(lines, FrequencyKind::toothMesh, 0);
    for (const FrequencyLine& line : lines) {
      if (line.kind == FrequencyKind::toothMesh) QCOMPARE(line.ratio, Rational(line.harmonic) * mesh);
      if (line.kind != FrequencyKind::sideband) continue;
      const Rational shaft = frequencyOfLink(lines, FrequencyKind::shaft, *line.link);
      QCOMPARE(line.ratio, (Rational(line.harmonic) * mesh + Rational(line.sideband) * shaft).abs());
    }
  }

  /// The frequency of each mesh from absolute speeds, where all axes are parallel.
  void meshFrequencyIsTeethTimesSpeedAgainstTheCarrier() {
    int compared = 0;
    for (const std::string& name : exampleNames()) {
      const Mechanism mechanism = example(name);
      const Placement placement = placementOf(mechanism);
      if (!placement.tree || std::any_of(placement.meshes.begin(), placement.meshes.end(),
                                         [](const auto& mesh) { return !mesh.has_value(); }))
        continue;
      const Worked worked(mechanism);
      if (!worked.analysis.solution) continue;
      const ByJoint<Rational> rates = frequencyRates(worked);
      const auto speedOf = [&](LinkOrdinal link) -> std::optional<Rational> {
        const auto about = absoluteSpeed(worked.placement, rates, link);
        if (about.size() > 1) return std::nullopt;
        if (about.empty()) return Rational(0);
        const int sign = directionSign(worked.placement, about[0].axisGroup, 0);
        return sign == 0 ? std::nullopt : std::optional(Rational(sign) * about[0].speed);
      };
      const auto lines = frequencyLines(mechanism, worked.placement, worked.model, {rates}, Rational(1));
      for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
        const MeshGeometry& geometry = *worked.placement.meshes[MeshOrdinal(mesh)];
        const auto tail = speedOf(geometry.tail);
        const auto carrier = speedOf(geometry.carrier);
        const bool isPlanar = directionSign(worked.placement, geometry.tailClass, geometry.headClass) != 0;
        if (!tail || !carrier || !isPlanar || !touches(geometry.kind)) continue;
        const Rational speed = (*tail - *carrier).abs();
        QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, mesh),
                 Rational(geometry.tailTeeth) * speed);
        ++compared;
      }
    }
    QVERIFY(compared >= 20);
  }

  void everyStateHasLinesAndIdleLinksHaveNone() {
    for (const std::string& name :
         {std::string("simpson"), std::string("ravigneaux"), std::string("eight-speed-gearbox")}) {
      const Worked worked(example(name));
      const auto states = solveStates(worked.mechanism, worked.model, worked.placement, false);
      for (const StateSolution& state : *states) {
        QVERIFY(state.isSolved());
        const FrequencyMotion motion{state.rates, state.idleRates};
        const LinkOrdinal drive = [&] {
          const auto& links = worked.mechanism.links;
          const auto& wanted = worked.mechanism.states[static_cast<std::size_t>(state.state)].drive;
          return LinkOrdinal(
              std::find_if(links.begin(), links.end(), [&](const Link& link) { return link.id == *wanted; }) -
              links.begin());
        }();
        const auto speed = shaftSpeed(worked.placement, motion, drive);
        QVERIFY(speed && *speed == Rational(1));
        const auto lines = frequencyLines(worked.mechanism, worked.placement, worked.model, motion, *speed);
        QCOMPARE(frequencyOfLink(lines, FrequencyKind::shaft, drive), Rational(1));
        for (LinkOrdinal link = 1; link <= worked.mechanism.n(); ++link)
          QVERIFY(shaftSpeed(worked.placement, motion, link));
      }
    }
  }

  void whatTurnsFreelyHasNoFrequency() {
    TrainSketch train(6);
    train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a").joint(3, 4, "p").joint(0, 5, "q").joint(0, 6,
                                                                                                     "r");
    train.mesh(1, 4, 24, 18, MeshKind::external).mesh(4, 2, 18, 60, MeshKind::internal);
    train.mesh(5, 6, 20, 30, MeshKind::external);  // nothing drives this pair
    Mechanism mechanism = train.build();
    addBrake(mechanism, "B", 2);
    addState(mechanism, "1", {"B"}, 1, 3);
    const Worked worked(mechanism);
    const auto states = solveStates(worked.mechanism, worked.model, worked.placement, false);
    const StateSolution& state = states->front();
    QVERIFY(state.isSolved());
    const FrequencyMotion motion{state.rates, state.idleRates};
    QVERIFY(!shaftSpeed(worked.placement, motion, 5));
    const auto lines = frequencyLines(worked.mechanism, worked.placement, worked.model, motion, Rational(1));
    QCOMPARE(frequencyOfLink(lines, FrequencyKind::shaft, 3), Rational(2, 7));
    QCOMPARE(frequencyOfMesh(lines, FrequencyKind::toothMesh, 1), Rational(120, 7));
    for (const FrequencyLine& line : lines) {
      QVERIFY(!line.mesh || int{*line.mesh} != 2);
      QVERIFY(!line.link || int{*line.link} < 5);
    }
  }
};

QTEST_APPLESS_MAIN(FrequencyLinesTest)
#include "test_frequency_lines.moc"
