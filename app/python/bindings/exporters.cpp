// Every format of core's registry, by its id.

#include "core/presentation/exporters/exporters.h"
#include "app/python/bindings/snapshot.h"

namespace geargraph::python {
namespace {

std::string_view typeName(OptionType type) {
  constexpr std::array<std::string_view, 4> kNames = {"flag", "number", "choice", "text"};
  return kNames.at(static_cast<std::size_t>(type));
}

/// By option: name, type, what it means, what holds without it, whether it is needed, least, most, choices.
py::list rowsOfOptions(const Exporter& exporter) {
  py::list rows;
  for (const ExportOption& option : exporter.options) {
    rows.append(py::make_tuple(option.name, typeName(option.type), exportOptionText(option.name).help,
                               option.otherwise, option.isNeeded, option.least, option.most,
                               option.choices != nullptr ? option.choices() : std::vector<std::string>()));
  }
  return rows;
}

/// By exporter: id, form, title, what is written, whether that is a folder, suffix, options, refusals.
py::list rowsOfExporters() {
  py::list rows;
  for (const Exporter* exporter : allExporters()) {
    py::list refusals;
    for (const ExportRefusal* refusal : exporter->refusals)
      refusals.append(py::make_tuple(refusal->code, refusal->meaning));
    rows.append(py::make_tuple(exporter->id, exporter->form, exporter->title, exporter->what,
                               exporter->files == ExportFiles::folder, exporter->suffix,
                               rowsOfOptions(*exporter), refusals));
  }
  return rows;
}

/// Where and how; the document's folder holds attached 3D files.
struct Place {
  std::string path;
  bool mayOverwrite = false;
  std::string folder;
};

struct HeardExport {
  Diagnostics errors;
  std::vector<std::string> notes;
};

ExportSource sourceOf(const Snapshot& self, const Place& place, HeardExport& heard) {
  ExportSource source;
  source.read = [&self]() -> std::variant<Mechanism, ExportError> { return self.mechanism(); };
  if (!place.folder.empty()) source.folder = place.folder;
  source.diagnose = [&heard](const Diagnostics& found) {
    for (const Diagnostic& each : found) {
      if (each.severity() == Severity::error) heard.errors.push_back(each);
    }
  };
  source.note = [&heard](const ExportNote& note) { heard.notes.push_back(note.text); };
  return source;
}

[[noreturn]] void raiseExportError(const ExportError& error, const HeardExport& heard) {
  if (error.kind == ExportError::Kind::usage) throw py::value_error(error.message);
  if (error.message.empty() && !heard.errors.empty()) raise(heard.errors);
  raise(error.kind == ExportError::Kind::file ? std::string_view("file") : error.code, error.message);
}

/// Writes by the exporter with this id; what a user should know, in sentences.
std::vector<std::string> writeExportOf(const Snapshot& self, const std::string& id,
                                       const std::map<std::string, std::string>& options,
                                       const std::string& path, bool mayOverwrite,
                                       const std::string& folder) {
  const Exporter* const exporter = exporterWithId(id);
  if (exporter == nullptr) throw py::value_error("There is no exporter \"" + id + "\".");
  OptionValues given;
  for (const auto& [name, value] : options) {
    const bool isKnown = std::any_of(exporter->options.begin(), exporter->options.end(),
                                     [&](const ExportOption& option) { return option.name == name; });
    if (!isKnown) throw py::type_error("The exporter \"" + id + "\" has no option " + name + '.');
    given.options[name] = {value};
  }
  given = withImplied(*exporter, std::move(given));
  HeardExport heard;
  const Place place{path, mayOverwrite, folder};
  const ExportResult result = interruptible([&](const std::stop_token& stop) {
    ExportContext context(sourceOf(self, place, heard));
    return writeExport(*exporter, context, given, {place.path, place.mayOverwrite}, stop);
  });
  if (const auto* error = std::get_if<ExportError>(&result)) raiseExportError(*error, heard);
  return heard.notes;
}

}  // namespace

void addExporters(py::module_& module) {
  module.def("exporters", rowsOfExporters);
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot")).def("write_export", writeExportOf);
}

}  // namespace geargraph::python
