#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using nlohmann::json;
using test::kRobot;
using test::parsed;
using test::Run;
using test::run;

namespace {

const QString kPlanetary = QString::fromStdString(test::examplePath("planetary-ring-held"));

}  // namespace

class CliDynamicsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyLinkHasItsMassAndItsShareOfTheInertia() {
    const Run call = run({"dynamics", kRobot, "--json"});
    QCOMPARE(call.status, 0);
    const json report = parsed(call);
    QCOMPARE(report["format"], "geargraph-dynamics");
    QCOMPARE(report["inputs"], json({8, 9, 11}));
    QCOMPARE(report["links"].size(), std::size_t{7});
    QVERIFY(report["simulation"].is_null());
    for (std::size_t input = 0; input < 3; ++input) {
      double sum = 0;
      for (const json& link : report["links"]) {
        QVERIFY(link["mass"].get<double>() > 0.01);
        QCOMPARE(link["source"], "solids");
        sum += link["reflected"][input].get<double>();
      }
      QVERIFY(std::abs(sum / report["inertia"][input][input].get<double>() - 1) < 1e-12);
    }
    const json light = parsed(run({"dynamics", kRobot, "--density", "3925", "--json"}));
    QVERIFY(
        std::abs(light["links"]["3"]["mass"].get<double>() * 2 / report["links"]["3"]["mass"].get<double>() -
                 1) < 1e-12);
  }

  // A constant torque: the speed is torque over inertia times time, and the work is the kinetic energy.
  void aMotionIsWrittenAsJsonAndCsv() {
    const QStringList torque{"--torque", "4=300Nmm", "--seconds", "0.5", "--interval", "0.1"};
    const json report = parsed(run(QStringList{"dynamics", kPlanetary, "--json"} + torque));
    QCOMPARE(report["accelerations"].size(), std::size_t{1});
    const double acceleration = 0.3 / report["inertia"][0][0].get<double>();
    QVERIFY(std::abs(report["accelerations"][0].get<double>() / acceleration - 1) < 1e-12);
    const json& simulation = report["simulation"];
    QCOMPARE(simulation["end"], "complete");
    QCOMPARE(simulation["columns"], json({"time", "angle 4", "speed 4", "acceleration 4", "torque 4",
                                          "kinetic", "potential", "work"}));
    QCOMPARE(simulation["rows"].size(), std::size_t{6});
    const json& last = simulation["rows"][5];
    QCOMPARE(last[0].get<double>(), 0.5);
    QVERIFY(std::abs(last[2].get<double>() / (acceleration * 0.5) - 1) < 1e-9);
    QVERIFY(std::abs(last[5].get<double>() / last[7].get<double>() - 1) < 1e-6);
    const QTemporaryDir folder;
    const QString path = folder.filePath("motion.csv");
    QCOMPARE(run(QStringList{"dynamics", kPlanetary, "-o", path} + torque).status, 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    QCOMPARE(lines.size(), 8);  // the heading, six samples, and behind the last line end
    QCOMPARE(lines[0], QByteArray(",time,angle 4,speed 4,acceleration 4,torque 4,kinetic,potential,work"));
    QCOMPARE(lines[6].split(',').at(1), QByteArray("0.5"));
  }

  void theLimitOfAJointEndsTheMotion() {
    const Run call = run({"dynamics", kRobot, "--torque", "9=0.2Nm", "--seconds", "10", "--json"});
    const json simulation = parsed(call)["simulation"];
    QCOMPARE(simulation["end"], "limit");
    QVERIFY(simulation["limitJoint"].get<int>() >= 8 && simulation["limitJoint"].get<int>() <= 14);
    QVERIFY(run({"dynamics", kRobot, "--torque", "9=0.2Nm", "--seconds", "10"})
                .output.find("reaches the end of its range") != std::string::npos);
  }

  void aStateHasAnInertiaOfItsOwn() {
    const QString gearbox = QString::fromStdString(test::examplePath("eight-speed-gearbox"));
    const auto inertia = [&](const char* state) {
      return parsed(run({"dynamics", gearbox, "--state", state, "--json"}))["inertia"][0][0].get<double>();
    };
    QVERIFY(inertia("1") > 0 && inertia("8") > 1.5 * inertia("1"));  // a high gear feels more of the output
  }

  void whatIsWrongIsSaid() {
    for (const QStringList& wrong : {QStringList{"--torque", "8=heavy"},
                                     {"--torque", "10=1Nm"},
                                     {"--torque", "8"},
                                     {"--damping", "8=-1"},
                                     {"--density", "0"},
                                     {"--gravity", "9.81"},
                                     {"--seconds", "0"},
                                     {"--angle", "8=x"},
                                     {"--seconds", "100", "--interval", "0.000001"}}) {
      const Run call = run(QStringList{"dynamics", kRobot} + wrong);
      QCOMPARE(call.status, 2);
      QVERIFY2(call.errors.find("geargraph-cli dynamics") != std::string::npos, call.errors.c_str());
      QVERIFY(call.output.empty());
    }
    QCOMPARE(run({"dynamics"}).status, 2);
    QCOMPARE(run({"dynamics", "no-such-file"}).status, 2);
    const Run broken =
        run({"dynamics", QString::fromStdString(test::examplePath("robot-to-mend")), "--json"});
    QCOMPARE(broken.status, 1);
    QVERIFY(parsed(broken)["inertia"].is_null() && !parsed(broken)["diagnostics"].empty());
  }

  void aTimeLimitEndsAMotion() {
    const Run call = run({"dynamics", kPlanetary, "--start-speed", "4=100000", "--torque", "4=1Nm",
                          "--seconds", "1000000", "--interval", "10", "--limit-seconds", "0.3"});
    QCOMPARE(call.status, 3);
    QVERIFY(call.output.empty());
  }
};

QTEST_GUILESS_MAIN(CliDynamicsTest)
#include "test_cli_dynamics.moc"
