#include "core/theory/ttgraph/notation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace geargraph {
namespace {

constexpr int kCountablePrimes = 4;  // the paper's robot has four; more are written as a number

/// "51", and with a mark between where a label has two digits: "12_3".
std::string pairOf(int a, int b, const char* between) {
  const std::string first = std::to_string(a);
  const std::string second = std::to_string(b);
  return first.size() + second.size() == 2 ? first + second : first + between + second;
}

std::string quotes(int count) {
  return std::string(static_cast<std::size_t>(count), '\'');
}

}  // namespace

std::string VelocityName::toText() const {
  const bool countable = primes <= kCountablePrimes;
  return "w" + pairOf(of, relativeTo, "_") +
         (countable ? quotes(primes) : "(" + std::to_string(primes) + ")");
}

std::string VelocityName::toLatex() const {
  const bool countable = primes <= kCountablePrimes;
  return "\\omega_{" + pairOf(of, relativeTo, ",") + "}" +
         (countable ? quotes(primes) : "^{(" + std::to_string(primes) + ")}");
}

VelocityName branchName(const Digraph& graph, JointOrdinal joint) {
  const DigraphEdge& edge = graph.turningEdge(joint);
  return {graph.nodeLabel(edge.head), graph.nodeLabel(edge.tail), 0};
}

VelocityName tailChordName(const TerminalPair& pair) {
  return {pair.tail, pair.carrier, pair.primes};
}

VelocityName headChordName(const TerminalPair& pair) {
  return {pair.head, pair.carrier, pair.primes};
}

std::vector<RatioNames> ratioNames(const Digraph& graph) {
  std::map<std::pair<int, int>, int> seen;  // how often two links mesh, whichever way
  std::vector<RatioNames> names;
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    const auto [tail, head] = graph.meshEdge(mesh);
    const std::string again = quotes(seen[std::minmax(tail, head)]++);
    const auto latex = [&](int a, int b) { return "n_{" + pairOf(a, b, ",") + "}" + again; };
    names.push_back({"i" + std::to_string(graph.edgeLabel(graph.t() + mesh)),
                     "n" + pairOf(tail, head, "_") + again, latex(tail, head),
                     "n" + pairOf(head, tail, "_") + again, latex(head, tail)});
  }
  return names;
}

EquationNumbers::EquationNumbers(const TtGraph& graph, int unknowns) : m_unknowns(unknowns) {
  const int meshes = graph.graph().c();
  m_circuits.assign(static_cast<std::size_t>(2 * meshes), 0);
  int next = terminal(meshes);
  for (const bool several : {true, false}) {
    for (int chord = 0; chord < 2 * meshes; ++chord) {
      const auto circuit = chord % 2 == 0 ? graph.tailCircuit(chord / 2) : graph.headCircuit(chord / 2);
      if ((circuit.size() > 1) == several) m_circuits[static_cast<std::size_t>(chord)] = next++;
    }
  }
  m_firstHeld = next;
  m_firstStep = next + static_cast<int>(graph.held().size());
}

}  // namespace geargraph
