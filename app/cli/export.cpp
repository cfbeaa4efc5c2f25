// `export FILE --to FORM ...`: each form has a file of its own (export_forms.h).

#include <array>

#include "app/cli/command.h"
#include "app/cli/export_forms.h"

namespace geargraph::cli {
namespace {

int run(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExport, "One file is needed.");
  const std::string form = arguments.value("--to").value_or("");
  if (const auto format = meshFormatFromName(form)) {
    if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
    return exportSolids(arguments, *format);
  }
  if (form == "assembly") {
    if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
    return exportAssembly(arguments);
  }
  if (const auto picture = pictureFormFromName(form)) {
    if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
    const bool solid = picture == PictureForm::png && arguments.value("--view") == "3d";
    return solid ? exportPicture(arguments) : exportDrawing(arguments, *picture);
  }
  if (form != "csv")
    return wrongUsage(kExport, "--to is one of csv, svg, pdf, png, stl, obj, ply, glb, 3mf, assembly.");
  if (!arguments.has("-o")) return wrongUsage(kExport, "-o says where to write.");
  return exportCsv(arguments);
}

constexpr std::array kOptions = {
    Option{"--to", "FORM",
           "csv: matrices; svg, pdf, png: a picture; stl, obj, ply, glb, 3mf: gears; assembly: gears for a "
           "check"},
    Option{"--matrix", "NAME",
           "incidence, reduced-incidence, path, spanning-tree, cycle-basis, cutset, screw, p or solution"},
    Option{"--all", "", "every matrix, into the folder that -o names"},
    Option{"-o", "OUT", "the file (\"-\" is standard output), or with --all the folder"},
    Option{"--force", "", "with a folder: overwrite files that are there"},
    Option{"--no-labels", "", "without the header row and the first column"},
    Option{"--separator", "NAME", "comma (the default), semicolon or tab"},
    Option{"--decimal", "NAME", "point (the default) or comma"},
    Option{"--bom", "", "begin with a byte order mark, for spreadsheet programs"},
    Option{"--gear", "MESH:SIDE", "one gear in its own frame: 15:tail or 15:head"},
    Option{"--link", "LABEL", "the solids of one link"},
    Option{"--animate", "SECONDS", "with glb: how long one period plays (without: as long as it takes)"},
    Option{"--tolerance", "MODULES", "of solids: farthest chord from the exact form (0.002)"},
    Option{"--view", "NAME", "of pictures: digraph, ttgraph or schematic; with png also 3d, the train"},
    Option{"--size", "WxH", "of pictures: pixels (as large as the drawing is; 3d: 1600x1000)"},
    Option{"--from", "NAME", "of 3d: front, back, left, right, top, bottom or iso"},
    Option{"--time", "SECONDS", "of 3d: how far the inputs have turned (0)"},
    Option{"--dark", "", "of pictures: on a dark ground"},
    Option{"--transparent", "", "of pictures: on no ground"},
    Option{"--frames", "N", "with assembly: poses of every gear, 12 or more (24)"},
};

}  // namespace

const Command kExport = {"export", "FILE --to FORM [...] -o OUT",
                         "Writes matrices as CSV, and gears as 3D files.", kOptions, run};

}  // namespace geargraph::cli
