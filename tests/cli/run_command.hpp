#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sfumato::test {

struct CommandResult {
  int exit_code = -1;  ///< 128 + the signal's number where a signal ended it
  std::string out;
  std::string err;
  double cpu_seconds = 0;      ///< of all its threads
  std::size_t peak_bytes = 0;  ///< resident; this process's own at the start at least
};

/// The names of what is in a folder, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

/// A new folder that goes away with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string add(const std::string& name, const std::string& content) const;
  std::vector<std::string> names() const { return names_in(folder_); }

 private:
  std::filesystem::path folder_;
};

/// A program that runs with its own standard streams, each a file.
class RunningCommand {
 public:
  RunningCommand(std::vector<std::string> arguments, const std::string& input);

  pid_t id() const { return id_; }
  CommandResult wait();
  /// Waits until the program has its own handler of this signal: it is started then. Needs /proc.
  void wait_until_it_catches(int signal_number) const;

 private:
  TemporaryFolder streams_;
  pid_t id_ = 0;
};

CommandResult run_command(std::vector<std::string> arguments, const std::string& input = {});

/// The built `sfumato` with these arguments.
CommandResult run_sfumato(std::vector<std::string> arguments, const std::string& input = {});

std::string read_whole(const std::string& path);

bool contains(const std::string& text, const std::string& part);

}  // namespace sfumato::test
