// Where something may grow: an area in the plane z = 0 or a volume, as dense as it says.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle {

// How much of a box lies inside.
enum class Share : std::uint8_t { none, some, all };

class Region {
 public:
  virtual ~Region() = default;
  // A box that holds it; z = 0 in both for an area.
  virtual glm::vec3 low() const = 0;
  virtual glm::vec3 high() const = 0;
  virtual bool contains(const glm::vec3& p) const = 0;
  // Whether what started inside may come to be there: where nothing starts that is within the boundaries, too. Holds
  // all of what is inside, and is no dearer to tell.
  virtual bool has_room(const glm::vec3& p) const { return contains(p); }
  // What is certain of a box, cheaply; `some` where nothing is.
  virtual Share share_of(const glm::vec3&, const glm::vec3&) const { return Share::some; }
  // How dense starts are at a place that has room, in (0, 1]: by light, for instance.
  virtual float density(const glm::vec3&) const { return 1; }

  // Of what is in one region and not in the other.
  static Share share_between(Share outer, Share inner) {
    if (outer == Share::none || inner == Share::all) return Share::none;
    return outer == Share::all && inner == Share::none ? Share::all : Share::some;
  }

  // Whether queries have used up their budget: then no place is inside any more, and the model returns an error.
  virtual bool is_exhausted() const { return false; }

  bool flat() const { return low().z == high().z; }
};

}  // namespace panicle
