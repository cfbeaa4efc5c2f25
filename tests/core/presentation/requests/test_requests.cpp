#include <QTest>
#include <nlohmann/json.hpp>

#include "core/presentation/requests/request_server.h"

using nlohmann::json;

using namespace geargraph;

namespace {

/// A server within this process, whose one hosted method keeps what it was asked.
class HostedServer {
 public:
  json ask(const char* method, const json& params) {
    return json::parse(m_server.answerTo(json{{"id", 7}, {"method", method}, {"params", params}}.dump()));
  }
  [[nodiscard]] const std::vector<std::string>& words() const { return m_words; }
  [[nodiscard]] const HostedTexts& texts() const { return m_texts; }

 private:
  std::vector<std::string> m_words;
  HostedTexts m_texts;
  RequestServer m_server{
      {{"count", MethodInput::documentAndWish, {}, {"--table"}}},
      [this](const HostedMethod&, std::vector<std::string> words, const HostedTexts& texts) {
        m_words = std::move(words);
        m_texts = texts;
        return HostedOutcome{0, R"({"links": 2})", "a note", {}};
      }};
};

}  // namespace

/// What `serve` answers, without a process or a standard input.
class RequestsTest : public QObject {
  Q_OBJECT
 private slots:
  void documentsAreEditedAndWritten() {
    HostedServer server;
    const json opened = server.ask("open", {{"text", "format,geargraph-table\n"}});
    QVERIFY(opened.contains("error"));  // a table without rows is no mechanism
    const json empty = server.ask(
        "open",
        {{"text", {{"format", "geargraph"}, {"version", 1}, {"links", json::array({{{"id", "0"}}})}}}});
    QCOMPARE(empty.at("id"), 7);
    const json document = empty.at("result").at("document");
    const json edited = server.ask(
        "edit", {{"document", document}, {"edits", json::array({{{"edit", "addLink"}, {"name", "sun"}}})}});
    QCOMPARE(edited.at("result").at("added").at("links").size(), 1U);
    const std::string text = server.ask("text", {{"document", document}}).at("result").at("text");
    QCOMPARE(json::parse(text).at("links").at(1).at("name"), "sun");
    QVERIFY(server.ask("close", {{"document", document}}).contains("result"));
    QCOMPARE(server.ask("text", {{"document", document}}).at("error").at("code"), "unknown-document");
  }

  void hostedMethodsGetTextsAndWords() {
    HostedServer server;
    const json document =
        server
            .ask("open",
                 {{"text",
                   {{"format", "geargraph"}, {"version", 1}, {"links", json::array({{{"id", "0"}}})}}}})
            .at("result")
            .at("document");
    const json answer = server.ask(
        "count", {{"document", document}, {"wish", {{"ratio", 4}}}, {"arguments", json::array({"--json"})}});
    QCOMPARE(answer.at("result").at("output").at("links"), 2);
    QCOMPARE(answer.at("result").at("messages"), "a note");
    QCOMPARE(server.words(), (std::vector<std::string>{"--json", "-", std::string(kSecondInput)}));
    QCOMPARE(json::parse(server.texts().second), (json{{"ratio", 4}}));
    QCOMPARE(json::parse(server.texts().first).at("format"), "geargraph");
  }

  /// Nothing that is hosted reads or writes a file of the program's.
  void wordsThatReachFilesAreRejected_data() {
    QTest::addColumn<QString>("word");
    for (const char* word : {"--table", "-ofile", "--force", "other.geargraph", "--limit-seconds=3"})
      QTest::newRow(word) << word;
  }
  void wordsThatReachFilesAreRejected() {
    QFETCH(QString, word);
    HostedServer server;
    const json answer =
        server.ask("count", {{"document", "1"}, {"arguments", json::array({word.toStdString()})}});
    QCOMPARE(answer.at("error").at("code"), "request");
    QVERIFY(server.words().empty());
  }
};

QTEST_GUILESS_MAIN(RequestsTest)
#include "test_requests.moc"
