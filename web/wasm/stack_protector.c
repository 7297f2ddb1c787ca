/* Debian's libc++ and compiler-rt for WebAssembly were built with a stack protector. Its wasi-libc
 * does not define the symbols that the stack protector needs. */
#include <stdint.h>

uintptr_t __stack_chk_guard = 0x9e3779b9u;

_Noreturn void __stack_chk_fail(void) {
  __builtin_trap();
}
