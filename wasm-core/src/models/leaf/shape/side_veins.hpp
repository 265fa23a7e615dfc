// Side veins of a leaf's main veins, as ribs.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/leaf/midrib.hpp"
#include "models/leaf/rib_plan.hpp"
#include "models/leaf/shape/margin.hpp"
#include "models/particles/outline.hpp"
#include "models/particles/ribs.hpp"

namespace panicle::particles::leaf {

// The part of the blade of one main vein.
struct Part {
  // all main veins of the leaf: each owns the part of the blade that is nearest to it
  std::span<const Ribs> mains = {};
  std::size_t own = 0;                       // index of the own one
  std::size_t first = 0, tip = 0, last = 0;  // of the margin's points: its right side is before its tip, its left after
  bool fan = false;                          // whether it includes the part below the base

  bool holds(const glm::vec3& p) const;
};

class SideVeins {
 public:
  // Margin and outline belong to the same leaf. All must outlive it.
  SideVeins(const RibPlan& plan, const Margin& margin, const Outline& outline);

  // Adds `count` veins on each side of a main vein, spread and angled by the plan, ending by its course; where that is
  // not open, before the margin.
  void add_veins(Ribs& ribs, const Midrib& midrib, std::uint32_t count, const Part& part) const;

  // Adds a vein to a lobe's tip, from a place of the main vein that sees it at about the planned angle and well clear
  // of the bays beside it. Returns false if no place sees it.
  bool to_lobe(Ribs& ribs, const Midrib& midrib, const glm::vec3& tip) const;

 private:
  struct Start {
    std::size_t root;    // place of the main vein
    float angle, least;  // degrees from it; least length of the vein
  };
  struct Vein {
    std::size_t root;
    std::vector<glm::vec3> places;
    bool at_margin = false;  // whether it ended at the margin
  };
  std::vector<Start> starts(const Midrib& midrib, std::uint32_t count, float side, bool fan) const;
  float angle_after(const Midrib& midrib, const Start& start, float walked) const;
  Vein walk(const Midrib& midrib, const Start& start, float side, const Part& part) const;
  Vein arched(const Midrib& midrib, const Start& start, float side, const Part& part, const Vein* above,
              float clearance) const;
  std::vector<glm::vec3> teeth(float side, const Part& part) const;
  void into_teeth(const Midrib& midrib, std::span<Vein> veins, std::span<const glm::vec3> teeth) const;
  std::vector<glm::vec3> curve_to(const Midrib& midrib, std::size_t root, const glm::vec3& end, float bend) const;
  bool is_clear(const glm::vec3& start, std::span<const glm::vec3> places, float clearance, float near_end) const;

  const RibPlan& plan_;
  const Margin& margin_;
  const Outline& outline_;
};

}  // namespace panicle::particles::leaf
