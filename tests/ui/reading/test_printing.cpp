#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPainter>
#include <QPrinterInfo>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/report/report.h"
#include "ui/mainwindow/document_files.h"
#include "ui/reading/page_preview.h"
#include "ui/reading/print_dialog.h"

namespace geargraph {

/// What is printed: which pages there are, what is on them, and how the dialog shows them.
class PrintingTest : public QObject {
  Q_OBJECT

  SnapshotPtr snapshot;
  DisplayList digraph;

  static constexpr QSizeF kPaper{595, 842};

  [[nodiscard]] PrintSource source() const {
    return {
        QStringLiteral("Robot"), {{QStringLiteral("Digraph"), [this] { return digraph; }}}, 0, snapshot, {}};
  }
  [[nodiscard]] std::shared_ptr<const SetReport> report() const {
    return std::make_shared<const SetReport>(derivationReport(snapshot));
  }
  [[nodiscard]] PrintedPages pagesOn(QSizeF paper) const {
    return {QStringLiteral("Robot"),
            {{QStringLiteral("Digraph"), [this] { return digraph; }}},
            report(),
            paper,
            QFont()};
  }
  static QImage painted(const PrintedPages& pages, int page) {
    constexpr double kScale = 2;
    QImage image((pages.paper() * kScale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    FlowPainter flow;
    pages.paint(painter, page, kScale, flow);
    return image;
  }
  /// What is not white.
  static QRect inkOf(const QImage& image) {
    QRect ink;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.pixel(x, y) != qRgb(255, 255, 255)) ink |= QRect(x, y, 1, 1);
      }
    }
    return ink;
  }

 private slots:
  void initTestCase() {
    Mechanism robot = *readDocument(robotExamplePath());
    digraph = digraphDrawing(digraphGeometry(robot, completedPositions(robot)), {});
    snapshot = analyze(std::make_shared<const Mechanism>(std::move(robot)));
  }

  void pagesKeepTheirMargins() {
    for (const QSizeF paper : {kPaper, QSizeF(842, 595), QSizeF(420, 595)}) {
      const PrintedPages pages = pagesOn(paper);
      QVERIFY(pages.count() > 3);
      for (int page = 0; page < pages.count(); ++page) {
        const QImage image = painted(pages, page);
        const QRect ink = inkOf(image);
        QVERIFY2(!ink.isEmpty(), qPrintable(QString::number(page)));
        QVERIFY(image.rect().adjusted(70, 70, -70, -40).contains(ink));
      }
    }
    QVERIFY(pagesOn({420, 595}).count() > pagesOn(kPaper).count());
  }

  void thePaperIsThatOfTheCountry_data() {
    QTest::addColumn<QString>("locale");
    QTest::addColumn<int>("paper");
    QTest::newRow("Germany") << "de_DE" << static_cast<int>(QPageSize::A4);
    QTest::newRow("Turkey") << "tr_TR" << static_cast<int>(QPageSize::A4);
    QTest::newRow("Spain") << "es_ES" << static_cast<int>(QPageSize::A4);
    QTest::newRow("Mexico") << "es_MX" << static_cast<int>(QPageSize::Letter);
    QTest::newRow("United States") << "en_US" << static_cast<int>(QPageSize::Letter);
    QTest::newRow("United Kingdom") << "en_GB" << static_cast<int>(QPageSize::A4);
  }
  void thePaperIsThatOfTheCountry() {
    if (!QPrinterInfo::defaultPrinter().isNull()) QSKIP("the printer of this machine has its own paper");
    QFETCH(const QString, locale);
    QFETCH(const int, paper);
    const QLocale before;
    QLocale::setDefault(QLocale(locale));
    const PrintDialog dialog(source());
    QLocale::setDefault(before);
    QCOMPARE(static_cast<int>(dialog.printer()->pageLayout().pageSize().id()), paper);
  }

  void theDialogShowsWhatIsChosen() {
    PrintDialog dialog(source());
    dialog.show();
    QTRY_VERIFY(dialog.isUpToDate());
    QCOMPARE(dialog.pages()->count(), 1);
    auto* derivation = dialog.findChild<QCheckBox*>(QStringLiteral("printDerivation"));
    QTest::mouseClick(derivation, Qt::LeftButton, {}, QPoint(8, derivation->height() / 2));
    QTRY_VERIFY(dialog.isUpToDate() && dialog.pages()->count() > 4);
    auto* page = dialog.findChild<QSpinBox*>(QStringLiteral("printPage"));
    QCOMPARE(page->maximum(), dialog.pages()->count());
    dialog.preview().setFocus();
    QTest::keyClick(&dialog.preview(), Qt::Key_PageDown);
    QCOMPARE(page->value(), 2);
    QCOMPARE(dialog.preview().accessibleDescription(),
             QStringLiteral("Page 2 of %1: Derivation").arg(dialog.pages()->count()));
    QTest::keyClick(&dialog.preview(), Qt::Key_End);
    QCOMPARE(page->value(), dialog.pages()->count());
    // The page that was shown goes: the last one that is left comes.
    QTest::mouseClick(derivation, Qt::LeftButton, {}, QPoint(8, derivation->height() / 2));
    QTRY_COMPARE(page->value(), 1);
    auto* drawing = dialog.findChild<QCheckBox*>(QStringLiteral("print0"));
    QTest::mouseClick(drawing, Qt::LeftButton, {}, QPoint(8, drawing->height() / 2));
    QTRY_VERIFY(dialog.isUpToDate() && dialog.pages()->count() == 0);
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("printNow"))->isEnabled());
  }

  /// Qt's own dialog does not open where there is no printer, as on this machine.
  void thePaperIsChosenWithoutAPrinter() {
    if (!QPrinterInfo::defaultPrinter().isNull()) QSKIP("this machine has a printer");
    PrintDialog dialog(source());
    dialog.show();
    QTRY_VERIFY(dialog.isUpToDate());
    const auto press = [&](QDialogButtonBox::StandardButton button, int size, int orientation) {
      for (auto* each : dialog.findChildren<QPushButton*>())
        if (each->text() == QStringLiteral("Page setup…")) each->click();
      auto* paper = dialog.findChild<QDialog*>(QStringLiteral("paperDialog"));
      if (paper == nullptr || !paper->isVisible()) return false;
      auto* sizes = paper->findChild<QComboBox*>(QStringLiteral("paper"));
      sizes->setCurrentIndex(sizes->findData(size));
      auto* orientations = paper->findChild<QComboBox*>(QStringLiteral("orientation"));
      orientations->setCurrentIndex(orientations->findData(orientation));
      paper->findChild<QDialogButtonBox*>()->button(button)->click();
      return true;
    };
    const QPageLayout before = dialog.printer()->pageLayout();
    QVERIFY(press(QDialogButtonBox::Cancel, QPageSize::A5, QPageLayout::Landscape));
    QCOMPARE(dialog.printer()->pageLayout(), before);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(press(QDialogButtonBox::Ok, QPageSize::A3, QPageLayout::Landscape));
    QCOMPARE(dialog.printer()->pageLayout().pageSize().id(), QPageSize::A3);
    QCOMPARE(dialog.printer()->pageLayout().orientation(), QPageLayout::Landscape);
    QTRY_VERIFY(dialog.isUpToDate());
    QCOMPARE(dialog.pages()->count(), 1);
  }

  void withoutASolutionTheDrawingsAreLeft() {
    PrintSource none = source();
    none.snapshot.reset();
    none.whyNoDerivation = QStringLiteral("Nothing to derive.");
    const PrintDialog dialog(std::move(none));
    const auto* derivation = dialog.findChild<QCheckBox*>(QStringLiteral("printDerivation"));
    QVERIFY(!derivation->isEnabled());
    QCOMPARE(derivation->toolTip(), QStringLiteral("Nothing to derive."));
  }

  void aPrinterGetsThePages() {
    const QTemporaryDir folder;
    const PrintedPages pages = pagesOn(kPaper);
    QPrinter printer(QPrinter::HighResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setOutputFileName(folder.filePath(QStringLiteral("all.pdf")));
    QCOMPARE(PrintDialog::print(pages, printer), QString());
    QFile all(printer.outputFileName());
    QVERIFY(all.open(QIODevice::ReadOnly));
    const QByteArray bytes = all.readAll();
    QVERIFY(bytes.startsWith("%PDF"));
    QVERIFY(bytes.contains("/Count " + QByteArray::number(pages.count())));

    printer.setOutputFileName(folder.filePath(QStringLiteral("two.pdf")));
    printer.setFromTo(2, 3);
    QCOMPARE(PrintDialog::print(pages, printer), QString());
    QFile two(printer.outputFileName());
    QVERIFY(two.open(QIODevice::ReadOnly));
    QVERIFY(two.readAll().contains("/Count 2"));

    QPrinter nowhere(QPrinter::HighResolution);
    nowhere.setOutputFormat(QPrinter::PdfFormat);
    nowhere.setOutputFileName(folder.filePath(QStringLiteral("missing/all.pdf")));
    QVERIFY(!PrintDialog::print(pages, nowhere).isEmpty());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::PrintingTest)
#include "test_printing.moc"
