// The listener that turns an interpreted grammar into a bunch: it answers ?E from the space around the turtle and
// keeps what the turtle draws.
#pragma once

#include <cstdint>
#include <vector>

#include "environment/sphere_grid.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/paper/interaction.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

// Several interpretations may follow one another in the same environment (a double bunch); begin() starts each.
class Growth final : public lsystem::Listener {
 public:
  // `largest` bounds the radius of all spheres.
  Growth(const InteractionOptions& options, const Limits& limits, float largest);

  // The next interpretation's grammar and seed; its first-order axes count on from `first_axis`.
  void begin(const lsystem::Bound& bound, std::uint64_t seed, std::int32_t first_axis);

  // Between the two, an interpretation lays its rachis and nothing else: it takes its room, and the same text
  // interpreted later finds it again. What grows in between has to make way.
  void begin_laying();
  void end_laying();

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;
  void ask(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage& lineage) override;
  void cut(const lsystem::Turtle& turtle) override;

  // What went wrong on the way; reason none if nothing did.
  const Diagnostic& trouble() const { return trouble_; }

  std::vector<Internode> internodes;  // in the grammar's unit
  std::vector<Berry> berries;
  std::uint32_t cuts = 0;   // internodes that found no room
  bool rachis_cut = false;  // whether one of them was of a rachis

 private:
  // The constants that the environment shares with the text.
  struct Constants {
    float width = 0;            // `w`, for modules that do not carry one
    float narrowing = 1;        // `r_w`
    float withered_length = 0;  // `l_w`
    float berry_radius = 0;     // `b_r`, for modules that do not carry one
  };

  // What ask() settled for the line that its answer is about to draw.
  struct Answered {
    bool pending = false;
    bool pedicel = false;
    bool withered = false;
    float width = 0;
    std::uint32_t tip = SphereGrid::no_sphere;
  };

  // A rachis internode laid before its time: the interpretation's seed and the address of its module tell which.
  struct Laid {
    std::uint64_t seed = 0;
    std::uint64_t address = 0;
    Room room;
    std::uint32_t tip = SphereGrid::no_sphere;
  };

  const Laid* find_laid(std::uint64_t address) const;
  bool within(std::size_t count, std::uint32_t limit, const char* what);

  InteractionOptions options_;
  Limits limits_;
  SphereGrid structure_;
  Constants constants_;
  Answered answered_;
  Diagnostic trouble_;
  std::uint64_t seed_ = 0;
  std::int32_t first_internode_ = 0;  // of this interpretation
  std::int32_t first_axis_ = 0;
  bool laying_ = false;
  std::size_t berries_before_ = 0;  // laying
  std::vector<Laid> laid_;
  std::vector<std::uint32_t> tips_;         // per internode: the sphere at its tip, or none
  std::vector<std::int32_t> rachis_depth_;  // per internode: how many rachis internodes lie above it
};

}  // namespace panicle::bunch
