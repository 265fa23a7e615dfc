// The bunch as a model: its request's blocks, and its plant's columns.
#include "models/bunch/model.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "foundation/english.hpp"
#include "foundation/fingerprint.hpp"
#include "models/bunch/foliage/flat_leaf.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

bunch::BunchRequest read(const ContainerWriter& writer) {
  std::uint8_t* const bytes = writer.write();
  const auto blocks = read_container({bytes, container_bytes(bytes)});
  REQUIRE(blocks);
  panicle::Request request(blocks.value(), nullptr);
  auto result = read_request(request);
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  bunch::BunchRequest read = std::move(result.value());
  read.grammar = {};  // they are views of the bytes
  read.leaf = {};
  std::free(bytes);
  return read;
}

template <class Value>
std::vector<Value> column(const Plant& plant, std::string_view name) {
  for (std::size_t i = 0; i < plant.columns.size(); ++i) {
    if (plant.columns[i].name != name) continue;
    const auto values = plant.columns[i].as<Value>();
    return {values.begin(), values.end()};
  }
  FAIL(name);
  return {};
}

// A request with all parts: a second bunch, withered stems, missing berries.
bunch::BunchRequest manifold(float procedure) {
  bunch::BunchRequest request = natural_request(table3[2].profile());
  set(request, Parameter::procedure, procedure);
  set(request, Parameter::wing, 0.5f);
  set(request, Parameter::count, 400);
  return request;
}

}  // namespace

TEST_CASE("each block of a request is read into the member of its name") {
  ContainerWriter writer;
  const auto word = [&writer](const char* name, const std::uint32_t& value) {
    writer.add(name, std::span<const std::uint32_t>(&value, 1));
  };
  const std::uint32_t seed = 7, sides = 5, segments = 9, steps = 3;
  const std::vector<std::uint32_t> thinned{4, 2};
  const std::vector<std::int32_t> m{3}, n{1, 2};
  const std::vector<float> parameters{300, 40};
  writer.add("model", "bunch");
  word("seed", seed);
  word("stem_sides", sides);
  word("berry_segments", segments);
  word("steps", steps);
  writer.add("outputs", "measures");
  writer.add("thinned", thinned);
  writer.add("m", m);
  writer.add("n", n);
  writer.add("parameters", parameters);
  const bunch::BunchRequest request = read(writer);
  CHECK(request.seed == 7);
  CHECK(request.stem_sides == 5);
  CHECK(request.berry_segments == 9);
  CHECK(request.steps == 3);
  CHECK(request.measures);
  CHECK(!request.meshes);
  CHECK(!request.mesh_fingerprint);
  CHECK(request.thinned == thinned);
  CHECK(request.m == 3);
  CHECK(request.n == n);
  CHECK(request.parameters == parameters);
}

TEST_CASE("a request's leaf is read from its four blocks, and refused where they do not match") {
  const FlatLeaf flat = flat_leaf();
  for (const bool whole : {true, false}) {
    ContainerWriter writer;
    writer.add("model", "bunch");
    writer.add("leaf.points", flat.points);
    writer.add("leaf.between", flat.between);
    writer.add("leaf.uvs", flat.uvs);
    if (whole)
      writer.add("leaf.triangles", flat.triangles);
    else
      writer.add("leaf.triangles", flat.triangles.subspan(1));
    std::uint8_t* const bytes = writer.write();
    const auto blocks = read_container({bytes, container_bytes(bytes)});
    REQUIRE(blocks);
    panicle::Request request(blocks.value(), nullptr);
    const auto result = read_request(request);
    CHECK(static_cast<bool>(result) == whole);
    if (whole) {
      const FlatLeaf& leaf = result.value().leaf;
      CHECK(std::equal(leaf.points.begin(), leaf.points.end(), flat.points.begin(), flat.points.end()));
      CHECK(std::equal(leaf.between.begin(), leaf.between.end(), flat.between.begin(), flat.between.end()));
      CHECK(std::equal(leaf.uvs.begin(), leaf.uvs.end(), flat.uvs.begin(), flat.uvs.end()));
      CHECK(std::equal(leaf.triangles.begin(), leaf.triangles.end(), flat.triangles.begin(), flat.triangles.end()));
    }
    std::free(bytes);
  }
}

TEST_CASE("columns have the properties of each internode, berry and missing berry") {
  for (const float procedure : {0.0f, 1.0f}) {
    CAPTURE(procedure);
    const GrownBunch bunch = grown(manifold(procedure));
    const Plant plant = plant_of(GrownBunch(bunch));
    const auto axes = column<std::int32_t>(plant, "segments.axis");
    const auto states = column<std::uint8_t>(plant, "segments.state");
    REQUIRE(axes.size() == bunch.internodes.size());
    std::size_t withered = 0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const Internode& one = bunch.internodes[i];
      const Segment& segment = plant.segments[i];
      CHECK(axes[i] == one.axis);
      CHECK(states[i] == static_cast<std::uint8_t>(one.state));
      CHECK(segment.parent == one.parent);
      CHECK(segment.tag == static_cast<std::uint32_t>(one.kind));
      CHECK(segment.start == one.start);
      CHECK(segment.end == one.end);
      CHECK(segment.radius == one.radius);
      CHECK(segment.radius_end == one.radius_end);
      withered += states[i];
    }
    CHECK(withered > 0);
    const auto ids = column<std::uint32_t>(plant, "berries.id");
    const auto spheres = column<float>(plant, "berries.spheres");
    const auto directions = column<float>(plant, "berries.directions");
    const auto seeds = column<float>(plant, "berries.seeds");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      CHECK(ids[i] == bunch.berries[i].id);
      CHECK(spheres[4 * i + 2] == bunch.berries[i].centre.z);
      CHECK(spheres[4 * i + 3] == bunch.berries[i].radius);
      CHECK(directions[3 * i + 1] == bunch.berries[i].direction.y);
      CHECK(seeds[i] == bunch.traits[i].seeds);
    }
    const auto missing = column<std::uint32_t>(plant, "thinned.id"), why = column<std::uint32_t>(plant, "thinned.why");
    const auto places = column<float>(plant, "thinned.places");
    CHECK((missing.size() > 0) == bunch.natural);
    for (std::size_t i = 0; i < missing.size(); ++i) {
      CHECK(missing[i] == bunch.thinned[i].id);
      CHECK(why[i] == static_cast<std::uint32_t>(bunch.thinned[i].why));
      CHECK(places[3 * i + 2] == bunch.thinned[i].place.z);
    }
  }
}

TEST_CASE("the plan's columns are its sides' widths and drops, their counts, and each axis") {
  bunch::BunchRequest request = manifold(0);
  const Profile& profile = table3[2].profile();
  const GrownBunch bunch = grown(request);
  const Plant plant = plant_of(GrownBunch(bunch));
  const auto sides = column<float>(plant, "plan.sides");
  const auto counts = column<std::int32_t>(plant, "plan.counts"), axes = column<std::int32_t>(plant, "plan.axes");
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(sides[2 * i] == profile.sides[i].width);
    CHECK(sides[2 * i + 1] == profile.sides[i].drop);
    CHECK(counts[2 * i] == bunch.plan.sides[i].n);
    CHECK(counts[2 * i + 1] == bunch.plan.sides[i].rd);
  }
  CHECK(axes[0] == bunch.plan.m);
  CHECK(std::equal(axes.begin() + 1, axes.end(), bunch.plan.axes.begin(), bunch.plan.axes.end()));
  CHECK(column<std::int32_t>(plant, "second.axes")[0] == bunch.second->m);
}

TEST_CASE("the fingerprint is the one that docs/fingerprint.md specifies") {
  for (const float procedure : {0.0f, 1.0f}) {
    const GrownBunch bunch = grown(manifold(procedure));
    Fingerprint print;
    const auto add = [&print](const auto... values) { (print.add(static_cast<float>(values)), ...); };
    for (const Internode& one : bunch.internodes)
      add(one.parent, static_cast<int>(one.kind), one.axis, static_cast<int>(one.state), one.start.x, one.start.y,
          one.start.z, one.end.x, one.end.y, one.end.z, one.radius, one.radius_end);
    for (std::size_t i = 0; i < bunch.berries.size(); ++i) {
      const Berry& one = bunch.berries[i];
      add(one.centre.x, one.centre.y, one.centre.z, one.radius, one.parent);
      if (bunch.natural)
        add(one.id, bunch.traits[i].width, bunch.traits[i].length, one.direction.x, one.direction.y, one.direction.z);
    }
    CHECK(bunch.fingerprint == print.value());
  }
}

TEST_CASE("stems have the requested number of sides, clamped") {
  bunch::BunchRequest request = request_for(table3[3].profile());
  request.meshes = true;
  const auto vertices = [&](std::uint32_t sides) {
    request.stem_sides = sides;
    return grown(request).stem->mesh.positions.size();
  };
  CHECK(vertices(6) < vertices(7));
  CHECK(vertices(1) == vertices(3));
  CHECK(vertices(1'000'000) == vertices(64));
}

TEST_CASE("an organ drawn in several pieces is one in every count") {
  bunch::BunchRequest request = request_for(table3[1].profile());
  const GrownBunch whole = grown(request);
  const std::string text = edited(3, "F(l)", "F(l/2)F(l/2)");
  REQUIRE(!text.empty());
  request.grammar = text;
  const GrownBunch pieces = grown(request);
  CHECK(pieces.internodes.size() > 1.5 * static_cast<double>(whole.internodes.size()));
  CHECK(pieces.counts.pedicels == whole.counts.pedicels);
  CHECK(pieces.counts.end_structures == whole.counts.end_structures);
  CHECK(pieces.counts.berries + pieces.counts.withered == pieces.counts.pedicels);
}

TEST_CASE("the scale scales all lengths, and nothing else") {
  const bunch::BunchRequest request = request_for(table3[1].profile());
  bunch::BunchRequest doubled = request;
  set(doubled, Parameter::unit, 0.5f);
  const GrownBunch one = grown(request), two = grown(doubled);
  REQUIRE(one.internodes.size() == two.internodes.size());
  for (std::size_t i = 0; i < one.internodes.size(); ++i) {
    CHECK(two.internodes[i].end.y == doctest::Approx(2 * one.internodes[i].end.y).epsilon(1e-4));
    CHECK(two.internodes[i].radius == doctest::Approx(2 * one.internodes[i].radius).epsilon(1e-4));
    CHECK(two.internodes[i].radius_end == doctest::Approx(2 * one.internodes[i].radius_end).epsilon(1e-4));
    CHECK(one.internodes[i].radius_end < 0.01f);  // metres
  }
  for (std::size_t i = 0; i < one.berries.size(); ++i)
    CHECK(two.berries[i].radius == doctest::Approx(2 * one.berries[i].radius).epsilon(1e-4));
}

TEST_CASE("a bunch whose trace a limit cuts is complete, and no trace entry has the answer of another module") {
  for (const int system : {3, 4}) {
    CAPTURE(system);
    // Idle modules, which every step copies and a derivation in one go writes once.
    std::string text(builtin_grammar(system));
    text.insert(text.find("axiom: ") + 7, "ZZ(300) ");
    text += "ZZ(n) : n>0 --> ZZ(n-1) Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q Q\n";
    bunch::BunchRequest request = request_for(table3[1].profile());
    set(request, Parameter::procedure, system == 4 ? 1 : 0);
    request.grammar = text;
    GrownBunch plain = grown(request);
    request.trace = lsystem::TraceRequest{.step = 9999};
    Limits limits;
    limits.work = 8000;
    auto cut = bunch::grow(request, limits);
    REQUIRE(cut);
    REQUIRE(cut->trace);
    CHECK(cut->trace->stopped().reason == Reason::limit);
    std::string answers;
    for (const auto& entry : cut->trace->modules()) answers += entry.response;
    CHECK(answers == "");
    CHECK(cut->fingerprint == plain.fingerprint);
    const Plant plant = plant_of(std::move(cut.value()));
    CHECK(english(plant.notes.back()).starts_with("The trace ends before the plant is complete."));
    for (const char* of : {"segments.module", "organs.module"}) {
      const auto modules = column<std::uint32_t>(plant, of);
      CHECK(modules.size() > 10);
      CHECK(std::count(modules.begin(), modules.end(), no_module) == static_cast<std::ptrdiff_t>(modules.size()));
    }
  }
}
