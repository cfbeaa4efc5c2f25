#include <QTest>

#include "core/machine/body_layout/body_recipe.h"

using namespace geargraph;

class BodyRecipeTest : public QObject {
  Q_OBJECT
 private slots:
  /// Parts beside each other, each where it was put.
  void recipesMakeWhatTheirPartsSay() {
    const Eigen::Isometry3d there = frameAlong({1, 2, 3}, {0, 1, 0});
    const Boss hub{{0, 0}, 4, 2};
    const std::vector<Boss> ends{{{20, 0}, 3, 1}, {{-10, 18}, 3, 1}};
    const std::vector<ProfileVertex> ring{{8, 2}, {5, 2}, {5, -2}, {8, -2}};
    Solid expected = tube(3, 1, -5, 12, 0.01);
    append(expected, spider(hub, ends, -1, 1, 0.02), there);
    append(expected, revolved(ring, 0.01));
    for (int i = 0; i < 2; ++i) append(expected, tubeSector(10, 9, -2, 5, 0.3, 0.01), there);
    const BarPart bar{10, 9, -2, 5, 0.3};
    const BodyRecipe recipe{{TubePart{3, 1, -5, 12}, 1, Eigen::Isometry3d::Identity()},
                            {SpiderPart{hub, ends, -1, 1}, 2, there},
                            {RevolvedPart{ring}, 1, Eigen::Isometry3d::Identity()},
                            {bar, 1, there},
                            {bar, 1, there}};
    QVERIFY(madeBy(recipe, 0.01) == expected);
  }

  void equalRecipesGetOneSolid() {
    BodyCache cache(2);
    const auto recipe = [](double length) {
      return BodyRecipe{{TubePart{3, 1, 0, length}, 1, Eigen::Isometry3d::Identity()}};
    };
    const auto solid = [&](double length) { return cache.deferred(recipe(length), 0.01); };
    const auto first = solid(4);
    QCOMPARE(solid(4), first);
    const auto second = solid(5);
    QVERIFY(second->solidIfReady() == nullptr);
    QVERIFY(*second->solid() == madeBy(recipe(5), 0.01));
    QCOMPARE(solid(4), first);
    QVERIFY(solid(6) != first);  // drops that of 5, the oldest
    QCOMPARE(solid(4), first);
    QVERIFY(solid(5) != second);
  }

  void aRecipeIsEveryNumberOfItsParts() {
    const BodyRecipe recipe{
        {SpiderPart{{{0, 0}, 4, 2}, {{{20, 0}, 3, 1}}, -1, 1}, 1, Eigen::Isometry3d::Identity()}};
    std::vector<BodyRecipe> others(5, recipe);
    std::get<SpiderPart>(others[0][0].shape).ends[0].hole = 1.5;
    std::get<SpiderPart>(others[1][0].shape).hub.centre.y() = 1e-9;
    others[2][0].module = 2;
    others[3][0].placed.translation().x() = 1;
    others[4].push_back(recipe[0]);
    BodyCache cache;
    const auto solid = cache.deferred(recipe, 0.01);
    for (const BodyRecipe& other : others) QVERIFY(cache.deferred(other, 0.01) != solid);
    QVERIFY(cache.deferred(recipe, 0.02) != solid);
    QCOMPARE(cache.deferred(recipe, 0.01), solid);
  }
};

QTEST_APPLESS_MAIN(BodyRecipeTest)
#include "test_body_recipe.moc"
