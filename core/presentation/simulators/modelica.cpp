#include "core/presentation/simulators/modelica.h"

#include <algorithm>
#include <vector>

#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {
namespace {

/// "text" as a string of Modelica; line ends and other control characters become blanks.
std::string modelicaString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + '"';
}

/// A text behind //.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

/// A mesh or a row of a coupling: whole factors of joint angles, and the multiplier of its torques.
struct ModelicaRow {
  std::string multiplier;
  std::string meaning;
  std::vector<std::pair<int, int>> joints;  ///< ordinal and factor
};

/// "18*j8.phi + 36*j10.phi": factors with what they multiply.
std::string sumOf(const std::vector<std::pair<std::string, int>>& terms) {
  std::string sum;
  for (const auto& [name, factor] : terms) {
    const int size = std::abs(factor);
    sum += sum.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
    sum += (size == 1 ? "" : std::to_string(size) + '*') + name;
  }
  return sum.empty() ? "0" : sum;
}

class ModelicaWriter {
 public:
  explicit ModelicaWriter(const AnalysisSnapshot& snapshot)
      : m_mechanism(*snapshot.mechanism),
        m_graph(*snapshot.graph),
        m_model(*snapshot.kinematics->model),
        m_matroid(*snapshot.matroid()),
        m_matrix(m_mechanism, m_model, snapshot.kinematics->placement()) {}

  /// The comments are English in every language of the program: users of other programs read them.
  std::string write() {
    addMeshes();
    addCouplings();
    const std::string name = modelicaName(m_mechanism.name);
    m_text =
        "// Written by GearGraph. No tool of Modelica has run it there: check it with yours.\n"
        "// Ideal and massless. A flange is a turning joint: phi is the angle of its head relative to its "
        "tail in rad, 0 in the\n"
        "// drawn pose, tau the torque that is put into the joint. What is attached to a flange acts between "
        "these two links, so\n"
        "// that a motor or a load belongs there, and the inertia of a link whose axis moves does not.\n";
    m_text += "model " + name + ' ' + modelicaString(m_mechanism.name) + '\n';
    for (JointOrdinal joint = 0; joint < m_graph.t(); ++joint) {
      m_text += "  Modelica.Mechanics.Rotational.Interfaces.Flange_a " + flange(joint) + ' ' +
                modelicaString(jointWords(joint)) + ";\n";
    }
    if (!m_rows.empty()) m_text += "protected\n";
    for (const ModelicaRow& row : m_rows)
      m_text += "  Real " + row.multiplier + "(unit=\"N.m\") " + modelicaString(row.meaning) + ";\n";
    m_text += "equation\n";
    for (const ModelicaRow& row : m_rows) {
      std::vector<std::pair<std::string, int>> terms;
      for (const auto& [joint, factor] : row.joints) terms.emplace_back(flange(joint) + ".phi", factor);
      m_text += "  " + sumOf(terms) + " = 0;  // " + oneLine(row.meaning) + '\n';
    }
    for (JointOrdinal joint = 0; joint < m_graph.t(); ++joint) {
      std::vector<std::pair<std::string, int>> terms;
      for (const ModelicaRow& row : m_rows) {
        for (const auto& [of, factor] : row.joints) {
          if (of == joint) terms.emplace_back(row.multiplier, factor);
        }
      }
      m_text += "  " + flange(joint) + ".tau = " + sumOf(terms) + ";\n";
    }
    return std::move(m_text) + "end " + name + ";\n";
  }

 private:
  [[nodiscard]] std::string flange(JointOrdinal joint) const {
    return "j" + std::to_string(m_graph.edgeLabel(joint));
  }

  [[nodiscard]] std::string jointWords(JointOrdinal joint) const {
    const DigraphEdge& edge = m_graph.turningEdge(joint);
    const auto link = [this](int node) {
      const int label = m_graph.nodeLabel(node);
      const Link& named = m_mechanism.links[label];
      return std::to_string(label) + (named.name.empty() ? "" : " (" + named.name + ")");
    };
    return "joint " + std::to_string(m_graph.edgeLabel(joint)) + ": link " + link(edge.head) +
           " relative to " + link(edge.tail);
  }

  void addMeshes() {
    for (const MeshOrdinal mesh : m_matroid.independentMeshes) {
      const GearMesh& gears = m_mechanism.gearMeshes[mesh];
      const std::string label = std::to_string(m_graph.edgeLabel(m_graph.t() + mesh));
      ModelicaRow& row = m_rows.emplace_back();
      row.multiplier = "m" + label;
      row.meaning = "mesh " + label + ", " + std::to_string(gears.tailTeeth) + ':' +
                    std::to_string(gears.headTeeth) + " teeth";
      for (const CoefficientMatrix::Entry& entry : m_matrix.row(mesh)) {
        row.joints.emplace_back(entry.joint, entry.sign * (entry.tail ? gears.tailTeeth : gears.headTeeth));
      }
      if (row.joints.empty() || row.joints.front().second > 0) continue;
      for (auto& [joint, factor] : row.joints) factor = -factor;  // reads better, and says the same
    }
  }

  void addCouplings() {
    int number = 0;
    for (const int equation : m_matroid.independentHeld) {
      const KinematicModel::HeldRow& held = m_model.heldRow(equation);
      ModelicaRow& row = m_rows.emplace_back();
      row.multiplier = "c" + std::to_string(++number);
      row.meaning = "coupling " + m_mechanism.couplings[held.coupling].id.text() + ", engaged";
      for (const KinematicModel::HeldRow::Term& term : held.joints)
        row.joints.emplace_back(term.of, term.factor);
    }
  }

  const Mechanism& m_mechanism;
  const Digraph& m_graph;
  const KinematicModel& m_model;
  const MatroidAnalysis& m_matroid;
  CoefficientMatrix m_matrix;
  std::vector<ModelicaRow> m_rows;
  std::string m_text;
};

}  // namespace

std::string modelicaName(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool isDigit = c >= '0' && c <= '9';
    if (isLetter || (isDigit && !result.empty())) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty()) return "Mechanism";
  // Keywords are in small letters; the name of the library inside would hide it.
  if (result.front() >= 'a') result.front() = static_cast<char>(result.front() - 'a' + 'A');
  return result == "Modelica" ? "Modelica_" : result;
}

std::string modelicaText(const AnalysisSnapshot& snapshot) {
  return ModelicaWriter(snapshot).write();
}

}  // namespace geargraph
