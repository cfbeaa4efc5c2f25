// Reads a document and prints the speed of every other joint over those of the inputs, as fractions and in
// the gear ratios: speed_ratios robot.geargraph

#include <core/mechanism/document_format/mechanism_file.h>
#include <core/theory/analysis/analysis.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

namespace {

void print(const geargraph::Diagnostics& diagnostics) {
  for (const geargraph::Diagnostic& diagnostic : diagnostics) {
    std::cerr << severityName(diagnostic.severity()) << ": " << diagnostic.message << '\n';
  }
}

/// "w10 = -1/2 w8", then the same in symbols, a line for each joint that is no input.
void printSpeeds(const geargraph::AnalysisSnapshot& snapshot) {
  const geargraph::ExactSolution& exact = *snapshot.solved->exact;
  const auto& symbolic = snapshot.solved->symbolic;
  for (std::size_t row = 0; row < exact.outputs.size(); ++row) {
    std::string numbers, symbols;
    for (std::size_t column = 0; column < exact.inputs.size(); ++column) {
      const std::size_t at = row * exact.inputs.size() + column;
      if (exact.matrix[at].isZero()) continue;
      const std::string input = " w" + std::to_string(snapshot.graph->edgeLabel(exact.inputs[column]));
      numbers += (numbers.empty() ? "" : " + ") + exact.matrix[at].toString() + input;
      if (symbolic && symbolic->matrix[at])
        symbols += (symbols.empty() ? "" : " + ") + ('(' + symbolic->matrix[at]->toText() + ')') + input;
    }
    std::cout << 'w' << snapshot.graph->edgeLabel(exact.outputs[row]) << " = "
              << (numbers.empty() ? "0" : numbers) << (symbols.empty() ? "" : " = " + symbols) << '\n';
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "Usage: speed_ratios FILE.geargraph\n";
    return 2;
  }
  std::ifstream file(words[1], std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const geargraph::Expected<geargraph::Mechanism> mechanism = geargraph::readMechanism(text);
  if (!mechanism) {
    print(mechanism.error());
    return 1;
  }
  const geargraph::SnapshotPtr snapshot =
      geargraph::analyze(std::make_shared<const geargraph::Mechanism>(*mechanism));
  print(snapshot->diagnostics);
  if (!snapshot->solved || !snapshot->solved->exact) return 1;
  std::cout << snapshot->matroid()->dof << " degrees of freedom\n";
  printSpeeds(*snapshot);
}
