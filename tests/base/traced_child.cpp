#include "base/traced_child.hpp"

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <utility>

#include "support/sanitizers.hpp"

namespace sfumato::test {

#if defined(__x86_64__) && defined(__linux__)
namespace {

constexpr int kCannotBeTraced = 77;
constexpr int kSystemCallStop = SIGTRAP | 0x80;

/// A sanitizer's allocator requests memory at unpredictable places, and ends a process that is
/// refused it.
bool is_of_a_sanitizer(long call) {
  return SFUMATO_HAS_SANITIZER && (call == SYS_mmap || call == SYS_munmap || call == SYS_madvise);
}

pid_t start(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(kCannotBeTraced);
  ::raise(SIGSTOP);
  ::_exit(body());
}

/// The tracer's side: stops twice at each call, before and after it.
class Tracer {
 public:
  Tracer(pid_t child, const Mishap& mishap) : child_(child), mishap_(mishap) {}

  TracedEnd run() {
    ::ptrace(PTRACE_SETOPTIONS, child_, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    int signal_number = 0;
    int status = 0;
    for (;;) {
      ::ptrace(PTRACE_SYSCALL, child_, nullptr,
               signal_number);  // has no effect on a killed process
      if (::waitpid(child_, &status, 0) != child_ || !WIFSTOPPED(status)) break;
      const bool is_call = WSTOPSIG(status) == kSystemCallStop;
      signal_number = is_call ? 0 : WSTOPSIG(status);
      if (is_call) stop_at_call();
    }
    end_.status = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    return end_;
  }

 private:
  void stop_at_call() {
    is_before_ = !is_before_;
    if (is_before_) {
      before_call();
    } else if (std::exchange(fails_, false)) {
      user_regs_struct registers = read();
      registers.rax =
          static_cast<unsigned long long>(-static_cast<long long>(mishap_.error_number));
      write(registers);
    }
  }

  void before_call() {
    user_regs_struct registers = read();
    const auto number = static_cast<long>(registers.orig_rax);
    if (number == SYS_exit_group || number == SYS_exit || is_of_a_sanitizer(number)) return;
    if (end_.call_count++ != mishap_.call || mishap_.kind == Mishap::Kind::none) return;
    end_.call = number;
    if (mishap_.kind == Mishap::Kind::kill) {
      ::kill(child_, SIGKILL);
    } else if (mishap_.kind == Mishap::Kind::error) {
      registers.orig_rax = ~0ull;  // an invalid call
      fails_ = true;
      write(registers);
    } else if (number == SYS_write && registers.rdx > 1) {
      registers.rdx /= 2;
      write(registers);
    }
  }

  user_regs_struct read() const {
    user_regs_struct registers{};
    ::ptrace(PTRACE_GETREGS, child_, nullptr, &registers);
    return registers;
  }

  void write(user_regs_struct registers) const {
    ::ptrace(PTRACE_SETREGS, child_, nullptr, &registers);
  }

  pid_t child_;
  Mishap mishap_;
  TracedEnd end_;
  bool is_before_ = false;
  bool fails_ = false;
};

}  // namespace

std::optional<TracedEnd> run_traced(const std::function<int()>& body, const Mishap& mishap) {
  const pid_t child = start(body);
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) {
    return std::nullopt;
  }
  return Tracer(child, mishap).run();
}

#else

std::optional<TracedEnd> run_traced(const std::function<int()>&, const Mishap&) {
  return std::nullopt;
}

#endif

}  // namespace sfumato::test
