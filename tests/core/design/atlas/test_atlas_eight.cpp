#include <QTest>
#include <algorithm>
#include <iterator>

#include "core/design/atlas/chain_enumeration.h"

using namespace geargraph;

namespace {

/// Rotation graphs and displacement graphs.
std::pair<std::size_t, std::size_t> countedGroups(const std::vector<std::vector<Chain>>& groups) {
  std::size_t chains = 0;
  for (const std::vector<Chain>& group : groups) chains += group.size();
  return {groups.size(), chains};
}

}  // namespace

/// The chains of eight links, which the program's atlas leaves out.
class AtlasEightTest : public QObject {
  Q_OBJECT

 private slots:
  /// Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301.
  void oneFreedomIsAsPublished() {
    QCOMPARE(countedGroups(enumerateChains(8, 1)), std::pair(std::size_t{1070}, std::size_t{6360}));
  }

  /// What resources/schema/README.md says.
  void othersAreAsTheFormatPageSays() {
    const auto groups = enumerateChains(8, 2);
    QCOMPARE(countedGroups(groups), std::pair(std::size_t{711}, std::size_t{11036}));
    std::vector<std::vector<Chain>> whole;
    for (const std::vector<Chain>& group : groups) {
      std::vector<Chain> some;
      std::copy_if(group.begin(), group.end(), std::back_inserter(some), isNonfractionated);
      if (!some.empty()) whole.push_back(std::move(some));
    }
    QCOMPARE(countedGroups(whole), std::pair(std::size_t{178}, std::size_t{687}));
    QCOMPARE(countedGroups(enumerateLockedChains(8)).second, std::size_t{94});
  }
};

QTEST_APPLESS_MAIN(AtlasEightTest)
#include "test_atlas_eight.moc"
