// Properties of twigs: leaves by the arrangement of the species, wood that stays in winter, areas and counts that are
// right.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "models/growth/coarse_leaf.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/texts.hpp"
#include "models/growth/twig_shapes.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

// A leaf of two triangles with the base at the origin and the tip at +Y.
Blade rhombus() {
  Blade blade;
  blade.mesh.positions = {0, 0, 0, 0.25f, 0.5f, 0, 0, 1, 0, -0.25f, 0.5f, 0};
  blade.mesh.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  blade.mesh.uvs = {0.5f, 1, 1, 0.5f, 0.5f, 0, 0, 0.5f};
  blade.mesh.indices = {0, 1, 2, 0, 2, 3};
  blade.area = 0.25f;
  return blade;
}

float area_of(const Mesh& mesh) {
  float area = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::vec3 a = vector_at(mesh.positions, mesh.indices[i]), b = vector_at(mesh.positions, mesh.indices[i + 1]),
                    c = vector_at(mesh.positions, mesh.indices[i + 2]);
    area += 0.5f * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

float between(float a, float b) {
  const float turn = std::fmod(std::fabs(a - b), 360.0f);
  return std::min(turn, 360 - turn);
}

TwigHabit habit_of(std::uint32_t shapes = 5) {
  TwigHabit habit;
  habit.shapes = shapes;
  return habit;
}

}  // namespace

TEST_CASE("the divergence of successive leaves is 144° in a spiral, 180° in two ranks, and pairs cross at 90°") {
  const auto spiral = twig_nodes(Phyllotaxis::spiral, 11, 0.5f), ranked = twig_nodes(Phyllotaxis::two_ranked, 11, 0),
             pairs = twig_nodes(Phyllotaxis::opposite, 12, 0);
  for (std::size_t i = 1; i < 11; ++i) {
    CHECK(between(spiral[i].azimuth, spiral[i - 1].azimuth) == doctest::Approx(144));
    CHECK(between(ranked[i].azimuth, ranked[i - 1].azimuth) == doctest::Approx(180));
    CHECK(spiral[i].along > spiral[i - 1].along);
  }
  for (std::size_t i = 0; i < 12; i += 2) {
    CHECK(between(pairs[i].azimuth, pairs[i + 1].azimuth) == doctest::Approx(180));
    CHECK(pairs[i].along == pairs[i + 1].along);
    if (i >= 2) CHECK(between(pairs[i].azimuth, pairs[i - 2].azimuth) == doctest::Approx(90));
  }
  // Crowded leaves are nearer to the tip.
  CHECK(twig_nodes(Phyllotaxis::spiral, 9, 1)[4].along > twig_nodes(Phyllotaxis::spiral, 9, 0)[4].along);
}

TEST_CASE("shapes of twigs differ, have all their leaves, and the area of their meshes") {
  for (const Phyllotaxis phyllotaxis : {Phyllotaxis::spiral, Phyllotaxis::two_ranked, Phyllotaxis::opposite}) {
    TwigHabit habit = habit_of();
    habit.phyllotaxis = phyllotaxis;
    habit.leaves = 17;
    const auto shapes = twig_shapes(habit, rhombus(), std::vector<float>(5, 1), false);
    REQUIRE(shapes.size() == 5);
    for (const TwigShape& shape : shapes) {
      CHECK(shape.leaf_count == 17);
      CHECK(shape.tips == 1 + habit.sides);
      CHECK(shape.area == doctest::Approx(area_of(shape.leaves)).epsilon(1e-3));
      CHECK(shape.leaves.indices.size() == 17 * rhombus().mesh.indices.size());
      CHECK(std::all_of(shape.wood.positions.begin(), shape.wood.positions.end(),
                        [](float value) { return std::fabs(value) < 2; }));
      CHECK(shape.wood.normals.size() == shape.wood.positions.size());
    }
    CHECK(shapes[0].wood.positions != shapes[1].wood.positions);
  }
}

TEST_CASE("needles are single or in pairs, and leaves that are not unfolded have no area") {
  TwigHabit habit = habit_of(1);
  habit.leaves = 40;
  habit.foliage = TwigHabit::Leaf::needle;
  const auto single = twig_shapes(habit, {}, {1}, false);
  habit.foliage = TwigHabit::Leaf::pair;
  const auto pairs = twig_shapes(habit, {}, {1}, false);
  CHECK(single[0].leaves.indices.size() == 3 * 40);
  CHECK(pairs[0].leaves.indices.size() == 2 * 3 * 40);
  CHECK(pairs[0].area == doctest::Approx(area_of(pairs[0].leaves)).epsilon(1e-3));
  const auto buds = twig_shapes(habit_of(1), rhombus(), {0}, false);
  CHECK(buds[0].area == 0);
  CHECK(buds[0].leaves.indices.empty());
  CHECK(!buds[0].wood.indices.empty());
}

TEST_CASE("buds are built for bare twigs, and the last shape is a short shoot where there are spurs") {
  TwigHabit habit = habit_of();
  habit.bud = 0.02f;
  habit.spurs = 0.4f;
  const auto bare = twig_shapes(habit, rhombus(), std::vector<float>(5, 0), true),
             leafy = twig_shapes(habit, rhombus(), std::vector<float>(5, 1), false);
  CHECK(bare[0].wood.indices.size() > leafy[0].wood.indices.size());
  const auto highest = [](const Mesh& mesh) {
    float high = 0;
    for (std::size_t i = 1; i < mesh.positions.size(); i += 3) high = std::max(high, mesh.positions[i]);
    return high;
  };
  CHECK(highest(leafy[4].wood) < 0.2f);
  CHECK(highest(leafy[0].wood) > 0.8f);
}

TEST_CASE("litter has all leaves of a twig, flat on the ground") {
  const Mesh litter = leaf_litter(habit_of(), rhombus(), 14);
  CHECK(litter.indices.size() == 14 * rhombus().mesh.indices.size());
  for (std::size_t i = 2; i < litter.positions.size(); i += 3) CHECK(litter.positions[i] == 0);
}

TEST_CASE("twigs stay in winter, leaves unfold by shape in spring, and each twig has one organ of leaves in summer") {
  const Population population = grown(text_named("oak"), 6);
  const Form form = form_of(population, FormHabit{});
  const Moment moment = sound(moment_of(population, form, 6, WoodHabit{}, Limits{}, {.pieces = 6}));
  const auto organs = [&](float season) {
    Plant plant;
    LeafHabit habit;
    habit.season = season;
    habit.many = 2;
    habit.twigs = habit_of();
    CHECK(add_leaves(plant, population, form, moment, 6, habit, Limits{}).reason == Reason::none);
    return plant.organs;
  };
  const auto many = [](const std::vector<Organ>& all, std::uint32_t tag) {
    return std::count_if(all.begin(), all.end(), [&](const Organ& organ) { return organ.tag == tag; });
  };
  const auto winter = organs(0.05f), spring = organs(0.16f), summer = organs(0.4f), late = organs(1);
  CHECK(many(winter, twig_tag) > 300);
  CHECK(many(winter, leaf_tag) == 0);
  for (const auto& season : {spring, summer, late}) CHECK(many(season, twig_tag) == many(winter, twig_tag));
  CHECK(many(summer, leaf_tag) == many(summer, twig_tag));
  CHECK(many(spring, leaf_tag) > 0);
  CHECK(many(spring, leaf_tag) < many(summer, leaf_tag));
  CHECK(many(late, shed_tag) == many(summer, leaf_tag));
  for (const Organ& organ : summer) {
    CHECK(organ.mesh >= 0);
    CHECK(organ.mesh < 5);
    CHECK(glm::length(organ.rotation) == doctest::Approx(1).epsilon(1e-3));
    // A twig begins on its segment.
    const Segment& wood = moment.segments[static_cast<std::size_t>(organ.segment)];
    const glm::vec3 way = wood.end - wood.start, from = organ.position - wood.start;
    const float along = glm::dot(from, way) / std::max(glm::dot(way, way), 1e-12f);
    CHECK(glm::length(from - std::clamp(along, 0.0f, 1.0f) * way) < 1e-3f);
  }
  const auto unfolded = [](float season) {
    LeafHabit habit;
    habit.twigs = habit_of();
    habit.season = season;
    return unfolded_by_shape(habit);
  };
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(unfolded(0.05f)[i] == 0);
    CHECK(unfolded(0.4f)[i] == 1);
  }
  CHECK(unfolded(0.2f)[0] > unfolded(0.2f)[4]);
}

TEST_CASE("more twigs than the limit are an error") {
  const Population population = grown(text_named("oak"), 6);
  const Form form = form_of(population, FormHabit{});
  const Moment moment = sound(moment_of(population, form, 6, WoodHabit{}, Limits{}));
  Plant plant;
  LeafHabit habit;
  habit.twigs = habit_of();
  Limits limits;
  limits.copies = 100;
  CHECK(add_leaves(plant, population, form, moment, 6, habit, limits).reason == Reason::limit);
}

TEST_CASE("a coarse leaf has fewer triangles, almost the same area and its petiole; a small leaf stays as it is") {
  // A lobed disc: a fan around its middle, which is not on its outline.
  std::vector<float> points{0, 0}, between{0}, uvs{0.5f, 1};
  std::vector<std::uint32_t> triangles;
  constexpr std::uint32_t corners = 24;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const SinCos turn = sincos_degrees(360.0f * static_cast<float>(i) / corners - 90);
    const float radius = i % 4 == 2 ? 0.4f : 0.5f;
    points.insert(points.end(), {radius * turn.cosine, 0.5f + radius * turn.sine});
    between.push_back(0.5f);
    uvs.insert(uvs.end(), {0.5f, 0.5f});
    triangles.insert(triangles.end(), {0, 1 + i, 1 + (i + 1) % corners});
  }
  const FlatLeaf leaf{points, between, uvs, triangles};
  const auto area = [](const FlatLeaf& of) { return make_blade(of, 1, 0).area; };
  const CoarseLeaf coarse = coarse_leaf(leaf, 12);
  CHECK(coarse.triangles.size() <= 3 * std::size_t{12});
  CHECK(coarse.triangles.size() >= 3 * std::size_t{6});
  CHECK(coarse.points[0] == 0);
  CHECK(coarse.points[1] == 0);
  CHECK(coarse.uvs.size() == coarse.points.size());
  CHECK(coarse.between.size() == coarse.points.size() / 2);
  CHECK(check(coarse.view(leaf)).reason == Reason::none);
  CHECK(area(coarse.view(leaf)) == doctest::Approx(area(leaf)).epsilon(0.2));
  CHECK(coarse_leaf(leaf, 100).triangles == triangles);
  CHECK(coarse_leaf({}, 12).triangles.empty());
}
