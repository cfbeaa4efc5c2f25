#include "app/python/bindings/bindings.h"

PYBIND11_MODULE(_geargraph, module) {
  using namespace geargraph::python;
  module.attr("version") = GEARGRAPH_VERSION;
  addDocument(module);
  addEdits(module);
  addSets(module);
  addTeeth(module);
  addDesign(module);
  addAnalysis(module);
  addSteps(module);
  addStatics(module);
  addDynamics(module);
  addPictures(module);
  addExports(module);
  addExporters(module);
  addSimulators(module);
  addExercises(module);
}
