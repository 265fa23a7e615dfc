#include "models/growth/form.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"
#include "models/growth/crown_light.hpp"
#include "models/growth/free_room.hpp"
#include "models/growth/volume_shape.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint64_t stream_angle = 0x666f726d, stream_turn = stream_angle + 1, stream_reach = stream_angle + 2,
                        stream_crook = stream_angle + 3, stream_trunk = stream_angle + 4,
                        stream_dead = stream_angle + 5;

constexpr float reach = 1.3f;  // search radius of a bud, in internodes
constexpr float crowded = 0.3f, short_shoot = 0.3f;
constexpr float spread = 0.15f, stray = 17;  // spread of branching angles as a share, and of azimuths in degrees
// A branch of the trunk reaches at least this share of the half width in at most `max_left` steps.
constexpr float filled = 0.8f, least_width = 0.25f, least_first = 0.35f;
constexpr float max_left = 6;
constexpr float floor_share = 0.012f;  // as a share of a volume's height: tips do not go lower
constexpr float first_along = 0.2f, bole_along = 0.8f;
// Where a whorl is in its stretch of an internode: the leader goes on above the last one.
constexpr float whorl_along = 0.7f;
constexpr std::uint16_t least_age = 2;  // steps before a branch may be shed
constexpr float in_whorl = 0.02f;       // height of a whorl, as a share of its internode
constexpr float trunk_crook = 0.35f;    // of child trunks against branches
constexpr float leaning = 18;           // slope of child trunks, degrees
// Area that a node and a counted leaf shade, in squares of a branch's first internode.
constexpr float node_shade = 0.06f, leaf_shade = 0.02f;
constexpr float beyond = 0.5f;   // growth of a shoot that would end outside its volume, as a share
constexpr int max_halvings = 6;  // of a shoot that would leave its room
// Number of samples along the way to a volume's edge, the longest way in volume heights, and the share of it that is
// grown.
constexpr int edge_samples = 24;
constexpr float farthest = 1.2f, to_edge = 0.9f;
// The greatest slope of canes, and their slope to both sides of the row by turns, so that bunches hang free of the
// wood; the strength that bends canes back between the wires for a metre off the row, and an arm to its own wire.
constexpr float remaining_twigs = 0.3f;  // share of the last shoots of dead branches that have not fallen off
constexpr float of_wire = 0.2f, of_row = 0.5f, held = 5, tied = 3;

// The vector with length 1, or `otherwise` if it has no length.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-6f ? v / length : otherwise;
}

// Builder of a tree's form: places the nodes of all shoots, step by step. Shoots are numbered as in the population
// (`q`).
class FormBuilder {
 public:
  FormBuilder(const Population& population, const FormHabit& habit, const Surroundings& surroundings,
              const ShootEdits& edits)
      : population_(population),
        habit_(habit),
        edits_(edits),
        angles_(habit.seed, stream_angle),
        turns_(habit.seed, stream_turn),
        reaches_(habit.seed, stream_reach),
        crooks_(habit.seed, stream_crook),
        trunks_(habit.seed, stream_trunk),
        surroundings_(surroundings),
        light_(population, surroundings) {}

  // Places all nodes and returns the form.
  Form run() {
    allocate_nodes();
    for (std::uint16_t step = 1; step <= population_.steps; ++step) grow(step);
    return std::move(form_);
  }

 private:
  // The internode on which a shoot has its branches of an age; a trunk's first internode takes two steps.
  std::uint32_t internode_at(const Shoot& shoot, std::uint16_t age) const {
    return shoot.trunk ? std::max<std::uint32_t>(age, 1) - 1u : age;
  }

  // Computes the path of each shoot: the range of its nodes, where it leaves its parent, and when it grows. The number
  // of internodes of each shoot is known before growth, and so the index of each node.
  void allocate_nodes() {
    std::uint32_t nodes = 0;
    std::vector<std::uint8_t> has_branches;
    if (!edits_.empty()) {
      has_branches.assign(population_.shoots.size(), 0);
      for (const Shoot& shoot : population_.shoots)
        if (shoot.parent >= 0) has_branches[static_cast<std::size_t>(shoot.parent)] = 1;
    }
    std::vector<std::uint32_t> attached_count(population_.shoots.size(), 0);
    count_whorls();
    for (const Shoot& shoot : population_.shoots) {
      ShootPath path;
      path.first = nodes;
      path.from = static_cast<std::uint16_t>(shoot.born + (shoot.trunk ? 1 : 0));
      path.count = population_.steps >= path.from ? population_.steps - path.from + 1u : 0;
      if (shoot.parent >= 0 && !shoot.trunk) {
        const auto parent = static_cast<std::size_t>(shoot.parent);
        path.internode = internode_at(population_.shoots[parent], shoot.node);
        const std::uint32_t place = attached_count[parent]++;
        ordinals_.push_back(place);
        const float turns = golden_ratio * static_cast<float>(place + 1);
        const bool on_bole = population_.shoots[parent].trunk && path.internode == 0;
        const float least_along = on_bole ? bole_along : first_along;
        path.along =
            glm::mix(least_along + (1 - least_along) * (turns - std::floor(turns)),
                     1 - 0.08f * (turns - std::floor(turns)), population_.shoots[parent].trunk ? habit_.whorl : 0);
        azimuths_.push_back(habit_.turn * static_cast<float>(place));
        if (habit_.whorl_size > 0 && population_.shoots[parent].trunk)
          place_in_whorl(shoot, path, on_bole ? bole_along : 0, azimuths_.back());
      } else {
        ordinals_.push_back(0);
        azimuths_.push_back(0);
      }
      path.uncut = path.count;
      if (!edits_.empty()) edit(path, has_branches[form_.paths.size()] != 0);
      nodes += path.count + 1;
      form_.paths.push_back(path);
    }
    form_.nodes.resize(nodes);
    placed_nodes_.reserve(nodes);
    deformed_.resize(population_.shoots.size());
    firsts_.assign(form_.paths.size(), 0);
    for (const GrowthVolume& volume : population_.volumes) shapes_.emplace_back(volume);
    for (std::uint32_t k = 0; k <= population_.steps; ++k)
      by_age_.push_back(power(habit_.age_ratio, static_cast<float>(k)));
    std::uint8_t highest = 1;
    for (const Shoot& shoot : population_.shoots) highest = std::max(highest, shoot.order);
    for (std::uint32_t order = 0; order <= highest; ++order)
      by_order_.push_back(power(habit_.order_ratio, static_cast<float>(order) - 1));
  }

  // Counts the branches on each internode of the trunks, where these have whorls.
  void count_whorls() {
    if (habit_.whorl_size == 0) return;
    const std::size_t per_trunk = population_.steps + std::size_t{1};
    on_internode_.assign(population_.volumes.size() * per_trunk, 0);
    placed_on_internode_ = on_internode_;
    for (const Shoot& shoot : population_.shoots)
      if (is_in_whorl(shoot)) ++on_internode_[internode_address(shoot)];
  }

  // Whether a shoot is a branch of a trunk.
  bool is_in_whorl(const Shoot& shoot) const {
    return shoot.parent >= 0 && !shoot.trunk && population_.shoots[static_cast<std::size_t>(shoot.parent)].trunk;
  }

  // The index of the trunk's internode of a branch in `on_internode_`.
  std::size_t internode_address(const Shoot& shoot) const {
    const Shoot& trunk = population_.shoots[static_cast<std::size_t>(shoot.parent)];
    return shoot.volume * (population_.steps + std::size_t{1}) + internode_at(trunk, shoot.node);
  }

  // Puts a branch of a trunk into one of the whorls of its internode, which are at even distances up to its end: sets
  // its place on the internode, from `lowest` on, and its azimuth in degrees.
  void place_in_whorl(const Shoot& shoot, ShootPath& path, float lowest, float& azimuth) {
    const std::size_t address = internode_address(shoot);
    const std::uint32_t count = on_internode_[address], number = placed_on_internode_[address]++;
    const std::uint32_t whorls = std::max((count + habit_.whorl_size / 2) / habit_.whorl_size, 1u);
    const std::uint32_t whorl = number * whorls / count, first = (whorl * count + whorls - 1) / whorls,
                        end = ((whorl + 1) * count + whorls - 1) / whorls;
    path.along = glm::mix(lowest, 1.0f, (static_cast<float>(whorl) + whorl_along) / static_cast<float>(whorls)) -
                 in_whorl * turns_.unit(hash_combine(address, number));
    azimuth = 360 * static_cast<float>(number - first) / static_cast<float>(std::max(end - first, 1u)) +
              golden_angle * static_cast<float>(path.internode + 3 * whorl);
  }

  // Applies edits to the path of the next shoot: a cut shortens it, and a cut below it removes it.
  void edit(ShootPath& path, bool has_branches) {
    const auto q = static_cast<std::uint32_t>(form_.paths.size());
    const Shoot& shoot = population_.shoots[q];
    EditedShoot state;
    const ShootEdit* const own = edits_.of(q);
    state.dead = own != nullptr && own->dead;
    state.drawn = own != nullptr && !own->curve.empty();
    if (shoot.parent >= 0 && !shoot.trunk) {
      const auto parent = static_cast<std::size_t>(shoot.parent);
      const EditedShoot& below = form_.edited[parent];
      const ShootPath& on = form_.paths[parent];
      state.dead |= below.dead;
      if (below.carrier >= 0) {
        state.carrier = below.carrier;
        state.carrier_node = below.carrier_node;
      } else if (path.internode >= on.count ||
                 (below.cut && path.internode + 1 == on.count && path.along >= below.last)) {
        state.carrier = below.cut ? shoot.parent : -1;
        state.carrier_node = on.count;
      } else if (below.cut && path.internode + 1 == on.count) {
        path.along /= below.last;
      }
      const bool falls_off = state.carrier < 0 && below.dead && !has_branches &&
                             random_unit(habit_.seed, stream_dead, population_.addresses[q]) >= remaining_twigs;
      if (falls_off) {
        state.carrier = shoot.parent;
        state.carrier_node = std::min(path.internode + 1, on.count);
      }
    }
    if (state.carrier >= 0) {
      path.count = 0;
    } else if (own != nullptr && own->cut < 1 && path.count > 0) {
      const float cut = own->cut * static_cast<float>(path.count);
      path.count = std::max(1u, static_cast<std::uint32_t>(std::ceil(cut)));
      state.last = cut - static_cast<float>(path.count - 1);
      state.cut = true;
      state.snapped = own->snapped;
    }
    form_.edited.push_back(state);
  }

  // Adds an internode to each shoot that grows in a step.
  void grow(std::uint16_t step) {
    room_.set_nodes(placed_nodes_, std::max(cell_, 0.05f));
    shade(step);
    if (habit_.shade_limit > 0) shed_shaded(step);
    for (; next_ < population_.deformations.size() && population_.deformations[next_].step <= step; ++next_)
      deformed_[population_.deformations[next_].shoot] = population_.deformations[next_];
    for (std::uint32_t q = 0; q < population_.shoots.size(); ++q) {
      const ShootPath& path = form_.paths[q];
      if (step < path.from || path.count == 0 || is_shed(q)) continue;
      const std::uint32_t internode = step - path.from;
      if (internode < path.count) extend(q, internode);
    }
  }

  // Whether a shoot has been shed.
  bool is_shed(std::uint32_t q) const { return !form_.shed.empty() && form_.shed[q] != Form::never; }

  // Sheds branches none of whose tips gets enough light, with all that grows on them, as trees do (Palubicki et al.
  // 2009, section 3.3): the light of a branch is that of its best tip. Trunks are never shed.
  void shed_shaded(std::uint16_t step) {
    form_.shed.resize(form_.paths.size(), Form::never);
    best_light_.assign(form_.paths.size(), 0);
    for (std::size_t q = form_.paths.size(); q-- > 0;) {
      const ShootPath& path = form_.paths[q];
      if (path.count == 0 || path.from >= step || is_shed(static_cast<std::uint32_t>(q))) continue;
      const std::uint32_t grown = std::min<std::uint32_t>(step - path.from, path.count);
      best_light_[q] = std::max(best_light_[q], light_.share(form_.nodes[path.first + grown]));
      // Edited shoots stay, and so do those that carry them.
      if (edits_.of(static_cast<std::uint32_t>(q)) != nullptr)
        best_light_[q] = std::max(best_light_[q], habit_.shade_limit);
      const std::int32_t parent = population_.shoots[q].parent;
      if (parent >= 0) {
        float& of_parent = best_light_[static_cast<std::size_t>(parent)];
        of_parent = std::max(of_parent, best_light_[q]);
      }
    }
    for (std::uint32_t q = 0; q < form_.paths.size(); ++q) {
      const Shoot& shoot = population_.shoots[q];
      ShootPath& path = form_.paths[q];
      if (shoot.trunk || is_shed(q) || path.count == 0) continue;
      const bool fell = shoot.parent >= 0 && is_shed(static_cast<std::uint32_t>(shoot.parent));
      const bool shaded = path.from + least_age <= step && best_light_[q] < habit_.shade_limit;
      if (!fell && !shaded) continue;
      form_.shed[q] = step;
      // It grows no more.
      path.count = path.from < step ? std::min<std::uint32_t>(path.count, step - path.from) : 0;
    }
  }

  // Adds the nodes and leaves of earlier steps to the cells of light.
  void shade(std::uint16_t step) {
    if (placed_nodes_.empty()) return;
    // The edge of the square that a shoot's nodes and leaves are measured by: a branch's first internode, metres.
    const auto side = [&](std::uint32_t shoot) {
      return habit_.shoot * population_.volumes[population_.shoots[shoot].volume].height / 10;
    };
    for (; shaded_ < placed_nodes_.size(); ++shaded_)
      light_.put(placed_nodes_[shaded_], node_shade * side(placed_shoots_[shaded_]) * side(placed_shoots_[shaded_]));
    for (; leaf_ < population_.leaves.size() && population_.leaves[leaf_].born < step; ++leaf_) {
      const std::uint32_t shoot = population_.leaves[leaf_].shoot;
      const ShootPath& path = form_.paths[shoot];
      if (path.count > 0 && path.from < step && has_place(form_, population_.leaves[leaf_]))
        light_.put(form_.nodes[path.first + 1], leaf_shade * side(shoot) * side(shoot));
    }
    light_.update();
  }

  // Returns where a shoot begins, and sets `ahead_of` to its first direction: a trunk at its volume, a branch along an
  // internode of its parent, turned from the branch before.
  glm::vec3 begin(std::uint32_t q, glm::vec3& ahead_of) {
    const Shoot& shoot = population_.shoots[q];
    const GrowthVolume& volume = population_.volumes[shoot.volume];
    const ShootPath& path = form_.paths[q];
    if (shoot.trunk) {
      ahead_of = shapes_[shoot.volume].axis();
      if (shoot.parent >= 0) {
        const SinCos slope = sincos_degrees(leaning);
        const SinCos azimuth = sincos_degrees(360 * trunks_.unit(q));
        ahead_of = unit_or(slope.cosine * ahead_of + slope.sine * glm::vec3(azimuth.cosine, 0, azimuth.sine), ahead_of);
      }
      return volume.at;
    }
    const ShootPath& parent = form_.paths[static_cast<std::size_t>(shoot.parent)];
    const glm::vec3 internode_start = form_.nodes[parent.first + path.internode],
                    internode_end = form_.nodes[parent.first + path.internode + 1];
    const glm::vec3 along = unit_or(internode_end - internode_start, glm::vec3(0, 1, 0)),
                    normal = any_perpendicular(along), binormal = glm::cross(along, normal);
    const float angle =
        (population_.shoots[static_cast<std::size_t>(shoot.parent)].trunk ? habit_.trunk_angle : habit_.branch_angle) *
        (1 + spread * (2 * angles_.unit(q) - 1));
    const SinCos slope = sincos_degrees(angle);
    const SinCos azimuth = sincos_degrees(azimuths_[q] + stray * (2 * turns_.unit(q) - 1));
    ahead_of = unit_or(slope.cosine * along + slope.sine * (azimuth.cosine * normal + azimuth.sine * binormal), along);
    if (shoot.order > 1) ahead_of = unit_or({ahead_of.x, ahead_of.y * (1 - habit_.flat), ahead_of.z}, along);
    if (shoot.order == 1 && habit_.cordon > 0)
      ahead_of = unit_or(glm::vec3(0, 1, 0) + (ordinals_[q] % 2 == 0 ? of_row : -of_row) * across(volume) +
                             of_wire * trunks_.direction(q),
                         along);
    return glm::mix(internode_start, internode_end, path.along);
  }

  // The unit vector that is level and orthogonal to a trained trunk's wire.
  static glm::vec3 across(const GrowthVolume& volume) { return {-sine(volume.towards), 0, cosine(volume.towards)}; }

  // The distance from a tip to the edge of its volume along the unit vector `forward`, in metres; found by samples.
  float edge_distance(const Shoot& shoot, const glm::vec3& tip, const glm::vec3& forward) const {
    const GrowthVolume& volume = population_.volumes[shoot.volume];
    const float longest = farthest * std::max({volume.height, volume.base, volume.middle, volume.top});
    for (int i = 1; i <= edge_samples; ++i) {
      const float distance = longest * static_cast<float>(i) / static_cast<float>(edge_samples);
      const glm::vec3 place = tip + distance * forward;
      if (!shapes_[shoot.volume].contains(place) || !surroundings_.contains(place))
        return distance - 0.5f * longest / static_cast<float>(edge_samples);
    }
    return longest;
  }

  // The length of the next internode of a shoot, before deformation: metres. Trunks share the height of the volume;
  // branches shorten by order and age, and with `reach` end at the volume's edge.
  float length_of(std::uint32_t q, std::uint32_t internode, const glm::vec3& tip, const glm::vec3& forward) {
    const Shoot& shoot = population_.shoots[q];
    const GrowthVolume& volume = population_.volumes[shoot.volume];
    const float tenth_of_height = volume.height / 10;
    if (shoot.trunk) {
      if (habit_.cordon > 0)
        return internode == 0 ? habit_.cordon
                              : 0.5f * volume.base / std::max(1.0f, static_cast<float>(form_.paths[q].uncut) - 1);
      const float trunk_length = habit_.leader * volume.height;
      if (internode == 0)
        return habit_.bole * trunk_length + (form_.paths[q].uncut == 1 ? (1 - habit_.bole) * trunk_length : 0);
      return (1 - habit_.bole) * trunk_length / static_cast<float>(form_.paths[q].uncut - 1);
    }
    const float by_habit = habit_.shoot * tenth_of_height * by_order_[shoot.order] * by_age_[internode];
    if (shoot.order > 1) return by_habit;
    if (internode > 0) return glm::mix(by_habit, firsts_[q] * by_age_[internode], habit_.reach);
    const VolumeShape& shape = shapes_[shoot.volume];
    const float half_width = std::max(shape.radius(std::clamp(shape.up(tip), 0.0f, 1.0f)), least_width * volume.base);
    const float steps_left = static_cast<float>(population_.steps - shoot.born + 1);
    // The first of a geometric series of lengths that ends at the edge.
    const float ratio = habit_.age_ratio, steps = std::max(steps_left, 1.0f);
    const float sum = ratio < 0.999f ? (1 - power(ratio, steps)) / (1 - ratio) : steps;
    if (habit_.reach > 0)
      firsts_[q] =
          std::max(least_first * habit_.shoot * tenth_of_height, to_edge * edge_distance(shoot, tip, forward) / sum);
    return glm::mix(std::max(least_first * habit_.shoot * tenth_of_height,
                             filled * half_width / std::clamp(steps_left, 1.0f, max_left)),
                    firsts_[q], habit_.reach);
  }

  // Adds the next internode of a shoot: its direction follows the shoot, noise, light, gravity and the free room, and
  // its length the shoot's habit.
  void extend(std::uint32_t q, std::uint32_t internode) {
    const Shoot& shoot = population_.shoots[q];
    const ShootPath& path = form_.paths[q];
    glm::vec3* const nodes = &form_.nodes[path.first];
    glm::vec3 forward(0, 1, 0);
    if (internode == 0) {
      nodes[0] = begin(q, forward);
      add_node(nodes[0], q);
    } else {
      forward = unit_or(nodes[internode] - nodes[internode - 1], forward);
    }
    const bool last = !form_.edited.empty() && form_.edited[q].cut && internode + 1 == path.count;
    const float remains = last ? form_.edited[q].last : 1;
    if (const ShootEdit* const own = edits_.of(q); own != nullptr && !own->curve.empty()) {
      nodes[internode + 1] = nodes[0] + drawn_place(*own, q, internode, remains);
      add_node(nodes[internode + 1], q);
      return;
    }
    const glm::vec3 tip = nodes[internode];
    float length = length_of(q, internode, tip, forward);
    cell_ = std::max(cell_, 0.5f * length);
    const std::uint64_t address = hash_combine(q, internode);
    const glm::vec3 noise = habit_.crook * crooks_.direction(address);
    if (shoot.trunk) {
      const glm::vec3 along_axis = 0.3f * shapes_[shoot.volume].axis();
      if (internode == 1 && habit_.cordon > 0) {
        const float towards = population_.volumes[shoot.volume].towards;
        forward = {cosine(towards), 0, sine(towards)};
      }
      const bool on_wire = habit_.cordon > 0;
      forward = internode == 0
                    ? forward
                    : unit_or(forward + trunk_crook * noise + (on_wire ? glm::vec3(0) : along_axis), forward);
      if (internode > 0 && on_wire)
        forward = unit_or({forward.x, 0.3f * forward.y + tied * (habit_.cordon - tip.y), forward.z}, forward);
    } else {
      const Environment& environment = population_.environments[shoot.volume];
      const Deformation& deformed = deformed_[q];
      length *= deformed.length;
      const float regard = std::clamp(environment.neighbours, 0.0f, 1.0f);
      const glm::vec3 light = light_.from(tip);
      const float random_reach = reaches_.unit(address);
      const FreeRoom::Found free_room =
          room_.find({tip, forward, light, reach * length, random_reach, regard}, shapes_[shoot.volume], surroundings_);
      const float order = std::min(static_cast<float>(shoot.order) - 1, 2.0f) / 2;
      const float downwards = environment.gravitropism + deformed.gravitropism + habit_.hang * order;
      forward = unit_or(habit_.inertia * forward + habit_.space * unit_or(free_room.middle, glm::vec3(0)) +
                            environment.phototropism * light - glm::vec3(0, downwards, 0) + noise,
                        forward);
      if (habit_.cordon > 0 && internode > 0) {
        const GrowthVolume& volume = population_.volumes[shoot.volume];
        const glm::vec3 row_normal = across(volume);
        forward = unit_or(forward - held * glm::dot(tip - volume.at, row_normal) * row_normal, forward);
      }
      // Shoots never die: their number is the grammar's alone.
      if (free_room.sum < crowded && habit_.cordon <= 0) length *= short_shoot;
      for (int i = 0; i < max_halvings && regard > 0 && !surroundings_.contains(tip + length * forward); ++i)
        length *= 0.5f;
      // A shoot beyond its volume grows half as far, unless the grammar lengthens it.
      if (deformed.length <= 1 && !shapes_[shoot.volume].contains(tip + length * forward)) length *= beyond;
      const float floor = floor_share * population_.volumes[shoot.volume].height;
      if (tip.y + length * forward.y < floor) length = std::min(length, 0.02f * length + std::max(0.0f, tip.y - floor));
    }
    nodes[internode + 1] = tip + remains * length * forward;
    add_node(nodes[internode + 1], q);
  }

  // The place on a drawn curve of the end of an internode, of which the share `remains` is left, relative to the base.
  // Internodes have the same shares of the curve's length as of the shoot's own.
  glm::vec3 drawn_place(const ShootEdit& edit, std::uint32_t q, std::uint32_t internode, float remains) const {
    const std::uint32_t count = form_.paths[q].uncut;
    const auto length_to = [&](std::uint32_t ends) {
      if (!population_.shoots[q].trunk) {
        float sum = 0;
        for (std::uint32_t i = 0; i < ends; ++i) sum += by_age_[i];
        return sum;
      }
      if (ends == 0 || count == 1) return static_cast<float>(ends);
      return habit_.bole + (1 - habit_.bole) * static_cast<float>(ends - 1) / static_cast<float>(count - 1);
    };
    return place_on_curve(edit, glm::mix(length_to(internode), length_to(internode + 1), remains) / length_to(count));
  }

  // Records a placed node and its shoot, for the free room and the light of later steps.
  void add_node(const glm::vec3& node, std::uint32_t shoot) {
    placed_nodes_.push_back(node);
    placed_shoots_.push_back(shoot);
  }

  const Population& population_;
  const FormHabit& habit_;
  const ShootEdits& edits_;
  const RandomStream angles_, turns_, reaches_, crooks_, trunks_;
  Form form_;
  const Surroundings& surroundings_;
  CrownLight light_;
  std::vector<std::uint32_t> ordinals_;  // index of each shoot among its parent's
  std::vector<float> azimuths_;          // of each shoot about its parent, degrees
  // By trunk and internode: the number of branches, and of those that are placed; only with whorls.
  std::vector<std::uint32_t> on_internode_, placed_on_internode_;
  std::vector<VolumeShape> shapes_;  // of the volumes
  // of each branch of a trunk, the first length that reaches the edge in the end
  std::vector<float> firsts_;
  std::vector<float> by_age_, by_order_;  // factors of lengths by age and by order
  std::vector<glm::vec3> placed_nodes_;   // every node so far, and the shoot of each
  std::vector<std::uint32_t> placed_shoots_;
  std::size_t shaded_ = 0, leaf_ = 0;  // numbers of those nodes, and of leaves, that the light includes
  FreeRoom room_;                      // with the nodes of earlier steps
  float cell_ = 0;
  std::vector<float> best_light_;      // of each shoot and its branches, the share of light of the best tip
  std::vector<Deformation> deformed_;  // current deformation of each shoot
  std::size_t next_ = 0;               // index of the next deformation
};

}  // namespace

// Computes the places of all nodes of a population's shoots.
Form form_of(const Population& population, const FormHabit& habit, const Surroundings& surroundings,
             const ShootEdits& edits) {
  return FormBuilder(population, habit, surroundings, edits).run();
}

bool has_place(const Form& form, const Leaf& leaf) {
  if (form.edited.empty()) return true;
  const EditedShoot& edited = form.edited[leaf.shoot];
  const ShootPath& path = form.paths[leaf.shoot];
  if (edited.dead || edited.snapped || path.count == 0) return false;
  return !edited.cut || leaf.born < path.from + path.count;
}

}  // namespace panicle::growth
