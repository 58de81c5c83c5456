// knotwork_contest: the works that rivals do too, ours and theirs.

#include <utility>

#include "benchmark/works.h"

namespace knotwork::benchmark {

std::vector<Kernel> all_kernels() {
  std::vector<Kernel> all = work_kernels();
  for (Kernel& kernel : rival_kernels()) all.push_back(std::move(kernel));
  return all;
}

}  // namespace knotwork::benchmark
