#pragma once

#include <QFile>
#include <QStringList>
#include <QTest>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph::test {

/// All links stand out, so that their names are drawn.
inline Emphases withNames(const Mechanism& mechanism) {
  Emphases emphases;
  for (const Link& link : mechanism.links) emphases[link.id].hovered = true;
  return emphases;
}

/// Line by line; GEARGRAPH_UPDATE_GOLDEN in the environment takes over what is drawn now.
inline void compareWithGolden(const QString& path, const std::string& drawn) {
  QFile golden(path);
  if (qEnvironmentVariableIsSet("GEARGRAPH_UPDATE_GOLDEN")) {
    QVERIFY(golden.open(QIODevice::WriteOnly));
    golden.write(drawn.c_str());
    golden.close();
  }
  QVERIFY(golden.open(QIODevice::ReadOnly));
  const QStringList expected = QString::fromUtf8(golden.readAll()).split('\n');
  const QStringList actual = QString::fromStdString(drawn).split('\n');
  for (qsizetype i = 0; i < std::min(expected.size(), actual.size()); ++i) QCOMPARE(actual[i], expected[i]);
  QCOMPARE(actual.size(), expected.size());
}

/// What lies on what in a drawing of nodes and lines, found from its marks, without the grid that placed
/// them: texts on lines, nodes or texts, nodes on nodes, lines over nodes.
inline QString collisionsIn(const DisplayList& list) {
  struct Named {
    QString name;
    Extent box;
    std::optional<ElementId> owner;  ///< the node that a badge leans on
  };
  std::vector<std::pair<ElementId, Circle>> discs;
  std::vector<std::pair<ElementId, Curve>> lines;
  for (const Outline& outline : list.outlines) {
    if (const auto* disc = std::get_if<Circle>(&outline.shape)) discs.emplace_back(outline.element, *disc);
    if (const auto* line = std::get_if<Curve>(&outline.shape)) lines.emplace_back(outline.element, *line);
  }
  const auto nameOf = [](const ElementId& element) { return QString::fromStdString(element.id.text()); };
  std::vector<Named> texts;
  for (const Mark& mark : list.marks) {
    if (const auto* fill = std::get_if<Fill>(&mark.what); fill != nullptr && mark.role == MarkRole::input) {
      texts.push_back({"badge of " + nameOf(mark.element), extentOf(fill->shape), mark.element});
    }
    const auto* text = std::get_if<Text>(&mark.what);
    if (text == nullptr || mark.role == MarkRole::input) continue;
    const bool inDisc = std::any_of(discs.begin(), discs.end(), [&](const auto& disc) {
      return disc.first == mark.element && disc.second.center == text->center;
    });
    if (inDisc) continue;
    const double halfWidth = textWidth(text->text, text->size, text->bold) / 2;
    texts.push_back({QString("\"%1\" of %2").arg(QString::fromStdString(text->text), nameOf(mark.element)),
                     {text->center, halfWidth, text->size * 0.45},
                     std::nullopt});
  }
  QStringList found;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    int touched = 0;
    for (const auto& [link, disc] : discs) {
      if (!texts[i].box.meetsCircle(disc.center, disc.radius)) continue;
      if (texts[i].owner && ++touched == 1) continue;  // its own node
      found << texts[i].name + " on node " + nameOf(link);
    }
    for (const auto& [element, line] : lines) {
      forEachChord(line, [&, name = nameOf(element)](CanvasPoint from, CanvasPoint to) {
        if (texts[i].box.grown(1).meetsSegment(from, to)) found << texts[i].name + " on line " + name;
      });
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (texts[i].box.meets(texts[j].box)) found << texts[i].name + " on " + texts[j].name;
    }
  }
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = distance(discs[i].second.center, discs[j].second.center);
      if (apart < 2 * discs[i].second.radius + 8) {
        found << "node " + nameOf(discs[i].first) + " on node " + nameOf(discs[j].first);
      }
    }
    for (const auto& [element, line] : lines) {
      if (distanceToCurve(discs[i].second.center, line) < discs[i].second.radius - 0.01) {
        found << "line " + nameOf(element) + " over node " + nameOf(discs[i].first);
      }
    }
  }
  for (const Mark& mark : list.marks) {
    const auto* stroke = std::get_if<Stroke>(&mark.what);
    if (stroke == nullptr || mark.role != MarkRole::hatching) continue;
    const auto* bar = std::get_if<Polyline>(&stroke->shape);
    for (const auto& [element, line] : lines) {
      if (bar == nullptr || element == mark.element) continue;
      forEachChord(line, [&, name = nameOf(element)](CanvasPoint from, CanvasPoint to) {
        if (Extent{0.5 * (bar->points.front() + bar->points.back()), 1, 1}.meetsSegment(from, to))
          found << "line " + name + " through the hatching of " + nameOf(mark.element);
      });
    }
  }
  return found.join(", ");
}

}  // namespace geargraph::test
