// Grammar → a bunch in flower: the skeleton as the text draws it, before berries collide.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/natural_plan.hpp"
#include "models/bunch/natural/settling/swelling.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

struct Sprout {
  Profile profile;                    // of this seed
  std::vector<NaturalPlan> plans;     // of the bunch, and of the second where there is one
  std::vector<BunchEnvelope> bounds;  // their outlines, millimetres
  std::vector<Internode> internodes;  // parents first; millimetres
  std::vector<Flower> flowers;
  std::int32_t second_root = -1;  // the first internode of the second bunch
  std::optional<lsystem::DerivationTrace> trace;
};

// Plans each bunch with the constants of the text, so that both place the same nodes; where the plan depends on the
// number of flowers, also with the number on an end structure that the text draws. Adds notes about the text to
// `notes`.
Result<Sprout> sprout(const BunchRequest& request, const Values& values, const Limits& limits,
                      std::vector<std::string>& notes);

}  // namespace panicle::bunch
