// The listener that turns an interpreted grammar into a bunch in flower: the skeleton as the text has it, a flower at
// every pedicel, nobody in anybody's way yet.
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

struct Flower {
  std::int32_t pedicel = -1;  // its internode
  std::uint32_t id = 0;
  std::uint32_t bunch = 0;      // 0 the first, 1 the second
  std::uint64_t address = 0;    // of the module that bears it
  glm::vec3 heading{0, -1, 0};  // unit
  std::int32_t axis = -1;       // first-order axis it is of, as of its internode
  std::int32_t depth = 0;       // internodes from the root to it
  std::int32_t place = 0;       // among the flowers of its end structure
  float strength = 1;           // 0 … 1: how far what bears it has grown; the radius that the text gives to S
};

class Sprouting final : public lsystem::Listener {
 public:
  explicit Sprouting(const Limits& limits) : limits_(limits) {}

  // The next interpretation's grammar; its first-order axes count on from `first_axis`.
  void begin(const lsystem::Bound& bound, std::uint32_t bunch, std::int32_t first_axis);

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;
  void ask(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage& lineage) override;
  void cut(const lsystem::Turtle&) override {}

  const Diagnostic& trouble() const { return trouble_; }

  std::vector<Internode> internodes;  // in the grammar's unit
  std::vector<Flower> flowers;

 private:
  bool within(std::size_t count, std::uint32_t limit, const char* what);

  Limits limits_;
  Diagnostic trouble_;
  float width_ = 1;  // for modules that do not carry one
  float asked_width_ = 0;
  bool pedicel_ = false;
  std::uint32_t bunch_ = 0;
  std::int32_t first_internode_ = 0, first_axis_ = 0;
  std::vector<std::int32_t> rachis_depth_, depth_, borne_;
};

}  // namespace panicle::bunch
