#include "cli/interrupt.hpp"

#include <array>
#include <atomic>
#include <csignal>

namespace sfumato::cli {
namespace {

// SIGXCPU means that the processor time of `ulimit -t` is used up.
constexpr std::array<int, 4> kSignals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

// A signal handler takes no argument of ours, so it needs globals. These two are the only mutable
// globals of the project.
std::atomic<CancelFlag*> cancel_flag{nullptr};
volatile std::sig_atomic_t last_signal = 0;

void set_cancel_flag(int signal_number) {
  last_signal = signal_number;
  if (CancelFlag* flag = cancel_flag.load()) flag->store(true);
}

void handle(int signal_number, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal_number, &action, nullptr);
}

/// Returns whether the caller ignores the signal, as `nohup` does.
bool is_ignored(int signal_number) {
  struct sigaction action {};
  return sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

CancelOnSignal::CancelOnSignal(CancelFlag& cancel) {
  cancel_flag.store(&cancel);
  for (const int signal_number : kSignals) {
    if (is_ignored(signal_number)) continue;
    handle(signal_number, set_cancel_flag, static_cast<int>(SA_RESETHAND | SA_RESTART));
  }
}

CancelOnSignal::~CancelOnSignal() {
  for (const int signal_number : kSignals) {
    if (!is_ignored(signal_number)) handle(signal_number, SIG_DFL, 0);
  }
  cancel_flag.store(nullptr);
}

void ignore_write_signals() {
  for (const int signal_number : {SIGPIPE, SIGXFSZ}) handle(signal_number, SIG_IGN, 0);
}

int received_signal() {
  return last_signal;
}

}  // namespace sfumato::cli
