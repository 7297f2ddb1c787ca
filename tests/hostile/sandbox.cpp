#include "hostile/sandbox.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace sfumato::hostile {
namespace {

namespace fs = std::filesystem;

/// A sanitizer's shadow and its memory of freed blocks count as the process's own. Therefore freed
/// blocks are kept for a shorter time than by default, returned stack frames not at all (the unit
/// tests check them), and only one function is recorded per allocation; a request above every limit
/// is reported.
constexpr const char* kAddressOptions =
    "quarantine_size_mb=8:thread_local_quarantine_size_kb=64:malloc_context_size=1:"
    "detect_stack_use_after_return=0:max_allocation_size_mb=2048:hard_rss_limit_mb=1024:"
    "detect_leaks=1";
constexpr const char* kUndefinedOptions = "print_stacktrace=1:halt_on_error=1";

int opened(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0) _exit(127);
  return file;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

[[noreturn]] void become(const std::string& binary, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{binary};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  setenv("ASAN_OPTIONS", kAddressOptions, 1);
  setenv("UBSAN_OPTIONS", kUndefinedOptions, 1);
  const rlimit most_cpu{kMostCpuSeconds, kMostCpuSeconds + 1};
  setrlimit(RLIMIT_CPU, &most_cpu);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  alarm(kMostWallSeconds);
  execv(argv[0], argv.data());
  _exit(127);
}

std::string beginning(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostErrorBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace

Sandbox::Sandbox() {
  path_ = (fs::temp_directory_path() / "sfumato-hostile-XXXXXX").string();
  if (!mkdtemp(path_.data())) throw std::runtime_error("no temporary folder");
  fs::create_directory(path_ + "/case");
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  // Cases may have removed the permission to delete their files.
  for (const auto& entry : fs::recursive_directory_iterator(path_, ignored)) {
    if (entry.is_directory(ignored)) fs::permissions(entry, fs::perms::owner_all, ignored);
  }
  fs::remove_all(path_, ignored);
}

bool Sandbox::prepare(const Case& of) const {
  const pid_t id = fork();
  if (id == 0) {
    if (chdir((path_ + "/case").c_str()) != 0) _exit(1);
    for (const auto& [name, bytes] : of.files) {
      std::ofstream file(name, std::ios::binary);
      file << bytes();
      if (!file.flush()) _exit(1);
    }
    if (of.prepare) of.prepare();
    _exit(0);
  }
  int status = 0;
  return id > 0 && waitpid(id, &status, 0) == id && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Ended Sandbox::run(const std::string& binary, const std::vector<std::string>& arguments,
                   const std::string& input) const {
  std::ofstream(path_ + "/stdin", std::ios::binary) << input;
  const pid_t id = fork();
  if (id == 0) {
    dup2(opened(path_ + "/stdin", O_RDONLY), STDIN_FILENO);
    dup2(opened("/dev/null", O_WRONLY), STDOUT_FILENO);
    dup2(opened(path_ + "/stderr", O_WRONLY | O_CREAT | O_TRUNC), STDERR_FILENO);
    if (chdir((path_ + "/case").c_str()) != 0) _exit(127);
    become(binary, arguments);
  }
  Ended ended;
  int status = 0;
  rusage used{};
  if (id < 0 || wait4(id, &status, 0, &used) != id) throw std::runtime_error("no such process");
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ended.user_seconds = seconds(used.ru_utime);
  ended.cpu_seconds = ended.user_seconds + seconds(used.ru_stime);
  ended.peak_bytes = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  ended.err = beginning(path_ + "/stderr");
  return ended;
}

std::vector<std::string> Sandbox::names() const {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path_ + "/case", ignored)) {
    const bool is_folder = entry.symlink_status(ignored).type() == fs::file_type::directory;
    found.push_back(entry.path().filename().string() + (is_folder ? "/" : ""));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace sfumato::hostile
