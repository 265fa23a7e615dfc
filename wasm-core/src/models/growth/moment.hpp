// A form as it stands at an age: segments, each of a shoot, as thick as what they bear asks for.
#pragma once

#include <cstdint>
#include <vector>

#include "models/growth/form.hpp"
#include "stems/segment.hpp"

namespace panicle::growth {

struct WoodHabit {
  float twig = 0.012f;  // metres, the thickness of a twig in a volume 10 m high
  float pipe = 2.3f;    // thickness to this power is the sum of those of all that is borne
};

struct Moment {
  std::vector<Segment> segments;      // parents first; tag 0 of trunks, 1 of branches
  std::vector<std::int32_t> axes;     // of each the shoot that it is of
  std::vector<std::int32_t> of_node;  // of each node of the form the segment that ends there; −1 before it is laid
  std::vector<glm::vec3> feet;        // where trunks stand
  std::uint32_t branches = 0;         // that there are by then, without trunks
};

// At `time` in steps: an internode is laid in the step before its own ends, growing all the while, and stays as it is.
// Errors: limit, where there are more segments than there may be.
Result<Moment> moment_of(const Population& population, const Form& form, float time, const WoodHabit& habit,
                         const Limits& limits);

// How much of what a step brings is there: 0 before it, 1 after.
float grown_share(std::uint16_t step, float time);

}  // namespace panicle::growth
