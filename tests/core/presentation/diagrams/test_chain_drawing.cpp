#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/design/atlas/atlas_file.h"
#include "core/presentation/diagrams/chain_drawing.h"
#include "core/presentation/diagrams/chain_layout.h"

using namespace geargraph;

namespace {

/// The lines between links, as the layout draws them.
std::vector<std::pair<int, int>> linesOf(const Chain& chain) {
  std::vector<std::pair<int, int>> lines;
  for (const DrawnTurning& turning : drawnTurnings(chain)) lines.push_back(turning.links);
  for (const ChainMesh& mesh : chain.meshes) lines.emplace_back(mesh.tail, mesh.head);
  return lines;
}

double side(CanvasPoint a, CanvasPoint b, CanvasPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Crossings of lines without a common end, counted anew, pair by pair.
int countedCrossings(const Chain& chain, const std::vector<CanvasPoint>& at) {
  const auto lines = linesOf(chain);
  int count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const auto [a, b] = lines[i];
      const auto [c, d] = lines[j];
      if (a == c || a == d || b == c || b == d) continue;
      count += side(at[a], at[b], at[c]) * side(at[a], at[b], at[d]) < 0 &&
               side(at[c], at[d], at[a]) * side(at[c], at[d], at[b]) < 0;
    }
  }
  return count;
}

}  // namespace

class ChainDrawingTest : public QObject {
  Q_OBJECT

  std::map<ChainNumber, ChainLayout> layouts;  // of the whole atlas

 private slots:
  void initTestCase() {
    for (const AtlasChain& each : Atlas::shipped().chains()) layouts[each.number] = chainLayout(each.chain);
  }

  void turningJointsSpanTheChain() {
    for (const AtlasChain& each : Atlas::shipped().chains()) {
      const auto turnings = drawnTurnings(each.chain);
      QCOMPARE(static_cast<int>(turnings.size()), each.chain.links - 1);
      std::vector<int> root(static_cast<std::size_t>(each.chain.links));
      for (int i = 0; i < each.chain.links; ++i) root[i] = i;
      for (const DrawnTurning& turning : turnings) {
        const std::vector<int>& axis = each.chain.axes[turning.axis];
        for (const int link : {turning.links.first, turning.links.second})
          QVERIFY(std::find(axis.begin(), axis.end(), link) != axis.end());
        const int from = root[turning.links.first], to = root[turning.links.second];
        QVERIFY2(from != to, qPrintable(QString::fromStdString(each.number.toString())));
        std::replace(root.begin(), root.end(), from, to);
      }
    }
  }

  // All that can turn have a drawing without crossings.
  void chainsThatTurnHaveNoCrossings() {
    int chains = 0;
    for (const AtlasChain& each : Atlas::shipped().chains()) {
      const ChainLayout& layout = layouts.at(each.number);
      QCOMPARE(layout.crossings, countedCrossings(each.chain, layout.places));
      if (each.number.dof == 0) continue;
      ++chains;
      QVERIFY2(layout.crossings == 0, qPrintable(QString::fromStdString(each.number.toString())));
    }
    QCOMPARE(chains, 2018);
  }

  void linesPassThroughNoOtherLink() {
    for (const AtlasChain& each : Atlas::shipped().chains()) {
      const ChainLayout& layout = layouts.at(each.number);
      for (const auto& [a, b] : linesOf(each.chain)) {
        const CanvasPoint from = layout.places[a], to = layout.places[b];
        for (int c = 0; c < each.chain.links; ++c) {
          if (c == a || c == b) continue;
          const CanvasPoint p = layout.places[c];
          const double length = std::hypot(to.x - from.x, to.y - from.y);
          const double along = ((p.x - from.x) * (to.x - from.x) + (p.y - from.y) * (to.y - from.y)) / length;
          if (along < 0 || along > length) continue;
          QVERIFY2(std::abs(side(from, to, p)) / length > 20,
                   qPrintable(QString::fromStdString(each.number.toString())));
        }
      }
    }
  }

  void aDrawingHasLinksJointsAndPairs() {
    const AtlasChain& chain = *Atlas::shipped().find({4, 1, 1, 1});
    const DisplayList plain = chainDrawing(chain.chain);
    int dashed = 0, solid = 0;
    QStringList labels;
    for (const Mark& mark : plain.marks) {
      if (const auto* stroke = std::get_if<Stroke>(&mark.what); stroke && mark.role == MarkRole::line)
        ++(stroke->dash == Dash::dashed ? dashed : solid);
      if (const auto* text = std::get_if<Text>(&mark.what)) labels << QString::fromStdString(text->text);
    }
    QCOMPARE(dashed, 2);
    QCOMPARE(solid, 3);
    QCOMPARE(labels, (QStringList{"1", "2", "3", "4"}));

    const DisplayList own =
        chainDrawing(chain.chain, {.labels = {0, 7, 5, 12}, .colors = {0, 7, 5, 12}, .namesAxes = true});
    labels.clear();
    for (const Mark& mark : own.marks)
      if (const auto* text = std::get_if<Text>(&mark.what)) labels << QString::fromStdString(text->text);
    QCOMPARE(labels, (QStringList{"a", "b", "b", "0", "7", "5", "12"}));
  }
};

QTEST_APPLESS_MAIN(ChainDrawingTest)

#include "test_chain_drawing.moc"
