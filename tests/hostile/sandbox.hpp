#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// How a process ended and what it took.
struct Ended {
  int exit_code = -1;          ///< where no signal ended it
  int signal = 0;              ///< or 0
  double user_seconds = 0;     ///< of all its threads
  double cpu_seconds = 0;      ///< with the system's part
  std::size_t peak_bytes = 0;  ///< resident; this process's own at least
  std::string err;             ///< the first kMostErrorBytes of it
};

/// Ends what never ends: by SIGXCPU, or by SIGALRM where it waits for something. No machine is so
/// slow that a case within its limit (pace.hpp) takes as long.
constexpr unsigned kMostCpuSeconds = SFUMATO_HAS_SANITIZER ? 60 : 30;
constexpr unsigned kMostWallSeconds = 300;
constexpr std::size_t kMostErrorBytes = std::size_t{1} << 20;

/// A folder that a case runs in, and that goes away with all it holds.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// Makes the case's files, in a process of its own. False where that fails.
  bool prepare(const Case& of) const;
  /// Runs `binary` there with these arguments; its standard output is thrown away.
  Ended run(const std::string& binary, const std::vector<std::string>& arguments,
            const std::string& input) const;
  /// What the folder holds, sorted; folders within end with a slash.
  std::vector<std::string> names() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace sfumato::hostile
