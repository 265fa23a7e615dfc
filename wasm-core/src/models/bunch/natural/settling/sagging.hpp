// How branches bend under their berries, and how pedicels hang.
//
// A branch is a beam that is held at its base: the weight beyond its base turns it by moment × length / (E I), I going
// as the fourth power of its radius (Euler and Bernoulli). Moments are those of the text's own pose and of ripe
// berries, not of the berries' final places: that would feed back, and a pixel of the profile would move a bunch by
// millimetres. All hangs by the time berries are as large as peas (stage 31 of Coombe 1995), while there is still room:
// berries that swung down when full would swing past each other, on this side or that.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/bunch/natural/settling/swelling.hpp"

namespace panicle::bunch {

class Sagging {
 public:
  // Axes grow up against their load: ripe berries hang, on average, where the text draws them.
  Sagging(std::span<const Branch> branches, std::span<const Swelling> berries);

  // The rotation of each branch, and of the parts that grow on it, while berries are `size` times as wide as when ripe.
  std::span<const glm::quat> turned(float size);

 private:
  void load(std::span<const Swelling> berries);
  void brace(std::span<const Swelling> berries);

  std::span<const Branch> branches_;
  std::vector<float> bends_;       // radians, under ripe berries
  std::vector<glm::vec3> axes_;    // level, about which they bend
  std::vector<glm::quat> braced_;  // rotation by which an axis grows more upright
  std::vector<glm::quat> turned_;
  float turned_by_ = -1;  // share of the bends applied last: constant once berries are as large as peas
};

// The direction of a pedicel that grew along `heading` while its berry is `size` times as wide as when ripe; unit.
glm::vec3 drooping(const glm::vec3& heading, float size);

}  // namespace panicle::bunch
