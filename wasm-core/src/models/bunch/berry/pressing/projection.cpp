#include "models/bunch/berry/pressing/projection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {

// The view from a direction of any length: unit vectors right, up and towards the viewer.
View view_from(glm::vec3 towards) {
  View view;
  view.towards = towards / std::sqrt(glm::dot(towards, towards));
  constexpr float nearly_vertical = 0.999f;
  const bool steep = std::abs(view.towards.y) > nearly_vertical;
  const glm::vec3 guide = steep ? glm::vec3(0, 0, view.towards.y > 0 ? -1 : 1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::cross(guide, view.towards);
  view.right = right / std::sqrt(glm::dot(right, right));
  view.up = glm::cross(view.towards, view.right);
  return view;
}

// Projects a berry, an ellipsoid of revolution, onto the plane of a view: the ellipse of its outline and its depth.
ProjectedBerry project(const BerryBody& body, const View& view) {
  constexpr float least = 1e-8f;  // a berry of no size has an outline still
  const float half_width = std::max(body.half_width, least), half_length = std::max(body.half_length, least);
  const float square = half_width * half_width;
  const float excess = half_length * half_length - square;
  const float u = glm::dot(body.direction, view.right), v = glm::dot(body.direction, view.up),
              w = glm::dot(body.direction, view.towards);
  const float suu = square + excess * u * u, suv = excess * u * v, svv = square + excess * v * v;
  const float determinant = suu * svv - suv * suv;
  ProjectedBerry seen;
  seen.centre = {glm::dot(body.centre, view.right), glm::dot(body.centre, view.up)};
  seen.depth = glm::dot(body.centre, view.towards);
  seen.half = {std::sqrt(suu), std::sqrt(svv)};
  seen.uu = svv / determinant;
  seen.uv = -suv / determinant;
  seen.vv = suu / determinant;
  const float swu = excess * w * u, swv = excess * w * v, sww = square + excess * w * w;
  seen.slope = {swu * seen.uu + swv * seen.uv, swu * seen.uv + swv * seen.vv};
  seen.thickness = std::sqrt(std::max(0.0f, sww - seen.slope.x * swu - seen.slope.y * swv));
  // One half axis is the half width; the other follows from the area.
  seen.outer = std::max(half_width, std::sqrt(determinant) / half_width);
  return seen;
}

// The area of the projected ellipse.
float ProjectedBerry::area() const { return pi / std::sqrt(uu * vv - uv * uv); }

// Maps a point of the unit disc to the ellipse, relative to its centre: with the ellipse's matrix L Lᵀ (Cholesky
// decomposition), by L.
glm::vec2 ProjectedBerry::on_disc(glm::vec2 unit) const {
  const float determinant = uu * vv - uv * uv;
  const float below = -uv / (determinant * half.x);
  const float rest = std::sqrt(std::max(0.0f, half.y * half.y - below * below));
  return {half.x * unit.x, below * unit.x + rest * unit.y};
}

}  // namespace panicle::bunch
