#include <QFile>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <iostream>
#include <random>

#include "core/mechanism/model/edits.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/notice_bar.h"
#include "ui/mainwindow/window_files.h"
#include "ui/mainwindow/window_set.h"
#include "ui/theme/application_theme.h"

namespace geargraph {
namespace {

constexpr int kTick = 20;                ///< ms between edits, at least
constexpr int kMaxLost = 2'000 / kTick;  ///< edits of the last two seconds
constexpr int kMaxSession = 150;         ///< edits

/// The k-th edit: the document's name says k, and every fifth adds a link.
Expected<Mechanism> edited(Mechanism mechanism, int k) {
  mechanism.name = std::to_string(k);
  if (k % 5 != 0) return mechanism;
  return withLink(std::move(mechanism), CanvasPoint{40.0 * (k % 20), 40.0 * (k / 20)});
}

Mechanism afterEdits(Mechanism mechanism, int count) {
  for (int k = 1; k <= count; ++k) mechanism = edited(std::move(mechanism), k).value();
  return mechanism;
}

/// The killed program: a window on a document, edited without a pause; says every edit on standard output.
int editUntilKilled(const QString& folder, const QString& document) {
  WindowSet windows(folder);
  windows.start({document});
  MainWindow& window = *windows.windows().front();
  QTimer timer;
  int k = 0;
  QObject::connect(&timer, &QTimer::timeout, &window, [&] {
    ++k;
    window.document().apply(
        {QStringLiteral("Edit"), [k](const Mechanism& mechanism) { return edited(mechanism, k); }, 0});
    std::cout << k << '\n' << std::flush;
  });
  timer.start(kTick);
  return QApplication::exec();
}

}  // namespace

/// kill -9 in the midst of an edit session.
class CrashTest : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder;
  QString document;
  QByteArray saved;
  Mechanism drawn;

  [[nodiscard]] QString app() const { return folder->filePath(QStringLiteral("app")); }
  std::unique_ptr<QProcess> startEditor() {
    auto editor = std::make_unique<QProcess>();
    editor->start(QCoreApplication::applicationFilePath(), {QStringLiteral("--edit"), app(), document});
    return editor;
  }
  /// Kills an editor when it has said that it made so many edits; the number it made.
  static int kill(QProcess& editor, int edits) {
    int made = 0;
    const auto listen = [&] {
      while (editor.canReadLine()) made = editor.readLine().trimmed().toInt();
    };
    while (made < edits && editor.waitForReadyRead(60'000)) listen();
    editor.kill();
    editor.waitForFinished();
    listen();
    return made;
  }
  static QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private slots:
  void initTestCase() {
    test::isolateSettings();
    QStandardPaths::setTestModeEnabled(true);
    applyTheme(*qApp, Theme::light);
  }
  void init() {
    folder = std::make_unique<QTemporaryDir>();
    document = folder->filePath(QStringLiteral("work.geargraph"));
    drawn = withLink(emptyMechanism(), {300, 90}).value();
    QVERIFY(!writeDocument(drawn, document));
    saved = contents(document);
  }

  void atMostTheLastTwoSecondsAreLost_data() {
    QTest::addColumn<int>("edits");
    std::mt19937 random(20261121);
    for (int round = 0; round < 6; ++round) {
      const int edits = 1 + static_cast<int>(random() % kMaxSession);
      QTest::addRow("%d: after %d edits", round, edits) << edits;
    }
  }

  void atMostTheLastTwoSecondsAreLost() {
    QFETCH(int, edits);
    const auto editor = startEditor();
    const int made = kill(*editor, edits);
    QVERIFY2(made >= edits, editor->readAllStandardError().constData());
    QCOMPARE(contents(document), saved);  // the person's file is untouched

    WindowSet windows(app());
    windows.start({document});
    MainWindow& window = *windows.windows().front();
    const Notice* offer = window.notices().current();
    if (offer == nullptr) {
      QVERIFY2(made <= kMaxLost, qPrintable(QStringLiteral("All of %1 edits are lost").arg(made)));
      return;
    }
    QVERIFY(offer->text.contains(QStringLiteral("work.geargraph")));
    for (auto* button : window.notices().findChildren<QPushButton*>()) {
      if (button->text() == QStringLiteral("Restore") && !button->isHidden()) button->click();
    }
    const Mechanism restored = *window.document().mechanism();
    const int kept = std::stoi(restored.name);
    QVERIFY(restored == afterEdits(drawn, kept));
    QVERIFY2(made - kept <= kMaxLost, qPrintable(QStringLiteral("%1 of %2").arg(kept).arg(made)));
    QVERIFY(offer == nullptr || window.isWindowModified());
  }

  void twoEditorsOnOneFileKeepTheirChangesApart() {
    const auto one = startEditor();
    const auto two = startEditor();
    kill(*one, kMaxSession);
    kill(*two, kMaxSession);
    const SideFiles left = recoverableFilesOf(document, app());
    QCOMPARE(left.size(), std::size_t{2});
    for (const auto& side : left) {
      const auto read = side->read();
      QVERIFY(read.has_value());
      QVERIFY(read->mechanism == afterEdits(drawn, std::stoi(read->mechanism.name)));
    }
    QCOMPARE(contents(document), saved);
  }
};

}  // namespace geargraph

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  const QStringList arguments = QApplication::arguments();
  if (arguments.size() == 4 && arguments.at(1) == QStringLiteral("--edit")) {
    geargraph::test::keepSettingsIn(arguments.at(2));  // what is killed removes no folder of its own
    QStandardPaths::setTestModeEnabled(true);
    return geargraph::editUntilKilled(arguments.at(2), arguments.at(3));
  }
  geargraph::CrashTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_crash.moc"
