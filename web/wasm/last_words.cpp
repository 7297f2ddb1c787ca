// What Debian's C++ library says before it ends a program would bring printf, and nobody is there
// to read it. These stand in the place of its own.
#include <cstdlib>
#include <vector>  // declares the first, as all containers do

void std::__libcpp_verbose_abort(const char* /*format*/, ...) {
  std::abort();
}

extern "C" [[noreturn]] void abort_message(const char* /*format*/, ...) {
  std::abort();
}
