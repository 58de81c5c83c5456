#pragma once

#if defined(__GLIBC__)
#include <cfenv>
#endif

namespace knotwork::test {

/// In debug builds, from here on a NaN, an infinity or a division by zero stops the test at the operation that made it,
/// not where it shows.
inline void trap_float_errors() {
#if defined(__GLIBC__) && !defined(NDEBUG)
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
}

/// While it lives, floating-point traps that main() has turned on are off. For texts with numbers such as 1e999: the
/// C library's strtod answers them with an overflow, which is what the code under test looks at.
class FloatTrapsOff {
 public:
#if defined(__GLIBC__)
  FloatTrapsOff() : traps_(fegetexcept()) { fedisableexcept(FE_ALL_EXCEPT); }
  ~FloatTrapsOff() {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps_);
  }

 private:
  int traps_;

 public:
#else
  FloatTrapsOff() {}
  ~FloatTrapsOff() {}
#endif
  FloatTrapsOff(const FloatTrapsOff&) = delete;
  FloatTrapsOff& operator=(const FloatTrapsOff&) = delete;
};

}  // namespace knotwork::test
