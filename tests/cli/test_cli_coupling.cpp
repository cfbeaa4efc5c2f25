#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/foundations/base/rational.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using test::parsed;
using test::Run;
using test::run;

namespace {

using FractionRows = std::vector<std::vector<Rational>>;

QString coupledExample(const char* name) {
  return QString::fromStdString(test::examplePath(name));
}
FractionRows fractionsOf(const nlohmann::json& rows) {
  FractionRows result;
  for (const auto& row : rows) {
    result.emplace_back();
    for (const auto& entry : row) result.back().push_back(*Rational::fromText(entry.get<std::string>()));
  }
  return result;
}
FractionRows productOf(const FractionRows& a, const FractionRows& b) {
  FractionRows result(a.size(), std::vector<Rational>(b.front().size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.front().size(); ++j) {
      for (std::size_t k = 0; k < b.size(); ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}
FractionRows transposeOf(const FractionRows& rows) {
  FractionRows result(rows.front().size(), std::vector<Rational>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) result[j][i] = rows[i][j];
  }
  return result;
}
FractionRows unitOf(std::size_t size) {
  FractionRows result(size, std::vector<Rational>(size));
  for (std::size_t i = 0; i < size; ++i) result[i][i] = Rational(1);
  return result;
}
std::vector<int> labelsOf(const nlohmann::json& joints) {
  std::vector<int> labels;
  for (const auto& joint : joints) labels.push_back(joint["label"].get<int>());
  return labels;
}
Run program(const QString& name, const QStringList& words) {
  QProcess process;
  process.start(name, words);
  if (!process.waitForFinished(120'000)) return {-1, {}, "did not end"};
  return {process.exitCode(), process.readAllStandardOutput().toStdString(),
          process.readAllStandardError().toStdString()};
}

}  // namespace

class CliCouplingTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_place;
  [[nodiscard]] QString file(const char* name) const { return m_place.filePath(QString::fromLatin1(name)); }

 private slots:
  void rangeOfTwoMotorsHasItsCornersWhereLimitsMeet() {
    const Run drawn = run({"export", coupledExample("robot"), "--to", "svg", "--view", "motors", "-o", "-"});
    QCOMPARE(drawn.status, 0);
    const QString svg = QString::fromStdString(drawn.output);
    for (const char* text : {"motor 8, degrees", "motor 9, degrees", "joint 10 at 170", "joint 12 at -110"})
      QVERIFY2(svg.contains(text), text);
    QVERIFY(svg.contains("those of joints 14"));  // it turns with motor 11 only
    const auto coupling = parsed(run({"export", coupledExample("robot"), "--to", "coupling", "-o", "-"}));
    const FractionRows gains = fractionsOf(coupling["motorToJoint"]);
    static const QRegularExpression kCorner("\\((-?[0-9./]+); (-?[0-9./]+)\\)");
    int corners = 0;
    for (auto found = kCorner.globalMatch(svg); found.hasNext(); ++corners) {
      const QRegularExpressionMatch corner = found.next();
      const Rational x = *Rational::fromText(corner.captured(1).toStdString());
      const Rational y = *Rational::fromText(corner.captured(2).toStdString());
      int met = 0;
      for (std::size_t joint = 0; joint < gains.size(); ++joint) {
        const auto& own = coupling["limits"]["joints"][joint];
        const Rational angle = gains[joint][0] * x + gains[joint][1] * y;
        const Rational low = *Rational::fromText(own["low"].get<std::string>());
        const Rational high = *Rational::fromText(own["high"].get<std::string>());
        QVERIFY(low <= angle && angle <= high);
        met += angle == low || angle == high ? 1 : 0;
      }
      QCOMPARE(met, 2);
    }
    QCOMPARE(corners, 4);
    const Run one =
        run({"export", coupledExample("spur-pair"), "--to", "svg", "--view", "motors", "-o", "-"});
    QVERIFY(QString::fromStdString(one.output).contains("There are not two motors."));
  }

  /// Rows 10, 12 and 14 of Eq. (45), which the chain to the end-effector has.
  void theRobotsChainIsThatOfItsHand() {
    const Run call = run({"export", kRobotFile(), "--to", "coupling", "-o", "-"});
    QCOMPARE(call.status, 0);
    const auto json = parsed(call);
    QCOMPARE(labelsOf(json["motors"]), (std::vector<int>{8, 9, 11}));
    QCOMPARE(labelsOf(json["joints"]), (std::vector<int>{10, 12, 14}));
    QCOMPARE(json["motorToJoint"],
             (nlohmann::json{{"-1/2", "0", "0"}, {"-1/3", "-2/3", "0"}, {"-8/27", "-16/27", "-8/9"}}));
    const FractionRows a = fractionsOf(json["motorToJoint"]), inverse = fractionsOf(json["jointToMotor"]);
    QVERIFY(productOf(a, inverse) == unitOf(3));
    QVERIFY(fractionsOf(json["jointToMotorTorque"]) == transposeOf(a));
    QVERIFY(fractionsOf(json["motorToJointTorque"]) == transposeOf(inverse));
    const auto sum = [&](const char* rates, const char* torques) {
      const FractionRows w = fractionsOf(nlohmann::json::array({json["test"][rates]})),
                         m = fractionsOf(nlohmann::json::array({json["test"][torques]}));
      return productOf(w, transposeOf(m)).front().front();
    };
    QVERIFY(sum("motorRates", "motorTorques") == sum("jointRates", "jointTorques"));
    QCOMPARE(sum("motorRates", "motorTorques").toString(), json["test"]["power"].get<std::string>());
    QVERIFY(!sum("motorRates", "motorTorques").isZero());
  }

  void theHeaderCompilesWithItsTestAndTheModuleRuns() {
    for (const char* name : {"robot", "bevel-differential", "ravigneaux"}) {
      QCOMPARE(run({"export", coupledExample(name), "--to", "coupling", "--as", "header", "-o", file("a.h")})
                   .status,
               0);
      QCOMPARE(run({"export", coupledExample(name), "--to", "coupling", "--as", "python", "-o", file("a.py")})
                   .status,
               0);
      const Run compiled =
          program("c++", {"-std=c++17", "-Wall", "-Werror", "-fsyntax-only", "-x", "c++", file("a.h")});
      QVERIFY2(compiled.status == 0 || compiled.errors.find("#pragma once") != std::string::npos,
               compiled.errors.c_str());
      const Run tested = program("python3", {file("a.py")});
      QVERIFY2(tested.status == 0, tested.errors.c_str());
      QVERIFY(tested.output.find("power in = power out = ") == 0);
    }
  }

  /// A header that was tampered with does not compile: the test in it is one.
  void theHeadersTestFindsAWrongNumber() {
    QCOMPARE(run({"export", kRobotFile(), "--to", "coupling", "--as", "header", "-o", file("b.h")}).status,
             0);
    QFile header(file("b.h"));
    QVERIFY(header.open(QIODevice::ReadWrite));
    QByteArray text = header.readAll();
    const auto at = text.indexOf("-1.0 / 2.0");
    QVERIFY(at > 0);
    text.replace(at, 10, "-1.0 / 3.0");
    header.resize(0);
    header.seek(0);
    header.write(text);
    header.close();
    QVERIFY(program("c++", {"-std=c++17", "-fsyntax-only", "-x", "c++", file("b.h")}).status != 0);
  }

  void kindsOfRos2AreFound() {
    const Run robot = run({"export", kRobotFile(), "--to", "coupling", "--as", "ros2", "-o", "-"});
    QCOMPARE(robot.status, 0);
    QVERIFY(robot.output.find("your_package/LinearTransmission") != std::string::npos);
    const Run pair =
        run({"export", coupledExample("spur-pair"), "--to", "coupling", "--as", "ros2", "-o", "-"});
    QVERIFY(pair.output.find("transmission_interface/SimpleTransmission") != std::string::npos);
    // Both axles of a differential drive its case and its pinion: the sum and the difference.
    QFile example(coupledExample("bevel-differential"));
    QVERIFY(example.open(QIODevice::ReadOnly));
    auto axles = nlohmann::json::parse(example.readAll().toStdString());
    axles["inputs"] = nlohmann::json::array({{{"joint", "7"}, {"speed", 1}}, {{"joint", "8"}, {"speed", 2}}});
    QFile driven(file("axles.geargraph"));
    QVERIFY(driven.open(QIODevice::WriteOnly));
    driven.write(QByteArray::fromStdString(axles.dump()));
    driven.close();
    const Run shaft = run({"export", file("axles.geargraph"), "--to", "coupling", "--as", "ros2", "-o", "-"});
    QCOMPARE(shaft.status, 0);
    QVERIFY2(shaft.output.find("transmission_interface/DifferentialTransmission") != std::string::npos,
             shaft.output.c_str());
  }

  void jointsMayBeNamedAndWrongOnesAreRefused() {
    const Run named = run({"export", kRobotFile(), "--to", "coupling", "--outputs", "14,10,12", "-o", "-"});
    QCOMPARE(labelsOf(parsed(named)["joints"]), (std::vector<int>{14, 10, 12}));
    const auto refused = [&](const char* joints, int status, const char* words) {
      const Run call = run({"export", kRobotFile(), "--to", "coupling", "--outputs",
                            QString::fromLatin1(joints), "-o", file("no.json")});
      return call.status == status && call.errors.find(words) != std::string::npos &&
             !QFile::exists(file("no.json"));
    };
    QVERIFY(refused("10,12", 1, "as many joints"));
    QVERIFY(refused("10,12,12", 2, "named twice"));
    QVERIFY(refused("10,12,99", 2, "no turning joint \"99\""));
    QVERIFY(refused("8,10,12", 1, "do not determine"));  // 10 follows from 8
  }

  /// Limits of joints bound the motors: at -1/2 of the motor's angle, 30 degrees are 60 of it.
  void limitsOfJointsBecomeLimitsOfMotors() {
    QFile robot(kRobotFile());
    QVERIFY(robot.open(QIODevice::ReadOnly));
    auto document = nlohmann::json::parse(robot.readAll().toStdString());
    for (auto& joint : document["turningJoints"]) {
      if (joint["id"] == "10") joint["limits"] = nlohmann::json::array({-10, 30});
      if (joint["id"] == "12" || joint["id"] == "14") joint["limits"] = nlohmann::json::array({-40, 40});
    }
    QFile limited(file("limited.geargraph"));
    QVERIFY(limited.open(QIODevice::WriteOnly));
    limited.write(QByteArray::fromStdString(document.dump()));
    limited.close();
    const auto json = parsed(run({"export", file("limited.geargraph"), "--to", "coupling", "-o", "-"}));
    QCOMPARE(json["limits"]["motors"][0], (nlohmann::json{{"low", "-60"}, {"high", "20"}}));
    const FractionRows inverse = fractionsOf(json["jointToMotor"]);
    const FractionRows corners = fractionsOf(json["limits"]["corners"]);
    QCOMPARE(corners.size(), std::size_t(8));
    for (std::size_t motor = 0; motor < 3; ++motor) {
      Rational low = corners[0][motor], high = low;
      for (const auto& corner : corners) {
        if (corner[motor] < low) low = corner[motor];
        if (high < corner[motor]) high = corner[motor];
      }
      QCOMPARE(low.toString(), json["limits"]["motors"][motor]["low"].get<std::string>());
      QCOMPARE(high.toString(), json["limits"]["motors"][motor]["high"].get<std::string>());
    }
    const auto open = parsed(run({"export", coupledExample("spur-pair"), "--to", "coupling", "-o", "-"}));
    QVERIFY(open["limits"]["corners"].is_null() && open["limits"]["motors"][0]["low"].is_null());
  }

 private:
  static QString kRobotFile() { return test::kRobot; }
};

QTEST_GUILESS_MAIN(CliCouplingTest)
#include "test_cli_coupling.moc"
