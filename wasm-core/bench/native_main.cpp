// core_bench_native KERNEL SIZE ROUNDS RUNS   times a kernel
// core_bench_native grow ROUNDS RUNS < request  times panicle_grow on one request (exports/panicle.h)
// Prints one line of JSON: the work of one round and the microseconds of a round, one number a run.
#ifndef __EMSCRIPTEN__

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "exports/panicle.h"
#include "kernels.hpp"

namespace {

template <class Work>
void time_runs(long rounds, long runs, Work work) {
  double amount = work(1);
  std::printf("{\"microseconds\":[");
  for (long run = 0; run < runs; ++run) {
    const std::clock_t begin = std::clock();  // of this process alone, independent of the machine's load
    amount = work(rounds);
    const double spent = static_cast<double>(std::clock() - begin) * (1e6 / CLOCKS_PER_SEC);
    std::printf("%s%.3f", run ? "," : "", spent / static_cast<double>(rounds));
  }
  std::printf("],\"work\":%.0f}\n", amount);
}

std::vector<std::uint8_t> standard_input() {
  std::vector<std::uint8_t> bytes;
  std::uint8_t block[4096];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, stdin)) > 0;)
    bytes.insert(bytes.end(), block, block + got);
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 4 && std::strcmp(arguments[1], "grow") == 0) {
    const std::vector<std::uint8_t> request = standard_input();
    time_runs(std::atol(arguments[2]), std::atol(arguments[3]), [&request](long rounds) {
      for (long round = 0; round < rounds; ++round)
        panicle_release(panicle_grow(request.data(), static_cast<std::uint32_t>(request.size())));
      return 1.0;
    });
    return 0;
  }
  if (count != 5) return 2;
  const auto kernel = static_cast<panicle::bench::Kernel>(std::atol(arguments[1]));
  const auto size = static_cast<std::uint32_t>(std::atol(arguments[2]));
  time_runs(std::atol(arguments[3]), std::atol(arguments[4]), [kernel, size](long rounds) {
    return panicle::bench::run(kernel, size, static_cast<std::uint32_t>(rounds));
  });
  return 0;
}

#endif
