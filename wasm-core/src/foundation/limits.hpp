// Work limits: counts, never times, so that the same request ends the same way everywhere.
#pragma once

#include <cstdint>

#include "foundation/work_budget.hpp"

namespace panicle {

struct Limits {
  std::uint32_t text_bytes = 256 * 1024;   // grammar text
  std::uint32_t steps = 4096;              // derivation steps
  std::uint32_t words = 16 * 1024 * 1024;  // 32-bit words of one derived string (64 MiB)
  std::uint32_t work = 50'000'000;         // units of work (work_budget.hpp) of one request
  std::uint32_t bytes = 200'000'000;  // of an exported file of one plant; exporting needs four times as much memory
  std::uint32_t depth = 100'000;      // open brackets while interpreting
  std::uint32_t spheres = 100'000;    // spheres in one environment
  std::uint32_t segments = 100'000;   // stems in one result
  std::uint32_t organs = 20'000;      // organs on them
  std::uint32_t bodies = 3000;        // of these, organs that press against each other
  std::uint32_t moves = 6'000'000;    // of all that runs, each at each step
  std::uint32_t pieces = 500'000;     // of the ways that were run, in one result
  std::uint32_t copies = 300'000;     // of one mesh, on them
  std::uint32_t triangles = 100'000;  // of the meshes that a request brings
  std::uint32_t looks = 300'000'000;  // triangles examined by inside tests of meshes: less than a second
  std::uint32_t darts = 3'000'000;    // of one generalized map: 550 MB with its skin

  // The part of the work that deriving a string may take: the rest is for drawing it.
  std::uint32_t work_of_derivation() const { return work - work / 4; }

  // The budget that all parts of one request share. Null: each derivation, interpretation … may take `work`.
  WorkBudget* budget = nullptr;
  // The same limits with a budget: the request's, or else `own`, which must outlive them.
  Limits counted_by(WorkBudget& own) const {
    Limits counted = *this;
    if (counted.budget == nullptr) counted.budget = &own;
    return counted;
  }
};

}  // namespace panicle
