#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#if defined(__GLIBC__) && !defined(NDEBUG)
#include <cfenv>
#endif

int main(int argc, char** argv) {
  // The command line decides first: a listing or a wrong option ends here and needs no traps.
  doctest::Context context(argc, argv);
#if defined(__GLIBC__) && !defined(NDEBUG)
  // A NaN, an infinity or a division by zero stops the test at the operation that made it, not where it shows.
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
  return context.run();
}
