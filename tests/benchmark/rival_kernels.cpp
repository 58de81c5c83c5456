#include "benchmark/rivals.h"
#include "benchmark/works.h"

namespace knotwork::benchmark {

std::vector<Kernel> rival_kernels() {
  std::vector<Kernel> rows;
  add_eigen(rows);
#ifdef KNOTWORK_WITH_SISL
  add_sisl(rows);
#endif
#ifdef KNOTWORK_WITH_OPENCASCADE
  add_opencascade(rows);
#endif
  return rows;
}

}  // namespace knotwork::benchmark
