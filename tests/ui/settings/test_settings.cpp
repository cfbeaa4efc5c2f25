#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <latch>

#include "ui/settings/settings.h"

namespace geargraph {

/// What is saved is read at once, and in the file after flushSettings().
class SettingsTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder;

 private slots:
  void initTestCase() {
    QCoreApplication::setOrganizationName(QStringLiteral("GearGraphTest"));
    QCoreApplication::setApplicationName(QStringLiteral("GearGraphTest"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
  }
  void init() {
    changeSettings({}, [](QSettings& settings) { settings.clear(); });
    flushSettings();
  }

  void whatIsSavedIsReadAtOnce() {
    QVERIFY(!isSettingSaved(QStringLiteral("theme")));
    QCOMPARE(savedSetting(QStringLiteral("theme"), 7).toInt(), 7);
    saveSetting(QStringLiteral("theme"), QStringLiteral("dark"));
    QCOMPARE(savedSetting(QStringLiteral("theme")).toString(), QStringLiteral("dark"));
    removeSetting(QStringLiteral("theme"));
    QVERIFY(!isSettingSaved(QStringLiteral("theme")));
  }

  void theFileHasItAfterAFlush() {
    for (int i = 0; i <= 100; ++i) saveSetting(QStringLiteral("scale"), i);
    changeSettings(QStringLiteral("session"), [](QSettings& settings) {
      settings.beginWriteArray(QStringLiteral("session"));
      settings.setArrayIndex(0);
      settings.setValue(QStringLiteral("source"), QStringLiteral("robot"));
      settings.endArray();
    });
    flushSettings();
    QCOMPARE(QSettings().value(QStringLiteral("scale")).toInt(), 100);
    QCOMPARE(QSettings().value(QStringLiteral("session/1/source")).toString(), QStringLiteral("robot"));
    QFile file(QSettings().fileName());
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("scale=100"));
  }

  void nothingWaitsForASlowDisk() {
    saveSetting(QStringLiteral("theme"), QStringLiteral("light"));
    flushSettings();
    std::latch written(1);
    changeSettings(QStringLiteral("session"), [&](QSettings&) { written.wait(); });
    saveSetting(QStringLiteral("scale"), 2);  // would deadlock if it waited
    QCOMPARE(savedSetting(QStringLiteral("scale")).toInt(), 2);
    QCOMPARE(savedSetting(QStringLiteral("theme")).toString(), QStringLiteral("light"));
    written.count_down();
    flushSettings();
    QCOMPARE(QSettings().value(QStringLiteral("scale")).toInt(), 2);
  }

  void otherProgramsSettingsAreRead() {
    saveSetting(QStringLiteral("theme"), QStringLiteral("light"));
    flushSettings();
    QSettings().setValue(QStringLiteral("theme"), QStringLiteral("dark"));
    QCOMPARE(savedSetting(QStringLiteral("theme")).toString(), QStringLiteral("dark"));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::SettingsTest)
#include "test_settings.moc"
