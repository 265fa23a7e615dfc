// The shape of a population: direction and length of each internode (Kim, Kim and Cho 2013, section 3.1 and figure 2;
// docs/models/growth/growth.md documents the choices that the paper leaves open). Metres, +Y up.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/growth/edits.hpp"
#include "models/growth/population.hpp"
#include "models/growth/surroundings.hpp"

namespace panicle::growth {

struct FormHabit {
  float shoot = 0.9f;  // length of a branch's first internode, metres, in a volume 10 m high
  float order_ratio = 0.78f, age_ratio = 0.93f;
  float bole = 0.16f;                         // share of the height without branches
  float leader = 0.97f;                       // share of the height that the trunk reaches
  float trunk_angle = 60, branch_angle = 45;  // between a branch and its parent, degrees
  float turn = 137.5f;                        // from one branch to the next, degrees
  float inertia = 1, space = 0.7f, crook = 0.08f;
  float hang = 0;                // gravitropism of branches of branches, besides the grammar's
  float reach = 0;               // weight of lengths that reach the volume's edge, for branches of the trunk, 0 … 1
  float whorl = 0;               // how near to an internode's end its branches are attached, 0 … 1
  std::uint32_t whorl_size = 0;  // branches of each whorl along an internode of the trunk; 0: none
  float shade_limit = 0;         // branches that get less than this share of all light are shed; 0: none
  float flat = 0;                // how level branches of branches leave, 0 … 1
  float cordon = 0;              // height where a trunk is bent level along a wire, metres; 0: not trained
  std::uint64_t seed = 1;
};

// The nodes of a shoot, the first of which is its base.
struct ShootPath {
  std::uint32_t first = 0;  // index of its first node in Form::nodes
  std::uint32_t count = 0;  // number of internodes; there is one more node
  std::uint32_t uncut = 0;  // the same without edits
  std::uint16_t from = 0;   // the step of its first internode
  // Index of the parent's internode that it is attached to, and the position along it, 0 … 1.
  std::uint32_t internode = 0;
  float along = 0;
};

// The effects of edits on a shoot.
struct EditedShoot {
  // The shoot that a removed one would grow on, and the node there that carries it; −1: not removed.
  std::int32_t carrier = -1;
  std::uint32_t carrier_node = 0;
  float last = 1;  // share of the last internode that remains
  bool cut = false, snapped = false, dead = false, drawn = false;
};

// The form after all steps. An earlier age is a part of it, since internodes never move.
struct Form {
  static constexpr std::uint16_t never = 0xffff;

  std::vector<ShootPath> paths;  // one a shoot
  std::vector<glm::vec3> nodes;
  std::vector<std::uint16_t> shed;  // the step at which each shoot is shed, with its branches; empty: none is
  std::vector<EditedShoot> edited;  // one a shoot; empty without edits
};

// A removed shoot has no internodes, and a cut one fewer; the others grow around them.
Form form_of(const Population& population, const FormHabit& habit, const Surroundings& about = {},
             const ShootEdits& edits = {});

// Whether edits leave a leaf its place: its shoot is alive there.
bool has_place(const Form& form, const Leaf& leaf);

}  // namespace panicle::growth
