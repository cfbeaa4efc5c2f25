#include <QTest>

#include "tests/core/support/example_files.h"
#include "ui/learning/work_check_service.h"

namespace geargraph {
namespace {

/// The rows of Eq. (45) under the labels of Eq. (25): those of joints 13 and 14 are exchanged.
constexpr auto kRowsOf45 =
    ",8,9,11\n10,-i15,0,0\n12,-i16 i15,-i16,0\n13,-i18 i17 i16 i15,-i18 i17 i16,-i18 i17\n"
    "14,-i17 i16 i15,-i17 i16,-i17\n";

}  // namespace

class PaperCheckServiceTest : public QObject {
  Q_OBJECT

  MechanismPtr m_robot = std::make_shared<const Mechanism>(test::example("robot"));

 private slots:
  void theNewestTextIsChecked() {
    WorkCheckService service;
    service.request({m_robot, "theta10 = theta8"});
    service.request({m_robot, "theta10 = -i15*theta8"});
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(service.answer()->mechanism, m_robot);
    const auto& verdict = *service.answer()->verdict;
    QVERIFY(std::get<std::vector<EquationVerdict>>(verdict).front().isRight);
  }

  void rowsOfEq45UnderLabelsOfEq25_areTheRowsOfTheOtherJoints() {
    WorkCheckService service;
    service.request({m_robot, kRowsOf45});
    QTRY_VERIFY(service.isComplete());
    QVERIFY(service.answer()->verdict.has_value());
    const auto& verdict = std::get<MatrixVerdict>(*service.answer()->verdict);
    QCOMPARE(verdict.kind, PaperMatrix::solution);
    QCOMPARE(verdict.outcome, WorkOutcome::wrong);
    QCOMPARE(verdict.differences.size(), std::size_t{2});
    QCOMPARE(verdict.differences.front().name, std::string("another-output"));
  }

  void textThatCannotBeRead_hasItsPlace() {
    WorkCheckService service;
    service.request({m_robot, "1 0 0\n1 0\n"});
    QTRY_VERIFY(service.isComplete());
    QVERIFY(!service.answer()->verdict);
    QCOMPARE(service.answer()->faults.front().code, Code::syntax);
    QCOMPARE(service.answer()->faults.front().line, 2);
  }

  void anEditedMechanism_isDerivedAnew() {
    Mechanism edited = *m_robot;
    edited.turningJoints.pop_back();
    const auto loose = std::make_shared<const Mechanism>(std::move(edited));
    WorkCheckService service;
    service.request({m_robot, kRowsOf45});
    QTRY_VERIFY(service.isComplete());
    QVERIFY(service.answer()->verdict.has_value());
    service.request({loose, kRowsOf45, PaperMatrix::solution});
    QTRY_VERIFY(service.isComplete());
    QCOMPARE(service.answer()->mechanism, loose);
    QVERIFY(!service.answer()->verdict);
    QCOMPARE(service.answer()->faults.front().code, Code::disconnected);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::PaperCheckServiceTest)
#include "test_paper_check_service.moc"
