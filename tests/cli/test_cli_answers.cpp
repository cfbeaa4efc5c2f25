#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/cli/cli_run.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using nlohmann::json;
using test::parsed;
using test::Run;
using test::run;

namespace {

std::set<std::string> codesIn(const json& report) {
  std::set<std::string> codes;
  for (const json& diagnostic : report["diagnostics"]) codes.insert(diagnostic["code"].get<std::string>());
  return codes;
}

}  // namespace

/// What statics and the shift table answer, and what they leave out with a reason.
class CliAnswersTest : public QObject {
  Q_OBJECT

 private slots:
  /// 20/7 N m is the answer without losses; with them it depends on how the planets share.
  void lossesOfThreePlanets() {
    const QString file = QString::fromStdString(test::examplePath("three-planets"));
    const QStringList call{"statics", file, "--load", "link:2=-10Nm", "--eta", "0.95"};
    const Run asked = run(call + QStringList{"--json"});
    QCOMPARE(asked.status, 0);
    const json report = parsed(asked);
    QCOMPARE(report["balances"][0]["torque"], "1600/521");
    QCOMPARE(report["balances"][0]["assumed"], true);
    QCOMPARE(report["balances"][0]["range"], json({"1600/521", "1600/521"}));
    QCOMPARE(report["share"], "stiffness");
    QCOMPARE(report["shareAssumed"], true);
    QVERIFY(report["power"]["loss"] != "0");
    QVERIFY(asked.errors.find("given for equally stiff teeth, an assumption") != std::string::npos);
    const json open = parsed(run(call + QStringList{"--share", "none", "--json"}));
    QVERIFY(open["balances"].is_null() && open["meshes"].is_null() && open["power"].is_null());
    QVERIFY(codesIn(open).contains("statically-indeterminate"));
    Mechanism stated = test::example("three-planets");
    stated.sharing = LoadSharing::stiffness;
    const json document =
        parsed(run({"statics", saved(stated), "--load", "link:2=-10Nm", "--eta", "0.95", "--json"}));
    QCOMPARE(document["balances"][0]["torque"], "1600/521");
    QCOMPARE(document["shareAssumed"], false);
  }

  /// The torques of a motion that cannot happen are no answer.
  void aTrainThatLocksHasNoTorques() {
    const QString file = QString::fromStdString(test::examplePath("ferguson-paradox"));
    const auto statics = [&](const char* load, const QStringList& more) {
      return run(QStringList{"statics", file, "--load", load, "--eta", "0.99"} + more);
    };
    int locked = 0;
    for (const char* load : {"link:3=1Nm", "link:3=-1Nm"}) {
      const Run call = statics(load, {"--json"});
      const json report = parsed(call);
      if (!codesIn(report).contains("self-locking")) continue;
      ++locked;
      QCOMPARE(call.status, 1);
      for (const char* name : {"balances", "jointTorques", "meshes", "bearings", "power", "jointPowers"})
        QVERIFY2(report[name].is_null(), name);
      QVERIFY(!report["loads"][0].contains("power"));
      QCOMPARE(report["efficiency"]["selfLocking"], true);
      const Run text = statics(load, {});
      QVERIFY(text.output.find("no torques are known") != std::string::npos);
      QVERIFY(text.output.find("Balances") == std::string::npos);
    }
    QCOMPARE(locked, 1);
  }

  /// Each state bears the torque at its own drive; its efficiency is no matter of loads.
  void theShiftTableHasOneTorqueAtTheDrive() {
    Mechanism train = test::example("ravigneaux");
    const auto states = [&](const QStringList& more) {
      return parsed(run(QStringList{"states", saved(train), "--eta", "0.98", "--json"} + more))["states"];
    };
    const json plain = states({"--torque", "100Nm"});
    QCOMPARE(plain[3]["torques"]["couplings"]["B2"], "-7302/25");  // -292.08 N m
    QCOMPARE(plain[3]["torques"]["drive"], "100");
    QCOMPARE(plain[3]["torques"]["driven"], "4802/25");
    QCOMPARE(plain[3]["efficiency"], "2401/2500");
    train.loads = {{{}, LinkTorque{LinkId("1"), {}, Number(100)}}};
    const json loaded = states({});
    QCOMPARE(loaded[3]["torques"]["couplings"]["B2"], "-7302/25");
    QCOMPARE(loaded[3]["torques"]["leftOut"], json({"link:1"}));
    const json other = states({"--torque", "1Nm"});
    for (std::size_t state = 0; state < 4; ++state)
      QCOMPARE(other[state]["efficiency"], plain[state]["efficiency"]);
    train.driveTorque = Number(Rational(7));
    QCOMPARE(states({})[0]["torques"]["drive"], "7");
    const Run text = run({"states", saved(train)});
    QVERIFY2(text.output.find("Torques in N m") != std::string::npos, text.output.c_str());
    QVERIFY(text.output.find("takes the place of the loads on link 1.") != std::string::npos);
    QCOMPARE(run({"states", saved(train), "--torque", "7"}).status, 2);
  }

 private:
  QString saved(const Mechanism& mechanism) {
    const QString path = m_folder.filePath(QString::number(m_next++) + ".geargraph");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
    file.write(QByteArray::fromStdString(writeMechanism(mechanism)));
    return path;
  }

  QTemporaryDir m_folder;
  int m_next = 0;
};

QTEST_GUILESS_MAIN(CliAnswersTest)
#include "test_cli_answers.moc"
