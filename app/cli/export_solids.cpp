#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/export_forms.h"
#include "app/cli/load_train.h"
#include "app/cli/number_options.h"
#include "app/cli/time_limit.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/meshfile/assembly.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph::cli {
namespace {

constexpr double kFinest = 1e-4;
constexpr double kCoarsest = 0.2;
constexpr double kLongestAnimation = 1e6;  // s
constexpr double kMostFrames = 10'000;

int failure(const Arguments& arguments, const MeshFileError& error) {
  if (error.kind == MeshFileError::Kind::stopped) return outOfTime(arguments, "the file");
  std::cerr << "geargraph-cli: " << error.message << '\n';
  return error.kind == MeshFileError::Kind::limit ? kResourceLimit : kUsageOrFile;
}

Float3 colourOfLink(int label) {
  const Color color = linkColor(label);
  constexpr float kFull = 255;
  return {static_cast<float>(color.red) / kFull, static_cast<float>(color.green) / kFull,
          static_cast<float>(color.blue) / kFull};
}

/// The gear that "15:tail" names, or a wheel of the document that bears the name itself.
const TrainGear* gearNamed(const LoadedTrain& loaded, const std::string& name) {
  for (const TrainMesh& mesh : loaded.train.meshes) {
    const std::string label = std::to_string(loaded.mechanism().meshLabel(mesh.mesh));
    if (name == label + ":tail") return &loaded.train.gears[static_cast<std::size_t>(mesh.tailGear)];
    if (name == label + ":head") return &loaded.train.gears[static_cast<std::size_t>(mesh.headGear)];
  }
  for (const TrainGear& gear : loaded.train.gears) {
    if (gear.name == name) return &gear;
  }
  return nullptr;
}

/// Whether the gears are too many or too fine to be made at all; says so.
bool isTooLarge(const LoadedTrain& loaded, double tolerance) {
  const double triangles = expectedTriangles(loaded.train, tolerance);
  if (triangles <= static_cast<double>(kMostTriangles)) return false;
  std::cerr << "geargraph-cli: About " << static_cast<long long>(triangles)
            << " triangles are more than the limit of " << kMostTriangles
            << "; choose a coarser --tolerance.\n";
  return true;
}

/// The solids of a train at the tolerance, or where --tolerance is not given at the finest coarser one that
/// keeps them below the limit of triangles.
TrainParts fittingParts(const LoadedTrain& loaded, const Arguments& arguments, double tolerance) {
  std::vector<double> tolerances{tolerance};
  if (!arguments.has("--tolerance"))
    tolerances.insert(tolerances.end(), {kScreenTolerance, kFarTolerance, kFarthestTolerance, kCoarsest});
  TrainParts made;
  for (const double each : tolerances) {
    const bool isLast = each == tolerances.back();
    if (!isLast && expectedTriangles(loaded.train, each) > static_cast<double>(kMostTriangles)) continue;
    made = {};  // before the next are made: they take most of the memory
    GearCache cache;
    made = trainParts(loaded.mechanism(), loaded.train, cache, each, arguments.stop);
    std::size_t triangles = 0;
    for (const LinkPart& part : made.parts) triangles += part.solid->triangles.size();
    if (!isLast && triangles > kMostTriangles && !arguments.stop.stop_requested()) continue;
    if (each != tolerance) {
      std::cerr << "geargraph-cli: The train is so large that its chords are within " << each
                << " modules instead of " << tolerance << " (--tolerance).\n";
    }
    break;
  }
  return made;
}

/// One gear, alone in its own frame.
std::variant<MeshScene, int> gearScene(const LoadedTrain& loaded, const std::string& name, double tolerance) {
  const TrainGear* gear = gearNamed(loaded, name);
  if (gear == nullptr) {
    return wrongUsage(kExport, "There is no gear \"" + name + "\"; gears are named like 15:tail, 15:head.");
  }
  const auto solid = gearSolid(gear->spec, tolerance);
  if (!solid) {
    std::cerr << diagnosticLines(name, solid.error());
    return static_cast<int>(kMechanismErrors);
  }
  const Link& link = loaded.mechanism().links[static_cast<std::size_t>(gear->link)];
  const int label = loaded.mechanism().linkLabel(gear->link);
  MeshScene scene{gear->name, loaded.mechanism().unit, {}, {}};
  scene.materials.push_back(
      {link.name.empty() ? "link " + std::to_string(label) : link.name, colourOfLink(label)});
  MeshNode& node = scene.nodes.emplace_back();
  node.name = gear->name;
  node.solid = std::make_shared<const Solid>(*solid);
  return scene;
}

/// The whole train, or one link of it, with its motion where the format carries one. Gears that cannot be
/// made are left out of a large train, as in the 3D view, and `status` tells; a train of few gears needs all
/// of them.
std::variant<MeshScene, int> trainScene(const LoadedTrain& loaded, const Arguments& arguments,
                                        MeshFormat format, double tolerance, double seconds, int& status) {
  const PlacedTrain placed = loaded.placed();
  TrainParts made = fittingParts(loaded, arguments, tolerance);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, "the solids");
  if (!made.diagnostics.empty()) {
    std::cerr << diagnosticLines(arguments.files.front(), made.diagnostics);
    status = kMechanismErrors;
    if (!loaded.train.hasSimpleBodies) return status;
    std::cerr << "geargraph-cli: Left out: " << made.diagnostics.size() << " of " << loaded.train.gears.size()
              << " gears, which cannot be made.\n";
  }
  if (const auto label = arguments.value("--link")) {
    std::erase_if(made.parts, [&](const LinkPart& part) {
      return std::to_string(loaded.mechanism().linkLabel(part.link)) != *label;
    });
    if (made.parts.empty()) return wrongUsage(kExport, "There is no link \"" + *label + "\" with solids.");
  }
  const LinkSceneSource source{loaded.mechanism(), *loaded.snapshot->tree, placed.kinematics, made.parts,
                               colourOfLink};
  std::optional<UniformMotion> motion;
  if (carriesAnimation(format) && !loaded.motions.empty()) {
    motion = UniformMotion{loaded.motions.front(), std::nullopt};
    if (seconds > 0) motion->seconds = seconds;
  }
  auto scene = linkScene(source, motion);
  const auto* error = std::get_if<MeshFileError>(&scene);
  if (error != nullptr && seconds > 0) return failure(arguments, *error);
  if (error != nullptr) {
    std::cerr << "geargraph-cli: " << error->message << " Nothing in the file moves.\n";
    scene = linkScene(source, std::nullopt);
  }
  return std::get<MeshScene>(std::move(scene));
}

}  // namespace

int exportSolids(const Arguments& arguments, MeshFormat format) {
  const auto tolerance = numberWithin(arguments, "--tolerance", kExportTolerance, kFinest, kCoarsest);
  const auto seconds = numberWithin(arguments, "--animate", 0, 1e-3, kLongestAnimation);
  for (const auto* read : {&tolerance, &seconds}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (arguments.has("--animate") && (!carriesAnimation(format) || arguments.has("--gear"))) {
    return wrongUsage(kExport, "Only --to glb of a train or a link carries an animation.");
  }
  if (arguments.has("--gear") && arguments.has("--link")) {
    return wrongUsage(kExport, "Give --gear or --link, not both.");
  }
  const auto loaded = loadTrain(arguments);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const LoadedTrain& train = std::get<LoadedTrain>(loaded);
  const double fineness = std::get<double>(tolerance);
  if (isTooLarge(train, arguments.has("--tolerance") ? fineness : kCoarsest)) return kResourceLimit;
  int fine = kFine;
  const auto scene = arguments.has("--gear")
                         ? gearScene(train, *arguments.value("--gear"), fineness)
                         : trainScene(train, arguments, format, fineness, std::get<double>(seconds), fine);
  if (const int* status = std::get_if<int>(&scene)) return *status;
  MeshWriteOptions options;
  options.stop = arguments.stop;
  const auto error = writeMesh(std::get<MeshScene>(scene), format, *arguments.value("-o"), options);
  return error ? failure(arguments, *error) : fine;
}

int exportAssembly(const Arguments& arguments) {
  const auto tolerance = numberWithin(arguments, "--tolerance", kExportTolerance, kFinest, kCoarsest);
  const auto frames =
      numberWithin(arguments, "--frames", 24, static_cast<double>(kFewestFrames), kMostFrames);
  for (const auto* read : {&tolerance, &frames}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (*arguments.value("-o") == "-")
    return wrongUsage(kExport, "--to assembly writes a folder; \"-\" is none.");
  const auto loaded = loadTrain(arguments);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const LoadedTrain& train = std::get<LoadedTrain>(loaded);
  if (isTooLarge(train, std::get<double>(tolerance))) return kResourceLimit;
  std::vector<std::vector<Rational>> motions = train.motions;
  if (motions.empty()) motions.emplace_back(static_cast<std::size_t>(train.mechanism().t()));  // all at rest
  GearCache cache;
  const auto count = static_cast<std::size_t>(std::get<double>(frames));
  const auto assembly = assemblyOf(train.placed(), cache, std::get<double>(tolerance), motions, count);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, "the assembly");
  if (!assembly) {
    std::cerr << diagnosticLines(arguments.files.front(), assembly.error());
    return kMechanismErrors;
  }
  const auto error = writeAssembly(*assembly, *arguments.value("-o"), arguments.has("--force"));
  return error ? failure(arguments, *error) : kFine;
}

}  // namespace geargraph::cli
