// A region for growth: an area in the plane z = 0 or a volume, with a density.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle {

// The share of a box that lies inside.
enum class Share : std::uint8_t { none, some, all };

class Region {
 public:
  virtual ~Region() = default;
  // A box that holds it; z = 0 in both for an area.
  virtual glm::vec3 low() const = 0;
  virtual glm::vec3 high() const = 0;
  virtual bool contains(const glm::vec3& p) const = 0;
  // Whether growth that started inside may reach a place: the boundaries also hold places where nothing starts.
  // Contains the whole inside, and costs no more than `contains`.
  virtual bool has_room(const glm::vec3& p) const { return contains(p); }
  // A cheap bound for a box; `some` where nothing is certain.
  virtual Share share_of(const glm::vec3&, const glm::vec3&) const { return Share::some; }
  // The density of starts at a place that has room, in (0, 1]: by light, for instance.
  virtual float density(const glm::vec3&) const { return 1; }

  // The share of the difference of two regions: in `outer` and not in `inner`.
  static Share share_between(Share outer, Share inner) {
    if (outer == Share::none || inner == Share::all) return Share::none;
    return outer == Share::all && inner == Share::none ? Share::all : Share::some;
  }

  // Whether queries have used up their budget: then no place is inside any more, and the model returns an error.
  virtual bool is_exhausted() const { return false; }

  // Whether the region is an area in the plane of x and y.
  bool flat() const { return low().z == high().z; }
};

}  // namespace panicle
