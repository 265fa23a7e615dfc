// Orthographic views of berries: an ellipsoid of revolution seen from anywhere is an ellipse, in closed form.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "models/bunch/berry/berry_body.hpp"

namespace panicle::bunch {

// An orthographic view: `right` and `up` span the picture, `towards` points at the viewer. Orthonormal, right-handed.
struct View {
  glm::vec3 right{1, 0, 0};
  glm::vec3 up{0, 1, 0};
  glm::vec3 towards{0, 0, 1};
};

// The view of an observer in the direction `towards` (any length but 0), +Y up in the picture unless it is the
// direction of view.
View view_from(glm::vec3 towards);

// The berry { c + x : xᵀ S⁻¹ x ≤ 1 } in a view, where S = w² I + (l² − w²) d dᵀ. Its outline is the ellipse of the same
// form under the picture's 2 × 2 block of S; the point of its surface that is seen there is conjugate to the view.
struct ProjectedBerry {
  glm::vec2 centre{0};           // in the picture
  float depth = 0;               // of the berry's centre, growing towards the viewer
  glm::vec2 half{0};             // half the outline's bounding box
  float uu = 0, uv = 0, vv = 0;  // the inverse of that block
  glm::vec2 slope{0};            // depth of the plane through the outline, per length in the picture
  float thickness = 0;           // from that plane to the surface seen, at the centre
  float outer = 0;               // longest half axis of the outline

  // Below 1 inside the outline, 1 on it; `away` is measured from the centre.
  float level(glm::vec2 away) const { return uu * away.x * away.x + 2 * uv * away.x * away.y + vv * away.y * away.y; }
  float area() const;
  // The point at `unit`, in the unit disc, of an affine picture of that disc onto the outline.
  glm::vec2 on_disc(glm::vec2 unit) const;
};

ProjectedBerry project(const BerryBody& body, const View& view);

}  // namespace panicle::bunch
