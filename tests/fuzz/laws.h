#pragma once

#include <string>
#include <string_view>

namespace geargraph::test {

// What has to hold for every input: the seeded mutations, libFuzzer and the kept corpus all check these. A
// law that does not hold prints a sentence and the input on standard error and aborts.

[[noreturn]] void lawFailed(const char* what, std::string_view input);

/// The reader takes for JSON what nlohmann's takes, apart from its own limits; what it accepts is well formed
/// and survives writing and reading; what it rejects it explains. True where it accepted the document.
bool checkReader(const std::string& text);

/// A table is read into a mechanism that can be saved, opened and written as a table again, or its faults are
/// sentences with a place. True where it was read.
bool checkTable(const std::string& text);

/// A graph is read into a mechanism that can be saved, opened and written as a graph in every form again, or
/// its faults are sentences with a place. True where it was read.
bool checkGraph(const std::string& text);

enum class Analysed { rejected, withErrors, withNumbers };
/// A document without errors gets numbers, on which both methods agree; one with errors gets none.
Analysed checkAnalysis(const std::string& text);

/// A formula is read or its fault is a sentence; what was read is set in finite boxes, at any width.
void checkTex(const std::string& text);

/// Commands of geargraph-cli and every exporter on a document: the first byte chooses, the rest is the
/// document. Each ends with a documented exit status; JSON is JSON; no number of the output is nan or inf.
/// Documents of more than 40 links or 3,000 teeth are left out: their cost is benchmarked.
void checkExports(const std::string& input);

/// assimp's reader of foreign files in this process, which may crash in assimp: the first byte chooses the
/// format. A solid is sound, an error is a sentence.
void checkMeshHere(const std::string& input);
/// The same in the process of geargraph-mesh, as the program reads them: whatever the file does, there is a
/// solid or a sentence.
void checkMeshConfined(const std::string& input);

/// What the confined reader answers, as its parent takes it: a sound solid, which packs into the same bytes,
/// or nothing.
void checkMeshAnswer(const std::string& bytes);

}  // namespace geargraph::test
