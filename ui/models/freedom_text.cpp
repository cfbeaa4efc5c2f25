#include "ui/models/freedom_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/theory/matroid/input_roles.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("freedom", text);
}

constexpr std::size_t kMaxFreedomNames = 12;
constexpr std::size_t kMaxLines = 8;

QString namesOf(const Digraph& graph, const std::vector<int>& joints) {
  QStringList names;
  for (std::size_t i = 0; i < joints.size() && i < kMaxFreedomNames; ++i)
    names << QString::number(graph.edgeLabel(joints[i]));
  QString text = names.join(QStringLiteral(", "));
  if (joints.size() > kMaxFreedomNames) text += tr(" and %1 more").arg(joints.size() - kMaxFreedomNames);
  return text;
}

}  // namespace

QString freedomText(const AnalysisSnapshot& snapshot) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr || !matroid->solution || matroid->solution->matrix.empty()) return {};
  const Digraph& graph = *snapshot.graph;
  QStringList lines;
  for (std::size_t i = 0; i < matroid->solution->inputs.size() && i < kMaxLines; ++i) {
    const int input = matroid->solution->inputs[i];
    const std::vector<int> commanded = commandedBy(*matroid->solution, input);
    const QString label = QString::number(graph.edgeLabel(input));
    lines << (commanded.empty() ? tr("No other joint turns with joint %1.").arg(label)
                                : tr("Joint %1 commands %2.").arg(label, namesOf(graph, commanded)));
  }
  if (snapshot.solved && snapshot.solved->exact && !snapshot.solved->exact->matrix.empty()) {
    const auto groups = tiedJoints(*snapshot.solved->exact);
    for (std::size_t i = 0; i < groups.size() && i < kMaxLines; ++i)
      lines << tr("Joints %1 turn together, at a fixed ratio.").arg(namesOf(graph, groups[i]));
  }
  std::vector<int> dead;
  for (int joint = 0; joint < graph.t(); ++joint) {
    if (matroid->dead[static_cast<std::size_t>(joint)] != 0) dead.push_back(joint);
  }
  if (!dead.empty()) lines << tr("Never turning: %1.").arg(namesOf(graph, dead));
  return lines.join(QStringLiteral("\n"));
}

}  // namespace geargraph
