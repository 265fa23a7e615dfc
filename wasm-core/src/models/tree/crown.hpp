// The crowns of a tree: their boundaries, their trunks, and the density of particles in them.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "light/voxel_light.hpp"
#include "models/particles/boundary.hpp"
#include "models/particles/hormone.hpp"
#include "models/particles/value_noise.hpp"
#include "spatial/solid.hpp"

namespace panicle::particles::tree {

struct CrownHabit {
  Form form = Form::ellipsoid;
  glm::vec3 size{6};    // metres
  float inner = 0.75f;  // size of the inner boundary over that of the outer; 0: none
  float trunk = 2;      // from the ground up to the crown
  std::uint32_t crowns = 1;
  float distance = 6;  // from crown to crown
  std::uint32_t stems = 1;
  float growth = 1;        // size of each, trunk and all, over the full-grown one
  float ragged = 0;        // how unevenly the outer boundary is filled, of its size
  std::uint64_t seed = 1;  // of the raggedness
  float shoots = 1;        // share of the space between the boundaries that has grown: shoots that ended early
};

struct Crowns {
  Solid outer, inner;
  std::vector<glm::vec3> feet;  // one a crown: its target
  float height = 0;             // of a crown
  float top = 0;                // its highest point
  float across = 0;             // size of a crown: cube root of its box
  float longest = 0;            // edge of the box of the grown part
  std::vector<glm::vec3> middles;
  float ragged = 0;
  ValueNoise lumps, tufts;  // noise of the ragged boundary

  // The middle of the crown that a place belongs to.
  glm::vec3 middle_of(const glm::vec3& p) const;
};

// Makes crowns side by side along x about the origin; `profile` and `mesh` as in `form_between`, `hollow` as in
// `inner_boundary`. `budget`: of both boundaries.
Crowns make_crowns(const CrownHabit& habit, std::span<const glm::vec2> profile, const Surface& mesh,
                   const Surface& hollow = {},
                   const std::shared_ptr<QueryBudget>& budget = std::make_shared<QueryBudget>());

// The region between the boundaries, with the density of light and the top's hormone.
class Foliage final : public Region {
 public:
  // All must outlive it; `light` may be null. `light_exponent`: the power of the light that density follows.
  Foliage(const Crowns& crowns, const VoxelLight* light, float light_exponent, const Hormone& hormone);

  glm::vec3 low() const override { return crowns_->outer.low(); }
  glm::vec3 high() const override { return crowns_->outer.high(); }
  bool contains(const glm::vec3& p) const override { return has_room(p) && leafy(p); }
  // Whether a point is between the outer and the inner boundary, before the ragged surface is cut out.
  bool has_room(const glm::vec3& p) const override { return crowns_->outer.contains(p) && !crowns_->inner.contains(p); }
  Share share_of(const glm::vec3& from, const glm::vec3& to) const override;
  bool is_exhausted() const override { return crowns_->outer.is_exhausted(); }
  float density(const glm::vec3& p) const override;

 private:
  bool leafy(const glm::vec3& p) const;

  const Crowns* crowns_;
  const VoxelLight* light_;
  const Hormone* hormone_;
  float light_exponent_;
  float brightest_ = 1;
};

}  // namespace panicle::particles::tree
