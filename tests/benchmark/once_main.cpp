// knotwork_contest_once: each of our works once, for Callgrind, which counts inside measured_run() (see instructions.mjs).
// Prints their names in the order of the runs.

#include <cstdio>

#include "benchmark/works.h"

// Of a name that Callgrind can be told.
extern "C" [[gnu::noinline]] void measured_run(const knotwork::benchmark::Kernel& kernel) { kernel.run(); }

int main() {
  for (const knotwork::benchmark::Kernel& kernel : knotwork::benchmark::work_kernels()) {
    if (!kernel.name.ends_with(" | Knotwork")) continue;
    measured_run(kernel);
    std::printf("%s\n", kernel.name.c_str());
  }
}
