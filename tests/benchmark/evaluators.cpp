// knotwork_benchmark: every evaluator of the library.

#include <utility>

#include "benchmark/kernel.h"

namespace knotwork::benchmark {

std::vector<Kernel> all_kernels() {
  std::vector<Kernel> all;
  for (const auto& rows : {curve_kernels, fitting_kernels, surface_kernels, measure_kernels}) {
    for (Kernel& kernel : rows()) all.push_back(std::move(kernel));
  }
  return all;
}

}  // namespace knotwork::benchmark
