#include <QTest>

#include "app/cli/arguments.h"
#include "app/cli/command.h"

namespace geargraph::cli {
namespace {

using Words = std::vector<std::string>;

std::variant<Arguments, UsageError> parsed(const Words& words) {
  static constexpr std::array kKnown = {Option{"--json", "", ""}, Option{"--speed", "8=1/2", ""},
                                        Option{"-o", "OUT", ""}};
  return parseArguments(words, kKnown);
}

Arguments read(const Words& words) {
  auto result = parsed(words);
  return std::holds_alternative<Arguments>(result) ? std::get<Arguments>(result) : Arguments{};
}

std::string errorOf(const Words& words) {
  const auto result = parsed(words);
  const auto* error = std::get_if<UsageError>(&result);
  return error == nullptr ? "" : error->message;
}

}  // namespace

class ArgumentsTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesFollowAsAWordOrAfterAnEqualsSign() {
    QCOMPARE(read({"--speed", "8=1"}).values("--speed"), Words{"8=1"});
    QCOMPARE(read({"--speed=8=1"}).values("--speed"), Words{"8=1"});
    QCOMPARE(read({"-o", "out"}).values("-o"), Words{"out"});
    QCOMPARE(read({"--speed", "1", "--speed=2"}).values("--speed"), (Words{"1", "2"}));
    QCOMPARE(*read({"--speed", "1", "--speed=2"}).value("--speed"), std::string("2"));
  }

  /// A speed may be negative, a file be called anything.
  void aValueMayLookLikeAnOptionOrBeEmpty() {
    for (const char* value : {"-1/3", "-", "--", "--json", "-o", "[a,b]", "{}", ""}) {
      const Arguments arguments = read({"--speed", value, "file"});
      QCOMPARE(arguments.values("--speed"), Words{value});
      QCOMPARE(arguments.files, Words{"file"});
      QVERIFY(!arguments.has("--json"));
    }
    const Arguments empty = read({"--speed=", "file"});
    QCOMPARE(empty.values("--speed"), Words{""});
    QCOMPARE(empty.files, Words{"file"});
  }

  void theOtherWordsAreFiles() {
    QCOMPARE(read({"a", "--json", "b"}).files, (Words{"a", "b"}));
    QCOMPARE(read({"-", "[a]", ""}).files, (Words{"-", "[a]", ""}));
    const Arguments dashed = read({"--json", "--", "--json", "-x", "--"});
    QCOMPARE(dashed.files, (Words{"--json", "-x", "--"}));
    QVERIFY(dashed.has("--json"));
    QVERIFY(read({}).files.empty());
    QVERIFY(read({"--json", "--json"}).has("--json"));
  }

  void whatIsWrongIsNamed() {
    QCOMPARE(errorOf({"--jason", "a"}), std::string("There is no option \"--jason\" here."));
    QCOMPARE(errorOf({"--js=1"}), std::string("There is no option \"--js\" here."));
    QCOMPARE(errorOf({"a", "-5"}), std::string("There is no option \"-5\" here."));
    QCOMPARE(errorOf({"--json=1"}), std::string("The option --json takes no value."));
    QCOMPARE(errorOf({"a", "--speed"}), std::string("The option --speed needs a value: --speed 8=1/2."));
    QCOMPARE(errorOf({"-o"}), std::string("The option -o needs a value: -o OUT."));
  }

  /// CLI11 would abort on a table with two options of one name.
  void theOptionsOfEveryCommandAreRead() {
    for (const Command* command : commands()) {
      for (const Option& option : command->options) {
        Words words{"file", std::string(option.name)};
        if (!option.value.empty()) words.emplace_back("x");
        const auto result = parseArguments(words, command->options);
        QVERIFY2(std::holds_alternative<Arguments>(result), words.back().c_str());
        QVERIFY(std::get<Arguments>(result).has(option.name));
      }
    }
  }
};

}  // namespace geargraph::cli

QTEST_APPLESS_MAIN(geargraph::cli::ArgumentsTest)
#include "test_arguments.moc"
