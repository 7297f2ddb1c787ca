// The exact gather of nodes and pixels of a public scene in CUDA: gpu_gather_cuda [SCENE.xml]
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "cuda/point_walk.hpp"
#include "gather/kernels/negligible.hpp"
#include "scenes.hpp"
#include "support/twin_source.hpp"
#include "walk_points.hpp"

namespace sfumato {
namespace {

constexpr int kTimes = 10;
constexpr std::size_t kCompared = 100'000;

std::size_t differing_bits(const gather::Scene& scene, std::span<const gather::WalkPoint> points,
                           const std::vector<float>& sums) {
  const std::size_t stride = gather::sums_of_point(scene);
  points = points.first(std::min(points.size(), kCompared));
  std::vector<float> expected(points.size() * stride);
  test::TwinSource<16> twin;
  Context context;
  if (!twin.sum(context, scene, points, expected)) return points.size();
  std::size_t differing = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    differing += !std::equal(&expected[i * stride], &expected[(i + 1) * stride], &sums[i * stride]);
  return differing;
}

int measure(const bench::Prepared& drawing, const char* what,
            const std::vector<gather::WalkPoint>& points) {
  const gather::Scene& scene = drawing.scene;
  const auto bytes = [](const auto& table) { return table.size() * sizeof table[0]; };
  std::vector<float> sums(points.size() * gather::sums_of_point(scene));
  for (const int block : {32, 64, 128}) {
    const bench::CudaWalk walk{scene.edge_beyond.data(),
                               bytes(scene.edge_beyond),
                               scene.hit_edge.data(),
                               bytes(scene.hit_edge),
                               scene.triangle.data(),
                               bytes(scene.triangle),
                               points.data(),
                               points.size(),
                               gather::kPointNegligible,
                               block};
    std::string device;
    const double ms = bench::walk_by_cuda(walk, kTimes, sums.data(), device);
    if (ms < 0) {
      std::fprintf(stderr, "gpu_gather_cuda: %s\n", device.c_str());
      return 1;
    }
    std::printf("%s: %s, %zu points, blocks of %d: %.3f ms, %.2f ns a point, %zu other bits\n",
                device.c_str(), what, points.size(), block, ms,
                1e6 * ms / static_cast<double>(points.size()), differing_bits(scene, points, sums));
  }
  return 0;
}

int run(const std::string& name) {
  const std::optional<std::string> text = bench::scene_text(name);
  Context context;
  const Result<ReadDocument> read = read_orzan(context, text.value_or(""), name);
  if (!text || !read) {
    std::fprintf(stderr, "gpu_gather_cuda: the public scene %s is not at hand\n", name.c_str());
    return 1;
  }
  const auto drawing = bench::prepare(read->document);
  const Box& artboard = read->document.artboard;
  int code = measure(*drawing, "nodes", bench::node_points(*drawing));
  for (const int width : {1024, 3840}) {
    const std::string what = std::to_string(width) + " pixels wide";
    if (code == 0)
      code = measure(*drawing, what.c_str(), bench::pixel_points(*drawing, artboard, width));
  }
  return code;
}

}  // namespace
}  // namespace sfumato

int main(int argc, char** argv) {
  return sfumato::run(argc > 1 ? argv[1] : "lady_bug.xml");
}
