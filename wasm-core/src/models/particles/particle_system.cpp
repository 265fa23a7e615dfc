#include "models/particles/particle_system.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace panicle::particles {

// The energy of a place is the sum over all particles that pass it; a trail is the way that a particle has gone, from
// its start to the target.

namespace {

constexpr std::uint32_t at_target = ~0u;
constexpr float budget_in_ways = 4;          // of the longest way
constexpr std::uint32_t sampled_ways = 100;  // taken from as many starts, evenly
constexpr float least_stride = 1e-6f;        // of a step: shorter strides count as waiting
constexpr std::uint32_t cells_a_particle = 24;

// The unit vector from one point to another; 0 where they coincide.
glm::vec3 direction_to(const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 way = to - from;
  const float length = glm::length(way);
  return length > 0 ? way / length : glm::vec3(0);
}

}  // namespace

// Places a particle with `energy` at each start. Arrays by slot (place, energy …) hold the particles that still move;
// nodes are the points of all trails, node 0 is the target, the starts follow.
ParticleSystem::ParticleSystem(std::span<const glm::vec3> starts, double energy, const Guide& guide, const Rules& rules)
    : guide_(&guide),
      rules_(rules),
      energy_(energy),
      started_(static_cast<std::uint32_t>(starts.size())),
      places_(starts.begin(), starts.end()),
      energies_(starts.size(), energy),
      particles_(starts.size()),
      nodes_at_(starts.size()),
      gone_(starts.size(), 0),
      merged_into_(starts.size()),
      slots_(starts.size()) {
  rules_.merge = std::max(rules.merge, least_merge(rules));
  std::iota(particles_.begin(), particles_.end(), 0u);
  std::iota(nodes_at_.begin(), nodes_at_.end(), 1);
  merged_into_ = slots_ = particles_;
  nodes_.push_back({guide.target()});
  float longest = 0;
  glm::vec3 low = guide.target(), high = low;
  for (std::uint32_t i = 0; i < started_; ++i) {
    nodes_.push_back({starts[i], -1, i});
    if (i % (1 + started_ / sampled_ways) == 0) longest = std::max(longest, guide.way(starts[i]));
    low = glm::min(low, starts[i]);
    high = glm::max(high, starts[i]);
  }
  const float strides = rules.step > 0 ? budget_in_ways * longest / rules.step : 0;
  step_budget_ = 1 + static_cast<std::uint32_t>(std::min(strides, 1e9f));
  if (rules_.join > 0) {
    grid_ = TrailGrid(low, high, rules_.join, cells_a_particle * started_ + 64);
    for (const Node& node : nodes_) grid_.add(node.place);
  }
}

// Moves all particles by one step, then merges those that met. Beyond twice the step budget all are led straight to the
// target. Returns false once none is left.
bool ParticleSystem::step() {
  if (places_.empty()) return false;
  ++steps_;
  moves_ += places_.size();
  if (steps_ > 2 * step_budget_) {
    for (std::uint32_t slot = 0; slot < places_.size(); ++slot) walk_to_target(slot);
    stragglers_ = static_cast<std::uint32_t>(places_.size());
    remove_gone();
    return true;
  }
  choose_strides();
  move();
  remove_gone();
  merge_pairs();
  remove_gone();
  if (rules_.join > 0) {
    join();
    remove_gone();
  }
  return true;
}

// Chooses each particle's stride: a step towards its aim, turned towards its nearest neighbour where that way is free.
void ParticleSystem::choose_strides() {
  const auto count = static_cast<std::uint32_t>(places_.size());
  const bool alone = steps_ > step_budget_ || count < 2;
  if (!alone) neighbours_.build(places_);
  const float reach = rules_.neighbourhood > 0 ? rules_.neighbourhood : std::numeric_limits<float>::max();
  strides_.resize(count);
  for (std::uint32_t slot = 0; slot < count; ++slot) {
    const glm::vec3& place = places_[slot];
    const glm::vec3 aim = aims_.empty() ? guide_->aim(place) : aims_[slot], ahead = direction_to(place, aim);
    const std::uint32_t other = alone ? Neighbours::none : neighbours_.nearest(slot, reach, *guide_);
    glm::vec3& stride = strides_[slot];
    stride = rules_.step * ahead;
    if (other != Neighbours::none) {
      const glm::vec3 to_neighbour = direction_to(place, places_[other]);
      const glm::vec3 sum = rules_.printed ? direction_to(glm::vec3(0), to_neighbour + ahead)
                                           : (rules_.pull * to_neighbour + ahead) / (1 + rules_.pull);
      if (guide_->passes(place, place + rules_.step * sum)) {
        stride = rules_.step * sum;
        continue;
      }
    }
    // The aim is in sight; a point a step beyond it need not be.
    if (glm::distance(place, aim) < rules_.step && !guide_->passes(place, place + stride)) stride = aim - place;
  }
  aims_.clear();
}

// Moves all particles by their strides; those within a step of the target arrive.
void ParticleSystem::move() {
  for (std::uint32_t slot = 0; slot < places_.size(); ++slot) {
    const glm::vec3& place = places_[slot];
    if (glm::distance(place, guide_->target()) <= rules_.step && guide_->sees(place, guide_->target()))
      arrive(slot);
    else if (glm::length(strides_[slot]) > least_stride * rules_.step)
      move_to(slot, place + strides_[slot]);
  }
}

// Merges pairs of particles that are near and see each other, the nearest pairs first; each particle at most once a
// step.
void ParticleSystem::merge_pairs() {
  if (places_.size() < 2) return;
  neighbours_.build(places_);
  pairs_.clear();
  neighbours_.pairs(rules_.merge, pairs_);
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& one, const Pair& other) {
    if (one.square != other.square) return one.square < other.square;
    return one.a != other.a ? one.a < other.a : one.b < other.b;
  });
  met_.assign(places_.size(), 0);
  for (const Pair& pair : pairs_) {
    if (met_[pair.a] || met_[pair.b] || !guide_->sees(places_[pair.a], places_[pair.b])) continue;
    const bool second = energies_[pair.b] > energies_[pair.a];
    const std::uint32_t heavy = second ? pair.b : pair.a, light = second ? pair.a : pair.b;
    const auto share = static_cast<float>(energies_[light] / (energies_[light] + energies_[heavy]));
    const glm::vec3 mean = places_[heavy] + share * (places_[light] - places_[heavy]);
    if (guide_->passes(places_[heavy], mean)) move_to(heavy, mean);
    link(light, nodes_at_[heavy]);
    energies_[heavy] += energies_[light];
    merged_into_[particles_[light]] = particles_[heavy];
    met_[heavy] = met_[light] = 1;
    gone_[light] = 1;
    ++merges_;
  }
}

// Ends particles that are near an older trail ahead in that trail. The others aim from where they are now in the next
// step: their aims are stored until then.
void ParticleSystem::join() {
  aims_.resize(places_.size());
  for (std::uint32_t slot = 0; slot < places_.size(); ++slot) {
    if (gone_[slot]) continue;
    aims_[slot] = guide_->aim(places_[slot]);
    const glm::vec3 place = places_[slot], ahead = aims_[slot] - place;
    const std::uint32_t self = particles_[slot];
    float best = rules_.join * rules_.join;
    std::int32_t found = -1;
    grid_.visit(place, [&](std::int32_t at) {
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      if (at == 0 || node.next < 0) return;
      const glm::vec3 way = node.place - place;
      const float square = glm::dot(way, way);
      if (square > best || (square == best && found >= 0 && found < at)) return;
      if (!(glm::dot(way, ahead) > 0) || union_root(node.particle) == self || !guide_->sees(place, node.place)) return;
      best = square;
      found = at;
    });
    if (found < 0) continue;
    const std::uint32_t other = union_root(nodes_[static_cast<std::size_t>(found)].particle);
    link(slot, found);
    if (slots_[other] == at_target)
      arrived_ += energies_[slot];
    else
      energies_[slots_[other]] += energies_[slot];
    merged_into_[self] = other;
    gone_[slot] = 1;
    ++joins_;
  }
  // Nodes of this step become candidates only now, for they are not older.
  for (std::size_t at = grid_.size(); at < nodes_.size(); ++at) grid_.add(nodes_[at].place);
}

// Makes the node `to` the next one of the particle's last node, which is left in this step.
void ParticleSystem::link(std::uint32_t slot, std::int32_t to) {
  Node& node = nodes_[static_cast<std::size_t>(nodes_at_[slot])];
  node.next = to;
  node.born = steps_;
}

// Moves a particle to a place and adds a node to its trail.
void ParticleSystem::move_to(std::uint32_t slot, const glm::vec3& to) {
  if (to == places_[slot]) return;
  link(slot, static_cast<std::int32_t>(nodes_.size()));
  nodes_at_[slot] = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({to, -1, particles_[slot]});
  places_[slot] = to;
}

// Leads a particle from aim to aim to the target in one step, as long as each aim is nearer to it.
void ParticleSystem::walk_to_target(std::uint32_t slot) {
  for (float left = guide_->way(places_[slot]);;) {
    const glm::vec3 aim = guide_->aim(places_[slot]);
    const float then = guide_->way(aim);
    if (!(then < left)) break;
    left = then;
    move_to(slot, aim);
  }
  arrive(slot);
}

// Ends a particle at the target and adds its energy there.
void ParticleSystem::arrive(std::uint32_t slot) {
  link(slot, 0);
  arrived_ += energies_[slot];
  slots_[particles_[slot]] = at_target;
  gone_[slot] = 1;
}

// The particle that `particle` has merged into, directly or through others: the root in a union-find forest, with path
// halving.
std::uint32_t ParticleSystem::union_root(std::uint32_t particle) {
  while (merged_into_[particle] != particle) {
    merged_into_[particle] = merged_into_[merged_into_[particle]];
    particle = merged_into_[particle];
  }
  return particle;
}

// Removes arrived and merged particles from the slots.
void ParticleSystem::remove_gone() {
  std::uint32_t remaining = 0;
  for (std::uint32_t slot = 0; slot < places_.size(); ++slot) {
    if (gone_[slot]) continue;
    places_[remaining] = places_[slot];
    energies_[remaining] = energies_[slot];
    particles_[remaining] = particles_[slot];
    nodes_at_[remaining] = nodes_at_[slot];
    if (!aims_.empty()) aims_[remaining] = aims_[slot];
    slots_[particles_[remaining]] = remaining;
    ++remaining;
  }
  places_.resize(remaining);
  energies_.resize(remaining);
  particles_.resize(remaining);
  nodes_at_.resize(remaining);
  if (!aims_.empty()) aims_.resize(remaining);
  gone_.assign(remaining, 0);
}

// The trails of all particles as a tree in tree order, with the energy that flows through each place.
Trails ParticleSystem::trails() const {
  const std::size_t count = nodes_.size();
  std::vector<std::int32_t> leads, number(count), next{-1};
  leads.reserve(count);
  for (const Node& node : nodes_) leads.push_back(node.next);
  const std::vector<std::uint32_t> order = tree_order(leads);
  next.reserve(count);
  for (std::size_t at = 0; at < count; ++at) {
    number[order[at]] = static_cast<std::int32_t>(at);
    if (at > 0) next.push_back(number[static_cast<std::size_t>(leads[order[at]])]);
  }

  Trails trails;
  trails.next = std::move(next);
  trails.energy.assign(count, 0);
  for (const std::uint32_t node : order) {
    trails.places.push_back(nodes_[node].place);
    trails.born.push_back(node == 0 ? steps_ : nodes_[node].born);
    const bool start = node > 0 && node <= started_;
    trails.particle.push_back(start ? static_cast<std::int32_t>(node) - 1 : -1);
  }
  for (std::size_t at = count; at-- > 0;) {
    if (trails.particle[at] >= 0) trails.energy[at] += energy_;
    if (trails.next[at] >= 0) trails.energy[static_cast<std::size_t>(trails.next[at])] += trails.energy[at];
  }
  return trails;
}

}  // namespace panicle::particles
