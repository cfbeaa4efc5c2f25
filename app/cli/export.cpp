// `export FILE --to FORM ...`: each form has a file of its own (export_forms.h).

#include <array>
#include <functional>

#include "app/cli/command.h"
#include "app/cli/export_forms.h"

namespace geargraph::cli {
namespace {

/// What writes this form; none where there is no such form.
std::function<int()> exporterOf(const Arguments& arguments, const std::string& form) {
  const bool solid = arguments.value("--view") == "3d";
  if (const auto format = meshFormatFromName(form)) {
    if (solid && format == MeshFormat::glb) return [&arguments] { return exportPicture(arguments, true); };
    return [&arguments, format] { return exportSolids(arguments, *format); };
  }
  if (const auto picture = pictureFormFromName(form)) {
    if (solid && picture == PictureForm::png) return [&arguments] { return exportPicture(arguments, false); };
    if (picture == PictureForm::pdf && !arguments.has("--view"))
      return [&arguments] { return exportReportPages(arguments); };
    return [&arguments, picture] { return exportDrawing(arguments, *picture); };
  }
  if (const auto report = reportFormFromName(form)) {
    return [&arguments, report] { return exportReport(arguments, *report); };
  }
  if (form == "assembly") return [&arguments] { return exportAssembly(arguments); };
  if (form == "csv") return [&arguments] { return exportCsv(arguments); };
  return nullptr;
}

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExport, "One file is needed.");
  const std::string form = arguments.value("--to").value_or("");
  const auto exporter = exporterOf(arguments, form);
  if (!exporter) {
    return wrongUsage(
        kExport, "--to is one of csv, html, latex, md, svg, pdf, png, stl, obj, ply, glb, 3mf, assembly.");
  }
  if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
  return exporter();
}

constexpr std::array kOptions = {
    Option{
        "--to", "FORM",
        "csv: matrices; html, latex, md, pdf: the worked derivation; svg, png, pdf with --view: a picture; "
        "stl, obj, ply, glb, 3mf: gears; assembly: gears for a check"},
    Option{"--matrix", "NAME",
           "incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p or solution"},
    Option{"--all", "", "every matrix, or every picture of a film, into the folder that -o names"},
    Option{"-o", "OUT", "the file (\"-\" is standard output), or with --all the folder"},
    Option{"--force", "", "with a folder: overwrite files that are there"},
    Option{"--inputs", "8,9,11", "of derivations: drive these joints (by label) instead of the document's"},
    Option{"--speed", "8=1/2", "of derivations: the speed of an input in rad/s; may be said again"},
    Option{"--no-labels", "", "without the header row and the first column"},
    Option{"--separator", "NAME", "comma (the default), semicolon or tab"},
    Option{"--decimal", "NAME", "point (the default) or comma"},
    Option{"--bom", "", "begin with a byte order mark, for spreadsheet programs"},
    Option{"--gear", "MESH:SIDE", "one gear in its own frame: 15:tail or 15:head"},
    Option{"--link", "LABEL", "the solids of one link"},
    Option{"--animate", "SECONDS", "with glb: how long one period plays (without: as long as it takes)"},
    Option{"--tolerance", "MODULES",
           "of solids: farthest chord from the exact form (0.002; of large trains as fine as 10 million "
           "triangles allow)"},
    Option{"--view", "NAME",
           "of pictures: digraph, ttgraph or schematic; with png and glb also 3d, the train as seen"},
    Option{"--size", "WxH", "of pictures: pixels (as large as the drawing is; 3d: 1600x1000)"},
    Option{"--dark", "", "of pictures: on a dark ground"},
    Option{"--transparent", "", "of pictures: on no ground"},
    Option{"--from", "NAME", "of 3d: front, back, left, right, top, bottom or iso"},
    Option{"--camera", "AZ,EL", "of 3d: from this azimuth and elevation, degrees (-26,20)"},
    Option{"--time", "SECONDS", "of 3d: how far the inputs have turned (0)"},
    Option{"--section", "AXIS:PART", "of 3d: cut open square to x, y or z, so far along (y:0.5)"},
    Option{"--explode", "PART", "of 3d: pulled apart along the axes, 0 to 1"},
    Option{"--faces", "NAME", "of 3d: shaded, lines (hidden ones left out) or edges (all of them)"},
    Option{"--show", "NAMES",
           "of 3d: "
           "labels,joint-labels,axis-labels,scale,pitch-circles,pitch-points,axes,instant-axes,velocities"},
    Option{"--hide", "LABELS", "of 3d: links that are left out: 2,5"},
    Option{"--ride", "LABEL", "of 3d: the link that is seen standing still"},
    Option{"--turntable", "", "of 3d: a film once round the train, as an animated PNG (or --all)"},
    Option{"--motion", "", "of 3d: a film of one period of the motion (a minute without one)"},
    Option{"--fps", "N", "of a film: pictures a second (24)"},
    Option{"--frames", "N", "of a film: pictures (72); with assembly: poses of every gear (24)"},
};

}  // namespace

const Command kExport = {
    "export", "FILE --to FORM [...] -o OUT",
    "Writes matrices as CSV, the worked derivation, pictures and films, and gears as 3D files.", kOptions,
    run};

}  // namespace geargraph::cli
