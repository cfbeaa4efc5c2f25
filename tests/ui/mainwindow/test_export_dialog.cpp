#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/mainwindow/export_dialog.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/window_exports.h"

namespace geargraph {

/// File > Export: every format of the registry, with its options, written on the thread of the exports.
class ExportDialogTest : public QObject {
  Q_OBJECT

  const QTemporaryDir folder;

  static QString wordOf(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  }
  static QPushButton* exportButton(const ExportDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>()) {
      if (button->isDefault()) return button;
    }
    return nullptr;
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }

  void theListIsTheRegistry() {
    const ExportDialog dialog(test::snapshotOf(test::example("robot")));
    const auto* formats = dialog.findChild<QComboBox*>("exportFormat");
    QStringList listed, registered;
    for (int i = 0; i < formats->count(); ++i) {
      const QString id = formats->itemData(i).toString();
      if (!id.isEmpty()) listed << id;
    }
    for (const Exporter* exporter : allExporters()) registered << wordOf(exporter->id);
    QCOMPARE(listed, registered);
  }

  void everyOptionHasAFieldOfItsType() {
    ExportDialog dialog(test::snapshotOf(test::example("robot")));
    for (const Exporter* exporter : allExporters()) {
      dialog.choose(exporter->id);
      QCOMPARE(dialog.exporter().id, exporter->id);
      for (const ExportOption& option : exporter->options) {
        auto* field = dialog.findChild<QWidget*>(wordOf(option.name));
        QVERIFY2(field != nullptr && !field->toolTip().isEmpty(), option.name.data());
        QCOMPARE(qobject_cast<QCheckBox*>(field) != nullptr, option.type == OptionType::flag);
        QCOMPARE(qobject_cast<QComboBox*>(field) != nullptr, option.type == OptionType::choice);
      }
      // What nobody has touched leaves the options as they are without it, and chooses this exporter.
      const OptionValues given = dialog.options();
      QCOMPARE(exporterOf(exporter->form, given)->id, exporter->id);
      QVERIFY(!uselessOption(*exporter, given));
    }
  }

  void whatIsSetIsGiven() {
    ExportDialog dialog(test::snapshotOf(test::example("robot")));
    dialog.choose("mjcf");
    dialog.findChild<QComboBox*>("--motor")->setCurrentText("torque");
    dialog.findChild<QWidget*>("--timestep")->findChild<QLineEdit*>()->setText("0,002");
    OptionValues given = dialog.options();
    QCOMPARE(given.value("--motor"), std::optional<std::string>("torque"));
    QCOMPARE(given.value("--timestep"), std::optional<std::string>("0.002"));
    QVERIFY(!given.has("--gravity"));
    dialog.choose("csv");
    dialog.findChild<QCheckBox*>("--bom")->setChecked(true);
    given = dialog.options();
    QVERIFY(given.has("--bom") && !given.has("--no-labels") && !given.has("--motor"));
    QCOMPARE(given.value("--matrix"), std::optional<std::string>("incidence"));
  }

  void aFormatThatTheDocumentHasNothingForSaysWhy() {
    Mechanism loose = emptyMechanism();
    loose.links.push_back({LinkId("1"), {}});
    ExportDialog dialog(test::snapshotOf(loose));
    dialog.choose("mjcf");
    const auto* reason = dialog.findChild<QLabel*>("exportReason");
    QVERIFY(!exportButton(dialog)->isEnabled() && !reason->text().isEmpty());
    dialog.choose("dot");
    QVERIFY(exportButton(dialog)->isEnabled() && reason->text().isEmpty());
    dialog.choose("mjcf");
    dialog.setSnapshot(test::snapshotOf(test::example("robot")));
    QVERIFY(exportButton(dialog)->isEnabled());
  }

  void theChoiceIsRemembered() {
    QString id;
    {
      ExportDialog dialog(test::snapshotOf(test::example("robot")));
      dialog.setAttribute(Qt::WA_DeleteOnClose, false);
      dialog.choose("graphml");
      connect(&dialog, &ExportDialog::wanted, this, [&](const QString& wanted) { id = wanted; });
      exportButton(dialog)->click();
    }
    QCOMPARE(id, QString("graphml"));
    const ExportDialog next(test::snapshotOf(test::example("robot")));
    QCOMPARE(next.exporter().id, std::string_view("graphml"));
  }

  void theWindowWritesOnItsOwnThread_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"dot", "graphml", "node-link", "mjcf", "urdf", "modelica", "glb", "3mf"})
      QTest::newRow(id) << id;
  }
  void theWindowWritesOnItsOwnThread() {
    QFETCH(QString, id);
    const auto window = test::openedWindow(QString::fromStdString(test::examplePath("spur-pair")));
    QVERIFY(window != nullptr);
    const Exporter& exporter = *exporterWithId(id.toStdString());
    const QString path = folder.filePath(id);
    QSignalSpy written(&window->exports(), &WindowExports::written);
    QSignalSpy rejected(&window->exports(), &WindowExports::rejected);
    window->exports().exportAs(exporter, withImplied(exporter, {}), path);
    QVERIFY(window->exportJobs().isBusy());
    QVERIFY(written.wait(60'000));
    QVERIFY(rejected.empty());
    const QFileInfo made(path);
    QVERIFY(exporter.files == ExportFiles::folder ? !QDir(path).isEmpty() : made.size() > 0);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::ExportDialogTest)
#include "test_export_dialog.moc"
