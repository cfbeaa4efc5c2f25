#include "core/presentation/meshfile/mesh_writer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/presentation/meshfile/encoders.h"

namespace geargraph {
namespace {

using Files = std::vector<EncodedFile>;
using Result = std::variant<Files, MeshFileError>;
using Write = std::function<std::optional<MeshFileError>(ByteSink&)>;

constexpr std::size_t kChunk = std::size_t{1} << 20U;
constexpr double kEncoded = 0.8;  // of the progress; writing is the rest

MeshFileError stopped() {
  return {MeshFileError::Kind::stopped, translated("Stopped; nothing was written.")};
}

Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double part) { progress(from + (to - from) * part); };
}

Result plain(std::optional<std::string> bytes, const std::string& stem, MeshFormat format) {
  if (!bytes) return stopped();
  return Files{{stem + "." + std::string(meshFormatName(format)), std::move(*bytes)}};
}

std::optional<std::string> glbBytes(const MeshScene& scene, const MeshWriteOptions& options) {
  TextSink sink;
  if (!writeGlb(scene, options, sink)) return std::nullopt;
  return sink.take();
}

Result objFiles(const MeshScene& scene, const std::string& stem, const MeshWriteOptions& options) {
  auto texts = objTexts(scene, stem + ".mtl", options);
  if (!texts) return stopped();
  return Files{{stem + ".obj", std::move(texts->scene)}, {stem + ".mtl", std::move(texts->materials)}};
}

std::optional<MeshFileError> writeBytes(ByteSink& sink, const std::string& bytes,
                                        const MeshWriteOptions& options) {
  for (std::size_t at = 0; at < bytes.size() && !sink.failed(); at += kChunk) {
    if (options.stop.stop_requested()) return stopped();
    sink.write(std::string_view(bytes).substr(at, kChunk));
    if (options.progress) options.progress(static_cast<double>(at) / static_cast<double>(bytes.size()));
  }
  return std::nullopt;
}

/// What `write` writes.
std::optional<MeshFileError> toStandardOutput(const Write& write) {
  StandardOutput sink;
  if (auto error = write(sink)) return error;
  if (sink.failed())
    return MeshFileError{MeshFileError::Kind::file, translated("Standard output could not be written.")};
  return std::nullopt;
}

/// What `write` writes, whole or not at all.
std::optional<MeshFileError> toFile(const std::filesystem::path& path, const Write& write) {
  AtomicFile file(path);
  if (auto error = write(file)) return error;
  if (const auto error = file.commit()) return MeshFileError{MeshFileError::Kind::file, error->message};
  return std::nullopt;
}

/// The first file goes to `path`, those that it refers to beside it: all of them or none.
std::optional<MeshFileError> toFiles(const std::filesystem::path& path, const Files& files,
                                     const MeshWriteOptions& options) {
  std::vector<std::unique_ptr<AtomicFile>> written;
  for (const auto& file : files) {
    const bool isFirst = written.empty();
    written.push_back(std::make_unique<AtomicFile>(isFirst ? path : path.parent_path() / file.name));
    MeshWriteOptions silent;
    silent.stop = options.stop;
    if (auto error = writeBytes(*written.back(), file.bytes, isFirst ? options : silent)) return error;
    if (!written.back()->failed()) continue;
    return MeshFileError{MeshFileError::Kind::file, written.back()->commit()->message};
  }
  for (auto file = written.rbegin(); file != written.rend();
       ++file) {  // what the first refers to comes first
    if (const auto error = (*file)->commit()) return MeshFileError{MeshFileError::Kind::file, error->message};
  }
  return std::nullopt;
}

bool isFinite(const Float3& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

/// The largest distance of a vertex from the solid's origin; infinite where a number of it is not finite.
double reachOf(const Solid& solid) {
  double reach = 0;
  for (const Float3& p : solid.positions) {
    if (!isFinite(p)) return INFINITY;
    reach = std::max(reach, std::hypot(double{p[0]}, double{p[1]}, double{p[2]}));
  }
  return std::all_of(solid.normals.begin(), solid.normals.end(), isFinite) ? reach : INFINITY;
}

/// Are all numbers finite, and all vertices within what a float holds wherever their nodes put them? Of no
/// use when `stop` was requested.
bool isWithinFloats(const MeshScene& scene, const std::stop_token& stop) {
  const std::vector<Eigen::Isometry3d> world = worldPoses(scene);
  std::map<const Solid*, double> reaches;
  for (std::size_t i = 0; i < scene.nodes.size() && !stop.stop_requested(); ++i) {
    const MeshNode& node = scene.nodes[i];
    double reach = 0;
    if (node.solid) {
      const auto [known, isNew] = reaches.try_emplace(node.solid.get());
      if (isNew) known->second = reachOf(*node.solid);
      reach = known->second;
    }
    const double far = std::max(node.pose.translation().norm(), world[i].translation().norm()) + reach;
    if (!(far < std::numeric_limits<float>::max())) return false;
    if (!node.pose.linear().allFinite()) return false;
    for (const RotationKey& key : node.keys)
      if (!std::isfinite(static_cast<float>(key.seconds)) || !key.rotation.coeffs().allFinite()) return false;
  }
  return true;
}

/// Why the scene is not written at all.
std::optional<MeshFileError> whyNot(const MeshScene& scene, const MeshWriteOptions& options) {
  const std::size_t triangles = triangleCount(scene);
  if (triangles > options.mostTriangles) {
    return MeshFileError{
        MeshFileError::Kind::limit,
        translated("The scene has %1 triangles, more than the limit of %2; choose a coarser tolerance.",
                   {std::to_string(triangles), std::to_string(options.mostTriangles)})};
  }
  if (options.stop.stop_requested()) return stopped();
  const bool isWithin = isWithinFloats(scene, options.stop);
  if (options.stop.stop_requested()) return stopped();
  if (!isWithin) {
    return MeshFileError{
        MeshFileError::Kind::limit,
        translated("The scene has coordinates beyond 3.4e38, the largest that 3D files hold; "
                   "bring the parts nearer to each other, or scale them down.")};
  }
  return std::nullopt;
}

/// A GLB, which is never held in memory.
std::optional<MeshFileError> writeStreamed(const MeshScene& scene, const std::filesystem::path& path,
                                           const MeshWriteOptions& options) {
  if (auto why = whyNot(scene, options)) return why;
  const auto write = [&](ByteSink& sink) {
    return writeGlb(scene, options, sink) ? std::nullopt : std::optional(stopped());
  };
  auto error = path == "-" ? toStandardOutput(write) : toFile(path, write);
  if (!error && options.progress) options.progress(1);
  return error;
}

}  // namespace

Result encodedMesh(const MeshScene& scene, MeshFormat format, const std::string& stem,
                   const MeshWriteOptions& options) {
  if (auto why = whyNot(scene, options)) return *std::move(why);
  switch (format) {
    case MeshFormat::stl:
      return plain(stlBytes(scene, options), stem, format);
    case MeshFormat::obj:
      return objFiles(scene, stem, options);
    case MeshFormat::ply:
      return plain(plyBytes(scene, options), stem, format);
    case MeshFormat::glb:
      return plain(glbBytes(scene, options), stem, format);
    case MeshFormat::threeMf:
      return plain(threeMfBytes(scene, options), stem, format);
  }
  return stopped();
}

std::optional<MeshFileError> writeMesh(const MeshScene& scene, MeshFormat format,
                                       const std::filesystem::path& path, const MeshWriteOptions& options) {
  if (format == MeshFormat::glb) return writeStreamed(scene, path, options);
  MeshWriteOptions encoding = options;
  encoding.progress = partOf(options.progress, 0, kEncoded);
  const std::string stem = path == "-" ? "mechanism" : path.stem().string();
  const Result encoded = encodedMesh(scene, format, stem, encoding);
  if (const auto* error = std::get_if<MeshFileError>(&encoded)) return *error;
  const Files& files = std::get<Files>(encoded);

  MeshWriteOptions writing = options;
  writing.progress = partOf(options.progress, kEncoded, 1);
  if (path == "-")
    return toStandardOutput([&](ByteSink& sink) { return writeBytes(sink, files[0].bytes, writing); });
  if (auto error = toFiles(path, files, writing)) return error;
  if (options.progress) options.progress(1);
  return std::nullopt;
}

}  // namespace geargraph
