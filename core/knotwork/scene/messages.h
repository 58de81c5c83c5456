#pragma once

#include <string>

#include "knotwork/scene/limits.h"

/// The sentences about numbers that checks, parameters and documents share.
namespace knotwork::scene {

/// A number as a reader writes it: at most 7 digits, no zeros at the end.
std::string number_text(double x);
/// "Must be a number from 0.1 to 4."
std::string number_message(const Limits& limits);
/// "Must be a whole number from 2 to 128."
std::string integer_message(const Limits& limits);

}  // namespace knotwork::scene
