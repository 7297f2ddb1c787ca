#include "equal/tool/scene_check.hpp"

#include "equal/tool/difference.hpp"
#include "equal/tool/scene_trace.hpp"

namespace sfumato::test {

Executor* SceneChecker::executor(int threads) {
  if (threads == 1) return nullptr;
  for (const std::unique_ptr<ThreadPool>& known : executors_) {
    if (known->thread_count() == threads) return known.get();
  }
  return executors_.emplace_back(std::make_unique<ThreadPool>(threads)).get();
}

std::vector<StageHash> SceneChecker::digest(const Scene& scene,
                                            const Configuration& configuration) {
  Context context;
  context.executor = executor(configuration.threads);
  context.simd = configuration.simd;
  return digest_scene(context, scene);
}

Result<Trace> SceneChecker::trace(const Scene& scene, const Configuration& configuration) {
  Context context;
  context.executor = executor(configuration.threads);
  context.simd = configuration.simd;
  return trace_scene(context, scene);
}

SceneCheck SceneChecker::check(const Scene& scene,
                               const std::vector<Configuration>& configurations) {
  const std::vector<StageHash> expected = digest(scene, configurations.front());
  SceneCheck check{digest_line(scene, expected), {}};
  for (std::size_t i = 1; i < configurations.size(); ++i) {
    const std::vector<StageHash> actual = digest(scene, configurations[i]);
    if (actual == expected) continue;
    check.complaint = complaint(scene, configurations.front(), configurations[i]) +
                      "  a: " + check.line + "\n  b: " + digest_line(scene, actual) + '\n';
    break;
  }
  return check;
}

std::string SceneChecker::complaint(const Scene& scene, const Configuration& a,
                                    const Configuration& b) {
  std::string text =
      "scene " + scene.name + ", " + to_string(a) + " (a) against " + to_string(b) + " (b)\n";
  const Result<Trace> trace_a = trace(scene, a), trace_b = trace(scene, b);
  if (!trace_a || !trace_b) {
    return text + "  " + to_string(trace_a ? trace_b.status() : trace_a.status()) + '\n';
  }
  const auto difference = first_difference(*trace_a, *trace_b);
  return text + (difference ? to_string(*difference)
                            : "  the traces are the same: another run may differ, or an output\n");
}

}  // namespace sfumato::test
