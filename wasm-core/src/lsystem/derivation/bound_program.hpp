// A compiled grammar with its inputs: all values that depend on the inputs alone are computed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lsystem/derivation/program.hpp"

namespace panicle::lsystem {

class BoundProgram {
 public:
  std::shared_ptr<const Program> program;
  std::vector<float> registers;           // as Code::registers, with the values that depend on inputs
  std::vector<double> precise;            // likewise as Code::precise
  std::vector<std::vector<float>> lists;  // by the place of their names in Code::arrays
  std::vector<std::uint32_t> words;       // as Program::words, with the values that depend on inputs
  std::vector<Definition> definitions;
  std::optional<std::uint32_t> steps;                         // the derivation length
  std::array<std::optional<float>, settings_count> settings;  // by GlobalSetting
  std::array<std::uint32_t, 2> depths = {1, 1};               // of decomposition and homomorphism
};

}  // namespace panicle::lsystem
