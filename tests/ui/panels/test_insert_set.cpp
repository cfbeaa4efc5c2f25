#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "ui/panels/insert_set_dialog.h"
#include "ui/panels/number_field.h"

namespace geargraph {

class InsertSetTest : public QObject {
  Q_OBJECT

  std::unique_ptr<InsertSetDialog> dialog;
  std::optional<Mechanism> inserted;

  template <class Widget>
  Widget* visible(const char* name) {
    for (auto* found : dialog->findChildren<Widget*>(QLatin1String(name))) {
      if (found->isVisible()) return found;
    }
    return nullptr;
  }
  void type(const char* field, const QString& text) {
    auto* into = visible<NumberField>(field);
    into->selectAll();
    QSignalSpy edited(into, &NumberField::edited), wrong(into, &NumberField::wrongChanged);
    QTest::keyClicks(into, text);
    QTRY_VERIFY(edited.count() + wrong.count() > 0);  // after the pause: Return would insert the set
  }
  void choose(int kind) { dialog->findChild<QListWidget*>(QStringLiteral("kinds"))->setCurrentRow(kind); }
  QString summary() { return dialog->findChild<QLabel*>(QStringLiteral("summary"))->text(); }
  QPushButton& insert() { return *dialog->findChild<QPushButton*>(QStringLiteral("insert")); }

 private slots:
  void init() {
    inserted.reset();
    dialog = std::make_unique<InsertSetDialog>();
    connect(dialog.get(), &InsertSetDialog::insertWanted, this,
            [this](const Mechanism& set) { inserted = set; });
    dialog->show();
    QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
  }
  void cleanup() { dialog.reset(); }

  void thePlanetarySetOfARequiredRatioIsTwoClicksAway() {
    type("wishedRatio", QStringLiteral("4"));
    auto* choices = visible<QTableWidget>("choices");
    QCOMPARE(choices->item(0, 3)->text(), QStringLiteral("4"));
    QCOMPARE(choices->item(0, 4)->text(), QStringLiteral("exact"));
    const int sun = choices->item(0, 0)->text().toInt();
    insert().click();
    QVERIFY(inserted.has_value());
    QCOMPARE(inserted->n(), 6);
    QCOMPARE(inserted->gearMeshes[0].tailTeeth, sun);
    QVERIFY(!dialog->isVisible());
  }

  void whatIsHeldIsHeldAsTheDialogSays() {
    auto* use = visible<QComboBox>("use");
    const int sunHeld = use->findText(QStringLiteral("ring to carrier, sun held"));
    QVERIFY(sunHeld >= 0);
    use->setCurrentIndex(sunHeld);
    emit use->activated(sunHeld);
    QVERIFY(summary().contains(QStringLiteral("brake B is engaged")));
    insert().click();
    QVERIFY(inserted.has_value());
    QCOMPARE(inserted->couplings.size(), std::size_t(1));
    QCOMPARE(inserted->find(inserted->couplings[0].links[0])->name, std::string("sun"));
    QCOMPARE(inserted->engaged, std::vector<ShiftElementId>{inserted->couplings[0].id});
    QCOMPARE(inserted->inputs->size(), std::size_t(1));

    dialog->show();
    auto* held = visible<QComboBox>("held");
    held->setCurrentIndex(1);
    emit held->activated(1);
    insert().click();
    QVERIFY(inserted->couplings.empty());
    QCOMPARE(inserted->n(), 5);  // the sun's teeth are the ground's
    QCOMPARE(inserted->gearMeshes[0].tail, inserted->links[0].id);
  }

  void theRatioOfASetIsToldWithItsSign() {
    QVERIFY(summary().contains(QStringLiteral("One turn of \"sun\" turns \"carrier\" by 2/7.")));
    auto* kinds = dialog->findChild<QListWidget*>(QStringLiteral("kinds"));
    const auto worm = kinds->findItems(QStringLiteral("Worm stage"), Qt::MatchExactly);
    QCOMPARE(worm.size(), 1);
    kinds->setCurrentItem(worm.front());
    QVERIFY(summary().startsWith(QStringLiteral("2 links, 2 joints, 1 mesh\n")));
    QVERIFY(summary().contains(QStringLiteral("One turn of \"worm\" turns \"worm wheel\" by \u22121/40.")));
    insert().click();
    QVERIFY(inserted.has_value());
    QCOMPARE(inserted->gearMeshes[0].kind, MeshKind::worm);
  }

  void anotherChoiceIsTakenFromTheTable() {
    auto* choices = visible<QTableWidget>("choices");
    choices->selectRow(2);
    const int planet = choices->item(2, 1)->text().toInt();
    insert().click();
    QCOMPARE(inserted->gearMeshes[0].headTeeth, planet);
  }

  void whatCannotBeIsSaidAndNotInserted() {
    choose(2);
    type("pinions", QStringLiteral("5"));
    QVERIFY(summary().contains(QStringLiteral("multiple of 5")));
    QVERIFY(!insert().isEnabled());
    type("pinions", QStringLiteral("4"));
    QVERIFY(insert().isEnabled());
    choose(0);
    type("wishedRatio", QStringLiteral("-4"));
    QVERIFY(!insert().isEnabled());
  }

  void everyKindCanBeInserted() {
    const int links[] = {6, 3, 5, 10, 10, 6};
    for (int kind = 0; kind < 6; ++kind) {
      inserted.reset();
      dialog->show();
      choose(kind);
      QVERIFY(insert().isEnabled());
      insert().click();
      QCOMPARE(inserted->n(), links[kind]);
    }
  }

  void noRatioIsElided() {
    choose(1);
    auto* table = visible<QTableWidget>("choices");
    QVERIFY(table != nullptr && table->rowCount() > 3);
    for (int row = 0; row < table->rowCount(); ++row) {
      for (int column = 0; column < table->columnCount(); ++column) {
        const QString text = table->item(row, column)->text();
        QVERIFY2(table->fontMetrics().horizontalAdvance(text) + 8 <= table->columnWidth(column),
                 qPrintable(text));
      }
    }
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::InsertSetTest)
#include "test_insert_set.moc"
