#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "core/foundations/files/csv.h"
#include "core/foundations/files/json_writer.h"
#include "tests/core/support/aborts.h"

using namespace geargraph;

namespace {

struct Entry {
  int column = 0;
  int value = 0;
};

const std::vector<std::string> kLabels = {"8", "9", "10"};

std::string written(const CsvOptions& options, const std::vector<std::vector<Entry>>& rows,
                    const std::vector<std::string>& columns = kLabels) {
  TextSink sink;
  {
    CsvWriter csv(sink, columns, options);
    for (std::size_t i = 0; i < rows.size(); ++i)
      csv.row("C" + std::to_string(i), std::span<const Entry>(rows[i]));
  }
  return sink.take();
}

/// Reads CSV back by RFC 4180, independent of the writer.
std::vector<std::vector<std::string>> parsed(const std::string& text, char separator) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
        rows.back().back() += text[++i];
      } else if (c == '"') {
        quoted = false;
      } else {
        rows.back().back() += c;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == separator) {
      rows.back().emplace_back();
    } else if (c == '\n') {
      rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

}  // namespace

class CsvTest : public QObject {
  Q_OBJECT

 private slots:
  void labelsStandAboveAndBeside() {
    QCOMPARE(written({}, {{{0, 1}, {2, -1}}, {}}), std::string(",8,9,10\nC0,1,0,-1\nC1,0,0,0\n"));
  }

  void optionsAreFollowed() {
    CsvOptions options;
    options.labels = false;
    QCOMPARE(written(options, {{{1, -1}}, {{0, 12}}}), std::string("0,-1,0\n12,0,0\n"));
    options.separator = ';';
    options.byteOrderMark = true;
    QCOMPARE(written(options, {{{1, -1}}}), std::string("\xEF\xBB\xBF"
                                                        "0;-1;0\n"));
    options = {};
    options.separator = '\t';
    QCOMPARE(written(options, {{{2, 1}}}), std::string("\t8\t9\t10\nC0\t0\t0\t1\n"));
  }

  void tablesWithoutColumnsOrRows() {
    QCOMPARE(written({}, {{}, {}}, {}), std::string("\nC0\nC1\n"));
    QCOMPARE(written({}, {}), std::string(",8,9,10\n"));
  }

  void labelsAreHarmless() {
    for (const char* formula : {"=1+2", "+1", "-1", "@x", "\tx", "\rx"}) {
      const std::string field = csvLabel(formula, ',');
      QCOMPARE(parsed(field + "\n", ',')[0][0], "'" + std::string(formula));
    }
    QCOMPARE(csvLabel("8", ','), std::string("8"));
    QCOMPARE(csvLabel("", ','), std::string());
    QCOMPARE(csvLabel("a,b", ','), std::string("\"a,b\""));
    QCOMPARE(csvLabel("a,b", ';'), std::string("a,b"));
    QCOMPARE(csvLabel("say \"x\"", ','), std::string("\"say \"\"x\"\"\""));
    QCOMPARE(csvLabel("two\nlines", ','), std::string("\"two\nlines\""));
    QCOMPARE(csvLabel("=cmd|' /C calc'!A0", ','), std::string("'=cmd|' /C calc'!A0"));
  }

  void realNumbersFollowTheDecimalChoice() {
    CsvOptions options;
    options.labels = false;
    const auto field = [&](double value) {
      TextSink sink;
      CsvWriter(sink, std::vector<std::string>{"8"}, options).row("", std::vector<double>{value});
      return sink.take();
    };
    QCOMPARE(field(-0.5), std::string("-0.5\n"));
    QCOMPARE(field(0.1), std::string("0.1\n"));
    QCOMPARE(field(-2.2250738585072014e-308), std::string("-2.2250738585072014e-308\n"));
    options.decimalPoint = ',';
    QCOMPARE(field(-0.5), std::string("\"-0,5\"\n"));
    QCOMPARE(field(-7), std::string("-7\n"));
    QCOMPARE(field(-2.2250738585072014e-308), std::string("\"-2,2250738585072014e-308\"\n"));
    options.separator = ';';
    QCOMPARE(field(-0.5), std::string("-0,5\n"));
    options.labels = true;
    TextSink sink;
    {
      CsvWriter csv(sink, kLabels, options);
      csv.row("10", std::vector<double>{1, -0.5, 2.25});
    }
    QCOMPARE(sink.text(), std::string(";8;9;10\n10;1;-0,5;2,25\n"));
  }

  void numbersThatAreNotFiniteAreABrokenContract() {
    for (const double value : {std::numeric_limits<double>::infinity(), -HUGE_VAL, std::nan("")}) {
      TextSink table, object;
      QVERIFY(test::aborts(
          [&] { CsvWriter(table, std::vector<std::string>{"8"}, {}).row("", std::vector<double>{value}); }));
      QVERIFY(test::aborts([&] { JsonWriter(object).number(value); }));
      JsonWriter(object).numberOrNull(value);
      QCOMPARE(object.take(), std::string("null"));
    }
    QVERIFY(!test::aborts([] {}));
    TextSink sink;
    JsonWriter(sink).numberOrNull(-0.5);
    QCOMPARE(sink.take(), std::string("-0.5"));
  }

  void sparseRowsOfRealNumbersAreTheFullOnes() {
    struct Entry {
      int column = 0;
      double value = 0;
    };
    std::mt19937_64 random(3);
    for (const int columns : {1, 5, 100}) {
      std::vector<std::string> labels;
      for (int column = 0; column < columns; ++column) labels.push_back(std::to_string(column));
      for (const CsvOptions& options :
           {CsvOptions{}, CsvOptions{';', ',', true, false}, CsvOptions{',', ',', false, true}}) {
        TextSink sparse, full;
        {
          CsvWriter one(sparse, labels, options), other(full, labels, options);
          for (int row = 0; row < 50; ++row) {
            std::vector<Entry> entries;
            std::vector<double> values(labels.size(), 0);
            for (int column = 0; column < columns; ++column) {
              if (random() % 3 != 0) continue;
              entries.push_back({column, std::ldexp(static_cast<double>(random() % 2001) - 1000, row - 25)});
              values[static_cast<std::size_t>(column)] = entries.back().value;
            }
            one.sparseRow("r", std::span<const Entry>(entries));
            other.row("r", values);
          }
        }
        QCOMPARE(sparse.text(), full.text());
      }
    }
  }

  /// Every pattern of runs, gaps and values comes back as it went in.
  void randomMatricesReadBack() {
    std::mt19937_64 random(7);
    for (int round = 0; round < 300; ++round) {
      const int columns = static_cast<int>(random() % 70 + 1);
      const auto density = random() % 10;
      const std::vector<std::string> labels(static_cast<std::size_t>(columns), "=\"x\",");
      std::vector<std::vector<Entry>> rows(random() % 5 + 1);
      std::vector<std::vector<std::string>> expected;
      for (auto& row : rows) {
        expected.emplace_back(static_cast<std::size_t>(columns), "0");
        for (int column = 0; column < columns; ++column) {
          if (random() % 10 >= density) continue;
          const int value = random() % 20 == 0 ? static_cast<int>(random()) : (random() % 3 == 0 ? 1 : -1);
          row.push_back({column, value});
          expected.back()[static_cast<std::size_t>(column)] = std::to_string(value);
        }
      }
      auto table = parsed(written({}, rows, labels), ',');
      QCOMPARE(table.front().size(), static_cast<std::size_t>(columns) + 1);
      QCOMPARE(table.front().back(), std::string("'=\"x\","));
      table.erase(table.begin());
      for (std::size_t i = 0; i < table.size(); ++i) {
        QCOMPARE(table[i].front(), "C" + std::to_string(i));
        table[i].erase(table[i].begin());
      }
      QVERIFY(table == expected);
    }
  }

  /// Rows given as sets of columns look as the same rows given as entries.
  void signRowsAreWhatTheirEntriesAre() {
    std::mt19937_64 random(9);
    for (int round = 0; round < 400; ++round) {
      const auto columns = static_cast<std::size_t>(random() % 300 + 1);
      const int sign = random() % 2 == 0 ? 1 : -1;
      const auto kind = random() % 4;  // empty words, full words, both, and any
      std::vector<std::uint64_t> words((columns + 63) / 64);
      for (auto& word : words)
        word = kind == 3 ? random() : (kind == 2 ? random() % 2 : kind) * ~std::uint64_t{0};
      if (columns % 64 != 0) words.back() &= ~std::uint64_t{0} >> (64 - columns % 64);
      std::vector<Entry> entries;
      for (std::size_t column = 0; column < columns; ++column) {
        if ((words[column / 64] >> (column % 64) & 1U) != 0)
          entries.push_back({static_cast<int>(column), sign});
      }
      const std::vector<std::string> labels(columns, "x");
      TextSink sink;
      {
        CsvWriter csv(sink, labels, {});
        csv.signRow("C0", words, -sign);  // the writer may not remember the sign of the row before
        csv.signRow("C0", words, sign);
      }
      for (Entry& entry : entries) entry.value = -sign;
      const std::string negated = written({}, {entries}, labels);
      for (Entry& entry : entries) entry.value = sign;
      const std::string plain = written({}, {entries}, labels);
      QCOMPARE(sink.text(), negated + plain.substr(plain.find('\n') + 1));
    }
  }

  void longTablesAreWrittenInChunks() {
    const std::vector<std::string> labels(200'000, "1");
    const std::string text = written({}, {{{199'999, 1}}, {{0, -1}}}, labels);
    QCOMPARE(text.size(), std::size_t{2 * 200'000 + 1 + (2 * 200'000 + 3) + (2 * 200'000 + 4)});
  }
};

QTEST_APPLESS_MAIN(CsvTest)
#include "test_csv.moc"
