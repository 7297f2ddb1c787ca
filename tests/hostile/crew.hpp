#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"

namespace sfumato::hostile {

/// The result of a case: plain memory that processes share.
struct Result {
  int exit_code;
  double cpu_seconds;
  std::size_t peak_bytes;
  char complaint[8192];  ///< ends with a zero; empty if all is well
};

/// A case and its family.
struct Job {
  const Family* family;
  const Case* attack;

  std::string name() const { return family->name() + "/" + attack->name; }
};

/// Runs all jobs, `worker_count` at a time, each in its own folder. Returns the results, job by
/// job.
std::vector<Result> run_all(const std::vector<Job>& jobs, const std::string& binary,
                            int worker_count);

}  // namespace sfumato::hostile
