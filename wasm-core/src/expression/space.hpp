// Queries of the space around a plant, for bound() and reach() of a text (Seo et al. 2014: clipping volumes).
#pragma once

#include <glm/vec3.hpp>

namespace panicle::expression {

// The space around a growing plant, implemented by models, in the grammar's unit. The same query must have the same
// response for as long as a plant grows.
class Space {
 public:
  virtual ~Space() = default;
  // bound(x, y, z, area): whether a place is inside area number `area`, counted from 1; outside of one that is not
  // there.
  virtual bool bound(const glm::vec3& place, float area) const = 0;
  // reach(x, y, z, hx, hy, hz, area, most): how far along `way`, however long that is, one stays inside the area, at
  // most `most`; 0 from outside, and without a way.
  virtual float reach(const glm::vec3& from, const glm::vec3& way, float area, float most) const = 0;
};

}  // namespace panicle::expression
