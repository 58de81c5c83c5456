// Laws that RapidCheck tries on what it draws. The draws are the same in every run, so that continuous integration is
// deterministic; RC_PARAMS overrides that: RC_PARAMS="max_success=10000" draws afresh and much more,
// RC_PARAMS="reproduce=..." repeats a failure as its report says.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

#include "unit/float_traps.h"

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  setenv("RC_PARAMS", "seed=3 max_success=100", 0);
  knotwork::test::trap_float_errors();
  return context.run();
}
