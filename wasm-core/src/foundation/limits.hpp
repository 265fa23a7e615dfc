// Work limits: counts, never times, so that the same request ends the same way everywhere.
#pragma once

#include <cstdint>

namespace panicle {

struct Limits {
  std::uint32_t text_bytes = 256 * 1024;   // grammar text
  std::uint32_t steps = 4096;              // derivation steps
  std::uint32_t words = 64 * 1024 * 1024;  // 32-bit words of one derived string (256 MiB)
  std::uint32_t evaluations = 50'000'000;  // productions applied in one derivation
  std::uint32_t depth = 100'000;           // open brackets while interpreting
  std::uint32_t spheres = 100'000;         // spheres in one environment
  std::uint32_t segments = 100'000;        // stems in one result
  std::uint32_t organs = 20'000;           // what may grow on them
  std::uint32_t bodies = 3000;             // of these, what presses against each other
  std::uint32_t moves = 6'000'000;         // of all that runs, each at each step
  std::uint32_t pieces = 500'000;          // of the ways that were run, in one result
  std::uint32_t copies = 300'000;          // of one mesh, on them
  std::uint32_t triangles = 100'000;       // of the meshes that a request brings
  std::uint32_t looks = 300'000'000;       // at triangles of meshes, to find out what is inside: less than a second
  std::uint32_t darts = 4'000'000;         // of one generalized map
};

}  // namespace panicle
