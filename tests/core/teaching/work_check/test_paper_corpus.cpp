#include <QTest>
#include <map>
#include <set>

#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "core/teaching/exercises/exercise_random.h"
#include "core/teaching/work_check/work_check.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {

/// All matrices of the examples, of textbook trains and of random ones: right in every permitted form, and
/// with every kind of mistake never right.
class PaperCorpusTest : public QObject {
  Q_OBJECT

  using Texts = std::vector<std::vector<std::string>>;
  struct Matrix {
    PaperMatrix kind = PaperMatrix::incidence;
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    Texts cells;
    std::vector<std::vector<char>> vanishes = {};  ///< a formula that is 0 for these teeth
  };
  struct Counts {
    long long right = 0, rightForms = 0, permuted = 0, ambiguous = 0, mistakes = 0, named = 0;
    std::map<std::string, int> names;
  };
  Counts m_counts;

  static Matrix matrixOf(const DerivedTable& table) {
    Matrix matrix{table.kind, {}, {}, {}};
    for (const Heading& heading : table.rows) matrix.rows.push_back(heading.text);
    for (const Heading& heading : table.columns) matrix.columns.push_back(heading.text);
    for (const auto& row : table.entries) {
      auto& texts = matrix.cells.emplace_back();
      auto& vanishes = matrix.vanishes.emplace_back();
      for (const DerivedEntry& entry : row) {
        texts.push_back(entryText(entry));
        vanishes.push_back(entry.value.isZero() && texts.back() != "0" ? 1 : 0);
      }
    }
    return matrix;
  }
  static std::string labelled(const Matrix& matrix) {
    std::string text;
    for (const std::string& column : matrix.columns) text += ';' + column;
    for (std::size_t i = 0; i < matrix.cells.size(); ++i) {
      text += '\n' + matrix.rows[i];
      for (const std::string& cell : matrix.cells[i]) text += ';' + cell;
    }
    return text;
  }
  /// In brackets, where nothing can be taken for a label.
  static std::string unlabelled(const Matrix& matrix) {
    std::string text = "[";
    for (const auto& row : matrix.cells) {
      for (const std::string& cell : row) text += "(" + cell + "), ";
      text.resize(text.size() - 2);
      text += ";\n";
    }
    return text + ']';
  }
  static Matrix shuffled(const Matrix& matrix, ExerciseRandom& random, bool hasColumns) {
    const auto order = [&](std::size_t count, bool isShuffled) {
      std::vector<std::size_t> places(count);
      for (std::size_t i = 0; i < count; ++i) places[i] = i;
      for (std::size_t i = count; isShuffled && i > 1; --i)
        std::swap(places[i - 1], places[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
      return places;
    };
    const auto rows = order(matrix.rows.size(), true);
    const auto columns = order(matrix.columns.size(), hasColumns);
    Matrix changed{matrix.kind, {}, {}, {}};
    for (const std::size_t column : columns) changed.columns.push_back(matrix.columns[column]);
    for (const std::size_t row : rows) {
      changed.rows.push_back(matrix.rows[row]);
      auto& cells = changed.cells.emplace_back();
      for (const std::size_t column : columns) cells.push_back(matrix.cells[row][column]);
    }
    return changed;
  }
  /// Rows turned round or multiplied, where that is permitted.
  static Matrix scaled(Matrix matrix, ExerciseRandom& random) {
    const RowFreedom freedom = rowFreedom(matrix.kind);
    if (freedom == RowFreedom::none) return matrix;
    for (auto& row : matrix.cells) {
      const std::string factor =
          freedom == RowFreedom::sign ? "-1" : random.oneOf<std::string>({"-1", "7/3", "-20"});
      if (random.below(2) == 0) continue;
      for (std::string& cell : row) cell = factor + "*(" + cell + ')';
    }
    return matrix;
  }

  static MatrixVerdict check(const ExerciseSource& source, const std::string& text,
                             std::optional<PaperMatrix> kind) {
    auto verdict = checkPaper(source, text, kind);
    if (!verdict) qWarning("%s", verdict.error().front().message.c_str());
    return verdict ? std::get<MatrixVerdict>(*verdict) : MatrixVerdict{};
  }

  void expectRight(const ExerciseSource& source, const std::string& text, PaperMatrix kind) {
    const MatrixVerdict verdict = check(source, text, kind);
    QVERIFY2(verdict.outcome == WorkOutcome::right,
             (text + "\n" + (verdict.differences.empty() ? "" : verdict.differences.front().reason)).c_str());
    QVERIFY(verdict.differences.empty());
    ++m_counts.rightForms;
  }

  void checkRightForms(const ExerciseSource& source, const Matrix& matrix, ExerciseRandom& random) {
    ++m_counts.right;
    expectRight(source, labelled(matrix), matrix.kind);
    expectRight(source, unlabelled(matrix), matrix.kind);
    expectRight(source, labelled(scaled(shuffled(matrix, random, true), random)), matrix.kind);
    for (const bool hasColumns : {false, true}) {
      const std::string text = unlabelled(scaled(shuffled(matrix, random, hasColumns), random));
      const MatrixVerdict verdict = check(source, text, matrix.kind);
      QVERIFY2(verdict.outcome != WorkOutcome::wrong, text.c_str());
      ++(verdict.outcome == WorkOutcome::right ? m_counts.permuted : m_counts.ambiguous);
    }
    const MatrixVerdict recognised = check(source, labelled(matrix), {});
    QVERIFY(recognised.outcome == WorkOutcome::right && recognised.isRecognised);
  }

  void expectWrong(const ExerciseSource& source, const Matrix& matrix,
                   const std::vector<EntryPlace>& places) {
    const MatrixVerdict verdict = check(source, labelled(matrix), matrix.kind);
    QVERIFY2(verdict.outcome == WorkOutcome::wrong, labelled(matrix).c_str());
    QVERIFY(!verdict.differences.empty());
    ++m_counts.mistakes;
    std::set<std::pair<int, int>> marked;
    for (const WorkDifference& difference : verdict.differences) {
      QVERIFY(!paperMistakeTitle(difference.name).empty());
      QVERIFY(difference.reason.ends_with('.'));
      ++m_counts.names[difference.name];
      if (difference.name != "wrong-entry") ++m_counts.named;
      if (difference.entries.empty()) return;
      for (const EntryPlace& place : difference.entries) marked.emplace(place.row, place.column);
    }
    for (const EntryPlace& place : places) {
      // In a row of which a multiple is permitted, the entries that differ depend on the multiple.
      if (matrix.kind == PaperMatrix::coefficients) {
        QVERIFY(
            std::any_of(marked.begin(), marked.end(), [&](const auto& m) { return m.first == place.row; }));
      } else if (rowFreedom(matrix.kind) == RowFreedom::none) {
        QVERIFY2(marked.contains({place.row, place.column}), labelled(matrix).c_str());
      }
    }
  }

  void checkMistakes(const ExerciseSource& source, const Matrix& matrix, ExerciseRandom& random) {
    const bool isFree = rowFreedom(matrix.kind) == RowFreedom::multiple;
    for (int round = 0; round < 6; ++round) {
      const auto row = static_cast<std::size_t>(random.below(static_cast<int>(matrix.rows.size())));
      const auto column = static_cast<std::size_t>(random.below(static_cast<int>(matrix.columns.size())));
      Matrix changed = matrix;
      std::string& cell = changed.cells[row][column];
      const bool isZero = cell == "0";
      cell = isZero ? random.oneOf<std::string>({"1", "-1", "2"})
                    : random.oneOf<std::string>({"0", "-(" + cell + ")", "3*(" + cell + ")"});
      const auto filled = std::count_if(matrix.cells[row].begin(), matrix.cells[row].end(),
                                        [](const std::string& c) { return c != "0"; });
      // A row with one entry may be written with any multiple of it, and either sign.
      const bool isPermitted =
          !isZero && filled == 1 && cell != "0" &&
          (isFree || (rowFreedom(matrix.kind) == RowFreedom::sign && cell.starts_with("-(")));
      if (isPermitted || matrix.vanishes[row][column] != 0) continue;
      expectWrong(source, changed, {{static_cast<int>(row), static_cast<int>(column)}});
    }
    for (std::size_t row = 0; row + 1 < matrix.rows.size(); ++row) {
      Matrix swapped = matrix;
      std::swap(swapped.cells[row], swapped.cells[row + 1]);
      if (check(source, labelled(swapped), matrix.kind).outcome == WorkOutcome::right) {
        // Equal rows, or equal up to what is permitted; where a mesh is redundant in other symbols.
        QVERIFY(matrix.kind >= PaperMatrix::coefficients || matrix.cells[row] == matrix.cells[row + 1] ||
                rowFreedom(matrix.kind) == RowFreedom::sign);
        continue;
      }
      expectWrong(source, swapped, {});
    }
  }

  void checkTransposedAndExchanged(const ExerciseSource& source, const Matrix& matrix) {
    Matrix turned{matrix.kind, matrix.columns, matrix.rows, {}};
    for (std::size_t column = 0; column < matrix.columns.size(); ++column) {
      auto& row = turned.cells.emplace_back();
      for (const auto& cells : matrix.cells) row.push_back(cells[column]);
    }
    if (matrix.rows.size() != matrix.columns.size()) expectWrong(source, turned, {});
    if (rowFreedom(matrix.kind) != RowFreedom::none) return;
    Matrix exchanged = matrix;
    for (auto& row : exchanged.cells) {
      for (std::string& cell : row) cell = cell == "0" ? cell : "-(" + cell + ')';
    }
    if (exchanged.cells != matrix.cells) expectWrong(source, exchanged, {});
  }

  void checkMechanism(const Mechanism& mechanism, std::uint64_t seed) {
    if (mechanism.n() > kMaxExerciseLinks || mechanism.n() == 0) return;
    const ExerciseSource source(mechanism);
    if (source.tree() == nullptr) return;
    const Vocabulary vocabulary(source);
    ExerciseRandom random(seed);
    for (const PaperMatrix kind : allPaperMatrices()) {
      const auto table = derivedTable(vocabulary, kind);
      if (!table || table->height() == 0 || table->width() == 0) continue;
      const Matrix matrix = matrixOf(*table);
      checkRightForms(source, matrix, random);
      checkMistakes(source, matrix, random);
      checkTransposedAndExchanged(source, matrix);
      if (QTest::currentTestFailed()) {
        qWarning("%s: %s", mechanism.name.c_str(), std::string(paperMatrixName(kind)).c_str());
        return;
      }
    }
  }

 private slots:
  void examples() {
    for (const std::string& name : test::exampleNames()) {
      checkMechanism(test::example(name), 11);
      if (QTest::currentTestFailed()) return;
    }
  }
  void textbookTrains() {
    for (const auto& train : test::textbookTrains()) {
      checkMechanism(train.mechanism, 12);
      if (QTest::currentTestFailed()) return;
    }
  }
  void randomTrains() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const int links = 3 + static_cast<int>(seed % 8);
      checkMechanism(test::randomTrain(seed, links, 1 + static_cast<int>(seed % 5)), seed);
      if (QTest::currentTestFailed()) return;
    }
  }

  /// What this program writes for other programs can be read again.
  void whatIsExported_isRight() {
    const ExerciseSource source(test::example("robot"));
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(source.mechanism()));
    for (const PaperMatrix kind : allPaperMatrices()) {
      const NamedResult& result = *resultNamed(paperMatrixName(kind));
      for (const EntryForm form : result.forms({snapshot})) {
        const ResultTablePtr table = resultTable(result, {snapshot}, form);
        for (const TableFormat format : {TableFormat::csv, TableFormat::tsv, TableFormat::latex})
          expectRight(source, resultText(*table, format), kind);
        if (!result.isWhole) continue;
        for (const TableFormat format : {TableFormat::matlab, TableFormat::numpy})
          expectRight(source, resultText(*table, format), kind);
      }
    }
  }

  void theCorpusIsLarge() {
    qInfo(
        "%lld matrices, right in %lld forms, unlabelled in another order %lld right and %lld ambiguous, %lld "
        "mistakes, %lld named",
        m_counts.right, m_counts.rightForms, m_counts.permuted, m_counts.ambiguous, m_counts.mistakes,
        m_counts.named);
    for (const auto& [name, count] : m_counts.names) qInfo("%s %d", name.c_str(), count);
    QVERIFY(m_counts.right > 400);
    QVERIFY(m_counts.mistakes > 4'000);
    QVERIFY(m_counts.permuted > 20 * m_counts.ambiguous / 10);
    QVERIFY(m_counts.named * 10 > m_counts.mistakes * 7);
    QVERIFY(m_counts.names.size() >= 20);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::PaperCorpusTest)
#include "test_paper_corpus.moc"
