/// Races that ThreadSanitizer ignores in the programs linked with this: races inside Mesa's
/// software driver. The driver is not instrumented, so ThreadSanitizer cannot see the reference
/// counts by which its threads pass a lock to the one that destroys it.
extern "C" const char* __tsan_default_suppressions();

extern "C" const char* __tsan_default_suppressions() {
  return "race:swrast_dri.so\n"     // Mesa before 24.2
         "race:libgallium-*.so\n";  // Mesa since 24.2
}
