// knotwork_contest as WebAssembly, under Node.js and in a browser: each kernel is held to its reference and then timed, the
// median of some runs. One line of JSON each. A name in the arguments selects kernels; --check does not time.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "benchmark/works.h"

namespace knotwork::benchmark {
namespace {

double seconds_of(const Kernel& kernel) {
  const auto start = std::chrono::steady_clock::now();
  kernel.run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of at least 7 runs and a quarter of a second.
double median_seconds(const Kernel& kernel) {
  std::vector<double> runs;
  for (double total = 0; runs.size() < 7 || total < 0.25; total += runs.back()) runs.push_back(seconds_of(kernel));
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end());
  return *middle;
}

}  // namespace
}  // namespace knotwork::benchmark

int main(int argc, char** argv) {
  using namespace knotwork::benchmark;
  const std::string wanted = argc > 1 ? argv[1] : "";
  int wrong = 0;
  for (const Kernel& kernel : work_kernels()) {
    if (wanted != "--check" && kernel.name.find(wanted) == std::string::npos) continue;
    kernel.run();
    const double error = kernel.error();
    const bool within = error <= kernel.tolerance;
    wrong += within ? 0 : 1;
    const double seconds = within && wanted != "--check" ? median_seconds(kernel) : 0;
    std::printf("{\"name\": \"%s\", \"ns\": %.6g, \"error\": %.3g, \"right\": %s}\n", kernel.name.c_str(),
                1e9 * seconds / static_cast<double>(kernel.items), error, within ? "true" : "false");
  }
  return wrong == 0 ? 0 : 1;
}
