// Whole gear sets from tooth counts, and tooth counts from requirements.

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/design/synthesis/bevel_sets.h"
#include "core/design/synthesis/insertion.h"
#include "core/design/synthesis/planets.h"
#include "core/design/synthesis/reverted_train.h"
#include "core/design/synthesis/shifting_sets.h"

namespace geargraph::python {
namespace {

PlanetaryMember memberNamed(const std::string& name) {
  if (name == "sun") return PlanetaryMember::sun;
  if (name == "ring") return PlanetaryMember::ring;
  if (name == "carrier") return PlanetaryMember::carrier;
  throw py::value_error("A member of a planetary set is sun, ring or carrier, not \"" + name + "\".");
}

void checkTeeth(std::initializer_list<int> counts) {
  for (const int count : counts) {
    if (count < kMinTeeth || count > kMaxTeeth)
      throw py::value_error("A gear has 1 to 100,000 teeth, not " + std::to_string(count) + ".");
  }
}

/// Wheels of sets that are looked through: the search costs their square.
void checkLimits(int fewest, int most) {
  constexpr int kMaxSearched = 2'000;
  checkTeeth({fewest, most});
  if (fewest > most || most > kMaxSearched)
    throw py::value_error("Tooth counts are looked for up to 2,000, the fewest first.");
}

void checkPlanets(int planets) {
  constexpr int kMaxPlanets = 100;
  if (planets < 1 || planets > kMaxPlanets) throw py::value_error("A set has 1 to 100 planets.");
}

py::list planetaryOfRatio(const NumberText& ratio, const std::string& drive, const std::string& driven,
                          int planets, int fewest, int most, std::size_t count) {
  checkLimits(fewest, most);
  checkPlanets(planets);
  const PlanetaryRequirements requirements{
      rationalFrom(ratio), memberNamed(drive), memberNamed(driven), planets, fewest, most};
  if (requirements.drive == requirements.driven) throw py::value_error("Drive and driven are one member.");
  py::list choices;
  for (const PlanetaryChoice& choice : interruptible(
           [&](const std::stop_token& /*stop*/) { return planetaryChoices(requirements, count); })) {
    choices.append(py::make_tuple(choice.teeth.sun, choice.teeth.planet, choice.teeth.ring(),
                                  choice.ratio.toString(), choice.error));
  }
  return choices;
}

py::list revertedOfRatio(const NumberText& ratio, int fewest, int most, std::size_t count) {
  checkLimits(fewest, most);
  const RevertedRequirements requirements{rationalFrom(ratio), fewest, most};
  if (requirements.ratio.sign() <= 0) throw py::value_error("The ratio of a reverted train is above 0.");
  py::list choices;
  for (const RevertedChoice& choice :
       interruptible([&](const std::stop_token& /*stop*/) { return revertedChoices(requirements, count); })) {
    const RevertedTeeth& teeth = choice.teeth;
    choices.append(py::make_tuple(teeth.first, teeth.second, teeth.third, teeth.fourth,
                                  choice.ratio.toString(), choice.error));
  }
  return choices;
}

}  // namespace

void addSets(py::module_& module) {
  module.def("planetary_choices", planetaryOfRatio);
  module.def("reverted_choices", revertedOfRatio);
  module.def("planetary_set", [](int sun, int planet, int planets) {
    checkTeeth({sun, planet});
    checkPlanets(planets);
    return Document(planetarySet({sun, planet}, planets));
  });
  module.def("reverted_train", [](int first, int second, int third, int fourth) {
    checkTeeth({first, second, third, fourth});
    return Document(revertedTrain({first, second, third, fourth}));
  });
  module.def("bevel_differential", [](int side, int pinion, int pinions) {
    checkTeeth({side, pinion});
    checkPlanets(pinions);
    return edited(bevelDifferentialSet(side, pinion, pinions));
  });
  module.def("bevel_wrist", [](int bendShaft, int bend, int rollShaft, int idler, int idlerPinion, int tool) {
    checkTeeth({bendShaft, bend, rollShaft, idler, idlerPinion, tool});
    return Document(bevelWrist({bendShaft, bend, rollShaft, idler, idlerPinion, tool}));
  });
  module.def("ravigneaux", [](int smallSun, int largeSun, int shortPlanet, int longPlanet, int pairs) {
    checkTeeth({smallSun, largeSun, shortPlanet, longPlanet});
    checkPlanets(pairs);
    return edited(ravigneauxSet({smallSun, largeSun, shortPlanet, longPlanet}, pairs));
  });
  module.def("simpson", [](int sun, int planet, int planets) {
    checkTeeth({sun, planet});
    checkPlanets(planets);
    return edited(simpsonSet({sun, planet}, planets));
  });
  py::class_<Document>(module.attr("Document"))
      .def("with_planets",
           [](const Document& self, const std::string& planet, int total) {
             checkPlanets(total);
             return edited(withPlanets(self.placed(), LinkId(planet), total));
           })
      .def("with_set", [](const Document& self, const Document& set) {
        return edited(withInserted(self.mechanism(), set.mechanism(), freePlace(self.mechanism())));
      });
}

}  // namespace geargraph::python
