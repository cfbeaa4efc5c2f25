#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph::inline meshfile {

/// A gear as a check of its teeth wants it: what it should be, what it is, and where. Lengths in the
/// document's unit; `profileShift`, `addendum`, `dedendum` and `rootRadius` in modules; angles in radians.
struct AssemblyGear {
  std::string name;  ///< "15:tail", "15:head", or one name for a wheel that serves several meshes
  MeshKind kind = MeshKind::external;  ///< internal: this gear is the ring
  int teeth = 0;
  double module = 0;  ///< at the reference circle
  double pressureAngle = 0;
  double profileShift = 0;
  double width = 0;                ///< face width; bevel: along the cone
  double bore = 0;                 ///< diameter, 0: none
  double coneAngle = 0;            ///< bevel: between axis and pitch cone
  double thinning = 0;             ///< of the tooth on the reference circle, for backlash
  std::optional<double> addendum;  ///< this and the following where they are not the standard rack's
  std::optional<double> dedendum;
  std::optional<double> rootRadius;
  std::optional<double> tipCircle;     ///< radius, a length
  std::optional<double> rootCircle;    ///< radius, a length
  std::shared_ptr<const Solid> solid;  ///< axis +z, tooth 0 centred on +x; bevel: apex at the origin
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to the base frame, reference pose
};

/// Two gears in mesh, by their places.
struct AssemblyPair {
  std::size_t a = 0;
  std::size_t b = 0;
};

/// All gears of a train, who meshes with whom, and where all are at several instants of the real motion.
struct Assembly {
  std::string unit = "mm";
  std::vector<AssemblyGear> gears;
  std::vector<AssemblyPair> meshes;
  std::vector<std::vector<Eigen::Isometry3d>> frames;  ///< pose of each gear to the base frame
};

constexpr std::size_t kFewestFrames = 12;

/// The name of each gear's STL file: the gear's, with "-" for what file systems may refuse; they differ.
[[nodiscard]] std::vector<std::string> gearFiles(const Assembly& assembly);

/// assembly.json, as the command line's manual describes it, with the unit beside.
[[nodiscard]] std::string assemblyJson(const Assembly& assembly);

/// Writes assembly.json and the gears' STL files. A folder that is not there yet appears whole or not at all;
/// in one that is there each file does, assembly.json last, and files of these names are kept unless
/// `overwrite`.
[[nodiscard]] std::optional<MeshFileError> writeAssembly(const Assembly& assembly,
                                                         const std::filesystem::path& folder, bool overwrite,
                                                         const MeshWriteOptions& options = {});

/// Times for `count` frames of a uniform motion in which mesh i passes `pitches[i]` pitches in a unit of
/// time: from 0 to where the slowest has passed one pitch or a little more. Among those ends the one is taken
/// at which the frames see the mesh that is seen worst in most positions of its pitch, so that none shows the
/// same position every time. Meshes at rest do not count; all at rest: times up to 1. @pre count >= 2
[[nodiscard]] std::vector<double> frameTimes(std::span<const double> pitches, std::size_t count);

}  // namespace geargraph::inline meshfile
