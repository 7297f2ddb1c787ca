#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hostile/case.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// How a process ended, and its cost.
struct Ended {
  int exit_code = -1;          ///< if no signal ended it
  int signal = 0;              ///< or 0
  double user_seconds = 0;     ///< of all its threads
  double cpu_seconds = 0;      ///< including system time
  std::size_t peak_bytes = 0;  ///< resident; at least this process's own peak
  std::string err;             ///< its first kMostErrorBytes
};

/// Ends a process that never ends: by SIGXCPU, or by SIGALRM if it waits. On no machine does a case
/// within its limit (pace.hpp) take this long.
constexpr unsigned kMostCpuSeconds = SFUMATO_HAS_SANITIZER ? 60 : 30;
constexpr unsigned kMostWallSeconds = 300;
constexpr std::size_t kMostErrorBytes = std::size_t{1} << 20;

/// A folder for a case, removed with its content.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// Makes the case's files in a separate process. Returns false if that fails.
  bool prepare(const Case& of) const;
  /// Runs `binary` there with these arguments; its standard output is discarded.
  Ended run(const std::string& binary, const std::vector<std::string>& arguments,
            const std::string& input) const;
  /// Returns the folder's content, sorted; folders end with a slash.
  std::vector<std::string> names() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace sfumato::hostile
