#include <QTest>
#include <QXmlStreamReader>
#include <memory>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/presentation/simulators/simulator_model.h"
#include "core/presentation/simulators/xml_text.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/trains.h"

namespace geargraph {
namespace {

using Made = std::variant<SimulatorModel, SimulatorError>;

Made made(Mechanism mechanism, const SimulatorOptions& options = {}, const std::stop_token& stop = {}) {
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(std::move(mechanism)));
  return simulatorModel(*snapshot, *snapshot->geometry->train(), options, stop);
}
SimulatorModel modelOf(Mechanism mechanism) {
  Made result = made(std::move(mechanism));
  if (const auto* error = std::get_if<SimulatorError>(&result)) qFatal("%s", error->message.c_str());
  return std::get<SimulatorModel>(std::move(result));
}

Mechanism robotWithWorld() {
  Mechanism robot = test::robot();
  const auto rename = [](LinkId& id) {
    if (id == LinkId("3")) id = LinkId("world");
  };
  for (Link& link : robot.links) rename(link.id);
  for (TurningJoint& joint : robot.turningJoints) {
    rename(joint.tail);
    rename(joint.head);
  }
  for (GearMesh& mesh : robot.gearMeshes) {
    rename(mesh.tail);
    rename(mesh.head);
  }
  return robot;
}

/// The elements of a name, each with its attributes; a text that is no XML gives none.
std::vector<QXmlStreamAttributes> elements(const std::string& xml, const char* name) {
  std::vector<QXmlStreamAttributes> found;
  QXmlStreamReader reader(QByteArray::fromStdString(xml));
  while (!reader.atEnd()) {
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QLatin1String(name))
      found.push_back(reader.attributes());
  }
  return reader.hasError() ? std::vector<QXmlStreamAttributes>() : found;
}

}  // namespace

class SimulatorsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyMeshIsATendonOverItsCycle() {
    const std::string xml = mjcfText(modelOf(test::robot()), {});
    QCOMPARE(elements(xml, "body").size(), std::size_t{7});
    QCOMPARE(elements(xml, "fixed").size(), std::size_t{4});
    QCOMPARE(elements(xml, "velocity").size(), std::size_t{3});
    std::size_t terms = 0;
    for (const QXmlStreamAttributes& joint : elements(xml, "joint"))
      terms += joint.hasAttribute(QStringLiteral("coef")) ? 1 : 0;
    QCOMPARE(terms, std::size_t{10});  // the entries of P
  }

  // Slip along the pitch circles: the coefficients are the pitch radii in metres, in the ratio of the teeth.
  void coefficientsArePitchRadii() {
    const SimulatorModel model = modelOf(test::robot());
    const SimulatedRow& row = model.rows[1];  // mesh 16, 20 and 30 teeth, module 2
    QCOMPARE(row.name, std::string("mesh 16"));
    QCOMPARE(row.joints.size(), std::size_t{3});
    QCOMPARE(std::abs(row.joints[0].second), 0.02);
    QCOMPARE(row.joints[1].second, -row.joints[0].second);
    QCOMPARE(std::abs(row.joints[2].second), 0.03);
  }

  void aJointAgainstTheTreeKeepsItsAngle() {
    test::TrainBuilder train("reversed");
    train.linkReversed(0, train.axis({0, 0, 0}, {0, 0, 1}));
    train.input(0);
    const SimulatorModel model = modelOf(train.mechanism());
    QCOMPARE(model.links[1].axis.z(), -1.0);  // the link turns the other way round
  }

  void couplingsHoldWhereTheyAreEngaged() {
    Mechanism gearbox = test::example("eight-speed-gearbox");
    gearbox.engaged = {gearbox.couplings.front().id};
    const SimulatorModel model = modelOf(std::move(gearbox));
    int active = 0;
    int idle = 0;
    for (const SimulatedRow& row : model.rows) {
      if (!row.name.starts_with("coupling")) continue;
      ++(row.isActive ? active : idle);
    }
    QCOMPARE(active, 1);
    QVERIFY(idle >= 4);
    QCOMPARE(elements(mjcfText(model, {}), "key").size(), std::size_t{1});
  }

  void limitsOfJointsAreWritten() {
    Mechanism robot = test::robot();
    QVERIFY(mjcfText(modelOf(robot), {}).find("range") == std::string::npos);
    robot.turningJoints[0].limits = {Number(-180), Number(90)};
    robot.turningJoints[1].limits = {{}, Number(360)};
    const std::string text = mjcfText(modelOf(robot), {});
    QStringList ranges;
    for (const QXmlStreamAttributes& joint : elements(text, "joint"))
      if (joint.hasAttribute("range")) ranges << joint.value("range").toString();
    QCOMPARE(ranges.size(), qsizetype{2});
    QVERIFY2(ranges.contains("-3.141592653589793 1.5707963267948966"), qPrintable(ranges.join(" | ")));
    QVERIFY2(ranges.contains("-1000000 6.283185307179586") || ranges.contains("-1e+06 6.283185307179586"),
             qPrintable(ranges.join(" | ")));
    const auto keys = elements(text, "key");
    QCOMPARE(keys.size(), std::size_t{2});
    QCOMPARE(keys[1].value("name").toString(), QString("back"));
    QVERIFY(keys[0].value("ctrl") != keys[1].value("ctrl"));
  }

  void motorsAreAsAskedFor() {
    const SimulatorModel model = modelOf(test::robot());
    SimulatorOptions options;
    options.motor = SimulatorMotor::torque;
    const std::string plain = mjcfText(model, options);
    QCOMPARE(elements(plain, "motor").size(), std::size_t{3});
    QVERIFY(plain.find("armature") == std::string::npos && elements(plain, "key").empty());
    options.motor = SimulatorMotor::none;
    QVERIFY(elements(mjcfText(model, options), "actuator").empty());
    options.motor = SimulatorMotor::speed;
    options.armature = 0.01;
    options.timestep = 0.0005;
    const std::string servos = mjcfText(model, options);
    QVERIFY(servos.find("armature=\"0.01\"") != std::string::npos);
    QVERIFY(servos.find("solref=\"0.001 1\"") != std::string::npos);
  }

  void urdfSaysWhatItCannotHold() {
    const auto text = urdfText(modelOf(test::robot()));
    const auto* error = std::get_if<SimulatorError>(&text);
    QVERIFY(error != nullptr);
    QCOMPARE(
        error->message,
        std::string(
            "A joint of URDF can follow one other joint. Joint 12 follows 8 and 9 (q12 = -1/3 q8 - 2/3 "
            "q9); Joint 13 follows 8, 9 and 11 (q13 = -4/9 q8 - 8/9 q9 - 4/3 q11); Joint 14 follows 8, 9 "
            "and 11 (q14 = -8/27 q8 - 16/27 q9 - 8/9 q11). Use --to mjcf, or --state with one freedom."));
  }

  void urdfHasAMimicForEveryFollower() {
    const auto text = urdfText(modelOf(test::example("planetary-ring-held")));
    const auto& xml = std::get<std::string>(text);
    const auto mimics = elements(xml, "mimic");
    QCOMPARE(mimics.size(), std::size_t{2});
    QCOMPARE(mimics[0].value(QStringLiteral("joint")).toString(), QStringLiteral("4"));
    QCOMPARE(mimics[0].value(QStringLiteral("multiplier")).toDouble(), 2.0 / 7);
    QCOMPARE(elements(xml, "link").size(), std::size_t{5});  // the world, the ground, three links
  }

  void namesOfUsersAreEscaped() {
    Mechanism robot = test::robot();
    robot.name = "a <b> & \"c\" -- d";
    const std::string xml = mjcfText(modelOf(robot), {});
    QCOMPARE(elements(xml, "mujoco").front().value(QStringLiteral("model")).toString(),
             QString::fromStdString(robot.name));
    QCOMPARE(xmlComment("a -- b ---"), std::string("<!-- a - - b - - -  -->"));
  }

  void aLinkCalledWorldGetsAnotherName() {
    const SimulatorModel model = modelOf(robotWithWorld());
    QCOMPARE(model.links[3].name, std::string("link world"));
    QCOMPARE(model.notes.size(), std::size_t{1});
    QCOMPARE(model.notes[0].text, std::string("The link \"world\" is written as \"link world\"."));
  }

  /// What the program shows is in its language; comments in the files are English, for other programs' users.
  void sentencesAreTranslatedAndFilesAreNot() {
    using test::PseudoLanguage;
    const Mechanism gearbox = test::example("planetary-ring-held");
    const std::string inEnglish = mjcfText(modelOf(gearbox), {});
    const SimulatorModel robot = modelOf(test::robot());
    const std::string refusal = std::get<SimulatorError>(urdfText(robot)).message;
    Mechanism tiny = test::robot();
    tiny.unit = "um";
    const std::string light = std::get<SimulatorError>(made(tiny)).message;
    const PseudoLanguage pseudo;
    QCOMPARE(mjcfText(modelOf(gearbox), {}), inEnglish);
    const auto words = [](const std::string& text) { return PseudoLanguage::english(text).size(); };
    const std::string there = std::get<SimulatorError>(urdfText(robot)).message;
    QVERIFY2(words(refusal) > 10 && words(there) == 0, there.c_str());
    const std::string lightThere = std::get<SimulatorError>(made(tiny)).message;
    QVERIFY2(words(light) > 10 && words(lightThere) == 0, lightThere.c_str());
  }

  void notesAreTranslatedAndCommentsAreNot() {
    const test::PseudoLanguage pseudo;
    const SimulatorModel model = modelOf(robotWithWorld());
    QCOMPARE(model.notes.size(), std::size_t{1});
    QVERIFY(test::PseudoLanguage::english(model.notes[0].text, {"world", "link"}).empty());
    const std::string comment = xmlComment("The link \"world\" is written as \"link world\".");
    QVERIFY(mjcfText(model, {}).find(comment) != std::string::npos);
  }

  void whatIsTooLightIsRejected() {
    Mechanism tiny = test::robot();
    tiny.unit = "um";
    const Made result = made(std::move(tiny));
    const auto* error = std::get_if<SimulatorError>(&result);
    QVERIFY(error != nullptr && error->message.find("too little mass") != std::string::npos);
    const Made massless = made(*withLinkMass(test::robot(), LinkId("3"), LinkMass{Number(0)}));
    QVERIFY(std::holds_alternative<SimulatorError>(massless));
    Mechanism unknown = test::robot();
    unknown.unit = "cubits";
    QVERIFY(std::holds_alternative<SimulatorError>(made(std::move(unknown))));
  }

  void aStopEndsIt() {
    std::stop_source stop;
    stop.request_stop();
    const Made result = made(test::robot(), {}, stop.get_token());
    QCOMPARE(std::get<SimulatorError>(result).kind, SimulatorError::Kind::stopped);
  }

  void numbersReadBackAsTheSameDouble() {
    for (const double value : {0.1, 1.0 / 3, -2.5e-17, 1e300, 0.0, -0.0})
      QCOMPARE(QByteArray::fromStdString(xmlNumber(value)).toDouble(), value);
    QCOMPARE(xmlNumber(-0.0), std::string("0"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::SimulatorsTest)
#include "test_simulators.moc"
