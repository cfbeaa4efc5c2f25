#include <QtTest>

#include "core/design/atlas/chain_document.h"
#include "core/design/atlas/identify.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

TrainIdentity identityOf(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  const auto drawn = drawnChain(mechanism, placement);
  return *identifyTrain(mechanism, placement, *drawn, Atlas::shipped());
}

/// "4-1.1.1 3-1.1.1": the parts.
QString partsText(const TrainIdentity& identity) {
  QStringList parts;
  for (const IdentifiedChain& part : identity.parts)
    parts += part.displacement ? QString::fromStdString(part.displacement->toString()) : "?";
  return parts.join(' ');
}

/// "0 no-mesh, 5 copy".
QString removedText(const TrainIdentity& identity) {
  QStringList links;
  for (const RemovedLink& removed : identity.removed)
    links += QString::number(removed.link) + ' ' + QString::fromStdString(std::string(removalName(removed.why)));
  return links.join(", ");
}

}  // namespace

class TestIdentify : public QObject {
  Q_OBJECT

 private slots:
  void examplesAreTheseChains_data() {
    QTest::addColumn<QString>("removed");
    QTest::addColumn<QString>("parts");
    QTest::newRow("x") << "" << "";
  }
  void examplesAreTheseChains() {
    for (const std::string& name : exampleNames()) {
      const Mechanism m = example(name);
      const Placement placement = placementOf(m);
      const auto drawn = drawnChain(m, placement);
      if (!drawn) { qWarning("%s: %s", name.c_str(), drawn.error().front().message.c_str()); continue; }
      const auto id = identityOf(m);
      qWarning("%s: removed %s parts %s", name.c_str(), qPrintable(removedText(id)), qPrintable(partsText(id)));
      for (auto& p : id.parts) qWarning("   links %d meshes %d dof %d locked %d byteeth %d  %s  %s", int(p.links.size()), int(p.meshes.size()), p.dof, p.isLocked, p.turnsByTeeth, axesText(p.chain).c_str(), meshesText(p.chain).c_str());
    }
  }
};

QTEST_APPLESS_MAIN(TestIdentify)
#include "test_identify.moc"
