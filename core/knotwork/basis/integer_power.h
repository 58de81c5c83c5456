#pragma once

namespace knotwork {

/// base^exponent by repeated multiplication, 1 for exponent 0; exponent >= 0. For numbers and truncated Taylor series,
/// where, unlike pow(), it asks nothing of the base: 0 and negative ones are as good as others. Relative error below
/// exponent * 2^-53.
template <class Number>
constexpr Number integer_power(const Number& base, int exponent) {
  Number power = 1.0;
  for (int k = 0; k < exponent; ++k) power = power * base;
  return power;
}

}  // namespace knotwork
