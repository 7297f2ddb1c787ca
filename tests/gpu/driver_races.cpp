/// What ThreadSanitizer is to pass over in the programs that are linked with this: races inside
/// Mesa's software driver. It is not instrumented, so that the counts of references by which its
/// threads hand a lock on to the one that destroys it cannot be seen.
extern "C" const char* __tsan_default_suppressions();

extern "C" const char* __tsan_default_suppressions() {
  return "race:swrast_dri.so\n"     // Mesa before 24.2
         "race:libgallium-*.so\n";  // and since
}
