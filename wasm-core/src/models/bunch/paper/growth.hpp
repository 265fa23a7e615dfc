// The listener of the paper's procedure: it answers ?E from the space around the turtle, and draws the internodes that
// found room.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "models/bunch/paper/interaction.hpp"
#include "models/bunch/paper/skeleton_drawing.hpp"
#include "spatial/sphere_grid.hpp"

namespace panicle::bunch {

// Several interpretations may follow one another in the same environment (a double bunch); begin() starts each.
class PaperGrowth final : public SkeletonDrawing {
 public:
  // `largest` bounds the radius of all spheres.
  PaperGrowth(const InteractionOptions& options, const Limits& limits, float largest);

  // Begins an interpretation of a text with a seed, of the first bunch or the second; its first-order axes are numbered
  // from `first_axis`.
  void begin(const lsystem::BoundProgram& text, const SymbolRoles& roles, bool second, std::uint64_t seed,
             std::int32_t first_axis);

  // Between begin_rachis_pass and end_rachis_pass, an interpretation reserves room for its rachis and for nothing else;
  // the same text interpreted later finds that room again. Internodes grown in between have to avoid it.
  void begin_rachis_pass() { in_rachis_pass_ = true; }
  void end_rachis_pass();

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;

  // Whether any internode found no room.
  bool refused() const { return refused_; }

  std::uint32_t cuts = 0;   // internodes that found no room
  bool rachis_cut = false;  // whether one of them was of a rachis

 private:
  // The constants that the environment shares with the text.
  struct Constants {
    float narrowing = 1;        // `r_w`
    float withered_length = 0;  // `l_w`
    float berry_radius = 0;     // `b_r`, for modules that do not carry one
  };

  // Room reserved for a rachis internode, known by the interpretation's seed and the address of its module.
  struct ReservedRoom {
    std::uint64_t seed = 0;
    std::uint64_t address = 0;
    Room room;
    std::uint32_t tip = SphereGrid::no_sphere;
  };

  Answer answer(const Question& question, const lsystem::Turtle& turtle, std::span<float> parameters,
                const lsystem::Lineage& lineage) override;
  Newborn newborn(const Question& question, const lsystem::Turtle& turtle, std::span<const float> parameters,
                  std::uint64_t address) const;
  const ReservedRoom* find_reserved(std::uint64_t address) const;
  std::string describe_room(const Room& room, const Newborn& newborn) const;
  std::string describe_obstacle(const Sphere& probe, std::uint32_t except, bool turned) const;

  InteractionOptions options_;
  SphereGrid structure_;
  Constants constants_;
  std::uint64_t seed_ = 0;
  bool in_rachis_pass_ = false, refused_ = false;
  std::vector<ReservedRoom> reserved_;
  // The owner of each sphere of the structure: the module that added it, and whether it is a berry.
  struct Owner {
    std::uint32_t module = 0;
    bool berry = false, second = false;
  };
  std::vector<Owner> owners_;
  // that the last answer put at the end of its line, and the address of its module
  std::uint32_t tip_ = SphereGrid::no_sphere;
  std::uint64_t tip_of_ = 0;
  std::vector<std::uint32_t> tips_;  // per internode: the sphere at its tip, or none
};

}  // namespace panicle::bunch
