#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/machine/teeth/gear_spec.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph {

/// A gear for an external check of its teeth: its parameters, its solid and its pose. Lengths in the
/// document's unit; `profileShift`, `addendum`, `dedendum` and `rootRadius` in modules; angles in radians.
struct AssemblyGear {
  std::string name;  ///< "15:tail", "15:head", or one name for a wheel that serves several meshes
  GearKind kind{};
  int teeth = 0;
  double module = 0;  ///< at the reference circle
  double pressureAngle = 0;
  double profileShift = 0;
  double width = 0;          ///< face width; bevel: along the cone
  double bore = 0;           ///< diameter, 0: none
  double coneAngle = 0;      ///< bevel: between axis and pitch cone
  double helixAngle = 0;     ///< at the reference circle, positive right-hand; the measures are transverse
  bool herringbone = false;  ///< `helixAngle` is that of the half below mid face
  double backlashAllowance = 0;    ///< on the reference circle: reduction of the tooth thickness
  std::optional<double> addendum;  ///< this and the following, if different from the standard rack
  std::optional<double> dedendum;
  std::optional<double> rootRadius;
  std::optional<double> tipCircle;     ///< radius, a length
  std::optional<double> rootCircle;    ///< radius, a length
  std::shared_ptr<const Solid> solid;  ///< axis +z, tooth 0 centred on +x; bevel: apex at the origin
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to the base frame, reference pose
};

/// Two gears in mesh, by position.
struct AssemblyPair {
  std::size_t a = 0;
  std::size_t b = 0;
};

/// All gears of a train, their meshes, and their poses at several instants of the motion.
struct Assembly {
  std::string unit = "mm";
  std::vector<AssemblyGear> gears;
  std::vector<AssemblyPair> meshes;
  std::vector<std::vector<Eigen::Isometry3d>> frames;  ///< pose of each gear to the base frame
};

constexpr std::size_t kMinFrames = 12;

/// The names of the gears' STL files, all different: the gears' names with "-" for characters that file
/// systems may reject.
[[nodiscard]] std::vector<std::string> gearFiles(const Assembly& assembly);

/// The text of assembly.json (see the manual of the command line), with the unit.
[[nodiscard]] std::string assemblyJson(const Assembly& assembly);

/// Writes assembly.json and the gears' STL files. A new folder is created atomically; in an existing one each
/// file is written atomically, assembly.json last, and existing files are kept unless `overwrite`.
[[nodiscard]] std::optional<MeshFileError> writeAssembly(const Assembly& assembly,
                                                         const std::filesystem::path& folder, bool overwrite,
                                                         const MeshWriteOptions& options = {});

/// Times for `count` frames of a uniform motion in which mesh i passes `pitches[i]` pitches per unit of time:
/// from 0 until the slowest mesh has passed one pitch or a little more. The end is chosen such that the
/// frames sample every mesh at as many different positions of its pitch as possible (maximin). Meshes at rest
/// are ignored; if all are at rest, times end at 1. @pre count >= 2
[[nodiscard]] std::vector<double> frameTimes(std::span<const double> pitches, std::size_t count);

}  // namespace geargraph
