// Edits of single branches by hand: cuts, dead wood and drawn curves.
#include "models/growth/edits.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/moment.hpp"
#include "models/growth/stubs.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

constexpr std::uint16_t steps = 7;

const Population& oak() {
  static const Population population = grown(text_named("oak"), steps);
  return population;
}

// The branch of the trunk with the most shoots on it that was born in an early step.
std::uint32_t limb(const Population& population) {
  std::vector<std::uint32_t> size(population.shoots.size(), 1);
  std::uint32_t best = 0;
  for (std::size_t q = population.shoots.size(); q-- > 0;) {
    const Shoot& shoot = population.shoots[q];
    if (shoot.parent >= 0) size[static_cast<std::size_t>(shoot.parent)] += size[q];
    if (shoot.order == 1 && !shoot.trunk && (best == 0 || size[q] > size[best])) best = static_cast<std::uint32_t>(q);
  }
  return best;
}

// Whether a shoot is `ancestor` or grows on it, directly or not.
bool is_on(const Population& population, std::size_t shoot, std::uint32_t ancestor) {
  for (auto q = static_cast<std::int32_t>(shoot); q >= 0; q = population.shoots[static_cast<std::size_t>(q)].parent)
    if (static_cast<std::uint32_t>(q) == ancestor) return true;
  return false;
}

struct Tree {
  Form form;
  Moment moment;
};

Tree tree_with(const Population& population, const std::vector<BranchEdit>& edits) {
  Tree tree;
  tree.form = form_of(population, {}, {}, ShootEdits(population, edits));
  tree.moment = sound(moment_of(population, tree.form, steps, WoodHabit{}, Limits{}));
  return tree;
}

BranchEdit edit_of(const Population& population, std::uint32_t shoot, EditKind kind, float at = 0.4f) {
  return {population.addresses[shoot], kind, at, {}};
}

}  // namespace

TEST_CASE("the address of a shoot does not depend on the number of steps, nor on the seed where both trees have it") {
  const std::string text = text_named("table-1-sigma1");
  const Population few = grown(text, 5), many = grown(text, 7), other = grown(text, 5, 9);
  const auto shared = [&](const Population& population) {
    return std::count_if(few.addresses.begin(), few.addresses.end(), [&](std::uint64_t address) {
      return std::count(population.addresses.begin(), population.addresses.end(), address) == 1;
    });
  };
  CHECK(shared(many) == static_cast<std::ptrdiff_t>(few.shoots.size()));
  CHECK(shared(other) > static_cast<std::ptrdiff_t>(few.shoots.size() / 2));
  CHECK(few.addresses[0] == other.addresses[0]);
}

TEST_CASE("a plant without edits, or with edits of unknown shoots, is the same as before") {
  const Tree plain = tree_with(oak(), {});
  const std::vector<BranchEdit> unknown{{12345, EditKind::prune, 0.5f, {}}};
  CHECK(ShootEdits(oak(), unknown).unknown() == 1);
  CHECK(ShootEdits(oak(), unknown).empty());
  const Tree other = tree_with(oak(), unknown);
  CHECK(plain.form.nodes == other.form.nodes);
  CHECK(plain.form.edited.empty());
}

TEST_CASE("pruning removes what grows beyond the cut and nothing else, and leaves the stub as thick as it was") {
  const std::uint32_t shoot = limb(oak());
  const Tree before = tree_with(oak(), {}), after = tree_with(oak(), {edit_of(oak(), shoot, EditKind::prune)});
  const float cut = 0.4f * static_cast<float>(before.form.paths[shoot].count);
  std::uint32_t removed = 0;
  for (std::size_t q = 0; q < oak().shoots.size(); ++q) {
    CAPTURE(q);
    const ShootPath &was = before.form.paths[q], &is = after.form.paths[q];
    if (!is_on(oak(), q, shoot)) {
      CHECK(is.count == was.count);
      continue;
    }
    if (q == shoot) continue;
    const auto parent = static_cast<std::uint32_t>(oak().shoots[q].parent);
    const bool gone = after.form.paths[parent].count == 0 ||
                      (parent == shoot && static_cast<float>(was.internode) + was.along >= cut);
    CHECK(is.count == (gone ? 0 : was.count));
    removed += gone ? 1 : 0;
  }
  CHECK(removed > 0);
  CHECK(after.moment.branches == before.moment.branches - removed);
  // The base of the limb, and the trunk below it.
  const auto thickness = [&](const Tree& tree, std::int32_t axis) {
    for (std::size_t i = 0; i < tree.moment.segments.size(); ++i)
      if (tree.moment.axes[i] == axis) return tree.moment.segments[i].radius;
    return 0.0f;
  };
  CHECK(thickness(after, static_cast<std::int32_t>(shoot)) ==
        doctest::Approx(thickness(before, static_cast<std::int32_t>(shoot))).epsilon(1e-3));
  CHECK(thickness(after, 0) == doctest::Approx(thickness(before, 0)).epsilon(1e-3));
  // Growth goes on elsewhere: some shoots that grew in the shade of the limb find other places.
  std::uint32_t moved = 0;
  for (std::size_t q = 0; q < oak().shoots.size(); ++q)
    if (!is_on(oak(), q, shoot) && after.form.paths[q].count > 0 &&
        glm::distance(before.form.nodes[before.form.paths[q].first + before.form.paths[q].count],
                      after.form.nodes[after.form.paths[q].first + after.form.paths[q].count]) > 1e-3f)
      ++moved;
  CHECK(moved > 0);
}

TEST_CASE("a cut tree has a face at each cut that the shoot has reached, and a broken one has splinters") {
  const std::uint32_t shoot = limb(oak());
  const Tree pruned = tree_with(oak(), {edit_of(oak(), shoot, EditKind::prune)}),
             snapped = tree_with(oak(), {edit_of(oak(), shoot, EditKind::snap)});
  const StubMeshes cut = stub_meshes(pruned.moment, pruned.form, 1), jag = stub_meshes(snapped.moment, snapped.form, 1);
  CHECK(!cut.cuts.indices.empty());
  CHECK(cut.splinters.indices.empty());
  CHECK(jag.cuts.indices.empty());
  CHECK(!jag.splinters.indices.empty());
  CHECK(jag.splinters.normals.size() == jag.splinters.positions.size());
  const Moment seedling = sound(moment_of(oak(), pruned.form, 1, WoodHabit{}, Limits{}));
  CHECK(stub_meshes(seedling, pruned.form, 1).cuts.indices.empty());
}

TEST_CASE("a dead branch has no leaves and keeps its larger wood; a broken one dies back to a living branch") {
  const std::uint32_t shoot = limb(oak());
  const Tree plain = tree_with(oak(), {}), dead = tree_with(oak(), {edit_of(oak(), shoot, EditKind::dead)}),
             snapped = tree_with(oak(), {edit_of(oak(), shoot, EditKind::snap, 0.8f)});
  std::size_t twigs = 0, left = 0;
  for (std::size_t q = 0; q < oak().shoots.size(); ++q) {
    if (!is_on(oak(), q, shoot)) {
      CHECK(dead.form.paths[q].count == plain.form.paths[q].count);
      continue;
    }
    ++twigs;
    left += dead.form.paths[q].count > 0 ? 1 : 0;
  }
  CHECK(left < twigs);
  CHECK(dead.form.paths[shoot].count == plain.form.paths[shoot].count);
  for (const Leaf& leaf : oak().leaves) CHECK(has_place(dead.form, leaf) == !is_on(oak(), leaf.shoot, shoot));
  const std::vector<std::uint8_t> bare = dead_segments(dead.moment, dead.form);
  REQUIRE(bare.size() == dead.moment.segments.size());
  for (std::size_t i = 0; i < bare.size(); ++i)
    CHECK(bare[i] == (is_on(oak(), static_cast<std::size_t>(dead.moment.axes[i]), shoot) ? 1 : 0));
  CHECK(dead_segments(plain.moment, plain.form).empty());
  const std::vector<std::uint8_t> back = dead_segments(snapped.moment, snapped.form);
  REQUIRE(!back.empty());
  // Dead wood never carries living wood.
  for (std::size_t i = 0; i < back.size(); ++i) {
    const std::int32_t parent = snapped.moment.segments[i].parent;
    if (!back[i] && parent >= 0) CHECK(!back[static_cast<std::size_t>(parent)]);
  }
}

TEST_CASE("a drawn trunk or branch follows its curve, from its base to its end") {
  for (const std::uint32_t shoot : {0u, limb(oak())}) {
    CAPTURE(shoot);
    BranchEdit drawn = edit_of(oak(), shoot, EditKind::curve);
    for (int i = 1; i <= 8; ++i) {
      const float t = static_cast<float>(i) / 8;
      drawn.curve.emplace_back(3 * t, 4 * t - 1.5f * t * t, std::sin(3 * t));
    }
    const Tree tree = tree_with(oak(), {drawn});
    const ShootPath& path = tree.form.paths[shoot];
    const glm::vec3 base = tree.form.nodes[path.first];
    const ShootEdits edits(oak(), std::vector<BranchEdit>{drawn});
    for (std::uint32_t i = 0; i <= path.count; ++i) {
      float nearest = std::numeric_limits<float>::max();
      for (int k = 0; k <= 400; ++k)
        nearest = std::min(nearest, glm::distance(tree.form.nodes[path.first + i] - base,
                                                  place_on_curve(*edits.of(shoot), static_cast<float>(k) / 400)));
      CHECK(nearest < 0.02f);
    }
    CHECK(glm::distance(tree.form.nodes[path.first + path.count] - base, drawn.curve.back()) < 1e-3f);
    // The curve goes through the drawn points.
    for (const glm::vec3& point : drawn.curve) {
      float nearest = std::numeric_limits<float>::max();
      for (int k = 0; k <= 2000; ++k)
        nearest =
            std::min(nearest, glm::distance(point, place_on_curve(*edits.of(shoot), static_cast<float>(k) / 2000)));
      CHECK(nearest < 0.01f);
    }
  }
}

TEST_CASE("requests of edits that are too many or out of range are refused") {
  const std::vector<std::uint32_t> one{1, 2, 0, 400, 0};
  CHECK(sound(read_edits(one, {})).size() == 1);
  const auto refused = [](std::vector<std::uint32_t> words, std::vector<float> points) {
    const auto read = read_edits(words, points);
    return read ? Reason::none : read.error().reason;
  };
  CHECK(refused({1, 2, 0, 400}, {}) == Reason::bad_request);
  CHECK(refused({1, 2, 9, 400, 0}, {}) == Reason::bad_request);
  CHECK(refused({1, 2, 0, 4000, 0}, {}) == Reason::bad_request);
  CHECK(refused({1, 2, 0, 400, 1}, {1, 2, 3}) == Reason::bad_request);
  CHECK(refused({1, 2, 3, 0, 2}, {1, 2, 3}) == Reason::bad_request);
  CHECK(refused({1, 2, 3, 0, 1}, {1, 2, std::numeric_limits<float>::quiet_NaN()}) == Reason::bad_request);
  CHECK(refused({1, 2, 3, 0, 1}, {1, 2, 1e9f}) == Reason::bad_request);
  CHECK(refused({1, 2, 3, 0, 17}, std::vector<float>(51, 1)) == Reason::limit);
  CHECK(refused(std::vector<std::uint32_t>(5 * 257, 0), {}) == Reason::limit);
}
