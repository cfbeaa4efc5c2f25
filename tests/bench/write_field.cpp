// The field of gears that bench_render paints, for a peer to paint: geargraph_bench_field COUNT SHAPES
// FILE.glb writes it; with FILE.png the same is painted from nothing, as a whole process.

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "tests/bench/gear_field.h"

int main(int count, char** words) {
  using namespace geargraph;
  if (count != 4) {
    std::fprintf(stderr, "usage: geargraph_bench_field COUNT SHAPES FILE\n");
    return 2;
  }
  auto stage = std::make_shared<MechanismScene>();
  stage->scene = bench::gearField(std::atoi(words[1]), std::atoi(words[2]));
  const std::filesystem::path file = words[3];
  if (file.extension() == ".glb") return writeMesh(sceneOf(*stage, {}), MeshFormat::glb, file) ? 1 : 0;
  SceneRendering rendering;
  rendering.stage = stage;
  rendering.size = {1280, 720};
  rendering.view.camera = Camera::from(-0.5, 0.6);
  rendering.view.style.samples = 4;
  return writePicture(rendering, file) ? 1 : 0;
}
