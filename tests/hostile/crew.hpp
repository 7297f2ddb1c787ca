#pragma once

#include <string>
#include <vector>

#include "hostile/case.hpp"

namespace sfumato::hostile {

/// What is kept of a case that ran: plain memory that processes share.
struct Result {
  int exit_code;
  double cpu_seconds;
  std::size_t peak_bytes;
  char complaint[8192];  ///< ended by a zero; empty where all is well
};

/// A case and the family that it belongs to.
struct Job {
  const Family* family;
  const Case* attack;

  std::string name() const { return family->name() + "/" + attack->name; }
};

/// Runs all jobs, `worker_count` at a time, each in a folder of its own. The results, job by job.
std::vector<Result> run_all(const std::vector<Job>& jobs, const std::string& binary,
                            int worker_count);

}  // namespace sfumato::hostile
