#include "app/cli/analyze_text.h"

#include <algorithm>

#include <unordered_map>

#include "app/cli/solution_text.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/exact/pi_number.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"

namespace geargraph::cli {
namespace {

constexpr int kMaxRows = 40;
constexpr int kMaxColumns = 40;
constexpr int kMaxListedElements = 100;

std::string rightAligned(std::string_view text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + std::string(text);
}

/// In one of two texts that are marked by toTranslate(), by their number, which is %1.
std::string countedItems(int count, const char* one, const char* many) {
  return filled(translated(count == 1 ? one : many), {std::to_string(count)});
}

std::string joints(const Mechanism& m) {
  if (!hasSlides(m))
    return countedItems(m.t(), toTranslate("%1 turning joint"), toTranslate("%1 turning joints"));
  const auto sliding = std::count_if(m.turningJoints.begin(), m.turningJoints.end(),
                                     [](const TurningJoint& joint) { return slides(joint); });
  return translated("%1 joints, of which %2 slide", {std::to_string(m.t()), std::to_string(sliding)});
}

std::string heading(const Mechanism& m) {
  return (m.name.empty() ? translated("Untitled mechanism") : m.name) +
         "\nn = " + countedItems(m.n(), toTranslate("%1 moving link"), toTranslate("%1 moving links")) +
         ", t = " + joints(m) +
         ", c = " + countedItems(m.c(), toTranslate("%1 gear mesh"), toTranslate("%1 gear meshes")) + '\n';
}

/// The labels of the links, so that joints and meshes are listed with numbers.
std::unordered_map<LinkId, std::string> labelsOfLinks(const Mechanism& m) {
  std::unordered_map<LinkId, std::string> labels;
  for (std::size_t i = 0; i < m.links.size(); ++i) labels[m.links[i].id] = std::to_string(i);
  return labels;
}

/// What the ratio of a mesh with a side that slides means.
std::string travel(const Mechanism& m, const GearMesh& mesh,
                   std::unordered_map<LinkId, std::string>& labels) {
  const bool ofTail = tailSlides(m, mesh);
  const auto weights = weightsOf(mesh, ofTail);
  if (!weights) return {};
  const PiNumber ratio = ofTail ? PiNumber(Rational(weights->head, weights->tail), weights->pi)
                                : PiNumber(Rational(weights->tail, weights->head), -weights->pi);
  return translated("travel of link %1 per radian of link %2: %3 %4",
                    {labels[ofTail ? mesh.tail : mesh.head], labels[ofTail ? mesh.head : mesh.tail],
                     ratio.toString(), m.unit});
}

std::string elements(const Mechanism& m) {
  if (m.n() + m.t() + m.c() > kMaxListedElements) return {};
  auto labels = labelsOfLinks(m);
  const auto arrow = [&](LinkId tail, LinkId head) { return labels[tail] + " -> " + labels[head]; };
  std::string text = '\n' + translated("Links") + '\n';
  for (int i = 0; i <= m.n(); ++i) {
    const Link& link = m.links[static_cast<std::size_t>(i)];
    const std::string label = std::to_string(m.linkLabel(i));
    text += rightAligned(label, 5) + (link.id.text() == label ? "" : "  " + link.id.text()) +
            (link.name.empty() ? "" : "  " + link.name) + '\n';
  }
  text += '\n' + translated("Turning joints") + '\n';
  for (int i = 0; i < m.t(); ++i) {
    const TurningJoint& joint = m.turningJoints[static_cast<std::size_t>(i)];
    text += rightAligned(std::to_string(m.jointLabel(i)), 5) + "  " + arrow(joint.tail, joint.head) + "  " +
            (slides(joint) ? translated("slides along axis %1", {joint.axis.text()})
                           : translated("axis %1", {joint.axis.text()})) +
            '\n';
  }
  text += '\n' + translated("Gear meshes") + '\n';
  for (int i = 0; i < m.c(); ++i) {
    const GearMesh& mesh = m.gearMeshes[static_cast<std::size_t>(i)];
    text += rightAligned(std::to_string(m.meshLabel(i)), 5) + "  " + arrow(mesh.tail, mesh.head) + "  " +
            (slides(saidKind(mesh)) ? travel(m, mesh, labels)
                                    : translated("teeth %1 : %2", {std::to_string(mesh.tailTeeth),
                                                                   std::to_string(mesh.headTeeth)})) +
            (mesh.kind ? "  " + kindWord(*mesh.kind) : "") + '\n';
  }
  return text;
}

std::string title(const ResultTable& table) {
  const NamedResult& result = table.result();
  std::string text = '\n' + std::string(result.symbol) + "   " + translated(result.title);
  if (const PaperEquation equation = result.equation(table.form()); equation != PaperEquation::none)
    text += ", " + translated("Eq. (%1)", {std::to_string(numberOf(equation))});
  return text + '\n';
}

std::string tableText(const ResultTable& table) {
  const std::string shape =
      countedItems(table.rows(), toTranslate("%1 row"), toTranslate("%1 rows")) + ", " +
      countedItems(table.columns(), toTranslate("%1 column"), toTranslate("%1 columns"));
  if (table.rows() == 0 || table.columns() == 0) return title(table) + "  " + shape + '\n';
  if (table.rows() > kMaxRows || table.columns() > kMaxColumns) {
    return title(table) + "  " +
           translated("%1: too large to print; see \"export --to csv --matrix %2\"",
                      {shape, table.result().name}) +
           '\n';
  }
  return title(table) + resultGrid(table);
}

}  // namespace

std::string analysisText(const SnapshotPtr& snapshot) {
  std::string text = heading(*snapshot->mechanism) + elements(*snapshot->mechanism);
  for (const NamedResult* result : namedResults()) {
    const ResultTablePtr table = result->isPrinted ? exactTable(*result, {snapshot}) : nullptr;
    if (table) text += tableText(*table);
  }
  return text + motionText(*snapshot);
}

}  // namespace geargraph::cli
