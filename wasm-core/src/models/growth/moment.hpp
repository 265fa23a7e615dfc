// The segments of a form at an age, with thickness by the pipe model.
#pragma once

#include <cstdint>
#include <vector>

#include "models/growth/form.hpp"
#include "models/growth/shoot_curves.hpp"
#include "stems/segment.hpp"

namespace panicle::growth {

struct WoodHabit {
  float twig = 0.012f;  // thickness of a twig in a volume 10 m high, metres
  float pipe = 2.3f;    // exponent: thickness to this power is the sum over all children
};

struct Moment {
  std::vector<Segment> segments;   // parents first; tag 0 of trunks, 1 of branches
  std::vector<std::int32_t> axes;  // the shoot of each segment
  // of each node of the form, the segment that ends there; −1 for a node of the future
  std::vector<std::int32_t> of_node;
  std::vector<std::int32_t> first_of_shoot;  // the first segment of each shoot; −1 for one of the future
  std::vector<glm::vec3> feet;               // bases of trunks
  std::uint32_t branches = 0;                // number of branches by then, without trunks
};

// The moment at `time` in steps: an internode grows during the step before its own ends, and stays unchanged after it.
// Errors: limit, where there are too many segments.
Result<Moment> moment_of(const Population& population, const Form& form, float time, const WoodHabit& habit,
                         const Limits& limits, const CurveHabit& curves = {});

// The segments of a node's internode, which are consecutive: the first, and the one after the last. Both are 0 for a
// node of the future.
struct SegmentRange {
  std::size_t first = 0, end = 0;
};
SegmentRange segments_of(const Moment& moment, const ShootPath& path, std::uint32_t shoot, std::uint32_t node);

// How much of a step's growth exists: 0 before it, 1 after.
float grown_share(std::uint16_t step, float time);

}  // namespace panicle::growth
