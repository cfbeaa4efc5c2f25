#pragma once

#include "app/cli/arguments.h"
#include "core/meshfile/mesh_format.h"

namespace geargraph::cli {

/// `export FILE --to csv (--matrix NAME -o OUT | --all [--force] -o FOLDER) [--no-labels] [--separator NAME]
/// [--decimal NAME] [--bom]`.
int exportCsv(const Arguments& arguments);

/// `export FILE --to stl/obj/ply/glb/3mf [--gear MESH:tail/head | --link LABEL] [--animate SECONDS]
/// [--tolerance MODULES] -o OUT`.
int exportSolids(const Arguments& arguments, MeshFormat format);

/// `export FILE --to assembly [--frames N] [--tolerance MODULES] [--force] -o FOLDER`.
int exportAssembly(const Arguments& arguments);

/// `export FILE --to png --view 3d [--size WxH] [--from VIEW] [--time SECONDS] [--dark] [--transparent] -o
/// OUT`.
int exportPicture(const Arguments& arguments);

}  // namespace geargraph::cli
