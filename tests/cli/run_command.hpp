#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sfumato::test {

struct CommandResult {
  int exit_code = -1;  ///< 128 + the signal's number if a signal ended it
  std::string out;
  std::string err;
  double cpu_seconds = 0;      ///< of all its threads
  std::size_t peak_bytes = 0;  ///< resident; at least this process's own peak at the start
};

/// Returns the names of a folder's content, sorted.
std::vector<std::string> names_in(const std::filesystem::path& folder);

/// A new folder that is removed with its content.
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

/// A running program whose standard streams are files.
class RunningCommand {
 public:
  RunningCommand(std::vector<std::string> arguments, const std::string& input);

  pid_t id() const { return id_; }
  CommandResult wait();
  /// Waits until the program handles this signal, which means that it has started. Needs /proc.
  void wait_until_it_catches(int signal_number) const;

 private:
  TemporaryFolder streams_;
  pid_t id_ = 0;
};

CommandResult run_command(std::vector<std::string> arguments, const std::string& input = {});

/// Runs the built `sfumato` with these arguments.
CommandResult run_sfumato(std::vector<std::string> arguments, const std::string& input = {});

std::string read_whole(const std::string& path);

bool contains(const std::string& text, const std::string& part);

/// Returns the number behind a key of JSON; -1 if there is no such key.
inline double number_after(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("\"" + key + "\":");
  if (at == std::string::npos) return -1;
  return std::stod(text.substr(at + key.size() + 3));
}

}  // namespace sfumato::test
