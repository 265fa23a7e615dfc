#include "models/bunch/natural/settling/bending.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "models/bunch/units.hpp"

namespace panicle::bunch {
namespace {

constexpr float stub_length = 0.3f;  // of the stalk, left where a berry was
constexpr float seat_widening = 1.35f;
constexpr float young_girth = 0.55f;  // of the ripe bunch's stems, while it flowers
constexpr float stout_at = 0.64f;     // berries' size from which stems thicken no more

// The thickness of stems, over that of the ripe bunch, while berries are `size` times as wide as ripe ones.
float girth_at(float size) { return young_girth + (1 - young_girth) * std::min(1.0f, size / stout_at); }

// Applies to `v` the least rotation from `from` to `onto`, and the same stretch.
glm::vec3 turned_onto(const glm::vec3& v, const glm::vec3& from, const glm::vec3& onto) {
  const float length = glm::length(from), far = glm::length(onto);
  if (!(length > 0) || !(far > 0)) return v;
  const glm::vec3 a = from / length, b = onto / far, axis = glm::cross(a, b);
  const float cosine = glm::dot(a, b);
  if (cosine < -0.9999f) return v * (-far / length);
  const glm::vec3 turned = v * cosine + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1 + cosine));
  return turned * (far / length);
}

// Bends a skeleton to the places of its swollen berries.
class Bending {
 public:
  Bending(std::span<const Internode> internodes, std::span<const Flower> flowers, const Hanging& hanging,
          std::span<const FlowerOutcome> outcomes, std::span<const glm::vec3> ends, float size)
      : internodes_(internodes), flowers_(flowers), hanging_(hanging), outcomes_(outcomes), ends_(ends), size_(size) {}

  // Returns the internodes that are left, bent by the berries' weight, in metres; places in `place_of`.
  BentSkeleton run() {
    find_what_stays();
    place_stalks();
    const float girth = girth_at(size_) * metres_per_millimetre;
    BentSkeleton bent;
    bent.place_of.assign(internodes_.size(), -1);
    std::vector<glm::vec3> ends(internodes_.size());
    for (std::size_t i = 0; i < internodes_.size(); ++i) {
      if (!stays_[i]) continue;
      Internode internode = internodes_[i];
      if (internode.parent >= 0) {
        const auto parent = static_cast<std::size_t>(internode.parent);
        internode.start = ends[parent];
        internode.parent = bent.place_of[parent];
      }
      ends[i] = end_of(i, internode.start);
      internode.end = ends[i];
      if (hanging_.stalk_from[i] >= 0 && states_[i] == FlowerState::stub) internode.state = State::withered;
      if (seats_[i]) internode.radius_end *= seat_widening;
      internode.start *= metres_per_millimetre;
      internode.end *= metres_per_millimetre;
      internode.radius *= girth;
      internode.radius_end *= girth;
      bent.place_of[i] = static_cast<std::int32_t>(bent.internodes.size());
      bent.internodes.push_back(internode);
    }
    return bent;
  }

 private:
  // Whether the internode belongs to a branch, whose end the swelling has moved.
  bool is_branch(std::size_t i) const { return hanging_.branch_of[i] >= 0; }
  // Whether the internode is a part on a stalk, such as a thorn: neither branch nor stalk.
  bool grows_on_stalk(std::size_t i) const { return hanging_.branch_of[i] < 0 && hanging_.stalk_from[i] < 0; }

  // Finds the internodes that stay: the rachis, those that lead to a berry, and branches that never had a flower.
  void find_what_stays() {
    std::vector<std::uint8_t> had_flower(internodes_.size(), 0);
    stays_.assign(internodes_.size(), 0);
    for (std::size_t f = 0; f < flowers_.size(); ++f) {
      const auto parent = static_cast<std::size_t>(flowers_[f].parent);
      had_flower[parent] = 1;
      if (outcomes_[f].state != FlowerState::fallen) stays_[parent] = 1;
    }
    for (std::size_t i = internodes_.size(); i-- > 0;) {
      if (internodes_[i].kind == Kind::rachis || (is_branch(i) && !had_flower[i])) stays_[i] = 1;
      if (internodes_[i].parent < 0) continue;
      const auto parent = static_cast<std::size_t>(internodes_[i].parent);
      if (had_flower[i]) had_flower[parent] = 1;
      if (stays_[i]) stays_[parent] = 1;
    }
    for (std::size_t i = 0; i < internodes_.size(); ++i)
      if (grows_on_stalk(i)) stays_[i] = stays_[static_cast<std::size_t>(internodes_[i].parent)];
  }

  // Places the ends of stalk internodes: by the positions of their flowers, in the middle of several.
  void place_stalks() {
    states_.assign(internodes_.size(), FlowerState::fallen);
    seats_.assign(internodes_.size(), 0);
    sums_.assign(internodes_.size(), glm::vec3(0));
    counts_.assign(internodes_.size(), 0);
    for (std::size_t f = 0; f < flowers_.size(); ++f) {
      const auto parent = static_cast<std::size_t>(flowers_[f].parent);
      if (hanging_.stalk_from[parent] < 0) continue;
      const auto first = static_cast<std::size_t>(hanging_.stalk_from[parent]);
      const glm::vec3 foot = internodes_[first].start, moved = moved_foot(first);
      const glm::vec3 grown = internodes_[parent].end - foot;
      if (outcomes_[f].state == FlowerState::berry) seats_[parent] = 1;
      for (std::size_t i = parent;; i = static_cast<std::size_t>(internodes_[i].parent)) {
        add_end(i, outcomes_[f].state, moved_point(outcomes_[f], moved, internodes_[i].end - foot, grown, i == parent));
        if (i == first) break;
      }
    }
  }

  // Where the stalk whose first internode is `first` begins now: at the moved end of its branch, or where it grew.
  glm::vec3 moved_foot(std::size_t first) const {
    const Internode& internode = internodes_[first];
    const std::int32_t stem =
        internode.parent < 0 ? -1 : hanging_.branch_of[static_cast<std::size_t>(internode.parent)];
    return stem < 0 ? internode.start : ends_[static_cast<std::size_t>(stem)];
  }

  // The new place of a point of a stalk. `along` and `grown` are vectors from the foot where it grew: to the point, and
  // to the stalk's end. `foot` is the foot's new place. `tip`: the point is the stalk's end, so it goes exactly to the
  // seat.
  glm::vec3 moved_point(const FlowerOutcome& outcome, const glm::vec3& foot, const glm::vec3& along,
                        const glm::vec3& grown, bool tip) const {
    if (outcome.state == FlowerState::stub) return foot + along * stub_length;
    if (outcome.state == FlowerState::flower) return foot + along * stalk_at(size_);
    return tip ? outcome.seat : foot + turned_onto(along, grown, outcome.seat - foot);
  }

  // Adds the end of stalk internode `i` for one of its flowers. Only the flowers of the greatest state count; their
  // ends are averaged.
  void add_end(std::size_t i, FlowerState state, const glm::vec3& end) {
    if (state < states_[i]) return;
    if (state > states_[i]) {
      states_[i] = state;
      counts_[i] = 0;
    }
    sums_[i] = counts_[i] == 0 ? end : sums_[i] + end;
    counts_[i] += 1;
  }

  // The new end of internode `i`, which now begins at `start`: the swollen branch's, the mean of its flowers', or as it
  // grew.
  glm::vec3 end_of(std::size_t i, const glm::vec3& start) const {
    if (is_branch(i)) return ends_[static_cast<std::size_t>(hanging_.branch_of[i])];
    if (grows_on_stalk(i)) return start + (internodes_[i].end - internodes_[i].start);
    return sums_[i] / counts_[i];
  }

  std::span<const Internode> internodes_;
  std::span<const Flower> flowers_;
  const Hanging& hanging_;
  std::span<const FlowerOutcome> outcomes_;
  std::span<const glm::vec3> ends_;
  float size_;
  std::vector<std::uint8_t> stays_;
  // Per internode of a stalk: its state, whether a berry sits on it, and its end, summed over flowers.
  std::vector<FlowerState> states_;
  std::vector<std::uint8_t> seats_;
  std::vector<glm::vec3> sums_;
  std::vector<float> counts_;
};

}  // namespace

// Moves the stems to where the swollen berries hang, and drops stems that have lost all their flowers. `ends`: of the
// branches after swelling, millimetres; `size`: berries' width over the ripe one.
BentSkeleton bend_skeleton(std::span<const Internode> internodes, std::span<const Flower> flowers,
                           const Hanging& hanging, std::span<const FlowerOutcome> outcomes,
                           std::span<const glm::vec3> ends, float size) {
  return Bending(internodes, flowers, hanging, outcomes, ends, size).run();
}

}  // namespace panicle::bunch
