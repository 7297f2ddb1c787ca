#pragma once

#include <memory>
#include <string>
#include <vector>

#include "equal/tool/configuration.hpp"
#include "equal/tool/digest.hpp"
#include "equal/tool/scene.hpp"
#include "equal/tool/trace.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::test {

/// The result of one scene under several configurations.
struct SceneCheck {
  std::string line;       ///< digest_line under the first configuration
  std::string complaint;  ///< empty if all agree; otherwise which one differs, and where
};

/// Runs scenes under configurations, and reuses the threads.
class SceneChecker {
 public:
  std::vector<StageHash> digest(const Scene& scene, const Configuration& configuration);
  Result<Trace> trace(const Scene& scene, const Configuration& configuration);

  /// configurations: not empty
  SceneCheck check(const Scene& scene, const std::vector<Configuration>& configurations);

 private:
  Executor* executor(int threads);
  std::string complaint(const Scene& scene, const Configuration& a, const Configuration& b);

  std::vector<std::unique_ptr<ThreadPool>> executors_;
};

}  // namespace sfumato::test
