#include <QProcess>
#include <QTest>

#include "app/cli/language.h"

namespace geargraph::cli {
namespace {

using Words = std::vector<std::string>;

const QString kRobot = SOURCE "/resources/examples/robot.geargraph";
const QString kBroken = SOURCE "/tests/golden/files/broken.geargraph";

std::optional<std::string> taken(Words& words) {
  auto result = takeLanguage(words);
  return std::holds_alternative<UsageError>(result) ? std::nullopt
                                                    : std::get<std::optional<std::string>>(std::move(result));
}

std::string languageErrorOf(Words words) {
  const auto result = takeLanguage(words);
  const auto* error = std::get_if<UsageError>(&result);
  return error == nullptr ? "" : error->message;
}

/// What the program says, with the locale of an environment.
QString said(const QStringList& words, const QMap<QString, QString>& locale = {},
             QProcess::ProcessChannelMode channels = QProcess::MergedChannels) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) environment.remove(variable);
  for (auto each = locale.begin(); each != locale.end(); ++each) environment.insert(each.key(), each.value());
  QProcess program;
  program.setProcessEnvironment(environment);
  program.setProcessChannelMode(channels);
  program.start(GEARGRAPH_CLI, words);
  if (!program.waitForFinished(60000)) return "timed out";
  return QString::fromUtf8(program.readAllStandardOutput());
}

}  // namespace

class CliLanguageTest : public QObject {
  Q_OBJECT
 private slots:
  void aLocaleNamesItsLanguage() {
    QCOMPARE(languageOfLocale("de_DE.UTF-8"), std::string("de"));
    QCOMPARE(languageOfLocale("tr"), std::string("tr"));
    QCOMPARE(languageOfLocale("es_MX@euro"), std::string("es"));
    for (const char* other : {"C", "C.UTF-8", "POSIX", "en_GB.UTF-8", "fr_FR", ""})
      QCOMPARE(languageOfLocale(other), std::string("en"));
  }

  void theOptionIsTakenOutOfTheWords() {
    Words words{"analyze", "--language", "de", "file", "--json"};
    QCOMPARE(*taken(words), std::string("de"));
    QCOMPARE(words, (Words{"analyze", "file", "--json"}));
    words = {"--language=tr", "--help"};
    QCOMPARE(*taken(words), std::string("tr"));
    QCOMPARE(words, (Words{"--help"}));
    words = {"analyze", "--", "--language", "de"};
    QVERIFY(!taken(words));
    QCOMPARE(words.size(), std::size_t(4));
    QCOMPARE(languageErrorOf({"--language"}),
             std::string("The option --language needs a value: --language en|de|tr|es."));
    QCOMPARE(languageErrorOf({"--language", "xx"}), std::string("--language is one of en, de, tr, es."));
  }

  /// LC_ALL goes before LC_MESSAGES, which goes before LANG; the option goes before all.
  void theEnvironmentNamesTheLanguage() {
    const QStringList help{"analyze", "--help"};
    const QString english = said(help);
    const QString german = said({"analyze", "--help", "--language", "de"});
    QVERIFY2(english.contains("Analyses a mechanism") && german.contains("Analysiert"), qPrintable(german));
    QCOMPARE(said(help, {{"LANG", "de_DE.UTF-8"}}), german);
    QCOMPARE(said(help, {{"LANG", "en_US.UTF-8"}, {"LC_MESSAGES", "de_DE.UTF-8"}}), german);
    QCOMPARE(said(help, {{"LC_MESSAGES", "de_DE.UTF-8"}, {"LC_ALL", "C"}}), english);
    QCOMPARE(said({"analyze", "--help", "--language", "en"}, {{"LANG", "de_DE.UTF-8"}}), english);
    QCOMPARE(said(help, {{"LANG", "fr_FR.UTF-8"}}), english);
  }

  /// A script reads the same in every country.
  void filesAndJsonStayAsTheyAre() {
    const QMap<QString, QString> turkish{{"LANG", "tr_TR.UTF-8"}};
    for (const QStringList& words :
         {QStringList{"analyze", kRobot, "--json"}, QStringList{"validate", kBroken, "--json"},
          QStringList{"export", kRobot, "--to", "csv", "--matrix", "p", "-o", "-"},
          QStringList{"convert", kRobot, "--to", "csv"}, QStringList{"convert", kRobot, "--to", "dot"}}) {
      const QString english = said(words, {}, QProcess::SeparateChannels);
      QVERIFY2(english.size() > 100, qPrintable(words.join(' ') + english));
      QCOMPARE(said(words, turkish, QProcess::SeparateChannels), english);
    }
  }

  /// The sentences of a diagnostic and of the derivation follow, codes and places do not.
  void sentencesFollowTheLanguage() {
    for (const char* language : {"de", "tr", "es"}) {
      const QStringList english = said({"validate", kBroken}).split('\n');
      const QStringList other = said({"validate", kBroken, "--language", language}).split('\n');
      QCOMPARE(other.size(), english.size());
      int differing = 0;
      for (qsizetype i = 0; i < english.size(); ++i) {
        QCOMPARE(other[i].section(": ", 0, 1).section(' ', 0, 0),
                 english[i].section(": ", 0, 1).section(' ', 0, 0));
        QCOMPARE(other[i].section('[', -1), english[i].section('[', -1));
        differing += other[i] == english[i] ? 0 : 1;
      }
      QVERIFY2(differing > 0, qPrintable(other.join('\n')));
      const QStringList derivation{"export", kRobot, "--to", "md", "-o", "-"};
      const QString text = said(derivation);
      const QString spoken = said(derivation + QStringList{"--language", language});
      QVERIFY(spoken.size() > text.size() / 2 && spoken != text);
      for (const QString& line : text.split('\n')) {
        if (line.size() < 40 || line.contains(QRegularExpression("[$|&\\\\]|Amirinezhad"))) continue;
        QVERIFY2(!spoken.contains(line), qPrintable(QString(language) + ": " + line));
      }
    }
  }
};

}  // namespace geargraph::cli

QTEST_GUILESS_MAIN(geargraph::cli::CliLanguageTest)
#include "test_cli_language.moc"
