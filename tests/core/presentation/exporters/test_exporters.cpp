#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <set>

#include "core/presentation/export_api/named_drawings.h"
#include "core/presentation/exporters/exporters.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/snapshot_of.h"
#include "tests/core/support/trains.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

namespace fs = std::filesystem;

/// What an export has told.
struct Heard {
  Diagnostics diagnostics;
  std::vector<ExportNote> notes;
  int readings = 0;
};

ExportContext contextOf(Mechanism mechanism, Heard& heard) {
  ExportSource source;
  source.read = [mechanism, &heard]() -> std::variant<Mechanism, ExportError> {
    ++heard.readings;
    return mechanism;
  };
  source.folder = fs::path(sourcePath("resources/examples"));
  source.diagnose = [&heard](const Diagnostics& found) {
    heard.diagnostics.insert(heard.diagnostics.end(), found.begin(), found.end());
  };
  source.note = [&heard](const ExportNote& note) { heard.notes.push_back(note); };
  return ExportContext(std::move(source));
}

void give(OptionValues& given, std::string_view name, const std::string& value) {
  given.options[std::string(name)] = {value};
}

/// The options of a quick export: what is needed, coarse and small.
OptionValues quickOptions(const Exporter& exporter) {
  OptionValues given;
  for (const ExportOption& option : exporter.options) {
    if (option.isNeeded) give(given, option.name, option.choices().front());
    if (option.name == "--tolerance") give(given, option.name, "0.2");
    if (option.name == "--size") give(given, option.name, "64x48");
    if (option.name == "--frames") give(given, option.name, std::to_string(static_cast<int>(option.least)));
  }
  return withImplied(exporter, std::move(given));
}

/// A link that nothing ties to the ground.
Mechanism looseLink() {
  Mechanism mechanism = emptyMechanism();
  mechanism.links.push_back({LinkId("1"), {}});
  return mechanism;
}

std::vector<std::pair<std::string, Mechanism>> documents() {
  return {{"robot", example("robot")},
          {"simpson", example("simpson")},
          {"spur-pair", example("spur-pair")},
          {"cannot-be-assembled", example("cannot-be-assembled")},
          {"redundant-planetary", example("redundant-planetary")},
          {"robot-to-mend", example("robot-to-mend")},
          {"loose", looseLink()},
          {"empty", emptyMechanism()}};
}

std::string pathFor(const QTemporaryDir& folder, const Exporter& exporter, const std::string& name) {
  const std::string suffix = exporter.suffix.empty() ? "" : "." + std::string(exporter.suffix);
  return folder.filePath(QString::fromStdString(name + "-" + std::string(exporter.id) + suffix))
      .toStdString();
}

/// Bytes of a file or of all files in a folder; 0 where there is none.
std::uintmax_t bytesAt(const fs::path& path) {
  if (!fs::exists(path)) return 0;
  if (!fs::is_directory(path)) return fs::file_size(path);
  std::uintmax_t bytes = 0;
  for (const auto& each : fs::recursive_directory_iterator(path)) {
    if (each.is_regular_file()) bytes += each.file_size();
  }
  return bytes;
}

/// Whether an exporter says that it may refuse for this reason.
bool lists(const Exporter& exporter, std::string_view code) {
  return std::any_of(exporter.refusals.begin(), exporter.refusals.end(),
                     [&](const ExportRefusal* each) { return each->code == code; });
}

/// Does it need a program that is not there?
bool isMissing(const Exporter& exporter) {
  return exporter.missing != nullptr && !exporter.missing().empty();
}

OptionValues optionsOf(std::initializer_list<std::pair<const char*, const char*>> words) {
  OptionValues given;
  for (const auto& [name, value] : words) give(given, name, value);
  return given;
}

}  // namespace

class ExportersTest : public QObject {
  Q_OBJECT

 private slots:
  void entriesAreWhole() {
    std::set<std::string_view> ids, used = {"--to", "-o", "--state", "--engage", "--all", "--force"};
    for (const Exporter* exporter : allExporters()) {
      QVERIFY2(ids.insert(exporter->id).second, exporter->id.data());
      QCOMPARE(exporterWithId(exporter->id), exporter);
      QVERIFY(exporter->write != nullptr && !exporter->title.empty() && !exporter->what.empty());
      QCOMPARE(exporter->suffix.empty(), exporter->files == ExportFiles::folder);
      for (const ExportOption& option : exporter->options) {
        used.insert(option.name);
        QVERIFY(exportOptionText(option.name).name == option.name);
        QVERIFY2(!exportOptionTitle(option.name).empty(), option.name.data());
        QCOMPARE(option.type == OptionType::choice, option.choices != nullptr);
        QCOMPARE(exportOptionText(option.name).value.empty(), option.type == OptionType::flag);
        checkUsual(option);
      }
      for (const auto& [name, value] : exporter->implied) {
        used.insert(name);
        QVERIFY(exportOptionText(name).name == name);
      }
    }
    for (const OptionText& text : exportOptionTexts())
      QVERIFY2(used.contains(text.name), text.name.data());  // else an option that nothing reads
    QVERIFY(exporterWithId("none") == nullptr);
  }

  /// All but the names of formats; two choices of one option never have one title.
  void choicesHaveTitlesInTheLanguageInUse() {
    const test::PseudoLanguage language;
    for (const Exporter* exporter : allExporters()) {
      for (const ExportOption& option : exporter->options) {
        if (option.choices == nullptr) continue;
        std::set<std::string> titles;
        for (const std::string& choice : option.choices()) {
          const std::string title = exportChoiceTitle(option.name, choice);
          QCOMPARE(title.empty(), option.name == "--as");
          QVERIFY2(test::PseudoLanguage::english(title).empty(), title.c_str());
          QVERIFY2(title.empty() || titles.insert(title).second, title.c_str());
        }
      }
    }
    QCOMPARE(exportChoiceTitle("--matrix", "nothing"), std::string());
  }

  void theOptionsChooseTheExporter() {
    const auto chosen = [](std::string_view form, const OptionValues& given) {
      const Exporter* exporter = exporterOf(form, given);
      return exporter == nullptr ? std::string_view("-") : exporter->id;
    };
    QCOMPARE(chosen("pdf", {}), std::string_view("pdf"));
    QCOMPARE(chosen("pdf", optionsOf({{"--view", ""}})), std::string_view("pdf"));
    QCOMPARE(chosen("pdf", optionsOf({{"--view", "digraph"}})), std::string_view("pdf-drawing"));
    QCOMPARE(chosen("pdf", optionsOf({{"--view", "3d"}})), std::string_view("pdf-drawing"));
    QCOMPARE(chosen("png", {}), std::string_view("png"));
    QCOMPARE(chosen("png", optionsOf({{"--turntable", ""}})), std::string_view("png"));
    QCOMPARE(chosen("png", optionsOf({{"--view", "3d"}})), std::string_view("png-3d"));
    QCOMPARE(chosen("png", optionsOf({{"--view", "3d"}, {"--turntable", ""}})),
             std::string_view("turntable"));
    QCOMPARE(chosen("png", optionsOf({{"--view", "3d"}, {"--motion", ""}, {"--all", ""}})),
             std::string_view("motion-pictures"));
    QCOMPARE(chosen("glb", {}), std::string_view("glb"));
    QCOMPARE(chosen("glb", optionsOf({{"--view", "digraph"}})), std::string_view("glb"));
    QCOMPARE(chosen("glb", optionsOf({{"--view", "3d"}})), std::string_view("glb-3d"));
    QCOMPARE(chosen("csv", {}), std::string_view("csv"));
    QCOMPARE(chosen("csv", optionsOf({{"--all", ""}})), std::string_view("csv-all"));
    QCOMPARE(chosen("sdf", {}), std::string_view("-"));
    for (const Exporter* exporter : allExporters()) {
      const OptionValues given = quickOptions(*exporter);
      QCOMPARE(chosen(exporter->form, given), exporter->id);
      QVERIFY2(!uselessOption(*exporter, given), exporter->id.data());
    }
  }

  void uselessOptionsAreNamedWithTheirUse() {
    const Exporter& dot = *exporterWithId("dot");
    QVERIFY(!uselessOption(dot, optionsOf({{"--view", "digraph"}, {"--state", "1"}})));
    const auto error = uselessOption(dot, optionsOf({{"--frames", "3"}}));
    QVERIFY(error);
    QCOMPARE(error->message,
             std::string("--frames has no meaning with --to dot; it is an option of animations "
                         "(--turntable, --motion); --to assembly."));
    const auto view = uselessOption(*exporterWithId("stl"), optionsOf({{"--inputs", "8"}}));
    QCOMPARE(view->message,
             std::string("--inputs has no meaning with --to stl; it is an option of derivations (--to html, "
                         "latex, md, pdf); handouts (--to handout, scorm)."));
  }

  void everyExporterWritesOrRefusesEveryDocument() {
    const QTemporaryDir folder;
    std::set<std::string_view> written;
    for (const auto& [name, mechanism] : documents()) {
      const SnapshotPtr live = analyzeLive(std::make_shared<const Mechanism>(mechanism));
      for (const Exporter* exporter : allExporters()) {
        const std::string path = pathFor(folder, *exporter, name);
        const std::string which = name + " " + std::string(exporter->id);
        Heard heard;
        ExportContext context = contextOf(mechanism, heard);
        double done = 0;
        ExportTarget target{path, false, [&](double part) {
                              QVERIFY2(part >= done && part <= 1, which.c_str());
                              done = part;
                            }};
        const ExportResult result = exporter->write(context, quickOptions(*exporter), target, {});
        const auto* error = std::get_if<ExportError>(&result);
        const std::string need = unmetNeed(*exporter, *live);
        if (error == nullptr) {
          QVERIFY2(need.empty(), (which + ": written in spite of: " + need).c_str());
          QVERIFY2(bytesAt(path) > 0, which.c_str());
          written.insert(exporter->id);
          continue;
        }
        QVERIFY2(bytesAt(path) == 0, which.c_str());
        if (exporter->id == "csv") continue;  // of these documents each has the first table
        QVERIFY2(error->kind == ExportError::Kind::mechanism || error->kind == ExportError::Kind::limit,
                 (which + ": " + error->message).c_str());
        QVERIFY2(lists(*exporter, error->code),
                 (which + ": " + std::string(error->code) + ": " + error->message).c_str());
        QVERIFY2(!error->message.empty() || hasErrors(heard.diagnostics), which.c_str());
      }
    }
    for (const Exporter* exporter : allExporters())
      QVERIFY2(written.contains(exporter->id) || isMissing(*exporter), exporter->id.data());
  }

  void aStopLeavesNothing() {
    const QTemporaryDir folder;
    std::stop_source source;
    source.request_stop();
    for (const Exporter* exporter : allExporters()) {
      if (isMissing(*exporter)) continue;
      const std::string path = pathFor(folder, *exporter, "stopped");
      Heard heard;
      ExportContext context = contextOf(example("robot"), heard);
      const ExportResult result =
          exporter->write(context, quickOptions(*exporter), {path}, source.get_token());
      const auto* error = std::get_if<ExportError>(&result);
      QVERIFY2(error != nullptr && error->kind == ExportError::Kind::stopped, exporter->id.data());
      QVERIFY2(!error->message.empty() && bytesAt(path) == 0, exporter->id.data());
    }
  }

  void numbersOutOfBoundsAreRejectedBeforeTheDocumentIsRead() {
    for (const Exporter* exporter : allExporters()) {
      for (const ExportOption& option : exporter->options) {
        if (option.type != OptionType::number) continue;
        for (const double value : {option.least - std::max(1.0, std::abs(option.least)),
                                   option.most + std::max(1.0, std::abs(option.most))}) {
          OptionValues given = quickOptions(*exporter);
          give(given, option.name, QString::number(value, 'g', 17).toStdString());
          Heard heard;
          ExportContext context = contextOf(example("robot"), heard);
          const ExportResult result = exporter->write(context, given, {"/nowhere/at/all"}, {});
          const auto* error = std::get_if<ExportError>(&result);
          const std::string which = std::string(exporter->id) + ' ' + std::string(option.name);
          QVERIFY2(error != nullptr && error->kind == ExportError::Kind::usage, which.c_str());
          QVERIFY2(error->message.find(option.name) != std::string::npos, error->message.c_str());
          QCOMPARE(heard.readings, 0);
        }
      }
    }
  }

  void everyChoiceIsTaken() {
    const QTemporaryDir folder;
    const std::set<std::string_view> slow = {"turntable", "motion", "turntable-pictures", "motion-pictures"};
    for (const Exporter* exporter : allExporters()) {
      for (const ExportOption& option : exporter->options) {
        if (option.type != OptionType::choice || slow.contains(exporter->id)) continue;
        for (const std::string& choice : option.choices()) {
          OptionValues given = quickOptions(*exporter);
          give(given, option.name, choice);
          Heard heard;
          ExportContext context = contextOf(example("robot"), heard);
          ExportTarget target{pathFor(folder, *exporter, std::string(option.name) + choice)};
          const ExportResult result = exporter->write(context, given, target, {});
          const auto* error = std::get_if<ExportError>(&result);
          const bool isOfLoads =
              exporter->id == "csv" && error != nullptr && error->code == "undefined-table";
          QVERIFY2(error == nullptr || isOfLoads,
                   (std::string(exporter->id) + ' ' + choice + ": " + (error ? error->message : "")).c_str());
        }
      }
    }
  }

  void filesThatAreThereStay() {
    const QTemporaryDir folder;
    const Exporter& all = *exporterWithId("csv-all");
    ExportTarget target{folder.filePath("tables").toStdString()};
    for (const bool again : {false, true}) {
      Heard heard;
      ExportContext context = contextOf(example("robot"), heard);
      const ExportResult result = all.write(context, withImplied(all, {}), target, {});
      QCOMPARE(std::holds_alternative<ExportError>(result), again);
    }
    target.mayOverwrite = true;
    Heard heard;
    ExportContext context = contextOf(example("robot"), heard);
    QVERIFY(std::holds_alternative<ExportOutcome>(all.write(context, withImplied(all, {}), target, {})));
  }

  void anAnalysisThatIsThereIsUsed() {
    const SnapshotPtr complete = snapshotOf(example("robot"));
    ExportSource source;
    source.read = [] { return std::variant<Mechanism, ExportError>(example("robot")); };
    source.snapshot = complete;
    ExportContext context(source);
    QCOMPARE(std::get<SnapshotPtr>(context.complete(example("robot"), {})), complete);
    QCOMPARE(std::get<SnapshotPtr>(context.live(example("robot"), {}))->geometry, complete->geometry);
    QVERIFY(std::get<SnapshotPtr>(context.complete(example("simpson"), {})) != complete);
  }

 private:
  /// What holds without an option is one of its values.
  static void checkUsual(const ExportOption& option) {
    if (option.otherwise.empty()) return;
    if (option.type == OptionType::choice) {
      const std::vector<std::string> choices = option.choices();
      QVERIFY(std::find(choices.begin(), choices.end(), option.otherwise) != choices.end());
    }
    if (option.type != OptionType::number) return;
    const auto value = numberFrom<double>(option.otherwise);
    QVERIFY(value && *value >= option.least && *value <= option.most);
  }
};

QTEST_GUILESS_MAIN(ExportersTest)
#include "test_exporters.moc"
