#include "cli/servers/browser.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

namespace sfumato::cli {
namespace {

constexpr const char* kOpener = "xdg-open";

/// The browser runs in its own session, without the signals that we block and ignore.
bool set_attributes(posix_spawnattr_t& attributes) {
  sigset_t none, pipes;
  sigemptyset(&none);
  sigemptyset(&pipes);
  sigaddset(&pipes, SIGPIPE);
  sigaddset(&pipes, SIGXFSZ);
  return posix_spawnattr_setsigmask(&attributes, &none) == 0 &&
         posix_spawnattr_setsigdefault(&attributes, &pipes) == 0 &&
         posix_spawnattr_setflags(
             &attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF) == 0;
}

/// The output of browsers is discarded.
bool set_streams(posix_spawn_file_actions_t& actions) {
  bool done = true;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    done &= posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0) == 0;
  }
  return done;
}

}  // namespace

bool open_in_browser(const std::string& address) {
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_t actions;
  if (posix_spawnattr_init(&attributes) != 0) return false;
  if (posix_spawn_file_actions_init(&actions) != 0) {
    posix_spawnattr_destroy(&attributes);
    return false;
  }
  std::string program = kOpener, argument = address;
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  pid_t id = 0;
  const bool opened = set_attributes(attributes) && set_streams(actions) &&
                      posix_spawnp(&id, kOpener, &actions, &attributes, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return opened;
}

}  // namespace sfumato::cli
