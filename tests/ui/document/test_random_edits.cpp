#include <QTest>
#include <random>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fragment.h"
#include "core/mechanism/model/validate.h"
#include "tests/core/support/mechanisms.h"
#include "ui/document/document.h"

namespace geargraph {

/// Ten thousand edits of every kind, taken back and done again.
class RandomEditsTest : public QObject {
  Q_OBJECT

  static constexpr int kEdits = 10'000;
  static constexpr int kMaxLinks = 25;

  std::mt19937_64 dice{20'261'121};
  int below(int limit) { return static_cast<int>(dice() % static_cast<std::uint64_t>(limit)); }
  template <class Element>
  const Element& oneOf(const std::vector<Element>& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
  }
  Number number() { return Number(Rational(below(400) - 200, 1 + below(7))); }
  NumberTriple triple() { return {number(), number(), number()}; }
  template <class Value>
  std::optional<Value> maybe(Value value) {
    return below(4) == 0 ? std::nullopt : std::optional<Value>(std::move(value));
  }
  std::vector<ElementId> some(const Mechanism& m, int count) {
    std::vector<ElementId> elements;
    for (int i = 0; i < count; ++i) {
      const int kind = below(4);
      if (kind == 0) elements.emplace_back(oneOf(m.links).id);
      if (kind == 1 && m.t() > 0) elements.emplace_back(oneOf(m.turningJoints).id);
      if (kind == 2 && m.c() > 0) elements.emplace_back(oneOf(m.gearMeshes).id);
      if (kind == 3 && !m.axes.empty()) elements.emplace_back(oneOf(m.axes).id);
    }
    return elements;
  }

  Reduce grow(const Mechanism& m) {
    const LinkId a = oneOf(m.links).id;
    const LinkId b = oneOf(m.links).id;
    switch (below(5)) {
      case 0:
        return [at = CanvasPoint{double(below(900)), double(below(600))}](const Mechanism& before) {
          return withLink(before, at, "new");
        };
      case 1:
        return [a, b, axis = m.axes.empty() ? AxisId() : maybe(oneOf(m.axes).id).value_or(AxisId())](
                   const Mechanism& before) { return withTurningJoint(before, a, b, axis); };
      case 2:
        return [a, b, i = below(60), j = below(60)](const Mechanism& before) {
          return withGearMesh(before, a, b, i, j);  // sometimes with no teeth: rejected
        };
      default: {
        const std::vector<ElementId> chosen = some(m, 3);
        return [chosen](const Mechanism& before) {
          return withFragment(before, fragmentOf(before, {chosen.begin(), chosen.end()}));
        };
      }
    }
  }

  Reduce change(const Mechanism& m) {
    const ElementId link = oneOf(m.links).id;
    if (m.t() == 0 || m.c() == 0) {
      return [link](const Mechanism& before) { return withName(before, link, "renamed"); };
    }
    const JointId joint = oneOf(m.turningJoints).id;
    const MeshId mesh = oneOf(m.gearMeshes).id;
    const AxisId axis = oneOf(m.axes).id;
    switch (below(12)) {
      case 0:
        return [joint](const Mechanism& before) { return withFlipped(before, joint); };
      case 1:
        return [mesh](const Mechanism& before) { return withFlipped(before, mesh); };
      case 2:
        return [axis, name = std::to_string(below(30))](const Mechanism& before) {
          return withName(before, axis, name);
        };
      case 3:
        return [link, at = CanvasPoint{double(below(900)), 0.5}](const Mechanism& before) {
          return withNodesMoved(before, std::array{std::pair(LinkId(link.id), at)});
        };
      case 4:
        return [mesh, i = below(90), j = 1 + below(90)](const Mechanism& before) {
          return withTeeth(before, mesh, i, j);
        };
      case 5:
        return [mesh, kind = maybe(static_cast<MeshKind>(below(3)))](const Mechanism& before) {
          return withMeshKind(before, mesh, kind);
        };
      case 6:
        return [mesh, point = maybe(triple())](const Mechanism& before) {
          return withPitchPoint(before, mesh, point);
        };
      case 7:
        return [axis, point = maybe(triple()), direction = maybe(triple())](const Mechanism& before) {
          return withAxisPlaced(before, axis, point, direction);
        };
      case 8:
        return [joint, axis](const Mechanism& before) { return withJointAxis(before, joint, axis); };
      case 9:
        return
            [joint, offset = number()](const Mechanism& before) { return withOffset(before, joint, offset); };
      case 10:
        return [inputs = maybe(std::vector<Input>{{joint, number(), {}}})](const Mechanism& before) {
          return withInputs(before, inputs);
        };
      default:
        return [link](const Mechanism& before) { return withGround(before, LinkId(link.id)); };
    }
  }

  Reduce anyEdit(const Mechanism& m) {
    const int kind = below(10);
    if (m.n() > kMaxLinks || kind == 0) {
      return [gone = some(m, m.n() > kMaxLinks ? 12 : 2)](const Mechanism& before) {
        return withoutElements(before, gone);
      };
    }
    return kind < 4 ? grow(m) : change(m);
  }

 private slots:
  void tenThousandEditsUndoneAndRedoneGiveTheSameDocuments() {
    Document document;
    document.replace(test::robotTopology(), {});
    QUndoStack& stack = document.undoStack();
    std::vector<Mechanism> states{*document.mechanism()};  // by place in the history, copied
    int accepted = 0;
    int rejected = 0;
    quint64 gesture = 0;
    while (accepted < kEdits) {
      if (below(8) == 0) gesture = below(8) == 0 ? document.newGesture() : 0;
      const Mechanism before = *document.mechanism();
      if (!document.apply({QStringLiteral("edit"), anyEdit(before), gesture})) {
        QVERIFY(*document.mechanism() == before);
        ++rejected;
        continue;
      }
      states.resize(static_cast<std::size_t>(stack.index()) + 1);
      states.back() = *document.mechanism();
      if (*document.mechanism() == before) continue;  // a name that it had, a ground that it was
      ++accepted;
      QVERIFY(wellFormedDiagnostics(*document.mechanism()).empty());
    }
    QVERIFY(rejected > 100);  // what cannot be was tried too
    QVERIFY(stack.count() > kEdits / 2);
    QCOMPARE(stack.count(), stack.index());

    while (stack.canUndo()) {
      stack.undo();
      QVERIFY(*document.mechanism() == states[static_cast<std::size_t>(stack.index())]);
    }
    QVERIFY(*document.mechanism() == test::robotTopology());
    while (stack.canRedo()) {
      stack.redo();
      QVERIFY(*document.mechanism() == states[static_cast<std::size_t>(stack.index())]);
    }
    for (int jump = 0; jump < 200; ++jump) {
      stack.setIndex(below(stack.count() + 1));
      QVERIFY(*document.mechanism() == states[static_cast<std::size_t>(stack.index())]);
    }
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::RandomEditsTest)
#include "test_random_edits.moc"
