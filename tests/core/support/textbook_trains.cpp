#include "tests/core/support/textbook_trains.h"

#include "tests/core/support/trains.h"

namespace geargraph::test {
namespace {

const ExactTriple kZ{0, 0, 1};

Rational fraction(std::int64_t numerator, std::int64_t denominator) {
  return {numerator, denominator};
}

/// Places on circles that have rational coordinates.
const std::vector<ExactTriple>& directions() {
  static const std::vector<ExactTriple> places{{1, 0, 0},
                                               {fraction(-3, 5), fraction(4, 5), 0},
                                               {fraction(-3, 5), fraction(-4, 5), 0},
                                               {fraction(5, 13), fraction(12, 13), 0},
                                               {fraction(5, 13), fraction(-12, 13), 0}};
  return places;
}

TextbookTrain spurPair() {
  TrainBuilder train("spur pair");
  const int a = train.axis({0, 0, 0}, kZ);
  const int b = train.axis({25, 0, 0}, kZ);
  const int driver = train.link(0, a);
  const int driven = train.link(0, b);
  train.external(driver, a, 20, driven, b, 30);
  train.input(0);
  return {"spur pair", train.mechanism(), 1, 1, {{1, fraction(-2, 3)}}};
}

/// Sun 24 (link 1, joint 0), ring 60 (2, 1), carrier (3, 2), planets 18 (4.., 3..). Willis: 24 ws + 60 wr =
/// 84 wc; planet against carrier: 18 wp = -24 (ws - wc).
TrainBuilder planetary(int planets) {
  TrainBuilder train("planetary train");
  const int a = train.axis({0, 0, 0}, kZ);
  const int sun = train.link(0, a, "sun");
  const int ring = train.link(0, a, "ring");
  const int carrier = train.link(0, a, "carrier");
  for (int i = 0; i < planets; ++i) {
    const int b = train.axis(scaled(directions()[static_cast<std::size_t>(i)], 21), kZ);
    const int planet = train.link(carrier, b, "planet");
    train.external(sun, a, 24, planet, b, 18);
    train.internal(planet, b, 18, ring, a, 60);
  }
  return train;
}

void addPlanetary(std::vector<TextbookTrain>& trains) {
  struct Held {
    const char* name;
    int held;
    int driven;
    std::vector<std::pair<int, Rational>> rates;
  };
  const std::vector<Held> cases{
      {"ring held", 1, 0, {{2, fraction(2, 7)}, {3, fraction(-20, 21)}}},
      {"sun held", 0, 1, {{2, fraction(5, 7)}, {3, fraction(20, 21)}}},
      {"carrier held", 2, 0, {{1, fraction(-2, 5)}, {3, fraction(-4, 3)}}},
  };
  for (const Held& held : cases) {
    for (int planets = 1; planets <= 5; ++planets) {
      TrainBuilder train = planetary(planets);
      train.input(held.driven);
      train.input(held.held, 0);
      auto rates = held.rates;
      for (int i = 1; i < planets; ++i) rates.emplace_back(3 + i, rates[1].second);
      trains.push_back({std::string("planetary, ") + held.name + ", planets " + std::to_string(planets),
                        train.mechanism(), 2, planets + 1, rates});
    }
  }
}

/// The fixed wheel 100 is cut on the ground; the wheels 99, 100, 101 share its planet 20. Carrier once round:
/// each wheel turns 1 - 100/N.
TextbookTrain ferguson() {
  TrainBuilder train("Ferguson's paradox");
  const int a = train.axis({0, 0, 0}, kZ);
  const int b = train.axis({60, 0, 0}, kZ);
  const int carrier = train.link(0, a, "carrier");
  const int planet = train.link(carrier, b, "planet");
  train.external(0, a, 100, planet, b, 20);
  for (const int teeth : {99, 100, 101}) train.external(planet, b, 20, train.link(0, a), a, teeth);
  train.input(0);
  return {
      "Ferguson", train.mechanism(), 1, 4, {{1, 5}, {2, fraction(-1, 99)}, {3, 0}, {4, fraction(1, 101)}}};
}

/// Sun 20 in, wheel 76 fixed, planet 56 / 24 on an oblique axis, wheel 35 out: 1176/17 to 1. In the carrier's
/// frame the fixed wheel and the output turn against the sun, by 20/76 and (20/56)(24/35).
TextbookTrain humpage() {
  TrainBuilder train("Humpage's reduction");
  const int a = train.axis({0, 0, 0}, kZ);
  const int b = train.axis({0, 0, 0}, {0, 4, 3});
  const int sun = train.link(0, a, "sun");
  const int carrier = train.link(0, a, "carrier");
  const int planet = train.link(carrier, b, "planet");
  const int out = train.link(0, a, "output");
  train.bevel(sun, a, 20, planet, b, 56, -1);
  train.bevel(0, a, 76, planet, b, 56, 1);
  train.bevel(planet, b, 24, out, a, 35, 1);
  train.input(0);
  return {"Humpage", train.mechanism(), 1, 3, {{1, fraction(5, 24)}, {3, fraction(17, 1176)}}};
}

/// Case (link 1), two axle wheels 16 (2, 3), pinions 10 on a cross axis: the axles' speeds add up to twice
/// the case's.
TextbookTrain differential(int pinions) {
  TrainBuilder train("bevel differential");
  const int a = train.axis({0, 0, 0}, {1, 0, 0});
  const int casing = train.link(0, a, "case");
  const int left = train.link(0, a, "left axle");
  const int right = train.link(0, a, "right axle");
  for (int i = 0; i < pinions; ++i) {
    const ExactTriple across{0, directions()[static_cast<std::size_t>(i)][0],
                             directions()[static_cast<std::size_t>(i)][1]};
    const int b = train.axis({0, 0, 0}, across);
    const int pinion = train.link(casing, b, "pinion");
    train.bevel(left, a, 16, pinion, b, 10, 1, -1);
    train.bevel(right, a, 16, pinion, b, 10, -1, 1);
  }
  train.input(0);
  train.input(1, fraction(3, 2));
  TextbookTrain result{
      "differential, pinions " + std::to_string(pinions), train.mechanism(), 2, pinions + 1, {}};
  result.rates = {{2, fraction(1, 2)}, {3, fraction(4, 5)}};
  return result;
}

/// Suns 30 and 36, short planet 20 (on sun 30), long planet 18 (on sun 36 and ring 72), one carrier.
/// Low gear, carrier held, sun 30 in: ring 30/72. Second, sun 36 held: carrier 30/66, ring 15/22.
void addRavigneaux(std::vector<TextbookTrain>& trains) {
  for (const bool low : {true, false}) {
    TrainBuilder train("Ravigneaux train");
    const int a = train.axis({0, 0, 0}, kZ);
    const int b = train.axis({15, 20, 0}, kZ);
    const int c = train.axis({27, 0, 0}, kZ);
    const int small = train.link(0, a, "small sun");
    const int large = train.link(0, a, "large sun");
    const int ring = train.link(0, a, "ring");
    const int carrier = train.link(0, a, "carrier");
    const int shortPlanet = train.link(carrier, b, "short planet");
    const int longPlanet = train.link(carrier, c, "long planet");
    train.external(small, a, 30, shortPlanet, b, 20);
    train.external(shortPlanet, b, 20, longPlanet, c, 18);
    train.external(large, a, 36, longPlanet, c, 18);
    train.internal(longPlanet, c, 18, ring, a, 72);
    train.input(0);
    train.input(low ? 3 : 1, 0);
    std::vector<std::pair<int, Rational>> rates{{1, fraction(-30, 36)}, {2, fraction(5, 12)}};
    if (!low) rates = {{2, fraction(15, 22)}, {3, fraction(5, 11)}};
    trains.push_back({low ? "Ravigneaux, low" : "Ravigneaux, second", train.mechanism(), 2, 4, rates});
  }
}

/// Suns 33 on one shaft, rings 74; the first carrier is one with the second ring, the output.
/// First: ring in, second carrier held: 2 + 33/74. Second: suns held: 1 + 33/74. Reverse: suns in: -74/33.
void addSimpson(std::vector<TextbookTrain>& trains) {
  const auto build = [] {
    TrainBuilder train("Simpson train");
    const int a = train.axis({0, 0, 0}, kZ);
    const int b = train.axis({54, 0, 0}, kZ);
    const int c = train.axis({-54, 0, 40}, kZ);
    const int suns = train.link(0, a, "suns");
    const int ring = train.link(0, a, "first ring");
    const int out = train.link(0, a, "output");
    const int carrier = train.link(0, a, "second carrier");
    const int first = train.link(out, b, "first planet");
    const int second = train.link(carrier, c, "second planet");
    train.external(suns, a, 33, first, b, 20);
    train.internal(first, b, 20, ring, a, 74);
    train.external(suns, a, 33, second, c, 20);
    train.internal(second, c, 20, out, a, 74);
    return train;
  };
  struct Gear {
    const char* name;
    int in;
    int held;
    Rational out;
  };
  for (const Gear& gear :
       {Gear{"Simpson, first", 1, 3, fraction(74, 181)}, Gear{"Simpson, second", 1, 0, fraction(74, 107)},
        Gear{"Simpson, reverse", 0, 3, fraction(-33, 74)}}) {
    TrainBuilder train = build();
    train.input(gear.in);
    train.input(gear.held, 0);
    trains.push_back({gear.name, train.mechanism(), 2, 4, {{2, gear.out}}});
  }
}

/// Roll housing (1), two shafts through it (2, 4), bend (3), idler (5) and tool roll (6), whose axis lies on
/// the first one in the drawn pose. 20:30 turns the bend, 25:40 and 24:18 the tool: bend = -(20/30)(q2 - q1);
/// idler = (25/40)(q4 - q1); tool = -(24/18)(idler - bend).
TextbookTrain wrist() {
  TrainBuilder train("bevel wrist");
  const int a = train.axis({0, 0, 0}, kZ);
  const int b = train.axis({0, 0, 0}, {0, 2, 0});
  const int c = train.axis({0, 0, 0}, kZ);
  const int housing = train.link(0, a, "housing");
  const int bendShaft = train.link(0, a, "bend shaft");
  const int bend = train.link(housing, b, "bend");
  const int rollShaft = train.link(0, a, "roll shaft");
  const int idler = train.link(housing, b, "idler");
  const int tool = train.link(bend, c, "tool");
  train.bevel(bendShaft, a, 20, bend, b, 30, -1, -1);
  train.bevel(rollShaft, a, 25, idler, b, 40, 1, -1);
  train.bevel(idler, b, 24, tool, c, 18, -1);
  train.input(0, 1);
  train.input(1, 4);
  train.input(3, -3);
  // bend = -(2/3) 3 = -2; idler = (5/8)(-4) = -5/2; tool = -(4/3)(-5/2 + 2) = 2/3
  return {"bevel wrist", train.mechanism(), 3, 3, {{2, -2}, {4, fraction(-5, 2)}, {5, fraction(2, 3)}}};
}

}  // namespace

Mechanism ringOfShafts(const std::vector<std::pair<int, int>>& teeth) {
  TrainBuilder train("ring of shafts");
  const int shafts = static_cast<int>(teeth.size());
  for (int k = 0; k < shafts; ++k) {
    train.link(0, train.axis({100 * k, 70 * (k % 2), 0}, kZ));
  }
  for (int k = 0; k < shafts; ++k) {
    const int next = (k + 1) % shafts;
    const auto [tail, head] = teeth[static_cast<std::size_t>(k)];
    train.external(k + 1, k, tail, next + 1, next, head);
  }
  return train.mechanism();
}

std::vector<TextbookTrain> textbookTrains() {
  std::vector<TextbookTrain> trains{spurPair(),      ferguson(),      humpage(), differential(1),
                                    differential(2), differential(4), wrist()};
  addPlanetary(trains);
  addRavigneaux(trains);
  addSimpson(trains);
  const auto ring = [&trains](const char* name, const std::vector<std::pair<int, int>>& teeth, int rank) {
    Mechanism mechanism = ringOfShafts(teeth);
    const int shafts = static_cast<int>(teeth.size());
    mechanism.inputs.emplace();
    std::vector<std::pair<int, Rational>> rates;
    if (rank < shafts) {
      mechanism.inputs->push_back({mechanism.turningJoints[0].id, Number(1), {}});
      rates.emplace_back(1, fraction(-teeth[0].first, teeth[0].second));
    } else {
      for (int k = 0; k < shafts; ++k) rates.emplace_back(k, 0);
    }
    trains.push_back({name, std::move(mechanism), shafts - rank, rank, rates});
  };
  ring("triangle of wheels, locked", {{20, 20}, {20, 20}, {20, 20}}, 3);
  ring("square of wheels, movable", {{20, 25}, {25, 30}, {30, 35}, {35, 20}}, 3);
  ring("two pairs of one ratio", {{20, 30}, {45, 30}}, 1);
  ring("two pairs of different ratios, locked", {{20, 30}, {44, 30}}, 2);
  // Both products have the first 19 digits in common, so that doubles cannot tell them apart; they differ by
  // 180.
  ring("locked by the twentieth digit", {{100000, 99999}, {99996, 99998}, {99993, 99991}, {99989, 99990}}, 4);
  ring("movable to the last digit", {{100000, 99996}, {99996, 99993}, {99993, 99989}, {99989, 100000}}, 3);
  return trains;
}

}  // namespace geargraph::test
