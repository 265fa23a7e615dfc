#include "kernels.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>
#include <vector>

#include "foundation/random.hpp"
#include "growth.hpp"
#include "lsystem/lsystem.hpp"
#include "maps.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/grammars.hpp"
#include "models/bunch/paper/interaction.hpp"
#include "models/bunch/parameters.generated.hpp"
#include "models/bunch/stems.hpp"
#include "particles.hpp"

namespace panicle::bench {
namespace {

// The grammar of Table 2 of the speed page.
constexpr std::string_view forks =
    "axiom: A(1)\n"
    "A(s) --> F(s)[+A(s/1.456)][-A(s/1.456)]\n";
// The stochastic plant of The Algorithmic Beauty of Plants, figure 1.27.
constexpr std::string_view by_chance =
    "axiom: F\n"
    "F --> F[+F]F[-F]F : 0.33\n"
    "F --> F[+F]F : 0.33\n"
    "F --> F[-F]F : 0.34\n";
// Figure 1.31 b there, after Hogeweg and Hesper: every module but turns has productions with both contexts.
constexpr std::string_view in_context =
    "ignore: + - F\n"
    "axiom: F I F I F I\n"
    "O < O > O --> I\n"
    "O < O > I --> I [- F I F I]\n"
    "O < I > O --> I\n"
    "O < I > I --> I\n"
    "I < O > O --> O\n"
    "I < O > I --> I F I\n"
    "I < I > O --> I\n"
    "I < I > I --> O\n"
    "+ --> -\n"
    "- --> +\n";

double derive(std::string_view text, std::uint32_t steps) {
  const auto program = lsystem::compile(text, {});
  if (!program) return -1;
  const auto bound = lsystem::bind(program.value(), {}, {});
  if (!bound) return -1;
  const auto derived = lsystem::develop(*bound.value(), 1, steps, {});
  return derived ? static_cast<double>(derived->modules_written) : -1;
}

// The paper's procedure, for the same bunch repeated along a longer rachis. Lengths and widths do not shrink, else the
// tip's would vanish.
bunch::BunchRequest longer_bunch(std::uint32_t factor) {
  constexpr std::int32_t axes[] = {8, 4, 6, 6, 3, 2, 3, 3, 1, 1, 1, 1};  // shouldered conical
  bunch::BunchRequest request;
  request.meshes = request.measures = false;
  request.parameters.assign(bunch::parameter_count, std::numeric_limits<float>::quiet_NaN());
  request.parameters[static_cast<std::size_t>(bunch::Parameter::procedure)] = 0;
  for (const auto rate : {bunch::Parameter::rw, bunch::Parameter::rrr, bunch::Parameter::rff})
    request.parameters[static_cast<std::size_t>(rate)] = 1;
  for (std::uint32_t i = 0; i < factor; ++i) request.n.insert(request.n.end(), std::begin(axes), std::end(axes));
  request.m = static_cast<std::int32_t>(request.n.size()) + 1;
  return request;
}

// The text is compiled once, as a page caches it.
double plan(std::uint32_t factor) {
  static const auto program = lsystem::compile(bunch::grammars::grape_bunch_3, {}, lsystem::Lineages::always);
  if (!program) return -1;
  bunch::BunchRequest request = longer_bunch(factor);
  request.program = program.value();
  const auto grown = bunch::grow(request);
  return grown ? grown->counts.pedicels : -1;
}

// Nodes down a cylinder with room for about two berries in three, as in a bunch.
double probe(std::uint32_t berries) {
  SphereGrid structure(30);
  const float length = static_cast<float>(berries) * 9;
  for (std::uint32_t i = 0; i < berries; ++i) {
    lsystem::Turtle turtle;
    const float depth = random_unit(1, 1, i) * length;
    turtle.heading = random_direction(1, 2, i);
    const glm::vec3 helper = std::fabs(turtle.heading.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    turtle.left = glm::normalize(glm::cross(helper, turtle.heading));
    turtle.up = glm::cross(turtle.heading, turtle.left);
    turtle.position = {random_unit(1, 3, i) * 100 - 50, -depth, random_unit(1, 4, i) * 100 - 50};
    bunch::Newborn newborn;
    newborn.pedicel = true;
    newborn.length = 40;
    newborn.radius = 20 + random_unit(1, 5, i) * 10;
    newborn.tie = random_direction(1, 6, i);
    const bunch::Room room = bunch::find_room(structure, turtle, newborn, {});
    if (room.found) structure.add(room.sphere);
  }
  return berries;
}

double tubes(const std::vector<bunch::Internode>& skeleton) {
  return static_cast<double>(bunch::sweep_internodes(skeleton, {12}, 0.00025f).segment.size());
}

std::vector<bunch::Internode> skeleton_of(std::uint32_t internodes) {
  const auto grown = bunch::grow(longer_bunch(internodes / 199 + 1));
  if (!grown) return {};
  std::vector<bunch::Internode> skeleton = grown->internodes;
  for (bunch::Internode& internode : skeleton) {
    internode.start *= 4000.0f;
    internode.end *= 4000.0f;
    internode.radius *= 4000.0f;
    internode.radius_end *= 4000.0f;
  }
  return skeleton;
}

}  // namespace

double run(Kernel kernel, std::uint32_t size, std::uint32_t rounds) {
  static std::vector<bunch::Internode> skeleton;  // grown before the clock starts: a call with no rounds prepares it
  if (kernel == Kernel::tubes && skeleton.empty()) skeleton = skeleton_of(size);
  double work = 0;
  for (std::uint32_t round = 0; round < rounds && work >= 0; ++round) {
    switch (kernel) {
      case Kernel::derive:
        work = derive(forks, size);
        break;
      case Kernel::derive_chance:
        work = derive(by_chance, size);
        break;
      case Kernel::derive_context:
        work = derive(in_context, size);
        break;
      case Kernel::plan:
        work = plan(size);
        break;
      case Kernel::probe:
        work = probe(size);
        break;
      case Kernel::tubes:
        work = tubes(skeleton);
        break;
      case Kernel::crowd_flat:
      case Kernel::crowd_space:
        work = run_crowd(size, kernel == Kernel::crowd_flat);
        break;
      case Kernel::brute_flat:
      case Kernel::brute_space:
        work = run_brute_crowd(size, kernel == Kernel::brute_flat);
        break;
      case Kernel::colonise_flat:
      case Kernel::colonise_space:
        work = colonise(size, kernel == Kernel::colonise_flat);
        break;
      case Kernel::map_build:
        work = build_map(size);
        break;
      case Kernel::map_check:
        work = check_map(size);
        break;
      case Kernel::map_embed:
        work = embed_map(size);
        break;
      case Kernel::map_place:
        work = place_map(size);
        break;
      case Kernel::growth_text:
      case Kernel::growth_population:
      case Kernel::growth_form:
      case Kernel::growth_moment:
      case Kernel::growth_leaves:
      case Kernel::growth_levels:
        work = run_growth(static_cast<Stage>(static_cast<std::uint32_t>(kernel) - 16), size, round + 1);
        break;
    }
  }
  return work;
}

}  // namespace panicle::bench
