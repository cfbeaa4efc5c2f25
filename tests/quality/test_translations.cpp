#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <vector>

namespace geargraph {
namespace {

struct Message {
  QString source;
  QString state;           ///< "", "unfinished", "vanished", "obsolete"
  QStringList forms;       ///< of the translation: one, or as many as the language has plural forms
  bool isCounted = false;  ///< its translation has plural forms
};

std::vector<Message> messagesOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) qFatal("Cannot read %s", qPrintable(path));
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("message")) {
      messages.emplace_back();
      messages.back().isCounted = xml.attributes().value(QStringLiteral("numerus")) == QLatin1String("yes");
      continue;
    }
    if (messages.empty()) continue;
    Message& message = messages.back();
    const auto text = [&xml] { return xml.readElementText(QXmlStreamReader::SkipChildElements); };
    if (xml.name() == QLatin1String("source")) {
      message.source = text();
    } else if (xml.name() == QLatin1String("translation")) {
      message.state = xml.attributes().value(QStringLiteral("type")).toString();
      if (!message.isCounted) message.forms << text();
    } else if (xml.name() == QLatin1String("numerusform")) {
      message.forms << text();
    }
  }
  if (xml.hasError()) qFatal("%s: %s", qPrintable(path), qPrintable(xml.errorString()));
  return messages;
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%(\\d|n)"));
  QStringList places;
  for (auto each = place.globalMatch(text); each.hasNext();) places << each.next().captured();
  places.sort();
  places.removeDuplicates();
  return places;
}

qsizetype mnemonicsIn(const QString& text) {
  static const QRegularExpression mnemonic(QStringLiteral("&\\w"),
                                           QRegularExpression::UseUnicodePropertiesOption);
  return text.count(mnemonic);
}

QStringList flawsOf(const Message& message, int pluralForms) {
  QStringList flaws;
  if (message.state == QLatin1String("unfinished")) flaws << QStringLiteral("not translated");
  if (message.state == QLatin1String("vanished") || message.state == QLatin1String("obsolete"))
    flaws << QStringLiteral("no longer in the sources");
  if (!flaws.isEmpty()) return flaws;
  if (message.forms.size() != (message.isCounted ? pluralForms : 1))
    flaws << QStringLiteral("wrong number of plural forms");
  for (const QString& form : message.forms) {
    if (form.isEmpty()) flaws << QStringLiteral("empty");
    if (placesIn(form) != placesIn(message.source)) flaws << QStringLiteral("other places: ") + form;
    if (mnemonicsIn(form) != mnemonicsIn(message.source)) flaws << QStringLiteral("other mnemonics: ") + form;
    const auto edge = [](const QString& text) {
      return std::pair(text.startsWith(QLatin1Char(' ')), text.endsWith(QLatin1Char(' ')));
    };
    if (edge(form) != edge(message.source)) flaws << QStringLiteral("other blanks at the ends: ") + form;
    if (form.count(QStringLiteral(";;")) != message.source.count(QStringLiteral(";;")))
      flaws << QStringLiteral("other file filters: ") + form;
  }
  return flaws;
}

}  // namespace

/// The catalogues say all that the sources say.
class TranslationsTest : public QObject {
  Q_OBJECT

  static QString root() { return QStringLiteral(GEARGRAPH_SOURCE); }

  /// Brings a copy of a catalogue up to date with the sources below `sources`, keeping what has vanished.
  static QString renewed(const QString& catalogue, const QString& sources, const QString& folder) {
    const QString copy = QDir(folder).filePath(QFileInfo(catalogue).fileName());
    QFile::remove(copy);
    if (!QFile::copy(catalogue, copy)) qFatal("Cannot copy %s", qPrintable(catalogue));
    QProcess extract;
    extract.start(QStringLiteral(GEARGRAPH_CMAKE),
                  {QStringLiteral("-D"), QStringLiteral("SOURCE=") + sources, QStringLiteral("-D"),
                   QStringLiteral("LUPDATE=" GEARGRAPH_LUPDATE), QStringLiteral("-P"),
                   root() + QStringLiteral("/tools/translations/extract.cmake"),
                   QDir(folder).filePath(QStringLiteral("sources")), QStringLiteral("-ts"), copy});
    if (!extract.waitForFinished(-1) || extract.exitCode() != 0)
      qFatal("%s", extract.readAllStandardError().constData());
    return copy;
  }

 private slots:
  void everyTextIsTranslated_data() {
    QTest::addColumn<int>("pluralForms");
    QTest::newRow("de") << 2;
    QTest::newRow("tr") << 1;
    QTest::newRow("es") << 2;
  }
  void everyTextIsTranslated() {
    QFETCH(const int, pluralForms);
    const QTemporaryDir folder;
    const QString name =
        QStringLiteral("/resources/translations/geargraph_%1.ts").arg(QLatin1String(QTest::currentDataTag()));
    const auto messages = messagesOf(renewed(root() + name, root(), folder.path()));
    QVERIFY(messages.size() > 1000);
    QStringList all;
    for (const Message& message : messages) {
      for (const QString& flaw : flawsOf(message, pluralForms))
        all << QStringLiteral("  \"%1\": %2").arg(message.source, flaw);
    }
    QVERIFY2(all.isEmpty(), qPrintable(QStringLiteral("%1 texts of %2, see the target \"translations\":\n%3")
                                           .arg(all.size())
                                           .arg(name, all.join(QLatin1Char('\n')))));
  }

  /// It can fail: a text that is new, one that is gone, and flaws of a translation are each named.
  void whatIsWrongIsNamed() {
    const QTemporaryDir folder;
    const auto write = [&](const QString& name, const QByteArray& text) {
      QFile file(QDir(folder.path()).filePath(name));
      QVERIFY(QDir(folder.path()).mkpath(QFileInfo(file.fileName()).path()));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(text);
    };
    write(QStringLiteral("tree/ui/a.cpp"),
          "auto a = View::tr(\"new\");\nauto b = translated(\"of %1\");\nauto c = toTranslate(\n    "
          "\"&Run\");\n");
    write(QStringLiteral("before/geargraph_de.ts"),
          "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!DOCTYPE TS>\n<TS version=\"2.1\" language=\"de\">\n"
          "<context><name>GearGraph</name>\n"
          "<message><source>gone</source><translation>fort</translation></message>\n"
          "<message><source>of %1</source><translation>von %2</translation></message>\n"
          "<message><source>&amp;Run</source><translation>Los</translation></message>\n"
          "</context></TS>\n");
    QDir(folder.path()).mkpath(QStringLiteral("after"));
    const auto messages = messagesOf(renewed(folder.filePath(QStringLiteral("before/geargraph_de.ts")),
                                             folder.filePath(QStringLiteral("tree")),
                                             folder.filePath(QStringLiteral("after"))));
    QCOMPARE(messages.size(), std::size_t{4});
    for (const Message& message : messages) QCOMPARE(flawsOf(message, 2).size(), 1);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::TranslationsTest)
#include "test_translations.moc"
