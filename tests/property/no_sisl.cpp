// In the place of sisl_agreement.cpp where SISL is not on the system: the report says that nothing was compared.

#include <doctest/doctest.h>

TEST_CASE("SISL is not on this system: agreement with it was not tested") {
  MESSAGE("Install SISL (Debian: libsisl-dev) and configure again to build property/sisl_agreement.cpp.");
}
