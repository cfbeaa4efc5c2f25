// 3D files of 54 gears of 40 teeth in memory, 300,000 triangles, against assimp's exporters of the same scene
// in the same run.
//
// accept  at most assimp's time for each format

#include <assimp/scene.h>
#include <benchmark/benchmark.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

#include "core/foundations/base/contract.h"
#include "core/machine/solids/gear_solid.h"
#include "core/presentation/meshfile/mesh_reader.h"

namespace geargraph {
namespace {

constexpr int kGears = 54;

const MeshScene& gears() {
  static const MeshScene scene = [] {
    MeshScene made;
    made.materials = {{"steel", {0.5F, 0.5F, 0.6F}}};
    for (int i = 0; i < kGears; ++i) {
      GearSpec spec = standardGear(GearKind::external, 40, 1, 8 + 0.01 * i);  // none shared
      MeshNode& node = made.nodes.emplace_back();
      node.name = "gear " + std::to_string(i);
      node.solid = std::make_shared<const Solid>(gearSolid(spec, kExportTolerance).value());
      node.pose.translation() = Eigen::Vector3d(50 * i, 10, 20);
    }
    return made;
  }();
  return scene;
}

std::string bytesOf(MeshFormat format) {
  const auto encoded = encodedMesh(gears(), format, "gears");
  GEARGRAPH_REQUIRE(std::holds_alternative<std::vector<EncodedFile>>(encoded));
  return std::get<std::vector<EncodedFile>>(encoded)[0].bytes;
}

void ours(benchmark::State& state, MeshFormat format) {
  std::size_t bytes = 0;
  for (auto _ : state) bytes = bytesOf(format).size();
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["triangles"] = static_cast<double>(triangleCount(gears()));
}

void assimp(benchmark::State& state, const char* id) {
  static const std::string glb = bytesOf(MeshFormat::glb);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(glb.data(), glb.size(), 0, "glb");
  GEARGRAPH_REQUIRE(scene != nullptr);
  for (auto _ : state) {
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(scene, id);
    GEARGRAPH_REQUIRE(blob != nullptr);
    state.counters["bytes"] = static_cast<double>(blob->size);
  }
}

BENCHMARK_CAPTURE(ours, stl, MeshFormat::stl)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assimp, stl, "stlb")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, ply, MeshFormat::ply)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assimp, ply, "plyb")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, obj, MeshFormat::obj)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assimp, obj, "obj")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, glb, MeshFormat::glb)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(assimp, glb, "glb2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ours, 3mf, MeshFormat::threeMf)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace geargraph

BENCHMARK_MAIN();
