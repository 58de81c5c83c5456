// The benchmark programs' main: the time of each kernel of the program, an item at a time. Before anything is timed, each
// runs once and is held to its reference; the program fails where one is wrong, and never because one is slow.
//
//   knotwork_benchmark                                  the table
//   knotwork_benchmark --check                          the comparison alone
//   knotwork_benchmark --benchmark_filter=surface       some of it; Google Benchmark's other options work as well

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmark/kernel.h"

namespace knotwork::benchmark {
namespace {

/// True when all agree with their references; prints each.
bool check(const std::vector<Kernel>& kernels) {
  bool right = true;
  for (const Kernel& kernel : kernels) {
    kernel.run();
    const double error = kernel.error();
    const bool within = error <= kernel.tolerance;
    std::fprintf(stderr, "%-66s differs by %8.2g, allowed %8.2g%s\n", kernel.name.c_str(), error, kernel.tolerance,
                 within ? "" : "  WRONG");
    right = right && within;
  }
  return right;
}

void time_kernel(::benchmark::State& state, const Kernel& kernel) {
  for (auto _ : state) {
    kernel.run();
    ::benchmark::ClobberMemory();
  }
  state.counters["each"] =
      ::benchmark::Counter(static_cast<double>(kernel.items),
                           ::benchmark::Counter::kIsIterationInvariantRate | ::benchmark::Counter::kInvert);
}

}  // namespace
}  // namespace knotwork::benchmark

int main(int argc, char** argv) {
  using namespace knotwork::benchmark;
  const std::vector<Kernel> kernels = all_kernels();
  if (!check(kernels)) return 1;
  if (argc == 2 && std::string_view(argv[1]) == "--check") {
    std::printf("%zu kernels agree with their references\n", kernels.size());
    return 0;
  }
  for (const Kernel& kernel : kernels) {
    ::benchmark::RegisterBenchmark(kernel.name.c_str(), [&kernel](::benchmark::State& state) {
      time_kernel(state, kernel);
    })->Unit(::benchmark::kMicrosecond);
  }
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  ::benchmark::RunSpecifiedBenchmarks();
  return 0;
}
