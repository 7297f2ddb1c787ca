/* Debian's libc++ and compiler-rt for WebAssembly were built with a stack protector; its wasi-libc
   does not define what that needs. */
#include <stdint.h>

uintptr_t __stack_chk_guard = 0x9e3779b9u;

_Noreturn void __stack_chk_fail(void) {
  __builtin_trap();
}
