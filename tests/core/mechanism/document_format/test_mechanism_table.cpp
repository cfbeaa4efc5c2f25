#include <QTest>

#include "core/mechanism/document_format/mechanism_table.h"
#include "core/mechanism/document_format/table_text.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// A pair of spur gears, as it is written by hand.
const std::string kPair =
    "element,id,tail,head,axis,tailTeeth,headTeeth,x,y,z\n"
    "link,0,,,,,,,,\n"
    "link,1,,,,,,,\n"
    "link,2,,,,,,,\n"
    "axis,a,,,,,,0,0,0\n"
    "axis,b\n"
    "turningJoint,3,0,1,a\n"
    "turningJoint,4,0,2,b\n"
    "gearMesh,5,1,2,,20,30\n";

Mechanism readTable(const std::string& table) {
  auto mechanism = readMechanismTable(table);
  if (!mechanism) qFatal("%s: %s", summary(mechanism.error()).c_str(), mechanism.error()[0].message.c_str());
  return *mechanism;
}

/// "2:6 schema; 3:1 unknown-id", or "" of a table that is read.
QString faults(const std::string& table) {
  const auto mechanism = readMechanismTable(table);
  QStringList all;
  if (!mechanism) {
    for (const Diagnostic& found : mechanism.error()) {
      all += QString("%1:%2 %3")
                 .arg(found.line)
                 .arg(found.column)
                 .arg(QString::fromStdString(std::string(codeName(found.code))));
    }
  }
  return all.join("; ");
}

const std::string kHeader = "element,id,tail,head,axis,tailTeeth,headTeeth,x,y\n";

}  // namespace

class MechanismTableTest : public QObject {
  Q_OBJECT

 private slots:
  void everyExampleIsReadBack_data();
  void everyExampleIsReadBack();
  void everyMemberIsReadBack();
  void whatATableDoesNotHoldIsNamed();
  void aTableByHandIsAMechanism();
  void rowsAndColumnsMayBeInAnyOrder();
  void semicolonsAllowDecimalCommas();
  void noInputsAreNotTheSameAsNone();
  void textsSurvive();
  void numbersKeepTheirSpelling();
  void faultsHaveLineAndColumn_data();
  void faultsHaveLineAndColumn();
  void faultsNameColumnAndElement();
  void atMostAHundredFaultsAreListed();
  void limitsAreStated();
};

void MechanismTableTest::everyExampleIsReadBack_data() {
  QTest::addColumn<QString>("name");
  for (const std::string& name : exampleNames()) QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

void MechanismTableTest::everyExampleIsReadBack() {
  QFETCH(QString, name);
  const Mechanism mechanism = example(name.toStdString());
  const TablePart part = tablePart(mechanism);
  for (const char separator : {',', ';', '\t'}) {
    const std::string table = writeMechanismTable(mechanism, {separator, separator == ';'});
    QVERIFY(looksLikeTable(table));
    QCOMPARE(readTable(table), part.mechanism);
    QCOMPARE(writeMechanismTable(readTable(table), {separator, separator == ';'}), table);
  }
  Mechanism without = mechanism;  // nothing else is lost
  without.view = {};
  QCOMPARE(part.mechanism, without);
}

void MechanismTableTest::everyMemberIsReadBack() {
  const Mechanism mechanism = everything();
  const Mechanism back = readTable(writeMechanismTable(mechanism));
  QCOMPARE(back, tablePart(mechanism).mechanism);
  Mechanism without = mechanism;
  without.view = {};
  without.links[2].shapes.clear();
  QCOMPARE(back, without);
}

void MechanismTableTest::whatATableDoesNotHoldIsNamed() {
  QCOMPARE(tablePart(everything()).lost,
           (std::vector<std::string>{"an attached 3D file",
                                     "the view (places in the drawings, camera of the 3D view)"}));
  QVERIFY(tablePart(emptyMechanism()).lost.empty());
  Mechanism mechanism = emptyMechanism();
  mechanism.links[0].unknown = {{"colour", "1"}};
  mechanism.unit.clear();
  const TablePart part = tablePart(mechanism);
  QCOMPARE(part.lost.size(), std::size_t{2});
  QCOMPARE(part.mechanism, emptyMechanism());
}

void MechanismTableTest::aTableByHandIsAMechanism() {
  const Mechanism mechanism = readTable(kPair);
  QCOMPARE(mechanism.n(), 2);
  QCOMPARE(mechanism.unit, std::string("mm"));
  QVERIFY(mechanism.turningJoints[1].axis == AxisId("b") && !mechanism.inputs);
  QVERIFY(mechanism.gearMeshes[0].tailTeeth == 20 && mechanism.gearMeshes[0].headTeeth == 30);
  QVERIFY(!mechanism.axes[1].point);
  const auto saved = readMechanism(writeMechanism(mechanism));
  QVERIFY(saved && *saved == mechanism);
}

void MechanismTableTest::rowsAndColumnsMayBeInAnyOrder() {
  QCOMPARE(readTable("headTeeth,tailTeeth,head,axis,tail,id,element,\n"
                     "30,20,2,,1,5,gearMesh,\n,,1,a,0,3,turningJoint,\n\n,,,,,,,\n,,2,b,0,4,turningJoint\n"
                     ",,,,,a,axis\n,,,,,b,axis\n,,,,,0,link\n,,,,,1,link\n,,,,,2,link\n"),
           readTable("element,id,tail,head,axis,tailTeeth,headTeeth\nlink,0\nlink,1\nlink,2\naxis,a\naxis,b\n"
                     "turningJoint,3,0,1,a\nturningJoint,4,0,2,b\ngearMesh,5,1,2,,20,30\n"));
}

void MechanismTableTest::semicolonsAllowDecimalCommas() {
  const Mechanism mechanism = readTable("element;id;x;y;z\r\nlink;0\r\naxis;a;1,5;-0,25;1/3\r\n");
  QCOMPARE(mechanism.axes[0].point->at(0).text(), std::string("1.5"));
  QCOMPARE(mechanism.axes[0].point->at(1).text(), std::string("-0.25"));
  QCOMPARE(faults("element;id;x;y;z\nlink;0\naxis;a;1,000,5;0;0\n"), QString("3:8 schema"));
  QCOMPARE(faults("element,id,x,y,z\nlink,0\naxis,a,\"1,5\",0,0\n"), QString("3:8 schema"));
}

void MechanismTableTest::noInputsAreNotTheSameAsNone() {
  for (const bool isStated : {true, false}) {
    Mechanism mechanism = emptyMechanism();
    if (isStated) mechanism.inputs.emplace();
    if (isStated) mechanism.balances.emplace();
    QCOMPARE(readTable(writeMechanismTable(mechanism)), mechanism);
  }
}

void MechanismTableTest::textsSurvive() {
  Mechanism mechanism = emptyMechanism();
  mechanism.name = "=cmd|'/c calc'!A0";
  mechanism.notes = std::string(" a\0b,\"c\";\r\nd\re\t", 14);
  mechanism.links = {{LinkId("-1"), "'=x"}, {LinkId("'"), "''"}, {LinkId("a|b\\"), "@"}};
  mechanism.couplings = {
      {ShiftElementId("a|b"), ShiftElementKind::brake, {LinkId("'")}, {}},
      {ShiftElementId("=\\"), ShiftElementKind::clutch, {LinkId("'"), LinkId("a|b\\")}, {}}};
  mechanism.engaged = {ShiftElementId("=\\"), ShiftElementId("a|b")};
  const std::string table = writeMechanismTable(mechanism);
  QCOMPARE(readTable(table), mechanism);
  for (const char* const formula : {",=", ",+", ",-1,", ",@"})
    QVERIFY2(table.find(formula) == std::string::npos, table.c_str());
  for (const std::string text : {"", "|", "\\", "a|", "\\\\|"})
    QCOMPARE(splitTexts(joinedTexts({text + "x", text})).front(), text + "x");
}

void MechanismTableTest::numbersKeepTheirSpelling() {
  for (const char* const number :
       {"0.10", "1e-3", "-0", "22/7", "-1/3", "+5", "007", "0.123456789012345678901234567890", "5e-4000"}) {
    Mechanism mechanism = emptyMechanism();
    mechanism.axes.push_back({AxisId("a"), NumberTriple{*Number::fromText(number), 1, 2}, {}, false, {}});
    QCOMPARE(readTable(writeMechanismTable(mechanism)), mechanism);
  }
}

void MechanismTableTest::faultsHaveLineAndColumn_data() {
  QTest::addColumn<QByteArray>("table");
  QTest::addColumn<QString>("found");
  const auto row = [](const char* name, const std::string& table, const char* found) {
    QTest::newRow(name) << QByteArray::fromStdString(table) << found;
  };
  row("sound", kPair, "");
  row("nothing", "", "1:1 format");
  row("another table", "a,b\n1,2\n", "1:1 format");
  row("unknown column", "element,id,colour\nlink,0,red\n", "1:12 schema");
  row("column twice", "element,id,id\nlink,0,1\n", "1:12 schema");
  row("unknown element", kHeader + "link,0\nspring,1\n", "3:1 schema");
  row("no element", kHeader + "link,0\n,1\n", "3:1 schema");
  row("two documents", "element,name\nlink\ndocument,a\ndocument,b", "2:1 schema; 4:1 schema");
  row("no teeth", kHeader + "link,0\ngearMesh,5,0,1,,20\n", "3:1 schema");
  row("empty teeth", kHeader + "link,0\ngearMesh,5,0,1,,20,\n", "3:20 schema");
  row("teeth", kHeader + "link,0\ngearMesh,5,0,1,,0,1.5\n", "3:17 schema; 3:19 schema");
  row("many teeth", kHeader + "link,0\ngearMesh,5,0,1,,100001,99999999999999\n", "3:17 schema; 3:24 schema");
  row("no number", kHeader + "link,0\naxis,a,,,,,,1,x\n", "3:15 schema; 3:1 schema");
  row("half a point", "element,id,x,y,z\nlink,0\naxis,a,1,,3\n", "3:10 schema");
  row("cell of another element", kHeader + "link,0,1\n", "2:8 schema");
  row("cell without a column", kHeader + "link,0,,,,,,,,7\n", "2:15 schema");
  row("quote", kHeader + "link,\"0\nlink", "2:6 syntax");
  row("no UTF-8", kHeader + "link,\xFF\n", "2:6 syntax");
  row("no ground", kHeader, "1:1 schema");
  row("id twice", kHeader + "link,0\nlink,0\n", "3:6 duplicate-id");
  row("no such link", kHeader + "link,0\naxis,a\nturningJoint,3,0,9,a\n", "4:18 unknown-id");
  row("to itself", kHeader + "link,0\naxis,a\nturningJoint,3,0,0,a\n", "4:18 self-joint");
  row("no direction", "element,id,dx,dy,dz\nlink,0\naxis,a,0,0,0\n", "3:8 schema");
  row("too far", "element,id,x,y,z\nlink,0\naxis,a,0,1e16,0\n", "3:10 schema");
  row("limits",
      "element,id,tail,head,axis,lowLimit,highLimit\nlink,0\nlink,1\naxis,a\nturningJoint,3,0,1,a,5,9\n",
      "5:22 schema");
  row("no such coupling", "element,id,engaged\nlink,0\ndocument,,A|B\n", "3:11 unknown-id; 3:11 unknown-id");
  row("no such link of a clutch", "element,id,tail,head\nlink,0\nclutch,C,0,1\n", "3:12 unknown-id");
  row("kind", "element,id,tail,head,tailTeeth,headTeeth,kind\nlink,0\nlink,1\ngearMesh,5,0,1,20,30,spur\n",
      "4:22 schema");
  row("mass", "element,id,mass,x,y,z\nlink,0,,1,2,3\n", "2:9 schema");
  row("load of both", "element,id,link,joint,torque\nlink,0\nload,,1,2,3\n", "3:7 schema");
  row("load of nothing", "element,id,link,torque\nlink,0\nload,,,3\n", "3:1 schema");
  row("force in a joint", "element,joint,x,y,z,dx,dy,dz\nload,3,0,0,0,1,0,0\n", "2:14 schema");
  row("speed", "element,id,joint,speed\nlink,0\ninput,,3,\n", "3:10 schema");
  row("pinned", "element,id,pinned\nlink,0,true\n", "2:8 schema");
}

void MechanismTableTest::faultsHaveLineAndColumn() {
  QFETCH(QByteArray, table);
  QTEST(faults(table.toStdString()), "found");
}

void MechanismTableTest::faultsNameColumnAndElement() {
  const auto found = readMechanismTable(kHeader + "gearMesh,5,1,2,,many,30\n").error();
  QCOMPARE(found.size(), std::size_t{1});
  QCOMPARE(found[0].message, std::string("The column \"tailTeeth\" has \"many\"; expected a whole number "
                                         "from 1 to 100,000."));
  QVERIFY(found[0].elements == std::vector<ElementId>{MeshId("5")});
  QVERIFY(found[0].pointer.empty());
}

void MechanismTableTest::atMostAHundredFaultsAreListed() {
  std::string table = "element\n";
  for (int i = 0; i < 100'000; ++i) table += "spring\n";
  const auto found = readMechanismTable(table).error();
  QCOMPARE(found.size(), std::size_t{100});
  QCOMPARE(found.back().line, 101);
  std::string copies = "element,id\n";
  for (int i = 0; i < 5'000; ++i) copies += "link,0\n";
  QCOMPARE(readMechanismTable(copies).error().size(), std::size_t{101});
  QCOMPARE(readMechanismTable(copies).error().back().code, Code::schema);
}

void MechanismTableTest::limitsAreStated() {
  std::string links = "element,id\n";
  for (int i = 0; i <= 100'000; ++i) links += "link," + std::to_string(i) + '\n';
  QCOMPARE(faults(links), QString("100002:1 schema"));
  QCOMPARE(faults(links.substr(0, links.rfind("link"))), QString());
  QCOMPARE(faults("element,id\nlink," + std::string(1'001, 'x')), QString("2:6 schema"));
  QCOMPARE(faults("element,id\nlink," + std::string(1'000, 'x')), QString());
  QCOMPARE(faults("element,id,name\nlink,0," + std::string(1'001, 'x')), QString("2:8 schema"));
  QCOMPARE(faults("element" + std::string(1'000'000, ',') + "\nlink"), QString("1:263 schema"));
  QCOMPARE(readMechanismTable(std::string(kLargestFile + 1, 'x')).error()[0].code, Code::schema);
}

QTEST_APPLESS_MAIN(MechanismTableTest)
#include "test_mechanism_table.moc"
