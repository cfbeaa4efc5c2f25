// Whole teeth for wanted ratios, and the certificates of such searches.

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/design/teeth_check/teeth_check.h"
#include "core/design/teeth_search/teeth_certificate.h"
#include "core/design/teeth_search/teeth_json.h"

namespace geargraph::python {
namespace {

TeethAnswer answerTo(const Document& document, const std::string& wish, std::size_t most) {
  const TeethWish read = valueOrRaise(readTeethWish(wish, document.mechanism()));
  TeethSearchOptions options;
  options.most = most;
  return valueOrRaise(interruptible(
      [&](const std::stop_token& stop) { return teethFor(document.placed(), read, options, stop); }));
}

/// The answer as JSON.
std::string teethOf(const Document& document, const std::string& wish, std::size_t most) {
  return teethJson(answerTo(document, wish, most));
}

std::string certificateOf(const Document& document, const std::string& wish, std::size_t most) {
  return valueOrRaise(teethCertificate(answerTo(document, wish, most), wish, GEARGRAPH_VERSION));
}

/// Whether a certificate holds, the sentences that say why it does not, and how many choices were tried.
py::tuple checkedTeeth(const std::string& certificate) {
  const TeethVerdict verdict = valueOrRaise(
      interruptible([&](const std::stop_token& stop) { return geargraph::checkTeeth(certificate, stop); }));
  return py::make_tuple(verdict.holds(), verdict.faults, verdict.tried, verdict.within);
}

/// Tail's and head's teeth of the meshes at these positions.
Document withTeethOf(const Document& document, const std::vector<std::tuple<int, int, int>>& teeth) {
  std::vector<MeshTeeth> all;
  for (const auto& [mesh, tail, head] : teeth) {
    if (mesh < 0 || mesh >= document.mechanism().c()) throw py::index_error("There is no such mesh.");
    all.push_back({mesh, tail, head});
  }
  return edited(withAllTeethFitted(document.placed(), all));
}

}  // namespace

void addTeeth(py::module_& module) {
  module.def("check_teeth", checkedTeeth);
  py::class_<Document>(module.attr("Document"))
      .def("teeth", teethOf)
      .def("teeth_certificate", certificateOf)
      .def("with_all_teeth", withTeethOf);
}

}  // namespace geargraph::python
