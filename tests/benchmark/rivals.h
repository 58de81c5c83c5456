#pragma once

#include <vector>

#include "benchmark/kernel.h"

namespace knotwork::benchmark {

/// One for each library; the last two are built where CMake finds theirs.
void add_eigen(std::vector<Kernel>& rows);
void add_sisl(std::vector<Kernel>& rows);
void add_opencascade(std::vector<Kernel>& rows);

}  // namespace knotwork::benchmark
