#include <QTest>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/machine/train/train.h"
#include "core/theory/analysis/analysis.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"
#include "tests/core/support/transformations.h"

using namespace geargraph;
using test::Transformation;

namespace {

using NamedDiagnostic =
    std::pair<std::string, std::set<std::string>>;  // code, elements in the original's names

/// What an analysis says of a mechanism, in the names of the original and free of the order of lists.
struct Verdict {
  int rank = -1;
  int dof = -1;
  std::multiset<NamedDiagnostic> diagnostics;
  std::map<std::string, Rational> rates;  // by joint
  std::map<std::string, double> radii;    // by mesh, in the original's length
  std::string messages;                   // to be read where something differs; not compared
};

bool operator==(const Verdict& a, const Verdict& b) {
  const auto radiiAgree = [&] {
    if (a.radii.size() != b.radii.size()) return false;
    return std::equal(a.radii.begin(), a.radii.end(), b.radii.begin(), [](const auto& x, const auto& y) {
      return x.first == y.first && std::abs(x.second - y.second) <= 1e-12 * std::abs(x.second);
    });
  };
  return a.rank == b.rank && a.dof == b.dof && a.diagnostics == b.diagnostics && a.rates == b.rates &&
         radiiAgree();
}

/// Which of several dependent meshes is called redundant, and which loop is said to lock, follows from the
/// order of the list; so in these diagnostics the meshes are not compared.
bool meshesFollowFromOrder(Code code) {
  return code == Code::redundantMesh || code == Code::locked || code == Code::deadJoint ||
         code == Code::assembly;
}

/// Routing of bodies prefers the positive end of an axis and the earlier of equal choices: a train some of
/// whose axes point the other way, or that is listed in another order, may get other bodies.
bool isOfBodies(const Diagnostic& diagnostic) {
  return diagnostic.detail == Detail::bodiesOverlap;
}

class Names {
 public:
  Names(const Mechanism& original, const Transformation& to) {
    add(ElementKind::link, original.links, to.linkIds);
    add(ElementKind::axis, original.axes, to.axisIds);
    add(ElementKind::turningJoint, original.turningJoints, to.jointIds);
    add(ElementKind::gearMesh, original.gearMeshes, to.meshIds);
  }
  [[nodiscard]] std::string of(const ElementId& element) const {
    const auto found = m_names.find({element.kind, element.id.text()});
    const std::string name = found == m_names.end() ? element.id.text() : found->second;
    return std::string(listName(element.kind)) + " " + name;
  }

 private:
  template <class List>
  void add(ElementKind kind, const List& list, const std::vector<InternedString>& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) m_names[{kind, ids[i].text()}] = list[i].id.text();
  }
  std::map<std::pair<ElementKind, std::string>, std::string> m_names;
};

Verdict verdictOf(const Mechanism& original, const Transformation& to, bool withTeeth, bool withBodies) {
  const Names names(original, to);
  const SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(to.mechanism));
  Verdict verdict;
  Diagnostics diagnostics = live->diagnostics;
  if (withTeeth) {
    const Diagnostics teeth = geometryDiagnostics(*live);
    diagnostics.insert(diagnostics.end(), teeth.begin(), teeth.end());
  }
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!withBodies && isOfBodies(diagnostic)) continue;
    std::set<std::string> elements;
    for (const ElementId& element : diagnostic.elements) {
      if (element.kind != ElementKind::gearMesh || !meshesFollowFromOrder(diagnostic.code))
        elements.insert(names.of(element));
    }
    verdict.messages += "\n    " + diagnostic.message;
    verdict.diagnostics.emplace(codeName(diagnostic.code), std::move(elements));
  }
  if (live->kinematics) {
    for (int m = 0; m < to.mechanism.c(); ++m) {
      const auto& mesh = live->kinematics->placement().meshes[static_cast<std::size_t>(m)];
      const ElementId id = to.mechanism.gearMeshes[static_cast<std::size_t>(m)].id;
      const double size = to.length.toDouble();
      if (!mesh) continue;
      verdict.radii[names.of(id) + " smaller"] =
          std::min(std::abs(mesh->tailRadius), std::abs(mesh->headRadius)) / size;
      verdict.radii[names.of(id) + " larger"] =
          std::max(std::abs(mesh->tailRadius), std::abs(mesh->headRadius)) / size;
    }
  }
  const MatroidAnalysis* matroid = live->matroid();
  if (matroid == nullptr) return verdict;
  verdict.rank = matroid->rank;
  verdict.dof = matroid->dof;
  if (!matroid->solution || hasErrors(live->diagnostics)) return verdict;
  const auto exact = solveExact(*live->kinematics->model, matroid->choice.joints, matroid->speeds);
  for (std::size_t j = 0; j < exact->rates.size(); ++j) {
    const TurningJoint& joint = to.mechanism.turningJoints[j];
    const int sign = to.jointSigns.empty() ? 1 : to.jointSigns[j];
    verdict.rates[names.of(ElementId(joint.id))] = Rational(sign) * exact->rates[j];
  }
  return verdict;
}

QString text(const Verdict& verdict) {
  std::string all = "rank " + std::to_string(verdict.rank) + ", dof " + std::to_string(verdict.dof);
  for (const auto& [code, elements] : verdict.diagnostics) {
    all += "; " + code;
    for (const std::string& element : elements) all += " " + element;
  }
  for (const auto& [joint, rate] : verdict.rates) all += "; " + joint + " = " + rate.toString();
  for (const auto& [mesh, radius] : verdict.radii) all += "; " + mesh + " " + std::to_string(radius);
  return QString::fromStdString(all + verdict.messages);
}

/// The inputs that the program chooses, written down: its choice follows the order of the joints.
Mechanism withInputsWritten(Mechanism mechanism) {
  if (mechanism.inputs) return mechanism;
  const SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(mechanism));
  if (live->matroid() == nullptr) return mechanism;
  mechanism.inputs.emplace();
  for (const int joint : live->matroid()->choice.joints) {
    mechanism.inputs->push_back(
        {mechanism.turningJoints[static_cast<std::size_t>(joint)].id, Number(std::int64_t{1}), {}});
  }
  return mechanism;
}

/// Inputs and pitch points are written down first: what a document leaves open is chosen by the order of its
/// lists and by tail and head.
void compare(const Mechanism& given, std::uint64_t seed, bool withTeeth) {
  const Mechanism mechanism = withInputsWritten(test::withPitchPointsWritten(given));
  const Verdict withBodies = verdictOf(mechanism, {"", mechanism}, withTeeth, true);
  const Verdict withoutBodies = verdictOf(mechanism, {"", mechanism}, withTeeth, false);
  for (const Transformation& to : test::transformationsOf(mechanism, seed)) {
    const bool sameBodies = to.keepsOrder && to.keepsDirections;
    const Verdict& expected = sameBodies ? withBodies : withoutBodies;
    const Verdict found = verdictOf(mechanism, to, withTeeth, sameBodies);
    if (found == expected) continue;
    qWarning().noquote() << "expected" << text(expected);
    qWarning().noquote() << "found" << text(found);
    QFAIL(to.name.c_str());
  }
}

}  // namespace

/// What a mechanism is does not depend on where it is, how large, in what order it is written or how its
/// arrows point.
class TransformationsTest : public QObject {
  Q_OBJECT
 private slots:
  void everyExampleIsTheSameTrainHoweverItIsWritten_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : test::exampleNames())
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
  }
  void everyExampleIsTheSameTrainHoweverItIsWritten() {
    QFETCH(QString, name);
    compare(test::example(name.toStdString()), 1, true);
  }

  void everyTextbookTrainIsTheSameTrainHoweverItIsWritten() {
    for (const test::TextbookTrain& train : test::textbookTrains()) compare(train.mechanism, 2, true);
  }

  void everyRandomTrainIsTheSameTrainHoweverItIsWritten() {
    std::vector<std::uint64_t> seeds(60);
    std::iota(seeds.begin(), seeds.end(), 1);
    seeds.insert(seeds.end(), {100, 101});  // modules of 2 and 400 beside each other
    for (const std::uint64_t seed : seeds) {
      const int links = 3 + static_cast<int>(seed % 12);
      compare(test::randomTrain(seed, links, links - 1 - static_cast<int>(seed % 3)), seed, true);
      if (QTest::currentTestFailed()) {
        qWarning() << "random train" << seed;
        return;
      }
    }
  }
};

QTEST_GUILESS_MAIN(TransformationsTest)
#include "test_transformations.moc"
