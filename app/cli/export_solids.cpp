#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/export_forms.h"
#include "app/cli/load_train.h"
#include "core/drawing/palette.h"
#include "core/meshfile/assembly.h"
#include "core/meshfile/mesh_writer.h"

namespace geargraph::cli {
namespace {

constexpr double kFinest = 1e-4;
constexpr double kCoarsest = 0.2;
constexpr double kLongestAnimation = 1e6;  // s
constexpr double kMostFrames = 10'000;

/// The number that an option gives, within bounds; `otherwise` where it is not given.
std::variant<double, UsageError> number(const Arguments& arguments, std::string_view option, double otherwise,
                                        double least, double most) {
  const auto text = arguments.value(option);
  if (!text) return otherwise;
  const auto value = numberFrom<double>(*text);
  if (value && *value >= least && *value <= most) return *value;
  const auto shown = [](double bound) {
    std::string digits = std::to_string(bound);
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.back() == '.' ? digits.substr(0, digits.size() - 1) : digits;
  };
  return UsageError{std::string(option) + " takes a number from " + shown(least) + " to " + shown(most) +
                    ", not \"" + *text + "\"."};
}

int failure(const MeshFileError& error) {
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

/// The whole train, or one link of it, with its motion where the format carries one.
std::variant<MeshScene, int> trainScene(const LoadedTrain& loaded, const Arguments& arguments,
                                        MeshFormat format, double tolerance, double seconds) {
  const PlacedTrain placed = loaded.placed();
  GearCache cache;
  TrainParts made = trainParts(placed.mechanism, placed.train, cache, tolerance);
  if (!made.diagnostics.empty()) {
    std::cerr << diagnosticLines(arguments.files.front(), made.diagnostics);
    return static_cast<int>(kMechanismErrors);
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
  if (error != nullptr && seconds > 0) return failure(*error);
  if (error != nullptr) {
    std::cerr << "geargraph-cli: " << error->message << " The file stands still.\n";
    scene = linkScene(source, std::nullopt);
  }
  return std::get<MeshScene>(std::move(scene));
}

}  // namespace

int exportSolids(const Arguments& arguments, MeshFormat format) {
  const auto tolerance = number(arguments, "--tolerance", kExportTolerance, kFinest, kCoarsest);
  const auto seconds = number(arguments, "--animate", 0, 1e-3, kLongestAnimation);
  for (const auto* read : {&tolerance, &seconds}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (arguments.has("--animate") && (!carriesAnimation(format) || arguments.has("--gear"))) {
    return wrongUsage(kExport, "Only --to glb of a train or a link carries an animation.");
  }
  if (arguments.has("--gear") && arguments.has("--link")) {
    return wrongUsage(kExport, "Give --gear or --link, not both.");
  }
  const auto loaded = loadTrain(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const LoadedTrain& train = std::get<LoadedTrain>(loaded);
  const double fineness = std::get<double>(tolerance);
  if (isTooLarge(train, fineness)) return kResourceLimit;
  const auto scene = arguments.has("--gear")
                         ? gearScene(train, *arguments.value("--gear"), fineness)
                         : trainScene(train, arguments, format, fineness, std::get<double>(seconds));
  if (const int* status = std::get_if<int>(&scene)) return *status;
  const auto error = writeMesh(std::get<MeshScene>(scene), format, *arguments.value("-o"));
  return error ? failure(*error) : kFine;
}

int exportAssembly(const Arguments& arguments) {
  const auto tolerance = number(arguments, "--tolerance", kExportTolerance, kFinest, kCoarsest);
  const auto frames = number(arguments, "--frames", 24, static_cast<double>(kFewestFrames), kMostFrames);
  for (const auto* read : {&tolerance, &frames}) {
    if (const auto* error = std::get_if<UsageError>(read)) return wrongUsage(kExport, error->message);
  }
  if (*arguments.value("-o") == "-")
    return wrongUsage(kExport, "--to assembly writes a folder; \"-\" is none.");
  const auto loaded = loadTrain(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const LoadedTrain& train = std::get<LoadedTrain>(loaded);
  if (isTooLarge(train, std::get<double>(tolerance))) return kResourceLimit;
  std::vector<std::vector<Rational>> motions = train.motions;
  if (motions.empty()) motions.emplace_back(static_cast<std::size_t>(train.mechanism().t()));  // all at rest
  GearCache cache;
  const auto count = static_cast<std::size_t>(std::get<double>(frames));
  const auto assembly = assemblyOf(train.placed(), cache, std::get<double>(tolerance), motions, count);
  if (!assembly) {
    std::cerr << diagnosticLines(arguments.files.front(), assembly.error());
    return kMechanismErrors;
  }
  const auto error = writeAssembly(*assembly, *arguments.value("-o"), arguments.has("--force"));
  return error ? failure(*error) : kFine;
}

}  // namespace geargraph::cli
