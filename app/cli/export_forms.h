#pragma once

#include "app/cli/arguments.h"
#include "core/presentation/handout/handout.h"
#include "core/presentation/meshfile/mesh_format.h"
#include "core/presentation/picture/picture.h"
#include "core/presentation/report/report.h"
#include "core/presentation/results/graph_files.h"

namespace geargraph::cli {

/// `export FILE --to csv (--matrix NAME -o OUT | --all [--force] -o FOLDER) [--no-labels] [--separator NAME]
/// [--decimal NAME] [--bom]`.
int exportCsv(const Arguments& arguments);

/// `export FILE --to stl/obj/ply/glb/3mf [--gear MESH:tail/head | --link LABEL] [--animate SECONDS]
/// [--tolerance MODULES] -o OUT`.
int exportSolids(const Arguments& arguments, MeshFormat format);

/// `export FILE --to assembly [--frames N] [--tolerance MODULES] [--force] -o FOLDER`.
int exportAssembly(const Arguments& arguments);

enum class SimulatorForm { mjcf, urdf };
/// `export FILE --to mjcf/urdf [--gravity X,Y,Z] [--density N] [--timestep S] [--motor NAME] [--armature I]
/// [--tolerance MODULES] [--force] -o FOLDER`.
int exportSimulator(const Arguments& arguments, SimulatorForm form);

/// `export FILE --to png --view 3d [--size WxH] [--from VIEW | --camera AZ,EL] [--time SECONDS] ... -o OUT`;
/// with --turntable or --motion an animated PNG, with --all its frames as files in a folder. `asSolids`:
/// `--to glb`, the solids as the view shows them.
int exportPicture(const Arguments& arguments, bool asSolids);

/// `export FILE --to svg/pdf/png --view NAME [--size WxH] [--dark] [--transparent] -o OUT`.
int exportDrawing(const Arguments& arguments, PictureForm form);

/// `export FILE --to html/latex/md [--inputs 8,9,11] [--speed 8=1 ...] -o OUT`: the worked derivation.
int exportReport(const Arguments& arguments, ReportForm form);
/// `export FILE --to pdf [--inputs ...] -o OUT`, without --view: the derivation as pages.
int exportReportPages(const Arguments& arguments);
/// `export FILE --to handout|scorm [--inputs ... | --exercises [--kinds LIST] [--seed N] [--title TEXT]
/// [--variants N --variant K]] -o OUT`: the derivation as an HTML page with adjustable inputs and exercises
/// with feedback; or as a SCORM package with that page, for a learning platform.
int exportHandout(const Arguments& arguments, HandoutUse use);

/// `export FILE --to modelica -o OUT`.
int exportModelica(const Arguments& arguments);

/// `export FILE --to dot/graphml/node-link [--view digraph/ttgraph] -o OUT`.
int exportGraph(const Arguments& arguments, GraphForm form);

// Common to exportPicture() and exportDrawing().

/// Width and height from "WxH", each at least kLeastPictureSide and at most `most`.
[[nodiscard]] std::optional<std::pair<int, int>> pictureSize(std::string_view text, int most);
/// The error message for a text that pictureSize() rejects.
[[nodiscard]] std::string wrongSize(std::string_view text, int most);
/// Writes the file atomically, or to standard output for "-"; returns the exit status.
int writePicture(std::string_view bytes, const std::string& path);

}  // namespace geargraph::cli
