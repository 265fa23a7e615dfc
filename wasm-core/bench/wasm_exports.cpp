// The exports of the benchmark, besides those of panicle.h.
#ifdef __EMSCRIPTEN__

#include "kernels.hpp"

extern "C" __attribute__((export_name("panicle_bench"))) double panicle_bench(std::uint32_t kernel, std::uint32_t size,
                                                                              std::uint32_t rounds) {
  return panicle::bench::run(static_cast<panicle::bench::Kernel>(kernel), size, rounds);
}

#endif
