#include "cli/run_command.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/places.hpp"

namespace sfumato::test {
namespace {

void open_as(int descriptor, const std::string& path, int flags) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(127);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Returns whether the process handles this signal. Reads /proc.
bool catches(pid_t id, int signal_number) {
  std::ifstream status("/proc/" + std::to_string(id) + "/status");
  std::string word;
  while (status >> word) {
    if (word != "SigCgt:") continue;
    status >> word;
    return (std::stoull(word, nullptr, 16) >> (signal_number - 1)) & 1;
  }
  return false;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "sfumato-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string TemporaryFolder::add(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
  return path(name);
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    found.push_back(entry.path().filename().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

RunningCommand::RunningCommand(std::vector<std::string> arguments, const std::string& input) {
  streams_.add("in", input);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  id_ = fork();
  if (id_ != 0) return;
  open_as(STDIN_FILENO, streams_.path("in"), O_RDONLY);
  open_as(STDOUT_FILENO, streams_.path("out"), O_WRONLY | O_CREAT);
  open_as(STDERR_FILENO, streams_.path("err"), O_WRONLY | O_CREAT);
  execv(argv[0], argv.data());
  _exit(127);
}

CommandResult RunningCommand::wait() {
  int status = 0;
  rusage used{};
  if (id_ < 0 || wait4(id_, &status, 0, &used) != id_) throw std::runtime_error("no such process");
  const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {exit_code, read_whole(streams_.path("out")), read_whole(streams_.path("err")),
          seconds(used.ru_utime) + seconds(used.ru_stime),
          static_cast<std::size_t>(used.ru_maxrss) * 1024};
}

void RunningCommand::wait_until_it_catches(int signal_number) const {
  while (!catches(id_, signal_number) && kill(id_, 0) == 0) usleep(1000);
}

CommandResult run_command(std::vector<std::string> arguments, const std::string& input) {
  return RunningCommand(std::move(arguments), input).wait();
}

CommandResult run_sfumato(std::vector<std::string> arguments, const std::string& input) {
  arguments.insert(arguments.begin(), sfumato_program());
  return run_command(std::move(arguments), input);
}

std::string read_whole(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace sfumato::test
